# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Checks that every #include points the right way between the folders of the project.

    language <- hls/cosim                (the test bench that compares a unit's Verilog with a model)
    language <- hls/units
    language <- hls/compiler             (which lowers anybody's units and knows none;
                                          its front and back end share the netlist alone)
    language, the units' published headers <- host <- verif, which may include all but the program
    the folders of host, each of which may include those before it:
        format, picture, scene, memory, tree, specialise, layout, board, link, ulx3s, render,
        analysis, view, app

An include is followed to the file that it names (beside the including file, then in the include
folders); standard and library headers belong to no folder and are always allowed.
"""


import argparse
import pathlib
import re
import sys

from dynrt_tools import project

# The folders, the most specific first, and those that each may include besides itself.
LANGUAGE = ("hls/include", "hls/native", "hls/lowered")
BACK_END = ("netlist", "passes", "schedule", "emit")
HOST = tuple(
    f"host/{folder}"
    for folder in (
        "format",
        "picture",
        "scene",
        "memory",
        "tree",
        "specialise",
        "layout",
        "board",
        "link",
        "ulx3s",
        "render",
        "analysis",
        "view",
        "app",
    )
)
FOLDERS = {
    "hls/include": {"hls/native", "hls/lowered"},
    "hls/native": {"hls/include"},
    "hls/lowered": {"hls/include"},
    "hls/cosim": set(LANGUAGE),
    "hls/units": set(LANGUAGE),
    "hls/compiler/frontend": {*LANGUAGE, "hls/compiler", "hls/compiler/netlist"},
    **{
        f"hls/compiler/{part}": {
            *LANGUAGE,
            "hls/compiler",
            *(f"hls/compiler/{other}" for other in BACK_END),
        }
        for part in BACK_END
    },
    "hls/compiler": {
        *LANGUAGE,
        "hls/cosim",
        *(f"hls/compiler/{p}" for p in (*BACK_END, "frontend")),
    },
    "rtl": set(LANGUAGE),
    **{folder: {*LANGUAGE, "host", *HOST[:place]} for place, folder in enumerate(HOST)},
    "host": set(LANGUAGE),  # headers directly in host: errors, the folder of a test
    "verif": {*LANGUAGE, "hls/cosim", "hls/units", "hls/compiler", "host", *HOST[:-1], "rtl"},
}
# Published headers, and the folders or files that may include them: the host includes the core's
# memory formats and frame registers, the board the native model that it runs, and the programs that
# write a join the function that turns a join into a Verilog top.
PUBLISHED = {
    "hls/units/memory_format.h": ("host",),
    "hls/units/memory_timing.h": ("host",),
    "hls/units/pixel.h": ("host",),
    "hls/units/frame.h": ("host",),
    "hls/units/frame_watch.h": ("host",),
    "hls/units/options.h": ("host",),
    "hls/units/core_model.h": ("host/board",),
    "hls/units/scan_out.h": ("host/board",),
    "hls/units/start.h": ("host/board",),
    "hls/units/tmds_specification.h": ("host/board",),
    "hls/units/link_format.h": ("host",),
    "hls/compiler/join/emit_top.h": ("hls/units/elaborate.cpp", "hls/units/elaborate_link.cpp"),
}
# Where the compiler looks, after the folder of the including file.
INCLUDE_FOLDERS = ("", "hls/include", "hls/native", "hls/lowered", "hls", "hls/compiler")

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*["<]([^">]+)[">]', re.MULTILINE)


def within(path: str, folder: str) -> bool:
    return path == folder or path.startswith(folder + "/")


def folder_of(path: str) -> str | None:
    return next((folder for folder in FOLDERS if within(path, folder)), None)


def may_read(source: str, published: str) -> bool:
    """Whether a published header is shown to this file."""
    return any(within(source, reader) for reader in PUBLISHED[published])


def resolve(root: pathlib.Path, source: pathlib.Path, name: str) -> str | None:
    """The project's file that `source` gets for `name`, relative to root, or None."""
    for folder in (source.parent, *(root / f for f in INCLUDE_FOLDERS)):
        candidate = (folder / name).resolve()
        if candidate.is_file() and candidate.is_relative_to(root):
            return candidate.relative_to(root).as_posix()
    return None


def allowed(source: str, target: str) -> bool:
    source_folder, target_folder = folder_of(source), folder_of(target)
    if target in PUBLISHED and may_read(source, target):
        return True
    return target_folder == source_folder or target_folder in FOLDERS.get(source_folder or "", ())


def check(root: pathlib.Path) -> tuple[list[str], int]:
    """All violations as sentences, and the number of includes between files of ours."""
    problems, followed = [], 0
    for folder in FOLDERS:
        for source in sorted((root / folder).rglob("*")):
            inner = folder_of(source.relative_to(root).as_posix()) != folder
            if inner or source.suffix not in (".h", ".cpp", ".inc"):
                continue
            text = source.read_text(encoding="utf-8")
            for match in INCLUDE.finditer(text):
                target = resolve(root, source, match.group(1))
                if target is None:
                    continue
                followed += 1
                here = source.relative_to(root).as_posix()
                if not allowed(here, target):
                    line = text.count("\n", 0, match.start()) + 1
                    may = ", ".join(sorted(FOLDERS[folder] | {folder}))
                    published = [p for p in PUBLISHED if may_read(here, p)]
                    extra = f" and {', '.join(published)}" if published else ""
                    problems.append(
                        f"{here}:{line}: includes {target}, but {folder} may include "
                        f"only {may}{extra}"
                    )
    return problems, followed


def main() -> int:
    parser = argparse.ArgumentParser(
        prog="scripts/check-layers",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument(
        "root",
        type=pathlib.Path,
        nargs="?",
        default=project.ROOT,
        metavar="ROOT",
        help="the project's folder (default: the folder of this script's project)",
    )
    root = parser.parse_args().root.resolve()
    problems, followed = check(root)
    for problem in problems:
        print(problem, file=sys.stderr)
    if followed == 0:
        print(
            f"{root}: no include between files of ours found; is this the project's folder?",
            file=sys.stderr,
        )
        return 1
    if not problems:
        print(f"{followed} includes, all pointing the right way")
    return 1 if problems else 0
