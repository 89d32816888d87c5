# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Parts that every command shares: the project's folder, progress on a terminal, files that are checked
before the work, and tools that must be there."""

import datetime
import hashlib
import json
import pathlib
import re
import shutil
import sys
from collections.abc import Callable, Iterable, Sequence
from typing import Any, NoReturn

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCRIPTS = ROOT / "scripts"

Json = dict[str, Any]  # an object as JSON has it
Progress = Callable[[str], None]  # shows the present work of a command


class Failed(Exception):
    """Why something has no result, in a sentence."""


def fail(message: object) -> NoReturn:
    """Ends the command with a sentence."""
    sys.exit(f"{pathlib.Path(sys.argv[0]).name}: {message}")


def enumerated(words: Sequence[str]) -> str:
    """As a sentence names them: a, b and c."""
    return " and ".join(part for part in (", ".join(words[:-1]), *words[-1:]) if part)


def today() -> str:
    """The date as records keep it."""
    return datetime.date.today().isoformat()


def day(date: str) -> str:
    """A date of a record as a sentence has it: 29 November 2026."""
    return f"{datetime.date.fromisoformat(date):%-d %B %Y}"


def show_progress(text: str) -> None:
    """Writes over the line before; an empty text removes it."""
    if sys.stderr.isatty():
        print(f"\r\033[K{text}", end="", file=sys.stderr, flush=True)


def read_json(path: pathlib.Path) -> Any:
    return json.loads(path.read_text(encoding="utf-8"))


def hash_of_files(paths: Iterable[pathlib.Path]) -> str:
    """Of what stands in files, in their order."""
    digest = hashlib.sha256()
    for path in paths:
        digest.update(path.read_bytes())
    return digest.hexdigest()


def with_whole_numbers(data: Any) -> Any:
    """The same data; numbers without a fraction as integers, as CMake and C++ tell 0.0 from 0."""
    if isinstance(data, dict):
        return {key: with_whole_numbers(value) for key, value in data.items()}
    if isinstance(data, (list, tuple)):
        return [with_whole_numbers(value) for value in data]
    return int(data) if isinstance(data, float) and data.is_integer() else data


def json_text(data: object, indent: int | None = None) -> str:
    return json.dumps(with_whole_numbers(data), indent=indent)


def write_json(path: pathlib.Path, data: object) -> None:
    path.write_text(json_text(data, 2) + "\n", encoding="utf-8")


def write_rows(path: pathlib.Path, data: Json, *lists: str) -> None:
    """As JSON with each entry of these lists in its line, so that two files can be compared."""
    text = json_text({**data, **{name: [] for name in lists}}, 2)
    for name in lists:
        rows = ",\n".join(f"    {json_text(row)}" for row in data[name])
        if rows:
            text = text.replace(f'\n  "{name}": []', f'\n  "{name}": [\n{rows}\n  ]')
    path.write_text(text + "\n", encoding="utf-8")


def searched(pattern: str, text: str, flags: re.RegexFlag = re.MULTILINE) -> re.Match[str]:
    """The first match of a pattern that must be in the text."""
    match = re.search(pattern, text, flags)
    if not match:
        raise Failed(f"nothing matches {pattern} in: {text[:80]!r}")
    return match


def require_tool(tool: str, package: str) -> None:
    """Names the package of a tool that is missing."""
    if not shutil.which(tool):
        raise Failed(
            f"{tool} is not installed; Debian's package {package} has it, and "
            "scripts/setup installs that"
        )


def check_output(flag: str, path: pathlib.Path) -> None:
    """Refuses a file that could not be written, before the work."""
    folder = path.absolute().parent
    if not folder.is_dir():
        fail(
            f"{flag} {path}: there is no folder '{path.parent}'; create it or name a file elsewhere"
        )
    new = not path.exists()
    try:
        with path.open("a", encoding="utf-8"):
            pass
    except OSError:
        fail(f"{flag} {path}: cannot be written; name a file that can")
    if new:
        path.unlink()
