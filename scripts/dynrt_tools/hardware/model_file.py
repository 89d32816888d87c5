# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The files of hlsc's delay models: which is of a device, and how a fit writes its constants."""

import json
import pathlib
import re

from dynrt_tools import project
from dynrt_tools.hardware import devices, placers
from dynrt_tools.project import read_json

FITTED = "Fitted by scripts/fit-delays"


def path_of(device: str, grade: str) -> pathlib.Path:
    """The model of a device's grade, which may not exist yet: the device's own is of its first."""
    if device not in devices.DEVICES or not devices.DEVICES[device]["delay"]:
        raise project.Failed(
            f"hlsc has no delay model of '{device}'; add one to hls/compiler/delay"
        )
    first = project.ROOT / devices.DEVICES[device]["delay"]
    return (
        first
        if grade in ("", placers.grade_of(device, ""))
        else first.with_name(f"{first.stem}-{grade}.json")
    )


def base_of(path: pathlib.Path) -> pathlib.Path:
    """The file that a model without one starts from."""
    return path if path.exists() else path.with_name(f"{path.stem.rpartition('-')[0]}.json")


def constants(path: pathlib.Path) -> dict[str, float]:
    """The numbers of a model's file."""
    return {k: v for k, v in read_json(path).items() if k not in ("name", "comment")}


def read(path: pathlib.Path) -> dict[str, float]:
    """The constants of a model, or those that it starts from."""
    return constants(base_of(path))


def write(path: pathlib.Path, model: dict[str, float], placed: str) -> None:
    """Puts constants into a model's file, each in its line, and says what they were fitted to."""
    base = base_of(path)
    text = base.read_text(encoding="utf-8")
    before = constants(base)
    for name, value in model.items():
        if value == before[name]:
            continue  # it stays as it is written
        text = re.sub(rf'("{name}": )[-\d.e]+', rf"\g<1>{value:g}", text)
    first, *others = read_json(base)["comment"]
    others = [line for line in others if not line.startswith(FITTED)]
    if base != path:
        grade = path.stem.rpartition("-")[2]
        text = re.sub(r'("name": ".*?)\d+"', rf'\g<1>{grade}"', text)
        others = []
    comment = [first, f"{FITTED} to {placed}.", *others]
    listed = ",\n".join(f"    {json.dumps(line)}" for line in comment)
    text = re.sub(
        r'"comment": \[.*?\n  \]', lambda _: f'"comment": [\n{listed}\n  ]', text, flags=re.DOTALL
    )
    path.write_text(text, encoding="utf-8")
