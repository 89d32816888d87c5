# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""From Verilog and its properties to a verdict, by Yosys and yosys-smtbmc.

Properties are Verilog that is read inside the module that they are about, before its endmodule, so
that they see its registers. Every assertion with a name is a property; those without one say why
the named ones hold, and serve the induction alone. Every cover statement has a name too.
"""

import pathlib
import re
import resource
import subprocess
from collections.abc import Iterable
from typing import Any

from dynrt_tools.project import ROOT, Failed

COVER = re.compile(r"^(\s*(?:if \(.*\) )?)(\w+): cover \((.*)\);$", re.MULTILINE)
STAGE = re.compile(r"_s(\d+)\b")
LAST_STAGE = 40
PREPARE = (
    "async2sync; opt -keepdc -fast; dffunmap; setundef -undriven -anyseq; opt_clean; "
    "tee -o assertions.txt select -list t:$assert"
)
OWN_CLOCKS = ("async2sync", "dffunmap", f"techmap -map {ROOT}/verif/formal/two_clocks.v")


class Broken(Failed):
    """A proof that did not come out as it should; the message is a sentence."""


def seconds() -> float:
    """Of processor time that Yosys and the solvers have taken, whatever else the machine does."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def run(command: list[str], folder: pathlib.Path) -> tuple[int, str]:
    result = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    return result.returncode, result.stdout + result.stderr


def written(verilog: str, what: str, channel: str) -> tuple[str, str]:
    """The expression of what ("valid" or "data") a unit writes to the FIFO of a channel, and the
    wire that it needs. Of a token only the bits that are not constant are written: the whole one is
    put together behind the FIFO."""
    found = re.search(
        rf"hls_fifo #\(\.WIDTH\((?P<width>\d+)\)[^;]*?"
        rf"\.valid_i\((?P<valid>.*)\), \.ready_o\({channel}_room\),\n"
        rf"\s*\.data_i\((?P<data>.*)\),\n.*\.data_o\({channel}_(?P<out>\w+)\)\);",
        verilog,
    )
    if not found:
        raise Broken(f"no FIFO of a channel {channel} is written")
    if what == "valid" or found["out"] == "data_o":
        return found[what], ""
    token = re.search(rf"assign {channel}_data_o = (.*);", verilog)
    if not token:
        raise Broken(f"nothing puts a token of the channel {channel} together")
    wire = f"{channel}_written"
    return (
        token[1].replace(f"{channel}_stored", wire),
        f"  wire [{int(found['width']) - 1}:0] {wire} = {found['data']};\n",
    )


def with_properties(verilog: str, module: str, properties: str) -> str:
    """The Verilog with the properties inside the module; throws Broken.

    WRITTEN_VALID(c) and WRITTEN_DATA(c) in them are what the module writes to the FIFO of c."""
    start = re.search(rf"^module {re.escape(module)}\b", verilog, re.MULTILINE)
    if not start:
        raise Broken(f"there is no module {module} to prove anything of")
    end = verilog.index("\nendmodule", start.start()) + 1
    wires = set()

    def replaced(match: re.Match[str]) -> str:
        expression, wire = written(verilog, match.group(1).lower(), match.group(2))
        wires.add(wire)
        return expression

    properties = re.sub(r"WRITTEN_(VALID|DATA)\((\w+)\)", replaced, properties)
    return verilog[:end] + "".join(sorted(wires)) + properties + verilog[end:]


def without_covers(properties: str) -> str:
    return COVER.sub("", properties)


def covers(properties: str) -> list[str]:
    return [match.group(2) for match in COVER.finditer(properties)]


def covers_as_assertions(properties: str) -> str:
    """A cover statement is reached if the solver finds a way to break its negation."""
    return COVER.sub(r"\1\2: assert (!(\3));", properties)


def mutated(verilog: str, mutation: dict[str, str]) -> str:
    """The Verilog with one text in another's place; throws Broken.

    A schedule decides in which stage a text stands: if it is not there, its stages (_s1) all count
    from the nearest one where it is.
    """
    source, place = mutation["from"], mutation["in"]
    for shift in sorted(range(-LAST_STAGE, LAST_STAGE + 1), key=abs):
        text = later(source, shift)
        times = verilog.count(text)
        if times == 1:
            return verilog.replace(text, later(mutation["to"], shift))
        if times or not STAGE.search(source):
            break
    raise Broken(
        f"a mutation's text is {times} times in {place}, it must be there once: "
        f"{text if times else source}"
    )


def later(text: str, shift: int) -> str:
    """A text of the stages that are so many later."""
    return STAGE.sub(lambda stage: f"_s{int(stage[1]) + shift}", text)


class Design:
    """A module with its properties, ready for a solver.

    solver "smt": yosys-smtbmc with Z3, which knows memories as arrays; "sat": Yosys's own, which
    sees nothing but bits and is the faster one where there is much data and no memory.
    """

    def __init__(
        self,
        folder: pathlib.Path,
        sources: Iterable[tuple[str, str]],
        top: str,
        parameters: dict[str, Any],
        solver: str,
        keep: str | None = None,
        cut: Iterable[str] = (),
        trim: Iterable[str] = (),
        includes: Iterable[pathlib.Path] = (),
        own_clocks: bool = False,
    ) -> None:
        """sources: pairs of a file's name and its text; keep: the name of the assertions that
        remain; cut and trim: Yosys commands, before and after the modules become one, that
        leave out what the proof needs nothing of; own_clocks: a step is an edge of some of the
        clocks, any, not of all."""
        self.folder = folder
        self.solver = solver
        self.top = top
        folder.mkdir(parents=True, exist_ok=True)
        for file, text in sources:
            (folder / file).write_text(text, encoding="utf-8")
        self.script = [f"verilog_defaults -add -I{i}" for i in includes]
        self.script += [f"read_verilog -formal {file}" for file, _ in sources]
        self.script += [
            "hierarchy -check -top "
            + top
            + "".join(f" -chparam {k} {v}" for k, v in parameters.items()),
            "proc",
            *cut,
            "flatten",
            *trim,
            *(OWN_CLOCKS if own_clocks else ()),
        ]
        if keep:
            self.script += [f"delete t:$assert n:*{keep} %d"]
        self.script += ["memory_map" if solver == "sat" else "memory_nordff", PREPARE]
        if solver == "smt":
            self.yosys(*self.script, "write_smt2 -wires design.smt2")
        else:
            self.yosys(*self.script, "write_rtlil design.il")
        listed = (folder / "assertions.txt").read_text(encoding="utf-8").split()
        self.assertions = [re.split(r"[/.\\]", name)[-1] for name in listed if "$" not in name]
        if not listed:
            raise Broken(f"no assertion was found in {top}, so nothing would be proved ({folder})")

    def yosys(self, *script: str) -> None:
        code, output = run(["yosys", "-q", "-p", "; ".join(script)], self.folder)
        if code != 0:
            raise Broken(f"yosys cannot read it ({self.folder}):\n{output.strip()}")

    def holds(self, clocks: int) -> tuple[bool, str]:
        """In so many clocks from the start: whether it does, and what says otherwise."""
        if self.solver == "smt":
            return self.smtbmc("-t", str(clocks), "--dump-vcd", "failed.vcd")
        return self.sat("-tempinduct-baseonly", clocks)

    def steps(self, clocks: int) -> tuple[bool, str]:
        """If in so many clocks, then in the next."""
        if self.solver == "smt":
            return self.smtbmc("-i", "-t", str(clocks), "--dump-vcd", "step.vcd")
        return self.sat(f"-tempinduct-inductonly -tempinduct-skip {clocks - 1}", clocks)

    def smtbmc(self, *arguments: str) -> tuple[bool, str]:
        command = [
            "yosys-smtbmc",
            "-s",
            "z3",
            "--presat",
            "--noprogress",
            *arguments,
            "design.smt2",
        ]
        _, output = run(command, self.folder)
        if "Status: " not in output:
            raise Broken(f"yosys-smtbmc came to no result ({self.folder}):\n{output.strip()}")
        found = [line.split("  ", 1)[-1] for line in output.splitlines() if "failed" in line]
        return "Status: PASSED" in output, "\n".join(found)

    def sat(self, mode: str, clocks: int) -> tuple[bool, str]:
        command = (
            f"sat {mode} -maxsteps {clocks} -prove-asserts -set-assumes "
            f"-dump_vcd failed.vcd {self.top}"
        )
        _, output = run(
            ["yosys", "-p", f"read_rtlil design.il; tee -o sat.log {command}"], self.folder
        )
        if "model found for base case: FAIL" in output:
            return False, "a counterexample was found"
        if "-> proof failed" in output:
            return False, "no induction"
        if not re.search(
            r"Induction step proven: SUCCESS|base case for \d+ steps: SUCCESS", output
        ):
            raise Broken(f"yosys came to no result ({self.folder}):\n{output.strip()[-2000:]}")
        return True, ""
