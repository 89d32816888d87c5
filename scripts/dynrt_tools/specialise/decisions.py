# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""From the needs of a scene and the measurements to every key of a configuration with its
reason."""

import pathlib
from collections.abc import Mapping, Sequence
from typing import Any

from dynrt_tools.build.configs import load_configurations
from dynrt_tools.project import Failed, Json

Measured = dict[str, tuple[Any, str]]  # by key: a value and its reason
KEYS = load_configurations().KEYS
TEXTS = [name for name, key in KEYS.items() if not key.of_core]  # of a configuration alone


def plain(stated: Any) -> Any:
    """The value of a key, which may stand beside a reason."""
    return stated["value"] if isinstance(stated, dict) else stated


def called(general_name: str) -> str:
    """A configuration's name, also of one that a file states."""
    return pathlib.Path(general_name).stem


def decide(
    keys: Mapping[str, Any],
    general_name: str,
    general: Json,
    needed: Json,
    measured: Measured,
    keep: Sequence[str],
) -> Json:
    """By key of KEYS `keys`: its value and its reason. `needed` are the decisions of `dynrt needs`,
    `measured` those of measurements, by key a value and a reason."""
    for kept in keep:
        if kept not in keys or kept in TEXTS:
            raise Failed(
                f"--keep {kept}: unknown; the keys are "
                f"{', '.join(k for k in keys if k not in TEXTS)}"
            )
    decided: Json = {}
    general_name = called(general_name)
    for name in keys:
        if name in TEXTS:
            continue
        if name in keep:
            value, reason = general[name], f"as in {general_name}: --keep asks for it"
        elif name in measured:
            value, reason = measured[name]
        else:
            value, reason = needed[name]["value"], needed[name]["reason"]
        decided[name] = {"value": value, "reason": reason}
    return decided


def configuration(scene: str, general_name: str, decided: Json) -> Json:
    """As scripts/configuration reads it, with the reasons."""
    return {
        "about": f"made for the scene {scene}, from the configuration {called(general_name)}",
        "made_for": scene,
        "made_from": general_name,
        **decided,
    }


def left_out(decided: Json, general: Json) -> list[str]:
    """The keys that are not as in the general configuration."""
    return [name for name, one in decided.items() if one["value"] != general[name]]
