# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The commands of docs/first-hour.md, and how a test runs them in a copy of the project."""

import dataclasses
import os
import pathlib
import re
import shutil
import subprocess

from dynrt_tools import project

PAGE = project.ROOT / "docs" / "first-hour.md"
BLOCK = re.compile(r"^```sh\n(.*?)^```", re.MULTILINE | re.DOTALL)
FAILS = "# fails"
# They take seconds, and change nothing that a later one needs.
QUICK = re.compile(r"build/release/dynrt (render|needs) |cat |scripts/synth ")


@dataclasses.dataclass(frozen=True)
class Command:
    """A command and the line of the page where it stands."""

    line: int
    text: str

    @property
    def fails(self) -> bool:
        """Whether the page says that it ends with an error."""
        return self.text.endswith(FAILS)

    @property
    def quick(self) -> bool:
        """Whether it is one of those that take seconds."""
        return QUICK.match(self.text) is not None


def commands(text: str) -> list[Command]:
    """The commands of a page in their order."""
    found = []
    for block in BLOCK.finditer(text):
        first = text.count("\n", 0, block.start(1)) + 1
        for line, words in enumerate(block[1].splitlines(), first):
            if words:
                found.append(Command(line, words))
    return found


def copy_project(folder: pathlib.Path) -> None:
    """Copies the project without what was built, into a repository of its own."""

    def left_out(parent: str, names: list[str]) -> set[str]:
        uppermost = pathlib.Path(parent) == project.ROOT
        return {"build", ".git", ".cache"} if uppermost else {"__pycache__"} & set(names)

    shutil.copytree(project.ROOT, folder, ignore=left_out)
    for words in (
        ["init", "--quiet"],
        ["add", "--all"],
        ["-c", "user.name=reader", "-c", "user.email=reader@localhost", "commit", "-qm", "Copy"],
    ):
        subprocess.run(["git", *words], cwd=folder, check=True)


def run(command: Command, folder: pathlib.Path) -> str | None:
    """Runs a command there; a sentence with its output if it does not end as the page says."""
    done = subprocess.run(
        ["bash", "-c", command.text],
        cwd=folder,
        env={**os.environ, "DYNRT_CACHE": str(folder / "cache")},
        text=True,
        errors="replace",
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        check=False,
    )
    if (done.returncode != 0) == command.fails:
        return None
    tail = "\n".join(done.stdout.splitlines()[-20:])
    return (
        f"docs/{PAGE.name}:{command.line}: '{command.text}' ends with exit code "
        f"{done.returncode}:\n{tail}"
    )
