# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Which Verilog files belong together, and which instances the core consists of."""

import argparse
import difflib
import pathlib
import re
from collections.abc import Iterable
from dataclasses import dataclass

from dynrt_tools import project

# The one configuration whose generated Verilog is checked in.
CHECKED_IN = "thesis"
GENERATED = project.ROOT / "rtl" / "generated" / CHECKED_IN
LIBRARY = project.ROOT / "rtl" / "lib"
# The module that joins the units, and the one that counts their transactions.
CORE, COUNTERS = "dynrt_core", "hls_counters"
INSTANCE = re.compile(r"^  (\w+)(?: #\((.*)\))? (u_\w+|counters) \($", re.MULTILINE)
PARAMETER = re.compile(r"\.(\w+)\((\d+)\)")


@dataclass(frozen=True)
class Instance:
    """An instance in the core beside those of the join itself: a unit, or the counters."""

    name: str
    module: str
    parameters: dict[str, str]


def meant(name: str, known: Iterable[str]) -> str:
    """A question with the names that look like a wrong one, or nothing: a unit's module may be called
    after more than its header, as packet_mailbox of mailbox.h."""
    names = sorted(known)
    close = [k for k in names if name in k or k in name] or difflib.get_close_matches(name, names)
    return f" (did you mean {' or '.join(close)}?)" if close else ""


def library() -> list[pathlib.Path]:
    """The primitives that every core is joined with."""
    return sorted(LIBRARY.glob("*.v"))


def hand_written() -> list[pathlib.Path]:
    """The primitives and the board."""
    return sorted(p for p in (project.ROOT / "rtl").rglob("*.v") if "generated" not in p.parts)


def board() -> list[pathlib.Path]:
    """The board's top and its parts."""
    return sorted((project.ROOT / "rtl" / "board").glob("*.v"))


def units_in(folder: pathlib.Path) -> list[pathlib.Path]:
    """The Verilog that hlsc made of a configuration: the units and their join."""
    return sorted(folder.glob("*.v"))


def core_files(folder: pathlib.Path = GENERATED) -> list[pathlib.Path]:
    """Every file of the core whose generated Verilog is in the folder."""
    return library() + units_in(folder)


def instances(core: pathlib.Path) -> list[Instance]:
    """The instances that the file of the module CORE has."""
    return [
        Instance(name.removeprefix("u_"), module, dict(PARAMETER.findall(parameters)))
        for module, parameters, name in INSTANCE.findall(core.read_text(encoding="utf-8"))
    ]


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The flags that choose a configuration."""
    parser.add_argument(
        "--config",
        default=CHECKED_IN,
        metavar="NAME",
        help=f"configuration (default: {CHECKED_IN}, which is checked in)",
    )
    parser.add_argument(
        "--build",
        type=pathlib.Path,
        metavar="FOLDER",
        help="the build that made the Verilog of the other configurations "
        "(default: build/release, else build/dev)",
    )


def generated(args: argparse.Namespace) -> list[pathlib.Path]:
    """The Verilog that hlsc made of a configuration: checked in, or else from a build."""
    builds = (
        [args.build] if args.build else [project.ROOT / "build" / p for p in ("release", "dev")]
    )
    folders = [GENERATED] if args.config == CHECKED_IN else []
    folders += [build / "generated" / args.config for build in builds]
    files: list[pathlib.Path] = next((found for f in folders if (found := units_in(f))), [])
    if not files:
        project.fail(
            f"there is no generated Verilog of configuration '{args.config}'; '{CHECKED_IN}' is "
            f"checked in, a build puts that of the others into "
            f"{' or '.join(str(b) for b in builds)}"
        )
    return files


def include_folders(files: Iterable[pathlib.Path]) -> list[pathlib.Path]:
    return sorted({f.parent for f in files})
