# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Runs Yosys on a module and keeps its result, under a key of all that it was made from: what
reads as the same Verilog, comments apart, is synthesized once."""

import functools
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time
from collections.abc import Callable, Iterable, Sequence
from typing import Any

from dynrt_tools import project
from dynrt_tools.build.cache import BuildCache
from dynrt_tools.hardware import rtl_files
from dynrt_tools.project import read_json

MODULE = re.compile(r"^\s*module\s+(\w+)", re.MULTILINE)
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
# What Yosys says when a signal has ended ABC, as 128 and the signal's number: SIGABRT or SIGSEGV.
ABC_ABORTED = re.compile(r"ABC: execution of command .* failed: return code (?:134|139)\b")
MORE_RUNS = 2  # after a run in which that happened
KEPT = pathlib.Path(os.environ.get("DYNRT_CACHE") or project.ROOT / "build" / "synth")


def modules(files: Iterable[pathlib.Path]) -> list[str]:
    return [m for f in files for m in MODULE.findall(_text(f))]


@functools.lru_cache(maxsize=None)
def _text(path: pathlib.Path) -> str:
    return path.read_text(encoding="utf-8")


@functools.lru_cache(maxsize=None)
def meaning(path: pathlib.Path) -> str:
    """A file's text without comments and what they leave behind."""
    text = re.sub(r"\s+", " ", COMMENT.sub(" ", _text(path))).strip()
    return f" {text} "


def needed(top: str, files: list[pathlib.Path]) -> list[pathlib.Path]:
    """The files that the module's hierarchy comes from, in their order."""
    defines = {m: f for f in files for m in MODULE.findall(_text(f))}
    todo, seen = [top], set()
    while todo:
        path = defines.get(todo.pop())
        if path is None or path in seen:
            continue
        seen.add(path)
        todo += set(re.findall(r"\w+", meaning(path))) & defines.keys()
    return [f for f in files if f in seen]


@functools.lru_cache(maxsize=None)
def tool_version(tool: str, flag: str, package: str) -> str:
    """The version that a tool prints."""
    project.require_tool(tool, package)
    result = subprocess.run([tool, flag], capture_output=True, text=True, check=False)
    return (result.stdout + result.stderr).strip()


def headers_beside(files: Sequence[pathlib.Path]) -> list[pathlib.Path]:
    """The headers beside Verilog files, which are part of the text, as it includes them."""
    return [h for folder in rtl_files.include_folders(files) for h in sorted(folder.glob("*.vh"))]


def kept(
    kind: str, said: object, files: list[pathlib.Path], make: Callable[[pathlib.Path], None]
) -> pathlib.Path:
    """The folder of a result. `said` is all that decides it besides the files; `make` writes it into an
    empty folder and throws project.Failed."""
    digest = hashlib.sha256(json.dumps([kind, said], sort_keys=True).encode())
    for path in files:
        digest.update(path.name.encode() + b"\0" + meaning(path).encode() + b"\0")
    for path in headers_beside(files):
        digest.update(meaning(path).encode() + b"\0")

    def build(partial: pathlib.Path) -> pathlib.Path:
        folder = partial / "result"
        folder.mkdir()
        start = time.monotonic()
        make(folder)
        (folder / "seconds").write_text(f"{time.monotonic() - start:.1f}\n", encoding="utf-8")
        return folder

    try:
        return BuildCache(KEPT).get(f"{kind}-{digest.hexdigest()[:24]}", build)
    except OSError as error:
        raise project.Failed(f"{error.filename or KEPT}: {error.strerror}") from error


def run_yosys(commands: list[str], folder: pathlib.Path, what: str) -> None:
    """Runs Yosys with its log in the folder; keeps the log of a run that fails elsewhere. Debian's
    berkeley-abc aborts now and then on a module that it maps at other times: after such a run, and
    after no other, Yosys runs again."""
    log = folder / "yosys.log"
    command = ["yosys", "-q", "-l", str(log), "-p", "; ".join(commands)]
    for more_runs in reversed(range(MORE_RUNS + 1)):
        result = subprocess.run(command, capture_output=True, text=True, check=False)
        if result.returncode == 0:
            return
        text = log.read_text(encoding="utf-8", errors="replace") if log.exists() else ""
        if not (more_runs and ABC_ABORTED.search(text)):
            break
        print(f"{what}: a signal aborted ABC; Yosys runs again", file=sys.stderr)
    left = KEPT / "failed.log"
    if log.exists():
        shutil.copyfile(log, left)
    last = (result.stderr or result.stdout).strip().splitlines()
    raise project.Failed(f"{what}: {last[-1] if last else 'Yosys failed'}; the whole log is {left}")


def read_commands(
    files: Iterable[pathlib.Path], blackboxes: Sequence[pathlib.Path] = ()
) -> list[str]:
    return [f"verilog_defaults -add -I{f}" for f in rtl_files.include_folders(files)] + [
        f"read_verilog {'-lib ' if f in blackboxes else ''}{f}" for f in files
    ]


def chosen(top: str, parameters: dict[str, Any]) -> list[str]:
    """Commands that give a module's parameters their values."""
    sets = " ".join(f"-set {name} {value}" for name, value in sorted(parameters.items()))
    return [f"chparam {sets} {top}"] if sets else []


def cells(
    top: str,
    files: list[pathlib.Path],
    synth: str,
    what: str,
    parameters: dict[str, Any] | None = None,
) -> tuple[dict[str, int], float]:
    """Synthesizes a module; returns how many cells of each type and the seconds it took."""
    said = [tool_version("yosys", "-V", "yosys"), top, synth, parameters or {}]
    files = needed(top, files)

    def make(folder: pathlib.Path) -> None:
        run_yosys(
            [
                *read_commands(files),
                *chosen(top, parameters or {}),
                synth.format(top=top),
                "check -assert",
                f"tee -q -o {folder}/stat.json stat -json",
            ],
            folder,
            what,
        )

    folder = kept("area", said, files, make)
    stat = read_json(folder / "stat.json")
    return stat["design"]["num_cells_by_type"], float((folder / "seconds").read_text())
