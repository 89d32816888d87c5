# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Which modules are proved, with which parameters and properties."""
import functools
import json
import pathlib
import re
import tempfile
from dataclasses import dataclass

import flow

LIBRARY = flow.ROOT / "rtl/lib"
GENERATED = flow.ROOT / "rtl/generated/thesis"
PROPERTIES = flow.ROOT / "verif/formal/properties"
LOWERED = [pathlib.Path("build/dev/generated/formal")]
INCLUDES = (GENERATED,)
OUTPUT = re.compile(r"^  output wire (\w+)_valid_o,", re.MULTILINE)
WRITTEN_IN = re.compile(r"assign lines_en_o = valid_s(\d+)")
LATENCY = re.compile(r"latency (\d+) clocks")


@dataclass(frozen=True)
class Instance:
    module: str
    parameters: dict
    sources: list
    carrier: str  # the module that the properties are read in
    properties: str

    @property
    def label(self):
        values = [f"{k.lower()}{v}" for k, v in sorted(self.parameters.items())]
        return "_".join([self.module, *values])

    def steps(self, kind):
        """Clocks of the induction: a number, or how many more than the latency of the unit."""
        steps = kind.get("induction")
        if isinstance(steps, str):
            text = self.sources[-1].read_text(encoding="utf-8")
            return int(LATENCY.search(text).group(1)) + int(steps.removeprefix("latency + "))
        return steps


@functools.cache
def core():
    """Every module of the elaborated core: pairs of its name and its parameters."""
    files = [*sorted(LIBRARY.glob("*.v")), *sorted(GENERATED.glob("*.v"))]
    with tempfile.TemporaryDirectory() as folder:
        script = [f"verilog_defaults -add -I{GENERATED}", *(f"read_verilog {f}" for f in files),
                  "hierarchy -check -top dynrt_core", "delete p:*", "write_json core.json"]
        code, output = flow.run(["yosys", "-q", "-p", "; ".join(script)], folder)
        if code != 0:
            raise flow.Broken(f"yosys cannot read the core:\n{output.strip()}")
        modules = json.loads(pathlib.Path(folder, "core.json").read_text(encoding="utf-8"))
    return [(name.split("\\")[-1] if not name.startswith("$paramod\\") else name.split("\\")[1],
             {k: int(v, 2) for k, v in module.get("parameter_default_values", {}).items()})
            for name, module in modules["modules"].items()]


def primitive(module, parameters):
    properties = (PROPERTIES / f"{module}.v").read_text(encoding="utf-8")
    return Instance(module, parameters, [LIBRARY / f"{module}.v"], module, properties)


def unit(module, parameters, stated):
    if "against" in stated:
        return against(module, parameters, stated)
    return with_file(module, parameters, stated)


def with_file(module, parameters, stated):
    """A unit with a file of properties: in its FIFOs, once for each output channel if the text says
    CHANNEL, or as it is. LATENCY in it is the unit's."""
    folder = LOWERED[0] if stated.get("lowered") else GENERATED
    sources = [*sorted(LIBRARY.glob("*.v")), folder / f"{module}.v"]
    if not sources[-1].exists():
        raise flow.Broken(f"{sources[-1]} is missing; the target formal_units makes it")
    verilog = sources[-1].read_text(encoding="utf-8")
    properties = (PROPERTIES / f"{stated['file']}.v").read_text(encoding="utf-8")
    for word, text in stated.get("words", {}).items():
        properties = properties.replace(word, text)
    if "inside" in stated:
        return Instance(module, parameters, sources, stated["inside"], properties)
    if "CHANNEL" in properties:
        properties = "\n".join(properties.replace("CHANNEL", channel)
                               for channel in OUTPUT.findall(verilog))
    written = WRITTEN_IN.search(verilog)
    if written:
        properties = properties.replace("WRITTEN_IN", written.group(1))
    properties = properties.replace("LATENCY", LATENCY.search(verilog).group(1))
    return Instance(module, parameters, sources, module, properties)


PORT = re.compile(r"^  (input|output) +wire (\[\d+:0\] )?(\w+)_(valid|data)_[io],?$", re.MULTILINE)


def against(module, parameters, stated):
    """A unit with one that was lowered for another clock inside: what they give is to be the same.
    Both take the same tokens in the same clock, and their tokens are taken when both have some."""
    slow = stated["against"][module]
    texts = {m: (LOWERED[0] / f"{m}.v") for m in (module, slow)}
    verilog = texts[module].read_text(encoding="utf-8")
    ports = PORT.findall(verilog)
    valids = [(way, name) for way, _, name, kind in ports if kind == "valid"]
    widths = {name: width for _, width, name, kind in ports if kind == "data"}
    pins, checks = [".clk_i(clk_i)", ".rst_ni(rst_ni)", ".fire_o(slow_fire)"], []
    if "frame_i" in verilog:
        pins.append(".frame_i(frame_i)")
    lines = ["  wire slow_fire;"]
    for way, name in valids:
        if way == "input":
            pins += [f".{name}_valid_i(fire_o)", f".{name}_data_i({name}_data_i)"]
            continue
        lines.append(f"  wire slow_{name}_valid;\n  wire {widths[name]}slow_{name}_data;")
        pins += [f".{name}_valid_o(slow_{name}_valid)", f".{name}_data_o(slow_{name}_data)",
                 f".{name}_ready_i({name}_ready_i)"]
        checks.append((name, f"{name}_valid_o && slow_{name}_valid"))
    lines.append(f"  {slow} slow ({', '.join(pins)});")
    lines += (PROPERTIES / "against.v").read_text(encoding="utf-8").splitlines()
    for name, both in checks:
        lines += ["  always @* begin", f"    if ({name}_ready_i) assume ({both});",
                  f"    if (was_reset_q && {both}) {name}_same: "
                  f"assert ({name}_data_o == slow_{name}_data);",
                  "    if (was_reset_q && quiet_q > LATENCY) "
                  f"{name}_none_lost: assert ({name}_valid_o == slow_{name}_valid);",
                  f"    {name}_given: cover (was_reset_q && {both} && {name}_ready_i);", "  end"]
    text = "\n".join(lines) + "\n"
    text = text.replace("LATENCY", LATENCY.search(verilog).group(1))
    sources = [*sorted(LIBRARY.glob("*.v")), texts[slow], texts[module]]
    return Instance(module, parameters, sources, module, text)


def is_unit(module):
    return (GENERATED / f"{module}.v").exists() and module != "dynrt_core"


def of(stated):
    """The instances of a proof: all that the core has of a primitive, or all its units."""
    if stated["of"] == "units" or isinstance(stated["of"], list):
        names = stated["of"]
        if names == "units":
            names = sorted(m for m, _ in core() if is_unit(m))
        found = [unit(m, {}, stated) for m in names]
    else:
        found = [primitive(m, p) for m, p in core() if m == stated["of"]]
    if not found:
        raise flow.Broken(f"the core has no {stated['of']}")
    return sorted({i.label: i for i in found}.values(), key=lambda i: i.label)


def example(stated):
    """The instance that shows that the proof is not vacuous."""
    chosen = stated["example"]
    if "unit" in chosen:
        return unit(chosen["unit"], chosen.get("parameters", {}), stated)
    return primitive(stated["of"], chosen["parameters"])
