# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Renders a scene with a variant and compares it with the truth. A scene that the variant cannot
hold is a result too: its figures give the reason."""

import argparse
import json
import pathlib
import subprocess
import sys

MISTAKE = 2  # dynrt's exit code where the input cannot be rendered


def main() -> None:
    parser = argparse.ArgumentParser(prog="scripts/run_variant", description=__doc__)
    parser.add_argument("program", metavar="PROGRAM", help="the program dynrt")
    parser.add_argument("scene", metavar="SCENE", help="a built-in scene or a file")
    parser.add_argument("size", metavar="WxH", help="pixels of the image")
    parser.add_argument("model", metavar="MODEL.so", help="the variant's native model")
    parser.add_argument("figures", metavar="FIGURES.json", help="the file that receives the result")
    parser.add_argument("pictures", metavar="PICTURES", help="the folder that receives the images")
    parser.add_argument(
        "schedules", metavar="SCHEDULES", nargs="?", help="the folder of the variant's Verilog"
    )
    args = parser.parse_args()
    figures, pictures = pathlib.Path(args.figures), pathlib.Path(args.pictures)
    pictures.mkdir(parents=True, exist_ok=True)
    clocks = ["--schedule", args.schedules] if args.schedules else []
    result = subprocess.run(
        [
            args.program,
            "measure",
            args.scene,
            *("--config", args.model, "--size", args.size),
            *("--out", pictures, "--json", figures),
            *clocks,
        ],
        capture_output=True,
        text=True,
        check=False,
    )
    sentence = result.stderr.strip().removeprefix("dynrt: ")
    # A file that cannot be written or loaded is no property of the variant.
    defect = any(path in sentence for path in (args.model, args.pictures, args.figures))
    if result.returncode == MISTAKE and not defect:
        figures.write_text(json.dumps({"refused": sentence}), encoding="utf-8")
        return
    if result.returncode != 0:
        sys.exit(sentence or f"{args.program} ended with {result.returncode}")
