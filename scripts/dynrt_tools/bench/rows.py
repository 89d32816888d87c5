# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The rows of scripts/bench: each aim, the figure reached, and the cause if it falls short."""

import dataclasses
import json
import pathlib
import statistics
import subprocess
from collections.abc import Callable

from dynrt_tools.bench import latency
from dynrt_tools.bench.run import Dynrt, Run, RunFailed, Speed, Work, busiest, rays
from dynrt_tools.hardware import placed_clocks
from dynrt_tools.project import Json, Progress

CONFIG = "fast"  # which is measured where no other is named
# The aims of rays a clock and of frames per second, placed, of `office`.
AIMS = {"fast": (0.23, 140), "full": (0.085, 65)}

# Work per packet of a tracer that is not ours, on the same models but with other cameras, six
# clipping nodes at the root, which cost a step each, and one level of trees.
YARDSTICK = {"office": {"steps": 36.1, "leaf_fetches": 7.3, "list_entries": 4.2, "triangles": 4.0}}
YARDSTICK_NOTE = {
    "steps": "yardstick with six clipping nodes at the root, 30.1 without",
    "leaf_fetches": "5.9 of the yardstick's are of empty leaves, which are never fetched here",
    "list_entries": "read, before the mailbox",
    "triangles": "after the mailbox",
}

# The cause where a figure falls short, and its remedy.
BUSY_CAUSE = (
    "the rest of the clocks go to lines that come from memory, to emptying the caches "
    "before the frame and to its first and last packets, which weigh more the smaller "
    "the image; larger caches and more packets mend it"
)
MODEL_CAUSE = (
    "the model computes the core's floats with integers, as the hardware does, and "
    "additions take the largest part of the time; doubles rounded once would give the "
    "same bits faster, but would be a second source of them"
)
TOP_LEVEL_CAUSE = "a slower or a busy machine: other programs take part of its caches"
TRUTH_CAUSE = "a slower or a busy machine: other programs take part of its caches"
TREE_CAUSE = (
    "the builder runs on all cores, so compare the processor time: on a busy machine the "
    "clock on the wall measures the others"
)


@dataclasses.dataclass
class Row:
    name: str
    unit: str = ""
    asked: float | None = None
    relation: str = ""  # at least: ">=", at most: "<=", no demand: ""
    reached: float | None = None
    digits: int = 0
    note: str = ""
    cause: str = ""  # of a figure that falls short, and its remedy

    @property
    def met(self) -> bool | None:
        """True, False, or None where nothing is asked or could be measured."""
        if not self.relation or self.reached is None or self.asked is None:
            return None
        return self.reached >= self.asked if self.relation == ">=" else self.reached <= self.asked

    def asked_text(self) -> str:
        return "" if self.asked is None else f"{self.relation} {self._number(self.asked)}".strip()

    def reached_text(self) -> str:
        return "-" if self.reached is None else self._number(self.reached)

    def _number(self, value: float) -> str:
        return f"{value:,.{self.digits}f}" + (f" {self.unit}" if self.unit else "")

    def data(self) -> Json:
        return {**dataclasses.asdict(self), "met": self.met}


@dataclasses.dataclass
class Options:
    scene: str
    size: str
    runs: int
    config: str
    packets: int  # of the configuration
    reports: pathlib.Path  # folder of hlsc's schedule reports of the configuration
    tree_benchmark: pathlib.Path  # the program that times the trees alone
    truth_benchmark: pathlib.Path  # the program that times the truth of rays


class Bench:
    """Measures all rows; the data keep every run for their reader."""

    def __init__(self, dynrt: Dynrt, options: Options, progress: Progress) -> None:
        self.dynrt, self.options, self.progress = dynrt, options, progress
        self.frames: dict[str, Json] = {}
        self.missing = ""  # why there are no figures of the RTL

    def rows(self) -> list[Row]:
        model = self._speed("model", rays)
        try:
            rtl = self._speed("rtl", lambda frame: float(frame["cycles"]))
        except RunFailed as failure:
            rtl, self.missing = None, str(failure)
        return [
            *self._core_rows(rtl),
            *self._work_rows((rtl or model).last),
            *self._latency_rows(rtl is not None),
            self._clocks_row(rtl),
            *self._host_rows(rtl, model),
        ]

    def _speed(self, board: str, amount: Callable[[Json], float]) -> Speed:
        speed = Speed.measure(
            self.dynrt,
            board,
            self.options.scene,
            self.options.config,
            self.options.size,
            self.options.runs,
            amount,
            self.progress,
        )
        self.frames[board] = speed.last.frame
        return speed

    def _core_rows(self, rtl: Speed | None) -> list[Row]:
        """How busy the core is, and its speed."""
        config, packets = self.options.config, self.options.packets
        half = packets // 2
        rays_aim, rate_aim = AIMS.get(config, (None, None))
        rows = [
            Row(
                f"busiest unit works, {packets} packets", "%", 90, ">=", digits=1, cause=BUSY_CAUSE
            ),
            Row(f"busiest unit works, {half} packets", "%", 75, ">=", digits=1, cause=BUSY_CAUSE),
            Row("rays per clock", "", rays_aim, ">=" if rays_aim else "", digits=4),
        ]
        rates = [
            Row("frames per second, placed", "", rate_aim, ">=" if rate_aim else "", digits=1),
            Row(f"frames per second at {placed_clocks.THESIS_MHZ} MHz", "", 37, ">=", digits=1),
        ]
        rows += rates
        if rtl is None:
            return rows
        frame = rtl.last.frame
        self.progress(f"rtl, {half} packets")
        fewer = self.dynrt.render(
            self.options.scene, "rtl", config, self.options.size, "--packets", str(half)
        ).frame
        self.frames[f"rtl, {half} packets"] = fewer
        for row, which in zip(rows, (frame, fewer)):
            name, transactions = busiest(which)
            row.reached = 100 * transactions / which["cycles"]
            row.note = f"{name}, {which['cycles']:,} clocks a frame"
        bound = Work.of(frame).bound()
        rows[2].reached = rays(frame) / frame["cycles"]
        rows[2].note = (
            f"bound {rays(frame) / bound:.4f} by the work counted below, "
            f"{rays(frame) / busiest(frame)[1]:.4f} by the busiest unit's transactions"
        )
        clock = placed_clocks.of(config)
        for row, mhz in zip(rates, (clock.mhz, placed_clocks.THESIS_MHZ)):
            row.reached = placed_clocks.frames_per_second(frame["cycles"], mhz)
            row.note = f"bound {placed_clocks.frames_per_second(bound, mhz):.1f}"
        rates[0].note = f"{clock.of_core(config)}; {rates[0].note}"
        if clock.configuration != config:  # nobody knows its clock
            rates[0].note = f"{rates[0].reached:.1f} {rates[0].note}"
            rates[0].reached = None
        return rows

    def _work_rows(self, run: Run) -> list[Row]:
        """The work of a packet; the same on both boards."""
        frame, yardstick = run.frame, YARDSTICK.get(self.options.scene, {})
        work = Work.of(frame)
        # The leaf of the instances' tree and its entry, which one level of trees does not have.
        own = 1 if run.report["scene"]["instances"] == 1 else 0
        rows = []
        for name in ("nodes", "steps", "leaf_fetches", "list_entries", "triangles", "objects"):
            asked, reached, note = yardstick.get(name), work.per_packet(name), ""
            if reached is None:
                continue
            if asked:
                note = YARDSTICK_NOTE[name]
            if own and name in ("leaf_fetches", "list_entries"):
                reached -= own
                note += f"{'; ' if note else ''}one more for the only instance"
            rows.append(
                Row(
                    f"{name.replace('_', ' ')} per packet",
                    "",
                    asked,
                    "<=" if asked else "",
                    reached,
                    2,
                    note,
                )
            )
        caches = ", ".join(
            f"{name} {100 * cache['hit_rate']:.1f} %" for name, cache in frame["caches"].items()
        )
        rows.append(
            Row(
                "clocks of the busiest unit alone, per packet",
                "",
                None,
                "",
                work.bound() / work.packets,
                2,
                f"cache hits: {caches}",
            )
        )
        return rows

    def _latency_rows(self, have_rtl: bool) -> list[Row]:
        planned = Row("traversal round trip, scheduled", "clocks", 32, "<=")
        schedule = latency.scheduled(self.options.reports)
        if schedule is None:
            planned.note = f"{self.options.reports} has no schedules"
        else:
            planned.reached = schedule.clocks
            stages = ", ".join(f"{unit} {n}" for unit, n in schedule.stages.items())
            planned.note = f"at {schedule.clock_ns:g} ns: {stages}"
        taken = Row("traversal round trip, measured", "clocks", 32, "<=", digits=1)
        if have_rtl:
            self.progress("rtl, one packet in flight")
            taken.reached = latency.measured(self.dynrt, self.options.config)
            taken.note = "RTL with one packet in flight, nodes in the cache"
        return [planned, taken]

    def _clocks_row(self, rtl: Speed | None) -> Row:
        """How far the clocks that the model counts are from those that the RTL takes."""
        row = Row("clocks of a frame, model against RTL", "%", 0, "<=", digits=3)
        self.progress("model, clock by clock")
        try:
            run = self.dynrt.render(
                self.options.scene,
                "model",
                self.options.config,
                self.options.size,
                "--schedule",
                str(self.options.reports),
            )
        except RunFailed as failure:
            row.note = str(failure)
            return row
        clocks = run.frame["cycles"]
        row.note = f"{clocks:,} by the units' schedules, in {run.cpu_seconds:.1f} s"
        if rtl is not None:
            cycles = rtl.last.frame["cycles"]
            row.reached = 100 * abs(clocks - cycles) / cycles
        return row

    def _host_rows(self, rtl: Speed | None, model: Speed) -> list[Row]:
        simulation = Row("RTL simulation, clocks per second", "", 100_000, ">=")
        memory = Row("peak memory of a render", "MB", 1000, "<=")
        if rtl is not None:
            simulation.reached, simulation.note = rtl.median, _spread(rtl, self.options.runs)
        peak: Run = (rtl or model).last
        memory.reached, memory.note = peak.peak_bytes / 1e6, f"board {peak.frame['board']}"
        native = Row(
            "native model, rays per second",
            "",
            300_000,
            ">=",
            reached=model.median,
            note=_spread(model, self.options.runs),
            cause=MODEL_CAUSE,
        )
        return [
            simulation,
            native,
            self._tree_row(),
            self._top_level_row(),
            self._truth_row(),
            memory,
        ]

    def _timed(self, program: pathlib.Path, name: str) -> list[Json] | None:
        """The runs of one benchmark of a program, in its order; None if it is not built."""
        if not program.exists():
            return None
        command: list[str | pathlib.Path] = [
            program,
            f"--benchmark_filter=^{name}$",
            "--benchmark_format=json",
            f"--benchmark_repetitions={self.options.runs}",
        ]
        result = subprocess.run(command, capture_output=True, text=True, check=False)
        if result.returncode != 0:
            raise RunFailed(f"{program}: {result.stderr.strip()}")
        return [
            run for run in json.loads(result.stdout)["benchmarks"] if run["run_type"] == "iteration"
        ]

    def _truth_row(self) -> Row:
        """The truth that `dynrt report error` judges by, for the primary rays of `office`."""
        row = Row("truth of rays, per second of two cores", "", 200_000, ">=", cause=TRUTH_CAUSE)
        self.progress("truth of rays")
        runs = self._timed(self.options.truth_benchmark, "primary_rays/process_time")
        if runs is None:
            row.note = f"{self.options.truth_benchmark} is not built"
            return row
        speeds = [2 * run["rays"] / (run["cpu_time"] * 1e-3) for run in runs]
        row.reached = statistics.median(speeds)
        row.note = (
            f"by processor time, {len(speeds)} runs, {min(speeds):,.0f} to "
            f"{max(speeds):,.0f}; {runs[0]['tests_per_ray']:.1f} primitives a ray, exact "
            f"arithmetic for {runs[0]['exact_per_ray']:.3f} decisions a ray"
        )
        return row

    def _top_level_row(self) -> Row:
        """The tree over 50,000 instances, as host/tree/tree_benchmark.cpp strews them."""
        row = Row("top level of 50,000 instances", "ms", 33, "<=", digits=1, cause=TOP_LEVEL_CAUSE)
        self.progress("top level of 50,000 instances")
        runs = self._timed(self.options.tree_benchmark, "instance_tree/50000")
        if runs is None:
            row.note = f"{self.options.tree_benchmark} is not built"
            return row
        times = [run["cpu_time"] for run in runs]
        row.reached = statistics.median(times)
        row.note = (
            f"processor time of one core, {len(times)} runs, {min(times):.1f} to "
            f"{max(times):.1f}; boxes and tree, without packing and upload"
        )
        return row

    def _tree_row(self) -> Row:
        runs = []
        for number in range(self.options.runs):
            self.progress(f"tree: run {number + 1} of {self.options.runs}")
            runs.append(self.dynrt.info(self.options.scene))
        seconds = [run.report["tree_seconds"] for run in runs]
        processor = statistics.median(run.cpu_seconds for run in runs)
        return Row(
            f"tree of {runs[0].report['triangles']:,} triangles",
            "s",
            2,
            "<=",
            statistics.median(seconds),
            2,
            f"by the clock on the wall, {len(runs)} runs, {min(seconds):.2f} to "
            f"{max(seconds):.2f}; {processor:.2f} s of processor time with reading the "
            "scene",
            TREE_CAUSE,
        )


def _spread(speed: Speed, runs: int) -> str:
    return f"one core, {runs} runs, {speed.low:,.0f} to {speed.high:,.0f}"
