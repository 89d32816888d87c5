# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Which modules are proved, with which parameters and properties."""

import functools
import pathlib
import re
import tempfile
from dataclasses import dataclass
from typing import Any

from dynrt_tools.formal import flow, pair
from dynrt_tools.hardware import rtl_files
from dynrt_tools.project import ROOT, Json, read_json, searched

GENERATED = rtl_files.GENERATED
PROPERTIES = ROOT / "verif/formal/properties"
OPEN = ROOT / "verif/formal/open"
LOWERED = [pathlib.Path("build/dev/generated/formal")]
INCLUDES = (GENERATED,)
OUTPUT = re.compile(r"^  output wire (\w+)_valid_o,", re.MULTILINE)
WRITTEN_IN = re.compile(r"assign lines_en_o = valid_s(\d+)")
LATENCY = re.compile(r"latency (\d+) clocks")


@dataclass(frozen=True)
class Instance:
    module: str
    parameters: Json
    sources: list[pathlib.Path]
    carrier: str  # the module that the properties are read in
    properties: str
    top: str = ""  # the module itself if there is none around it
    opened: tuple[str, ...] = ()  # of the sources
    clocks: int = 0  # of the induction, if that is known

    @property
    def label(self) -> str:
        values = [f"{k.lower()}{v}" for k, v in sorted(self.parameters.items())]
        return "_".join([self.module, *values])

    def steps(self, kind: Json) -> int:
        """Clocks of the induction: a number, or how many more than the latency of the unit, or
        than a transaction of a pair takes."""
        steps = kind.get("induction")
        if self.clocks and steps:
            return self.clocks + int(steps.removeprefix("pair + "))
        if isinstance(steps, str):
            text = self.sources[-1].read_text(encoding="utf-8")
            return int(searched(LATENCY.pattern, text)[1]) + int(steps.removeprefix("latency + "))
        return int(steps or 0)


@functools.cache
def core() -> list[tuple[str, Json]]:
    """Every module of the elaborated core: pairs of its name and its parameters."""
    files = rtl_files.core_files()
    with tempfile.TemporaryDirectory() as folder:
        script = [
            f"verilog_defaults -add -I{GENERATED}",
            *(f"read_verilog {f}" for f in files),
            "hierarchy -check -top dynrt_core",
            "delete p:*",
            "write_json core.json",
        ]
        code, output = flow.run(["yosys", "-q", "-p", "; ".join(script)], pathlib.Path(folder))
        if code != 0:
            raise flow.Broken(f"yosys cannot read the core:\n{output.strip()}")
        modules = read_json(pathlib.Path(folder, "core.json"))
    return [
        (
            name.split("\\")[-1] if not name.startswith("$paramod\\") else name.split("\\")[1],
            {k: int(v, 2) for k, v in module.get("parameter_default_values", {}).items()},
        )
        for name, module in modules["modules"].items()
    ]


def primitive(stated: Json, parameters: dict[str, Any]) -> Instance:
    """A module written by hand; what it consists of is stated with it, as names of files."""
    module = stated["of"]
    properties = (PROPERTIES / f"{module}.v").read_text(encoding="utf-8")
    files = stated.get("with", [f"rtl/lib/{module}.v"])
    return Instance(module, parameters, [ROOT / f for f in files], module, properties)


def unit(module: str, parameters: dict[str, Any], stated: Json) -> Instance:
    if "against" in stated:
        return against(module, parameters, stated)
    return with_file(module, parameters, stated)


def with_file(module: str, parameters: dict[str, Any], stated: Json) -> Instance:
    """A unit with a file of properties, or several: in its FIFOs, once for each output channel if the
    text says CHANNEL, or as it is, opened if that is stated. LATENCY in it is the unit's."""
    folder = LOWERED[0] if stated.get("lowered") else GENERATED
    sources = [*rtl_files.library(), folder / f"{module}.v"]
    if not sources[-1].exists():
        raise flow.Broken(f"{sources[-1]} is missing; the target formal_units makes it")
    verilog = sources[-1].read_text(encoding="utf-8")
    files = [stated["file"]] if isinstance(stated["file"], str) else stated["file"]
    properties = "".join((PROPERTIES / f"{f}.v").read_text(encoding="utf-8") for f in files)
    for word, text in stated.get("words", {}).items():
        properties = properties.replace(word, text)
    if "inside" in stated:
        return Instance(module, parameters, sources, stated["inside"], properties)
    if "CHANNEL" in properties:
        properties = "\n".join(
            properties.replace("CHANNEL", channel) for channel in OUTPUT.findall(verilog)
        )
    written = WRITTEN_IN.search(verilog)
    if written:
        properties = properties.replace("WRITTEN_IN", written.group(1))
    properties = properties.replace("LATENCY", searched(LATENCY.pattern, verilog)[1])
    made_open = (sources[-1].name,) if stated.get("opened") else ()
    return Instance(module, parameters, sources, module, properties, opened=made_open)


def against(module: str, parameters: dict[str, Any], stated: Json) -> Instance:
    """A unit beside itself as it was lowered for another clock (pair.py)."""
    folder = LOWERED[0] if stated.get("lowered") else GENERATED
    texts = [folder / f"{m}.v" for m in (module, module + stated["against"])]
    for path in texts:
        if not path.exists():
            raise flow.Broken(f"{path} is missing; the target formal_units makes it")
    text, clocks = pair.compared(*(pair.Unit(path) for path in texts))
    return Instance(
        module,
        parameters,
        [*sorted(OPEN.glob("*.v")), *texts],
        "pair",
        text,
        top="pair",
        opened=tuple(path.name for path in texts),
        clocks=clocks,
    )


def is_unit(module: str) -> bool:
    return (GENERATED / f"{module}.v").exists() and module != "dynrt_core"


def of(stated: Json) -> list[Instance]:
    """The instances of a proof: all that the core has of a primitive, and those that stand for what
    other cores have of it; or all its units."""
    if stated["of"] == "units" or isinstance(stated["of"], list):
        names = stated["of"]
        if names == "units":
            names = sorted(m for m, _ in core() if is_unit(m))
        found = [unit(m, {}, stated) for m in names]
    else:
        found = [primitive(stated, p) for m, p in core() if m == stated["of"]]
        found += [primitive(stated, p) for p in stated.get("besides", [])]
    if not found:
        raise flow.Broken(f"the core has no {stated['of']}")
    return sorted({i.label: i for i in found}.values(), key=lambda i: i.label)


def example(stated: Json) -> Instance:
    """The instance that shows that the proof is not vacuous."""
    chosen = stated["example"]
    if "unit" in chosen:
        return unit(chosen["unit"], chosen.get("parameters", {}), stated)
    return primitive(stated, chosen["parameters"])
