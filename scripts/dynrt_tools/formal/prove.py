# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Proves the properties that proofs.json states.

A proof succeeds only if every property holds of every instance, if every cover statement is
reached, so that no assumption makes it empty, and if every mutation of the Verilog breaks the
property that it is meant to break.
"""

import argparse
import json
import pathlib
import sys

from dynrt_tools.formal import flow, instances, opened
from dynrt_tools.project import ROOT, Json, read_json

INTRODUCTION = """\
Every line of the table is a test of the label `formal`. A proof by induction holds for ever and for
every input that the writer's promises allow. *Every instance* means all parameters with which the core
`thesis` uses the module. *Every unit* means its units as `hlsc` lowered them. A unit `tiny_...` is
lowered with the small numbers and tables of
[verif/formal/units/tiny.h](../../verif/formal/units/tiny.h). Each test also reaches every cover
statement of its properties, and sees a mutation of the Verilog break each property. So no property
holds for want of a case. A file without an assertion is an error. `scripts/prove NAME` runs one proof
and prints its seconds; the target `formal_page` writes this page.

**How the proofs work together.** Each output of a unit is a FIFO (`streams`). The unit sends no more
than the FIFO has room for (`promise`), and the FIFO keeps tokens and their order (`hls_fifo`). A cache
writes a row whole, from one token (`cache_fill`). The row reads as it was written (`hls_ram_1r1w`). The
cache answers with it only if its tag is the address of the request (`cache_lookup`).

**Units in several stages.** `one_stage` compares two versions of a unit: the unit as lowered for the
project's clock, and the unit as lowered for a clock so long that only a RAM makes a stage. Both take
the same tokens, and the proof shows that they give the same tokens, rows and addresses. In this proof
the FIFOs are wires. The contents of RAMs, register files and registers are free, but the same for both
versions: the same transactions read and write them, at the same rows, with the same data. The order of
these accesses is a promise. `HLS_ASSERT` checks it for a RAM within a unit, and the core keeps it for a
RAM between units. For a register or a register file it is proved, since all of its accesses lie in one
stage.

This proof does not cover one unit. The shading takes eight bits of a mantissa and multiplies
coordinates and colours of ten bits and more, whatever the format, which no solver has finished yet.
Only co-simulation compares it with the C++. The transformation has floats of two bits of mantissa here.

**Two clocks.** In the proof of `hls_clock_fifo` a step is an edge of one clock, of the other, or of both,
in any order. A register that takes a signal of the other clock gets the value before the step. A real one
may settle late, to the old or the new value. As one bit of a count changes at a time (`one_bit`), that is
a count which the other side might have had anyway, an edge earlier or later.

**Buses.** The rules of [AXI4](../../verif/bus/axi4_rules.v) and of
[Wishbone](../../verif/bus/wishbone_rules.v) are modules, written from the specifications. A proof of a
module of `rtl/bus` asserts those of its end of the bus and assumes those of the other end; the
simulations of `verif/bus` assert both. The proofs take small numbers for the widths and for what is in
flight. That a FIFO keeps its tokens is proved of `hls_fifo`.

**A limit of `hls_fork`.** A reader may see valid fall again before it was ready, because another reader
stops being ready. Every reader in the core is a unit or a FIFO, and these remember nothing of a token
that they did not take."""


class Proof:
    def __init__(self, name: str, stated: Json, work: pathlib.Path) -> None:
        self.name = name
        self.stated = stated
        self.work = work / name
        self.example = stated["example"]

    def design(
        self,
        instance: instances.Instance,
        name: str,
        keep: str | None = None,
        mutation: Json | None = None,
        reach: str | None = None,
        whole: bool = True,
    ) -> flow.Design:
        """The instance with its properties; mutation: changed, reach: with that cover statement
        alone; whole: with all that is cut elsewhere."""
        properties = instance.properties
        properties = (
            flow.covers_as_assertions(properties) if reach else flow.without_covers(properties)
        )
        if mutation and mutation["in"] == "properties":
            properties = flow.mutated(properties, mutation)
        texts = []
        for path in instance.sources:
            text = path.read_text(encoding="utf-8")
            if mutation and path.name == mutation["in"]:
                text = flow.mutated(text, mutation)
            if path.name in instance.opened:
                text = opened.opened(text)
            if path.stem == instance.carrier:
                text = flow.with_properties(text, instance.carrier, properties)
            texts.append((path.name, text))
        return flow.Design(
            self.work / name,
            texts,
            instance.top or instance.module,
            instance.parameters,
            self.stated["solver"],
            keep=keep or reach,
            cut=() if whole else self.stated.get("cut", ()),
            trim=() if whole else self.stated.get("trim", ()),
            includes=instances.INCLUDES,
            own_clocks=self.stated.get("own_clocks", False),
        )

    def prove(self, instance: instances.Instance) -> list[str]:
        """The names of the assertions that hold; throws Broken."""
        design = self.design(instance, instance.label, whole=False)
        kind = self.stated["kind"]
        steps = instance.steps(kind)
        checks = [("from the start", design.holds, steps + 1 if steps else kind["bounded"])]
        if steps:
            checks.append(("from clock to clock", design.steps, steps))
        for what, check, clocks in checks:
            passed, why = check(clocks)
            if not passed:
                raise flow.Broken(
                    f"{self.name}, {instance.label}: does not hold {what}; the "
                    f"waveform is in {design.folder}\n{why}"
                )
        return design.assertions

    def reach(self, instance: instances.Instance) -> None:
        names = flow.covers(instance.properties)
        if not names:
            raise flow.Broken(f"{self.name}: no cover statement shows that it is not vacuous")
        for name in names:
            passed, _ = self.design(instance, f"reach_{name}", reach=name).holds(
                self.example["clocks"]
            )
            if passed:
                raise flow.Broken(
                    f"{self.name}: is vacuous, '{name}' is not reached in "
                    f"{self.example['clocks']} clocks"
                )

    def mutate(self, instance: instances.Instance) -> None:
        mutations = self.stated["mutations"]
        spared = set(self.stated["properties"]) - {m["breaks"] for m in mutations}
        if spared:
            raise flow.Broken(f"{self.name}: no mutation breaks {', '.join(sorted(spared))}")
        for number, mutation in enumerate(mutations, 1):
            other = mutation.get("parameters")
            broken = instances.primitive(self.stated, other) if other else instance
            design = self.design(
                broken, f"mutation{number}", keep=mutation["breaks"], mutation=mutation
            )
            passed, _ = design.holds(mutation.get("clocks", self.example["clocks"]))
            if passed:
                raise flow.Broken(
                    f"{self.name}: {mutation['breaks']} does not notice that "
                    f"'{mutation['from']}' became '{mutation['to']}'"
                )

    def run(self) -> Json:
        """The results, as data; throws Broken."""
        began = flow.seconds()
        found = instances.of(self.stated)
        proved = set()
        for instance in found:
            proved.update(self.prove(instance))
        missing = {
            name
            for name in self.stated["properties"]
            if not any(f"_{a}".endswith(f"_{name}") for a in proved)
        }
        if missing:
            raise flow.Broken(
                f"{self.name}: no assertion has the name {', '.join(sorted(missing))}"
            )
        example = instances.example(self.stated)
        self.reach(example)
        self.mutate(example)
        return {"seconds": round(flow.seconds() - began, 1), "instances": len(found)}


def page(stated: Json) -> str:
    """docs/reference/proofs.md: the properties, their instances and the kind of each proof."""
    lines = (
        [
            "<!-- Written by scripts/prove --page from verif/formal/proofs.json. -->",
            "# What is proved",
            "",
        ]
        + INTRODUCTION.splitlines()
        + ["", "| proof | property | of | kind |", "|---|---|---|---|"]
    )
    for name, proof in stated.items():
        kind = proof["kind"]
        if "bounded" in kind:
            how = f"bounded, {kind['bounded']} clocks"
        else:
            clocks = str(kind["induction"]).replace("pair", "a transaction's")
            how = f"induction over {clocks} clock{'' if clocks == '1' else 's'}"
        of = proof["of"]
        if isinstance(of, list):
            of = ", ".join(f"`{unit}`" for unit in of)
        elif "with" in proof:
            of = f"`{of}`"
        else:
            of = "every unit" if of == "units" else "every instance"
        for label, sentence in proof["properties"].items():
            lines.append(f"| `{name}` | `{label}`: {sentence} | {of} | {how} |")
            of = how = '"'
    return "\n".join(lines) + "\n"


def main() -> int:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("names", nargs="*", help="proofs (default: all)")
    parser.add_argument(
        "--work",
        type=pathlib.Path,
        default=pathlib.Path("build/formal"),
        help="folder for designs, waveforms and results",
    )
    parser.add_argument("--list", action="store_true", help="print the names and labels for CMake")
    parser.add_argument(
        "--lowered",
        type=pathlib.Path,
        default=instances.LOWERED[0],
        help="folder of the Verilog that hlsc made of units/*.h",
    )
    parser.add_argument("--page", type=pathlib.Path, help="write docs/reference/proofs.md")
    parser.add_argument(
        "--check-page",
        type=pathlib.Path,
        help="fail if the page and proofs.json disagree",
    )
    args = parser.parse_args()
    instances.LOWERED[0] = args.lowered.resolve()
    stated = read_json(ROOT / "verif/formal/proofs.json")
    for name in args.names:
        if name not in stated:
            sys.exit(f"there is no proof '{name}'; there are {', '.join(stated)}")
    if args.list:
        for name, proof in stated.items():
            print(name, *proof.get("labels", []))
        return 0
    if args.page:
        args.page.write_text(page(stated), encoding="utf-8")
        return 0
    if args.check_page:
        if args.check_page.read_text(encoding="utf-8") != page(stated):
            sys.exit(
                f"{args.check_page} and proofs.json disagree; the target "
                "formal_page writes it again"
            )
        return 0
    for name in args.names or stated:
        try:
            result = Proof(name, stated[name], args.work.resolve()).run()
        except flow.Broken as error:
            print(error, file=sys.stderr)
            return 1
        (args.work / f"{name}.json").write_text(json.dumps(result) + "\n", encoding="utf-8")
        print(
            f"{name}: {len(stated[name]['properties'])} properties hold of {result['instances']} "
            f"instances, {len(stated[name]['mutations'])} mutations are noticed; "
            f"{result['seconds']} s of processor time"
        )
    return 0
