# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The commands that README.md and docs/first-hour.md name, and how tests run them in a copy of the
project: all of the first hour as they stand, or those of both pages at a small size."""

import dataclasses
import os
import pathlib
import re
import shutil
import subprocess

from dynrt_tools import project

PAGE = project.ROOT / "docs" / "first-hour.md"
README = project.ROOT / "README.md"
BLOCK = re.compile(r"^```sh\n(.*?)^```", re.MULTILINE | re.DOTALL)
README_COMMAND = re.compile(
    r"^ {4,}((?:scripts|build/release)/.*)|`((?:dynrt|scripts/[\w-]+)(?:\s[^`]*)?)`", re.MULTILINE
)
FAILS = "# fails"

# A tetrahedron, for the reader's own model.
PLY = """ply
format ascii 1.0
element vertex 4
property float x
property float y
property float z
element face 4
property list uchar int vertex_indices
end_header
0 0 0
1 0 0
0 1 0
0 0 1
3 0 2 1
3 0 1 3
3 0 3 2
3 1 2 3
"""

# What runs in a command's place where that takes long, never ends or would install something.
SMALL = {
    "scripts/demo": "scripts/demo --scene blocks --size 32x24 --out office.png",
    "scripts/setup --for test": "scripts/setup --for test --check",
    "build/release/dynrt render YOUR.ply --position 0,1,3 --look-at 0,0,0 --size 256x192": (
        "build/release/dynrt render YOUR.ply --position 0,1,3 --look-at 0,0,0 --size 32x24"
    ),
    "build/release/dynrt view YOUR.ply": (
        "build/release/dynrt view YOUR.ply --size 32x24 --export view.html"
    ),
    "dynrt render SCENE --board ulx3s": (
        "build/release/dynrt render blocks --board ulx3s --size 8x4"
    ),
}
# Commands that these tests leave to others, and to which.
ELSEWHERE = {
    "scripts/test": "it runs these tests",
    "scripts/test --build-only": "scripts/test does it first",
    "cmake --preset release": "scripts/test does it first",
    "scripts/try shading    # fails": "docs.first_hour_whole, as it needs a build of its own",
    "build/release/dynrt specialise office": "specialise",
    "build/release/dynrt specialise office --out made": "specialise",
    "scripts/bitstream ulx3s": "scripts.bitstream, as Debian 12 has no nextpnr-ecp5",
    "scripts/docs": "docs.site",
    "scripts/docs --serve": "docs.site",
}


@dataclasses.dataclass(frozen=True)
class Command:
    """A command and the line of the page where it stands."""

    line: int
    text: str
    page: pathlib.Path = PAGE

    @property
    def fails(self) -> bool:
        """Whether the page says that it ends with an error."""
        return self.text.endswith(FAILS)

    @property
    def small(self) -> "Command | None":
        """The same at a small size; nothing if another test runs it."""
        if self.text in ELSEWHERE:
            return None
        return dataclasses.replace(self, text=SMALL.get(self.text, self.text))


def commands(text: str) -> list[Command]:
    """The commands of the first hour's page in their order."""
    found = []
    for block in BLOCK.finditer(text):
        first = text.count("\n", 0, block.start(1)) + 1
        for line, words in enumerate(block[1].splitlines(), first):
            if words:
                found.append(Command(line, words))
    return found


def readme_commands(text: str) -> list[Command]:
    """The commands of the README, in lines of their own and within sentences, without remarks."""
    found = []
    for match in README_COMMAND.finditer(text):
        words = re.split(" {2,}#", match[1])[0] if match[1] else " ".join(match[2].split())
        found.append(Command(text.count("\n", 0, match.start()) + 1, words, README))
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
        f"{command.page.relative_to(project.ROOT)}:{command.line}: '{command.text}' ends with exit "
        f"code {done.returncode}:\n{tail}"
    )
