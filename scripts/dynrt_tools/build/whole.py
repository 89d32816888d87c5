# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Whether a build has all that a command needs, asked before the work."""

from dynrt_tools.project import Failed, Json


def require_whole(build: Json, work: str, parts: str) -> None:
    """Refuses some work that needs these parts where scripts/demo built the program without them.
    `build` is what cmake/DescribeBuild.cmake wrote."""
    if build.get("program_only"):
        raise Failed(
            f"{work} needs {parts}, and scripts/demo built this program without; "
            "scripts/test --build-only builds the whole program"
        )
