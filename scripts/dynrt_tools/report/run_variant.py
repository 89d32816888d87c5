# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Renders a scene with a variant and holds it beside the truth.

Usage: scripts/run_variant PROGRAM SCENE SIZE MODEL.so FIGURES.json PICTURES [SCHEDULES]

A scene that the variant cannot hold is a result too: its figures say why.
"""


import json
import pathlib
import subprocess
import sys

MISTAKE = 2  # dynrt's exit code where the input cannot be rendered


def main() -> None:
    program, scene, size, model, figures, pictures, *schedules = sys.argv[1:]
    pathlib.Path(pictures).mkdir(parents=True, exist_ok=True)
    clocks = ["--schedule", schedules[0]] if schedules else []
    result = subprocess.run(
        [
            program,
            "measure",
            scene,
            "--config",
            model,
            "--size",
            size,
            "--out",
            pictures,
            "--json",
            figures,
            *clocks,
        ],
        capture_output=True,
        text=True,
        check=False,
    )
    sentence = result.stderr.strip().removeprefix("dynrt: ")
    # What cannot be written or loaded is nothing that the variant could help.
    defect = any(path in sentence for path in (model, pictures, figures))
    if result.returncode == MISTAKE and not defect:
        pathlib.Path(figures).write_text(json.dumps({"refused": sentence}), encoding="utf-8")
        return
    if result.returncode != 0:
        sys.exit(sentence or f"{program} ended with {result.returncode}")
