# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Writes dynrt_core.f and dynrt_board.f, lists of the Verilog that dynrt.core describes.

Names are relative to the folder rtl/, where the lists are installed. These commands read them
there:
    verilator --lint-only -F rtl/dynrt_board.f --top-module dynrt_board
    iverilog -g2005 -s dynrt_core -f dynrt_core.f      (run in rtl/)
"""


import argparse
import pathlib

import yaml
from dynrt_tools import project

LISTS = {"dynrt_core.f": "core_alone", "dynrt_board.f": "default"}


def lists(root: pathlib.Path) -> dict[str, str]:
    """The text of each list by its file's name."""
    core = yaml.safe_load((root / "dynrt.core").read_text(encoding="utf-8").partition("\n")[2])
    texts = {}
    for name, target in LISTS.items():
        sources, folders = [], []
        for fileset in core["targets"][target]["filesets"]:
            for entry in core["filesets"][fileset]["files"]:
                if isinstance(entry, dict):  # a header
                    (path,) = entry
                    folders.append(pathlib.PurePosixPath(path).parent.relative_to("rtl"))
                else:
                    sources.append(pathlib.PurePosixPath(entry).relative_to("rtl"))
        lines = [f"+incdir+{f}" for f in sorted(set(folders))] + [str(f) for f in sources]
        texts[name] = "\n".join(lines) + "\n"
    return texts


def main() -> int:
    parser = argparse.ArgumentParser(
        prog="scripts/file_lists",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument(
        "folder", type=pathlib.Path, metavar="FOLDER", help="the folder that receives them"
    )
    args = parser.parse_args()
    if not args.folder.is_dir():
        project.fail(f"there is no folder '{args.folder}'; create it or name another")
    for name, text in lists(project.ROOT).items():
        try:
            (args.folder / name).write_text(text, encoding="utf-8")
        except OSError as error:
            project.fail(f"{args.folder / name}: cannot be written: {error.strerror}")
    return 0
