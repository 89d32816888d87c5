# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The names by which a command takes a unit: that of its Verilog module, as packet_mailbox, or that of
its header, as mailbox of hls/units/mailbox.h. A header may have several modules. Each command takes
modules and headers from the list that the join of the units makes, or from Verilog made by it."""

import difflib
import pathlib
from collections.abc import Iterable, Mapping

from dynrt_tools import project


def header_name(header: str) -> str:
    """The name of a header as users give it: mailbox of units/mailbox.h."""
    return pathlib.PurePosixPath(header).stem


def modules_of(name: str, headers: Mapping[str, str]) -> list[str]:
    """The modules that a name means, none if it is unknown; `headers` has the header of each module."""
    return [name] if name in headers else [m for m, header in headers.items() if header == name]


def all_modules_of(names: Iterable[str], headers: Mapping[str, str], more: str = "") -> list[str]:
    """The modules that several names mean, each once; throws Failed for an unknown name, with the known
    ones and what `more` says of them."""
    found: dict[str, None] = {}
    for name in names:
        modules = modules_of(name, headers)
        if not modules:
            raise project.Failed(unknown(name, headers) + more)
        found |= dict.fromkeys(modules)
    return list(found)


def unknown(name: str, headers: Mapping[str, str]) -> str:
    """The sentence that refuses a name: those that look like it, and every unit."""
    known = sorted({*headers, *headers.values()})
    close = [k for k in known if name in k or k in name] or difflib.get_close_matches(name, known)
    question = f" (did you mean {' or '.join(close)}?)" if close else ""
    units = [m if m == h else f"{m} (or {h})" for m, h in sorted(headers.items())]
    return f"there is no unit '{name}'{question}; the units are {', '.join(units)}"
