# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Which Verilog files belong together; shared by scripts/lint and scripts/synth."""

import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent


def fail(message):
    sys.exit(f"{pathlib.Path(sys.argv[0]).name}: {message}")


def configurations(root):
    """Names of the configurations whose generated Verilog is checked in."""
    generated = root / "rtl" / "generated"
    return sorted(p.name for p in generated.iterdir() if p.is_dir()) if generated.is_dir() else []


def hand_written(root):
    return sorted(p for p in (root / "rtl").rglob("*.v") if "generated" not in p.parts)


def generated(root, config):
    """The checked-in Verilog of a configuration, or else what the last build made of it."""
    folders = [root / "rtl" / "generated" / config]
    folders += [root / "build" / preset / "generated" / config for preset in ("release", "dev")]
    for folder in folders:
        files = sorted(folder.glob("*.v"))
        if files:
            return files
    return []
