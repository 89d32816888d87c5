# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Measures how fast the core and the programs of this project are on this machine, and prints each
figure with its aim."""

import argparse
import dataclasses
import json
import os
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass

from dynrt_tools.build import configs
from dynrt_tools.experiments import frame as frames
from dynrt_tools.experiments import output, round_trip, table
from dynrt_tools.experiments.frame import Work, busiest, rays
from dynrt_tools.experiments.rows import aligned
from dynrt_tools.hardware import placed_clocks
from dynrt_tools.project import ROOT, Failed, Json, read_json, show_progress, write_json

STATED = table.experiment("speed")
CAUSES: Mapping[str, str] = STATED["causes"]
QUICK_SIZE = "128x96"
HOW = """\
Sets up and builds first, as scripts/demo does. The RTL counts the clocks, which are the same in
every run. Speeds are medians of several runs in seconds of processor time, less those of an image
of 2x2 pixels: they contain neither the reading of the scene nor other work of the machine. The
time of the tree is the median by the clock on the wall. The top level is built again over 50,000
turned and scaled boxes that stand as close as the trees of a wood, in processor time on one core.
The table marks and explains a figure that falls short of its aim; that is no failure. The clocks of
other scenes, configurations and memories are experiments of `dynrt report`."""


@dataclass
class Row:
    """A figure and its aim: at least `asked` where `more` is better, else at most."""

    name: str
    unit: str = ""
    asked: float | None = None
    more: bool = True
    digits: int = 0
    cause: str = ""  # of a figure that falls short, and its remedy
    reached: float | None = None
    note: str = ""

    @property
    def met(self) -> bool | None:
        """None where nothing is asked or could be measured."""
        if self.reached is None or self.asked is None:
            return None
        return self.reached >= self.asked if self.more else self.reached <= self.asked

    def cells(self) -> tuple[str, ...]:
        def number(value: float) -> str:
            return f"{value:,.{self.digits}f}" + (f" {self.unit}" if self.unit else "")

        asked = "" if self.asked is None else f"{'>=' if self.more else '<='} {number(self.asked)}"
        reached = "-" if self.reached is None else number(self.reached)
        mark = {True: "ok", False: "short", None: ""}[self.met]
        return self.name, asked, reached, mark, self.note

    def data(self) -> Json:
        return {**dataclasses.asdict(self), "met": self.met}


@dataclass
class Run:
    """One run of dynrt: its report, and its cost on this machine."""

    report: Json
    cpu_seconds: float  # user and system time of all its threads
    peak_bytes: int


@dataclass
class Bench:
    """Measures all rows; `frames` keep what they are of."""

    program: pathlib.Path
    scene: str
    size: str
    runs: int
    config: str
    packets: int  # of the configuration
    folder: pathlib.Path  # for files that go at the end
    frames: Json = dataclasses.field(default_factory=dict)
    missing: str = ""  # why there are no figures of the RTL

    @property
    def schedules(self) -> pathlib.Path:
        return self.program.parent / "generated" / self.config

    def run(self, *arguments: str) -> Run:
        figures = self.folder / "figures.json"
        command = [str(self.program), *arguments, "--json", str(figures)]
        with open(self.folder / "errors", "w+", encoding="utf-8") as errors:
            process = subprocess.Popen(
                command, stdout=subprocess.DEVNULL, stderr=errors, cwd=self.folder
            )
            # wait4, because subprocess does not give the time of a single child.
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            errors.seek(0)
            sentence = errors.read().strip()
        if process.returncode != 0:
            raise Failed(sentence or f"{self.program} ended with {process.returncode}")
        seconds = usage.ru_utime + usage.ru_stime
        return Run(read_json(figures), seconds, usage.ru_maxrss * 1024)

    def render(self, board: str, size: str, *flags: str, scene: str = "") -> Run:
        show_progress(f"{board}, {self.config}, {size}")
        known = ("--board", board, "--config", self.config, "--size", size, "--out", "image.png")
        return self.run("render", scene or self.scene, *known, *flags)

    def speed(self, board: str, amount: Callable[[Json], float]) -> tuple[list[float], Run]:
        """`amount` of a frame per second of processor time in each run, less that of 2x2 pixels;
        and the last run."""
        speeds = []
        for _ in range(self.runs):
            run, start = self.render(board, self.size), self.render(board, "2x2")
            seconds = max(run.cpu_seconds - start.cpu_seconds, 1e-3)
            speeds.append((amount(run.report["frame"]) - amount(start.report["frame"])) / seconds)
        self.frames[board] = run.report["frame"]
        return speeds, run

    def rows(self) -> list[Row]:
        model, last = self.speed("model", rays)
        rtl: tuple[list[float], Run] | None = None
        try:
            rtl = self.speed("rtl", lambda frame: float(frame["cycles"]))
            last = rtl[1]
        except Failed as failure:
            self.missing = str(failure)
        frame = rtl[1].report["frame"] if rtl else None
        return [
            *self.core_rows(frame),
            *self.work_rows(last.report),
            *self.round_trip_rows(rtl is not None),
            self.clocks_row(frame),
            self.median(
                Row("RTL simulation, clocks per second", asked=100_000), rtl[0] if rtl else []
            ),
            self.median(
                Row("native model, rays per second", asked=300_000, cause=CAUSES["model"]), model
            ),
            self.tree_row(),
            self.benchmark_row(
                Row("top level of 50,000 instances", "ms", 33, False, 1, CAUSES["machine"]),
                "host/tree/tree_benchmark",
                "instance_tree/50000",
                lambda run: float(run["cpu_time"]),
            ),
            self.benchmark_row(
                Row("truth of rays, per second of two cores", "", 200_000, cause=CAUSES["machine"]),
                "host/analysis/truth/truth_benchmark",
                "primary_rays/process_time",
                lambda run: float(2 * run["rays"] / (run["cpu_time"] * 1e-3)),
            ),
            Row("peak memory of a render", "MB", 1000, False, reached=last.peak_bytes / 1e6),
        ]

    def median(self, row: Row, values: list[float], note: str = "one core") -> Row:
        if values:
            row.reached = statistics.median(values)
            ends = f"{min(values):,.{row.digits}f} to {max(values):,.{row.digits}f}"
            row.note = f"{note}, {len(values)} runs, {ends}"
        return row

    def core_rows(self, frame: Json | None) -> Iterator[Row]:
        """How busy the core is, and its speed."""
        fewer = self.packets // 2
        for packets, asked in ((self.packets, 90), (fewer, 75)):
            row = Row(f"busiest unit works, {packets} packets", "%", asked, digits=1)
            row.cause = CAUSES["busy"]
            if frame and packets == fewer:
                one = self.render("rtl", self.size, "--packets", str(fewer)).report["frame"]
                self.frames[f"rtl, {fewer} packets"] = one
            if frame:
                one = frame if packets == self.packets else one
                unit = busiest(one["units"])
                row.reached = 100 * one["units"][unit]["utilisation"]
                row.note = f"{unit}, {one['cycles']:,} clocks a frame"
            yield row
        rate = Row("rays per clock", asked=STATED["rays per clock"].get(self.config), digits=4)
        clock = placed_clocks.of(self.config)
        aim = STATED["frames per second, placed"].get(self.config)
        placed = Row("frames per second, placed", asked=aim, digits=1)
        thesis = Row(f"frames per second at {placed_clocks.THESIS_MHZ} MHz", asked=37, digits=1)
        if frame:
            bound = Work.of(frame).bound()
            rate.reached = rays(frame) / frame["cycles"]
            rate.note = f"bound {rays(frame) / bound:.4f} by the work counted below"
            for row, mhz in ((placed, clock.mhz), (thesis, placed_clocks.THESIS_MHZ)):
                row.reached = placed_clocks.frames_per_second(frame["cycles"], mhz)
                row.note = f"bound {placed_clocks.frames_per_second(bound, mhz):.1f}"
            placed.note = f"{clock.of_core(self.config)}; {placed.note}"
            if clock.configuration != self.config:  # nobody knows its clock
                placed.note, placed.reached = f"{placed.reached:.1f} {placed.note}", None
        yield from (rate, placed, thesis)

    def work_rows(self, report: Json) -> Iterator[Row]:
        """The work of a packet; the same on both boards."""
        work, yardstick = Work.of(report["frame"]), STATED["yardstick"].get(self.scene, {})
        # The leaf of the instances' tree and its entry, which one level of trees does not have.
        own = 1 if report["scene"]["instances"] == 1 else 0
        for name in Work.EACH:
            reached = work.per_packet(name)
            if reached is None:
                continue
            asked, note = yardstick.get(name, (None, ""))
            if own and name in ("leaf_fetches", "list_entries"):
                reached -= own
                note = "; ".join(filter(None, (note, "one more for the only instance")))
            name = f"{name.replace('_', ' ')} per packet"
            yield Row(name, "", asked, False, 2, reached=reached, note=note)
        hits = frames.figures_of(report["frame"])
        caches = ", ".join(f"{n} {v:.1f} %" for n, v in hits.items() if n.endswith("cache hits"))
        bound = work.bound() / work.packets
        yield Row(
            "clocks of the busiest unit alone, per packet", digits=2, reached=bound, note=caches
        )

    def round_trip_rows(self, have_rtl: bool) -> Iterator[Row]:
        planned = Row("traversal round trip, scheduled", "clocks", 32, False)
        planned.note = f"{self.schedules} has no schedules"
        if schedule := round_trip.scheduled(self.schedules):
            planned.reached, planned.note = schedule
        yield planned
        taken = Row("traversal round trip, measured", "clocks", 32, False, 1)
        if have_rtl:

            def render(scene: str, flags: tuple[str, ...]) -> Json:
                return dict(self.render("rtl", "64x48", *flags, scene=scene).report["frame"])

            taken.reached = round_trip.measured(self.folder, render)
            taken.note = "RTL with one packet in flight, nodes in the cache"
        yield taken

    def clocks_row(self, frame: Json | None) -> Row:
        """How far the clocks that the model counts are from those that the RTL takes."""
        row = Row("clocks of a frame, model against RTL", "%", 0, False, 3)
        try:
            run = self.render("model", self.size, "--schedule", str(self.schedules))
        except Failed as failure:
            row.note = str(failure)
            return row
        clocks = run.report["frame"]["cycles"]
        row.note = f"{clocks:,} by the units' schedules, in {run.cpu_seconds:.1f} s"
        if frame:
            row.reached = 100 * abs(clocks - frame["cycles"]) / frame["cycles"]
        return row

    def tree_row(self) -> Row:
        runs = [self.run("info", self.scene) for _ in range(self.runs)]
        triangles, processor = runs[0].report["triangles"], [run.cpu_seconds for run in runs]
        row = Row(f"tree of {triangles:,} triangles", "s", 2, False, 2, CAUSES["tree"])
        self.median(row, [run.report["tree_seconds"] for run in runs], "by the clock on the wall")
        row.note += (
            f"; {statistics.median(processor):.2f} s of processor time with reading the scene"
        )
        return row

    def benchmark_row(
        self, row: Row, program: str, name: str, figure: Callable[[Json], float]
    ) -> Row:
        """A figure of the runs of one benchmark of a program."""
        path = self.program.parent / program
        if not path.exists():
            row.note = f"{path} is not built"
            return row
        flags = (f"--benchmark_filter=^{name}$", f"--benchmark_repetitions={self.runs}")
        command = [str(path), *flags, "--benchmark_format=json"]
        show_progress(row.name)
        result = subprocess.run(command, capture_output=True, text=True, check=False)
        if result.returncode != 0:
            raise Failed(f"{path}: {result.stderr.strip()}")
        found = json.loads(result.stdout)["benchmarks"]
        values = [figure(run) for run in found if run["run_type"] == "iteration"]
        return self.median(row, values, "by processor time")


def report_rows(program: pathlib.Path, scene: str, size: str, folder: pathlib.Path) -> list[Row]:
    """How long an error report takes when nothing is built yet, and again."""

    def minutes() -> tuple[float, float]:
        """By the clock, and of processor time."""
        environment = os.environ | {"DYNRT_CACHE": str(folder / "cache")}
        before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
        out = str(folder / "report")
        command = [str(program), "report", "error", scene, "--size", size, "--out", out]
        done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise Failed(done.stderr.strip())
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        processor = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        return (time.monotonic() - start) / 60, processor / 60

    first, processor = minutes()
    again, _ = minutes()
    runs = read_json(folder / "report" / "error.json")["runs"]
    measured = [run for run in runs if "refused" not in run]
    width, height = map(int, size.split("x"))
    truth = [run["seconds"]["truth"] for run in measured if run["seconds"].get("truth")]
    full = size == STATED["size"]
    cause = CAUSES["report"]
    whole = Row("error report, nothing built yet", "min", digits=1, more=False, cause=cause)
    whole.asked, whole.reached = STATED["report minutes"] if full else None, first
    where = f"{len(measured)} variants on {len(os.sched_getaffinity(0))} cores"
    whole.note = f"{where}, {processor:.1f} minutes of processor time"
    rate = Row("truth, primary rays", "million/s", 0.2, digits=2, cause=cause, note="fastest run")
    rate.reached = width * height / min(truth) / 1e6 if truth else None
    return [
        whole,
        Row("the same again", "min", digits=2, reached=again, note="only collected"),
        rate,
    ]


def shared(command: str) -> subprocess.CompletedProcess[str]:
    """Runs a function of scripts/common.sh, which says what is wrong in this script's name."""
    script = f'source "{ROOT}/scripts/common.sh"; {command}'
    return subprocess.run(
        ["bash", "-euo", "pipefail", "-c", script, "bench"],
        text=True,
        stdout=subprocess.PIPE if command == "help_packages" else None,
        check=False,
    )


def parse() -> argparse.Namespace:
    size, config = STATED["size"], STATED["configuration"]
    parser = argparse.ArgumentParser(
        prog="scripts/bench",
        description=f"{__doc__}\n\n{HOW}",
        epilog=shared("help_packages").stdout,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    add = parser.add_argument
    add("--scene", default="office", help="a built-in name or a file (default: office)")
    add("--config", default=config, metavar="NAME", help=f"configuration (default: {config})")
    add(
        "--quick", action="store_true", help=f"{QUICK_SIZE} pixels, not {size}, and one run of each"
    )
    add("--runs", type=int, metavar="N", help="number of runs that a median is of (default: 5)")
    add("--json", type=pathlib.Path, metavar="FILE", help="also write the table as data")
    add(
        "--report",
        action="store_true",
        help="instead of the table: how long `dynrt report error` takes when nothing is built yet, "
        "half an hour or so",
    )
    add(
        "--program",
        type=pathlib.Path,
        metavar="FILE",
        help="measure this dynrt; nothing is set up or built",
    )
    args = parser.parse_args()
    if args.runs is not None and args.runs < 1:
        parser.error(f"--runs {args.runs}: at least one run is needed")
    listed = configs.load_configurations().listed()
    if args.config not in listed:
        parser.error(f"--config {args.config}: unknown; the configurations are {', '.join(listed)}")
    args.packets = listed[args.config]["packets"]
    args.runs = args.runs or (1 if args.quick else 5)
    args.size = QUICK_SIZE if args.quick else size
    return args


def text(rows: list[Row]) -> str:
    lines = [aligned([("", "asked", "reached", "", "note"), *(row.cells() for row in rows)], 5)]
    causes: dict[str, list[str]] = {}
    for row in rows:
        if row.met is False and row.cause:
            causes.setdefault(row.cause, []).append(row.name)
    lines += [f"\nShort: {', '.join(names)}: {cause}." for cause, names in causes.items()]
    return "\n".join(lines)


def measure(args: argparse.Namespace, program: pathlib.Path, folder: pathlib.Path) -> None:
    scene = output.scene_path(args.scene)
    data: Json = {"scene": args.scene, "size": args.size}
    if args.report:
        rows, missing = report_rows(program, scene, args.size, folder), ""
    else:
        bench = Bench(program, scene, args.size, args.runs, args.config, args.packets, folder)
        rows, missing = bench.rows(), bench.missing
        machine = {"cores": os.cpu_count(), "load": os.getloadavg()[0]}
        data |= {"configuration": args.config, "machine": machine, "frames": bench.frames}
    show_progress("")
    if args.json:
        write_json(args.json, {**data, "rows": [row.data() for row in rows]})
    print(f"scene {args.scene}, {args.size} pixels, configuration {args.config}\n\n{text(rows)}")
    if missing:
        print(f"\nNothing of the RTL was measured: {missing}")


def main() -> int:
    args = parse()
    try:
        output.check_folder("--json", args.json, args.json and args.json.absolute().parent)
        if args.program is None and shared("prepare release").returncode != 0:
            return 1
        program = (args.program or ROOT / "build" / "release" / "dynrt").resolve()
        if not os.access(program, os.X_OK):
            raise Failed(f"{program} is no program; build it or leave out --program")
        with tempfile.TemporaryDirectory() as folder:
            measure(args, program, pathlib.Path(folder))
    except Failed as failure:
        show_progress("")
        print(f"bench: {failure}", file=sys.stderr)
        return 1
    return 0
