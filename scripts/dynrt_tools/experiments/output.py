# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""How a command writes its files: all of them or none, so that a full disk leaves those that were
there."""

import contextlib
import csv
import errno
import os
import pathlib
import re
import shutil
import tempfile
from collections.abc import Iterator, Sequence

from dynrt_tools.project import Failed, Json

AS_IT_WAS = "a report that was there is as it was, and all measurements are kept"
NEW = re.compile(r"\.new(\d+)\.")  # what a process with this number writes first


def not_written(out: pathlib.Path, error: OSError, then: str) -> Failed:
    reason = "the disk is full" if error.errno == errno.ENOSPC else error.strerror
    return Failed(f"--out {out}: cannot be written ({reason}); {then}")


def check_writable(out: pathlib.Path, then: str = AS_IT_WAS) -> None:
    """Refuses a folder that could not be written to, before anything is measured; `then` ends the
    sentence."""
    try:
        out.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(prefix=f".new{os.getpid()}.", dir=out):
            pass
    except OSError as error:
        raise not_written(out, error, then) from error


def remove_left(out: pathlib.Path) -> None:
    """Half-written folders of processes that have ended."""
    for left in out.glob(".new*"):
        process = NEW.match(left.name)
        if process and not pathlib.Path("/proc", process[1]).exists():
            shutil.rmtree(left, ignore_errors=True)


@contextlib.contextmanager
def written_first(out: pathlib.Path, then: str = AS_IT_WAS) -> Iterator[pathlib.Path]:
    """A folder to write to, whose files take the place of those of the same name in `out` when all
    are there: if the disk is full, what was there before stays as it is. `then` says so."""
    try:
        out.mkdir(parents=True, exist_ok=True)
        remove_left(out)
        new = pathlib.Path(tempfile.mkdtemp(prefix=f".new{os.getpid()}.", dir=out))
        try:
            yield new
            # The page last: a reader who finds the new one finds all that it shows.
            files = sorted(
                (p for p in new.rglob("*") if p.is_file()), key=lambda p: (p.suffix == ".html", p)
            )
            for path in files:
                with path.open("rb") as file:
                    os.fsync(file.fileno())
            for path in files:
                goal = out / path.relative_to(new)
                goal.parent.mkdir(parents=True, exist_ok=True)
                path.replace(goal)
        finally:
            shutil.rmtree(new, ignore_errors=True)
    except OSError as error:
        raise not_written(out, error, then) from error


def check_folder(flag: str, path: pathlib.Path | None, folder: pathlib.Path | None) -> None:
    """Refuses the value of a flag whose folder is not there, before the work."""
    if path and folder and not folder.is_dir():
        named = path if folder == path else path.parent
        other = "another" if folder == path else "a file elsewhere"
        raise Failed(f"{flag} {path}: there is no folder '{named}'; create it or name {other}")


def write_csv(path: pathlib.Path, lines: Sequence[Json]) -> None:
    """A line for each, with every key as a column."""
    columns = list(dict.fromkeys(key for line in lines for key in line))
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, columns, lineterminator="\n")
        writer.writeheader()
        writer.writerows(lines)


def scene_path(scene: str) -> str:
    """As the program reads it in any folder: a file's absolute path, or the name of a built-in one,
    which goes before a folder or file of that name."""
    file = pathlib.Path(scene if os.path.isfile(scene) else scene.split(":")[0])
    return os.path.abspath(scene) if file.suffix and file.is_file() else scene


def scene_name(scene: str) -> str:
    """The name of a scene in a report: that of a built-in scene, or of its file."""
    stem, _, part = scene.partition(":")
    name = pathlib.Path(stem).stem + (f"_{part}" if part else "")
    return re.sub(r"[^A-Za-z0-9_.-]", "_", name)
