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


def generated(root, config):
    """The Verilog that hlsc made of a configuration: checked in, or else from the last build."""
    folders = [root / "rtl" / "generated" / CHECKED_IN] if config == CHECKED_IN else []
    folders += [root / "build" / preset / "generated" / config for preset in ("release", "dev")]
    return next((files for f in folders if (files := sorted(f.glob("*.v")))), [])


def include_folders(files):
    return sorted({f.parent for f in files})
