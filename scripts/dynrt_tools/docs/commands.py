# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The pages of the commands, from what each prints for --help."""

import os
import pathlib
import re
import subprocess
from collections.abc import Iterator

from dynrt_tools import project

# In the order of a reader's day.
SCRIPTS = (
    "setup",
    "demo",
    "test",
    "try",
    "build_times",
    "configuration",
    "lint",
    "synth",
    "gates",
    "place",
    "fit-delays",
    "bench",
    "file_lists",
    "docs",
)
# What depends on the build, and what the page says in its place.
BUILT_IN = re.compile(r"(?<=configuration of the core: )[\w, ]+(?=, or a file)")
BUILT_IN_MEANS = "one that the program was built with"
SUBCOMMAND = re.compile(r"^  (\w[\w-]*)  ", re.MULTILINE)


def help_of(command: list[str]) -> str:
    """What a command prints for --help, in lines of 100 columns at most if it wraps them."""
    done = subprocess.run(
        [*command, "--help"],
        env={**os.environ, "COLUMNS": "100"},
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        check=False,
    )
    if done.returncode:
        raise project.Failed(f"{' '.join(command)} --help fails: {done.stderr.strip()}")
    return done.stdout.rstrip()


def section(name: str, text: str, depth: int) -> list[str]:
    return ["", f"{'#' * depth} {name}", "", "```text", text, "```"]


def scripts_page() -> str:
    """The scripts that a user or a contributor calls."""
    lines = [
        "# Scripts",
        "",
        "Each prints this for `--help`. [The program dynrt](commands.md) has a page of its own.",
    ]
    for name in SCRIPTS:
        if (project.SCRIPTS / name).exists():
            text = help_of([str(project.SCRIPTS / name)])
            lines += section(f"scripts/{name}", text, 2)
    return "\n".join(lines) + "\n"


def subcommands(program: str, words: tuple[str, ...]) -> Iterator[tuple[tuple[str, ...], str]]:
    """The help of a command and of each command below it."""
    text = help_of([program, *words])
    yield words, text
    for name in SUBCOMMAND.findall(text.partition("\nSubcommands:\n")[2].partition("\n\n")[0]):
        yield from subcommands(program, (*words, name))


def programs_page(dynrt: pathlib.Path, hlsc: pathlib.Path) -> str:
    """The programs that a build makes."""
    lines = [
        "# The programs dynrt and hlsc",
        "",
        "Each prints this for `--help`. [Scripts](scripts.md) have a page of their own.",
    ]
    for words, text in subcommands(str(dynrt), ()):
        text = BUILT_IN.sub(BUILT_IN_MEANS, text)
        lines += section(" ".join(("dynrt", *words)), text, 2 + len(words))
    text = help_of([str(hlsc)]).replace(str(hlsc), "hlsc")
    lines += section("hlsc", text, 2)
    return "\n".join(lines) + "\n"
