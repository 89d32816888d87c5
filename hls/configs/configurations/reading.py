# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Reads configurations from JSON: inheritance, defaults and checks.

A key may be stated as its value or as {"value": ..., "reason": "a sentence"}. What is wrong is
refused in a sentence, with the line of the file where it stands.
"""

import json
import keyword
import pathlib
import re
from collections.abc import Mapping
from typing import Any

from configurations.gone import GONE
from configurations.keys import KEYS
from configurations.kinds import Sentence, whole
from configurations.rules import FLOAT_BITS, RULES

LISTED = pathlib.Path(__file__).resolve().parent.parent / "configs.json"
NAME = re.compile(r"[a-z][a-z0-9_]*")
Configuration = dict[str, Any]  # every key with its value


class Refused(Exception):
    """What is wrong, in a sentence, and the line where it stands, if that is known."""

    def __init__(self, sentence: str, line: int | None = None):
        super().__init__(sentence)
        self.line = line

    def at(self, path: pathlib.Path) -> str:
        """The sentence with the file and the line before it."""
        return f"{path}:{f'{self.line}:' if self.line else ''} {self}"


class Lined(dict[str, Any]):
    """A JSON object that knows on which line of its file it and each of its values begin."""

    line: int | None = None
    lines: Mapping[str, int] = {}


def _line_of(stated: Mapping[str, Any], key: str | None = None) -> int | None:
    """The line of a key, or of the object; none if it did not come from a file."""
    if not isinstance(stated, Lined):
        return None
    return stated.lines.get(key, stated.line) if key else stated.line


class _Decoder(json.JSONDecoder):
    """Makes every object a Lined and refuses a key that stands in one twice."""

    def __init__(self) -> None:
        super().__init__()
        self.parse_object = self._object
        # The scanner of the C library would not call parse_object.
        self.scan_once = json.scanner.py_make_scanner(self)  # type: ignore[attr-defined]

    def _object(
        self, place: tuple[str, int], strict: bool, scan_once: Any, *_: Any
    ) -> tuple[Lined, int]:
        text, start = place
        lines: list[int] = []

        def scan(text: str, index: int) -> Any:
            lines.append(text.count("\n", 0, index) + 1)
            return scan_once(text, index)

        pairs, end = json.decoder.JSONObject(  # type: ignore[attr-defined]
            place, strict, scan, None, lambda pairs: pairs
        )
        found = Lined(pairs)
        found.line = text.count("\n", 0, start) + 1
        found.lines = dict(zip((key for key, _ in pairs), lines))
        if len(found) != len(pairs):
            names = [name for name, _ in pairs]
            twice = next(i for i, name in enumerate(names) if name in names[:i])
            raise Refused(f"'{names[twice]}' is there twice; leave one", lines[twice])
        return found, end


def parse(path: pathlib.Path) -> Any:
    """What a JSON file says; its objects are Lined. Throws Refused."""
    try:
        return _Decoder().decode(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise Refused(f"cannot be read: {error.strerror}") from error
    except UnicodeDecodeError as error:
        raise Refused(f"is no text in UTF-8, see byte {error.start}") from error
    except json.JSONDecodeError as error:
        raise Refused(
            f"column {error.colno} is no JSON: {error.msg.lower()}", error.lineno
        ) from error


def _value_of(where: str, stated: Mapping[str, Any], key: str) -> Any:
    """What is stated of a key, without the reason that may stand beside it; throws Refused."""
    value = stated[key]
    if not isinstance(value, dict):
        return whole(value)
    if set(value) != {"value", "reason"} or not Sentence().allows(value["reason"]):
        raise Refused(
            f"{where}: key '{key}' is {json.dumps(value)}; write its value, or "
            '{"value": ..., "reason": "a sentence"}',
            _line_of(stated, key),
        )
    return whole(value["value"])


def _complete(where: str, stated: Mapping[str, Any]) -> Configuration:
    """Every key, in the order of KEYS, its value of the kind that it should be; throws Refused."""
    for unknown in stated:
        if unknown in GONE:
            raise Refused(
                f"{where}: the key '{unknown}' is gone; {GONE[unknown]}", _line_of(stated, unknown)
            )
        if unknown not in KEYS:
            raise Refused(
                f"{where}: unknown key '{unknown}'; the keys are {', '.join(KEYS)}",
                _line_of(stated, unknown),
            )
    config: Configuration = {}
    for name, key in KEYS.items():
        if name not in stated and key.required:
            raise Refused(
                f"{where}: lacks the key '{name}' ({key.about}), {key.kind.wants()}",
                _line_of(stated),
            )
        value = _value_of(where, stated, name) if name in stated else key.default
        if not key.kind.allows(value):
            raise Refused(
                f"{where}: key '{name}' ({key.about}) is {json.dumps(value)}; "
                f"it must be {key.kind.wants()}",
                _line_of(stated, name),
            )
        config[name] = value
    return config


def checked(name: str, stated: object) -> Configuration:
    """The configuration with every key, in the order of KEYS; throws Refused."""
    where = f"configuration '{name}'"
    if not isinstance(stated, dict):
        raise Refused(f"{where}: must be an object of keys, not {json.dumps(stated)}")
    if not NAME.fullmatch(name) or keyword.iskeyword(name):
        raise Refused(
            f"{where}: is no name; write small letters, digits and _, a letter first",
            _line_of(stated, "name"),
        )
    config = _complete(where, stated)
    bits = 1 + config["exponent_bits"] + config["mantissa_bits"]
    if bits > FLOAT_BITS:
        raise Refused(
            f"{where}: a float of 1 + {config['exponent_bits']} + {config['mantissa_bits']} = "
            f"{bits} bits; it must have {FLOAT_BITS} at most",
            _line_of(stated, "mantissa_bits"),
        )
    for rule in RULES:
        is_given = all(config[key] == value for key, value in rule.given.items())
        if is_given and not rule.wants.allows(config[rule.other]):
            raise Refused(
                f"{where}: {rule}; it is {json.dumps(config[rule.other])}",
                _line_of(stated, rule.other),
            )
    return config


def inherited(name: str, stated: Lined | dict[str, Any], known: Mapping[str, Any]) -> Lined:
    """What is stated of a configuration, after what it is like; throws Refused.

    `known` are the configurations that it may be like, each with what is stated of it."""
    own = Lined({key: value for key, value in stated.items() if key not in ("name", "like")})
    own.line, own.lines = _line_of(stated), getattr(stated, "lines", {})
    if "like" not in stated:
        return own
    like = stated["like"]
    if not isinstance(like, str) or like not in known:
        wrong = "itself" if like == name else json.dumps(like)
        choices = ", ".join(known) or "none; it is the first"
        raise Refused(
            f"configuration '{name}': is like {wrong}; the configurations before it are {choices}",
            _line_of(stated, "like"),
        )
    base = {k: v for k, v in known[like].items() if k not in KEYS or KEYS[k].inherited}
    merged = Lined(base | own)
    merged.line, merged.lines = own.line, own.lines
    return merged


def read(
    path: pathlib.Path, base: Mapping[str, Configuration] | None = None
) -> dict[str, Configuration]:
    """Every configuration of a list, by name, with every key; throws Refused.

    One may be like those before it and those of `base`."""
    entries = parse(path)
    if not isinstance(entries, list) or not entries:
        raise Refused("must be a list of one or more configurations")
    stated: dict[str, Mapping[str, Any]] = dict(base or {})
    configs: dict[str, Configuration] = {}
    for number, entry in enumerate(entries, start=1):
        if not isinstance(entry, Lined) or not isinstance(entry.get("name"), str):
            line = entry.line if isinstance(entry, Lined) else None
            raise Refused(f"configuration {number} of the list must be an object with a name", line)
        name = entry["name"]
        if name in configs:
            raise Refused(f"configuration '{name}' is there twice; leave one", entry.lines["name"])
        stated[name] = inherited(name, entry, stated)
        configs[name] = checked(name, stated[name])
    return configs


def listed() -> dict[str, Configuration]:
    """The project's configurations, by name; throws Refused."""
    return read(LISTED)


def read_one(path: pathlib.Path, name: str) -> Configuration:
    """The one configuration that a user's file states; it may be like one that is listed."""
    stated = parse(path)
    if not isinstance(stated, Lined):
        raise Refused("must be an object of keys")
    if "name" in stated:
        raise Refused(
            "key 'name' has no place here; the file's name is its name", stated.lines["name"]
        )
    stated.setdefault("about", f"made of {path.name}")
    return checked(name, inherited(name, stated, listed()))
