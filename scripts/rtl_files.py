# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Which Verilog files belong together; shared by scripts/lint and scripts/synth."""

import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent


def fail(message):
    sys.exit(f"{pathlib.Path(sys.argv[0]).name}: {message}")


# The one configuration whose generated Verilog is checked in.
CHECKED_IN = "thesis"


def hand_written(root):
    return sorted(p for p in (root / "rtl").rglob("*.v") if "generated" not in p.parts)


def add_arguments(parser):
    """The flags that choose a configuration."""
    parser.add_argument("--config", default=CHECKED_IN, metavar="NAME",
                        help=f"configuration (default: {CHECKED_IN}, which is checked in)")
    parser.add_argument("--build", type=pathlib.Path, metavar="FOLDER",
                        help="the build that made the Verilog of the other configurations "
                        "(default: build/release, else build/dev)")


def generated(root, args):
    """The Verilog that hlsc made of a configuration: checked in, or else from a build."""
    builds = [args.build] if args.build else [root / "build" / p for p in ("release", "dev")]
    folders = [root / "rtl" / "generated" / CHECKED_IN] if args.config == CHECKED_IN else []
    folders += [build / "generated" / args.config for build in builds]
    files = next((files for f in folders if (files := sorted(f.glob("*.v")))), [])
    if not files:
        fail(f"no generated Verilog of configuration '{args.config}'; '{CHECKED_IN}' is checked "
             f"in, the others are in {' or '.join(str(b) for b in builds)} once it is built")
    return files


def check_output(flag, path):
    """Refuses a file that could not be written, before the work."""
    folder = path.absolute().parent
    if not folder.is_dir():
        fail(f"{flag} {path}: there is no folder '{path.parent}'; create it or name a file elsewhere")
    new = not path.exists()
    try:
        with path.open("a", encoding="utf-8"):
            pass
    except OSError:
        fail(f"{flag} {path}: cannot be written; name a file that can")
    if new:
        path.unlink()


def include_folders(files):
    return sorted({f.parent for f in files})
