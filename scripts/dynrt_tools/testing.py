# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Parts that tests share: a folder of their own, trees of files, programs that stand in for others, and
commands whose output they read."""

import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest
from collections.abc import Mapping

Word = str | os.PathLike[str]
Result = subprocess.CompletedProcess[str]


class InFolder(unittest.TestCase):
    """A test that has a folder of its own, which goes at the test's end."""

    folder: pathlib.Path

    def setUp(self) -> None:
        super().setUp()
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))


def write_tree(root: pathlib.Path, files: Mapping[str, str]) -> None:
    """Writes texts by the names of their files, and makes the folders that these are in."""
    for name, text in files.items():
        path = root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")


def write_program(path: pathlib.Path, text: str) -> None:
    """Writes a script that can be run."""
    path.write_text(text, encoding="utf-8")
    path.chmod(0o755)


def link_tools(folder: pathlib.Path, *tools: str) -> None:
    """Makes the folder a PATH that has these tools alone."""
    for tool in tools:
        found = shutil.which(tool)
        assert found, f"{tool} is not installed"
        (folder / tool).symlink_to(found)


def run(
    *command: Word, cwd: pathlib.Path | None = None, env: Mapping[str, str] | None = None
) -> Result:
    """Runs a command that may fail."""
    return subprocess.run(command, cwd=cwd, env=env, capture_output=True, text=True, check=False)
