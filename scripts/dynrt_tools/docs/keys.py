# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The pages of the configurations and of their keys."""

import json
from typing import Any

from dynrt_tools import project
from dynrt_tools.build import configs
from dynrt_tools.hardware import rtl_files


def described() -> Any:
    """The package that describes each key: KEYS by name, RULES between them."""
    return configs.load_configurations()


def configurations() -> dict[str, dict[str, Any]]:
    """Every configuration of the project with every key."""
    package = configs.load_configurations()
    listed: dict[str, dict[str, Any]] = package.read(package.reading.LISTED)
    return listed


def shown(value: object) -> str:
    """A value as it stands in JSON, as code."""
    return f"`{json.dumps(value)}`"


def keys_page() -> str:
    """Each key with its values, its default and its meaning."""
    package = described()
    lines = [
        "# Keys of a configuration",
        "",
        "Each configuration of `hls/configs/configs.json` has these keys. "
        "[A configuration of your own](../how-to/configuration.md) shows how to write one: a file "
        "of yours needs neither `name` nor `about`.",
        "",
        "| key | meaning | values | default |",
        "|---|---|---|---|",
        "| `name` | how commands name it | letters, digits and `_` | must be stated |",
        "| `like` | the configuration from which all other keys come | a name | none |",
    ]
    for name, key in package.KEYS.items():
        default = "must be stated" if key.required else shown(key.default)
        if not key.inherited:
            default += "; not inherited"
        lines.append(f"| `{name}` | {key.about} | {key.kind.wants()} | {default} |")
    lines += [
        "",
        "## What one key asks of another",
        "",
        "| if | then | because |",
        "|---|---|---|",
    ]
    for rule in package.RULES:
        given = " and ".join(f"`{key}` is {shown(value)}" for key, value in rule.given.items())
        lines.append(f"| {given} | `{rule.other}` is {rule.wants} | {rule.why} |")
    lines += [
        "",
        "## How to state a key",
        "",
        'As its value, `"packets": 32`, or with a reason: '
        '`"packets": {"value": 32, "reason": "a sentence"}`. A key that no line above has, a value '
        "out of range and a configuration that is like itself are errors that name the file and "
        "the line.",
    ]
    return "\n".join(lines) + "\n"


def configurations_page() -> str:
    """What each configuration is for, and in which keys it differs from the defaults."""
    known = described().KEYS
    checked_in = project.enumerated([f"`{name}`" for name in rtl_files.all_checked_in()])
    lines = [
        "# Configurations",
        "",
        "`hls/configs/configs.json` lists them. *Verilog*: builds make its Verilog too; the others "
        f"run as C++ alone. The Verilog of {checked_in} is checked in, under `rtl/generated`, for "
        "readers without LLVM. Where no configuration is named, frames are rendered with `fast`. A "
        "frame may use fewer packets and lines than its configuration has (`--packets`, `--lines`).",
        "",
        "| configuration | Verilog | what it is for |",
        "|---|---|---|",
    ]
    listed = configurations()
    for name, config in listed.items():
        made = "yes" if config["rtl"] else "no"
        lines.append(f"| [`{name}`](#{name}) | {made} | {config['about']} |")
    for name, config in listed.items():
        lines += ["", f"## {name}", "", "| key | value |", "|---|---|"]
        for key, value in config.items():
            description = known[key]
            if description.of_core and value != description.default:
                lines.append(f"| `{key}` | {shown(value)} |")
        lines.append("| all others | the [default](keys.md) |")
    return "\n".join(lines) + "\n"
