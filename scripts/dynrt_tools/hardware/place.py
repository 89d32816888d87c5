# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Places and routes units, the whole core or the board's top with registers around their ports,
several seeds each, and holds the clock that they reach against the one that hlsc's delay model
predicts.

Units are lowered for the delay model of device and grade; the core and the board's top are the
checked-in Verilog. A row appears when it is done, with the worst paths of its median seed: where
each starts and ends, its time in cells and in wires, and how many registers' inputs it ends at.

Units that do not fit the device, or all where its tool is missing, get Yosys's own timing for
7-series, which knows the delay of cells but not of wires."""

import argparse
import concurrent.futures
import pathlib
import shutil
import sys
from collections.abc import Sequence
from typing import Any

from dynrt_tools import options, project, unit_names
from dynrt_tools.command import Pool
from dynrt_tools.hardware import (
    lowering,
    place_record,
    place_row,
    place_table,
    placed_clocks,
    placers,
    placing,
    rtl_files,
)
from dynrt_tools.project import Json


def parse() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="scripts/place",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        epilog="""\
The folder that DYNRT_CACHE names, else build/synth, keeps every placement under a key of the
netlist, the constraints, the placer's version, the seed and the flags, with its report and its
delays. The exit code is 1 if a row was not placed: its tool is missing, it failed, ran out of time, does
not fit the device or cannot be lowered for the clock. It is 1 too if a single seed failed or a file
cannot be written. The other rows are complete in each case.""",
    )
    parser.add_argument(
        "unit",
        nargs="*",
        metavar="UNIT",
        help=f"units to place, by module or header, {rtl_files.CORE} for the whole core, "
        f"{rtl_files.BOARD} for the board's top "
        f"(default: every unit; on ecp5-85 {rtl_files.CORE} too)",
    )
    parser.add_argument(
        "--device",
        default="ice40-hx8k",
        metavar="NAME",
        help=f"one of {', '.join(placers.PLACERS)} (default: ice40-hx8k)",
    )
    parser.add_argument(
        "--grade",
        default="",
        metavar="N",
        help="the speed grade: 6, 7 or 8 on ecp5-85 (default: 6)",
    )
    parser.add_argument(
        "--clock-ns",
        type=options.positive,
        default=10.0,
        metavar="NS",
        help="the period that hlsc schedules units for (default: 10)",
    )
    parser.add_argument(
        "--ask-mhz",
        type=options.positive,
        metavar="MHZ",
        help="the clock that the placer is asked for (default: that of --clock-ns; where units are "
        "not among what is placed, that of the core's Verilog)",
    )
    parser.add_argument(
        "--seeds",
        type=options.count,
        default=5,
        metavar="N",
        help="placements, of seeds 1 to N (default: 5)",
    )
    parser.add_argument(
        "--seed",
        type=options.whole,
        action="append",
        metavar="N",
        help="place with this seed instead; may be repeated",
    )
    parser.add_argument(
        "--copies",
        type=options.count,
        default=1,
        metavar="N",
        help="of each, in one chip (default: 1)",
    )
    parser.add_argument(
        "--paths",
        type=options.whole,
        default=3,
        metavar="N",
        help="worst paths to print below a row (default: 3)",
    )
    parser.add_argument(
        "--timeout",
        type=options.positive,
        default=180,
        metavar="MINUTES",
        help="the time that one placement may take (default: 180)",
    )
    parser.add_argument(
        "--config",
        default=rtl_files.CHECKED_IN,
        metavar="NAME",
        help=f"configuration (default: {rtl_files.CHECKED_IN}, whose core is checked in)",
    )
    parser.add_argument(
        "--build",
        type=pathlib.Path,
        metavar="FOLDER",
        help="the build whose hlsc lowers, and which has the cores of other configurations "
        "(default: build/release, else build/dev)",
    )
    options.add_jobs(parser, "tools")
    parser.add_argument(
        "--json",
        type=pathlib.Path,
        metavar="FILE",
        help="also write the figures as data, anew after each row",
    )
    parser.add_argument(
        "--record",
        type=pathlib.Path,
        metavar="FILE",
        help="also write what docs/results keeps: clocks, cells and the ends of paths that limit each "
        "row, which docs/results/devices.md shows and scripts/fit-delays reads",
    )
    parser.add_argument(
        "--clock",
        action="store_true",
        help=f"also state the clock of {rtl_files.CORE} in hls/configs/clocks.json, at which dynrt "
        "and the documents count frames per second",
    )
    return parser.parse_args()


class Run:
    """All rows of one call, each printed and written as soon as it is done."""

    def __init__(self, args: argparse.Namespace, names: list[str]) -> None:
        self.args = args
        self.names = names
        self.placer = placers.PLACERS[args.device]
        self.target = placing.Target(
            args.device,
            placers.grade_of(args.device, args.grade),
            args.ask_mhz or 1000 / self._period(),
            args.timeout * 60,
        )
        self.there = shutil.which(self.placer["program"]) is not None
        self.done: dict[str, place_row.Row] = {}
        self.written = True  # all that was asked for
        self.seeds = args.seed or range(1, args.seeds + 1)

    def _period(self) -> float:
        """Of the Verilog that is there already, where nothing else is placed."""
        if set(self.names) <= set(rtl_files.WHOLE):
            return place_record.scheduled_for(
                rtl_files.generated(self.args.config, self.args.build)
            )
        return float(self.args.clock_ns)

    def place(self, build: pathlib.Path | None) -> None:
        """Places every row and seed, as many at a time as there may be."""
        with Pool(self.args.jobs) as pool:
            preparing = {pool.submit(place_row.prepare, n, self.args, build): n for n in self.names}
            placements: dict[concurrent.futures.Future[Json], tuple[place_row.Row, int]] = {}
            left: dict[str, int] = {}
            pending: set[concurrent.futures.Future[Any]] = set(preparing)
            while pending:
                ready, pending = concurrent.futures.wait(
                    pending, return_when=concurrent.futures.FIRST_COMPLETED
                )
                for job in ready:
                    if job in preparing:
                        row = self._prepared(preparing[job], job)
                        seeds = self._seeds(row)
                        left[row.name] = len(seeds)
                        for seed in seeds:
                            new = pool.submit(self._place, row, seed)
                            placements[new] = row, seed
                            pending.add(new)
                    else:
                        row, seed = placements[job]
                        row.add(seed, job, self.placer["program"])
                        if row.placed and row.placed[-1]["seed"] == seed:
                            self._tell(f"{row.name}, seed {seed}: {row.placed[-1]['mhz']:.1f} MHz")
                        left[row.name] -= 1
                    if left[row.name] == 0:
                        self._finish(row)

    @staticmethod
    def _prepared(name: str, job: "concurrent.futures.Future[place_row.Row]") -> place_row.Row:
        """The row that a job made, or one that says why there is none."""
        try:
            return job.result()
        except (project.Failed, OSError) as error:
            print(f"place: {error}", file=sys.stderr)
            return place_row.Row(name, {"unit": name, "note": f"failed: {error}"})

    def _seeds(self, row: place_row.Row) -> Sequence[int]:
        if row.subject is None or "note" in row.data:
            return ()
        if not self.there:
            row.data["note"] = f"{self.placer['program']} is not on the PATH"
            return ()
        return self.seeds

    def _place(self, row: place_row.Row, seed: int) -> Json:
        assert row.subject is not None  # or it would have no seeds
        return placing.place(
            self.target,
            row.subject,
            seed,
            lambda: self._tell(f"placing {row.name}, seed {seed}"),
        )

    @staticmethod
    def _tell(text: str) -> None:
        """On a terminal over the line before, elsewhere as a line of a log."""
        if sys.stderr.isatty():
            project.show_progress(text)
        else:
            print(f"place: {text}", file=sys.stderr, flush=True)

    def _finish(self, row: place_row.Row) -> None:
        row.finish()
        self.done[row.name] = row
        project.show_progress("")
        print(place_table.line(place_table.cells_of(row.data)))
        for path in place_table.paths_of(row.data, self.args.paths):
            print(path)
        sys.stdout.flush()
        try:
            if self.args.json:
                project.write_json(self.args.json, self.data())
            if self.args.record:
                place_record.write(self.args.record, self.record())
            if self.args.clock and row.name == rtl_files.CORE and row.placed and not row.failures:
                placed_clocks.write(place_record.clock_of(self.record()))
        except (OSError, project.Failed) as error:
            self.written = False
            print(f"place: {row.name} is placed and not recorded: {error}", file=sys.stderr)

    def record(self) -> Json:
        """What is kept of the rows that are done."""
        said = {
            key: value for key, value in self.data().items() if key not in ("units", "clock_ns")
        }
        rows = [self.done[name] for name in self.names if name in self.done]
        return place_record.of_rows(said, rows, self.seeds)

    def data(self) -> Json:
        """The rows that are done, in the order of their names on the command line."""
        return {
            "config": self.args.config,
            "device": self.args.device,
            "grade": self.target.grade,
            "clock_ns": self.args.clock_ns,
            "asked_mhz": round(self.target.mhz, 3),
            "copies": self.args.copies,
            "complete": len(self.done) == len(self.names),
            "units": [self.done[n].data for n in self.names if n in self.done],
        }

    def failed(self) -> bool:
        """Whether a row has no placement or lacks one of a seed, or a file is not written."""
        return not self.written or any(r.failures or not r.placed for r in self.done.values())

    def summary(self) -> str:
        """A sentence with every row that has no placement, in the order of the names, or else with
        those of which a part is missing."""
        rows = [self.done[name] for name in self.names]
        missing = [row for row in rows if not row.placed]
        reasons = "; ".join(f"{row.name} ({place_row.reason(row.data)})" for row in missing)
        if missing:
            return f"not placed are {len(missing)} of {len(rows)} rows: {reasons}"
        return "not every seed was placed" if self.written else "not everything is recorded"


def chosen(args: argparse.Namespace) -> tuple[list[str], pathlib.Path | None]:
    """The names of the rows, and the build that lowers their units where there are any."""
    if set(args.unit) & set(rtl_files.WHOLE):
        rtl_files.generated(
            args.config, args.build
        )  # ends here where there is no such configuration
    if args.unit and all(name in rtl_files.WHOLE for name in args.unit):
        return list(dict.fromkeys(args.unit)), None
    build = rtl_files.find_build(args.build)
    units = lowering.units(build, args.config)
    if not units:
        project.fail(f"--config {args.config}: the build {build} has no such configuration")
    names = unit_names.all_modules_of(
        args.unit,
        lowering.headers(units) | {name: name for name in rtl_files.WHOLE},
        f"; {' and '.join(rtl_files.WHOLE)} are the whole core and the board's top",
    )
    if not names and args.device == "ecp5-85":
        rtl_files.generated(args.config, args.build)  # as above
        return [*units, rtl_files.CORE], build
    return names or list(units), build


def check(args: argparse.Namespace) -> None:
    """Ends the command if a flag is wrong in itself; `chosen` checks the names."""
    if args.device not in placers.PLACERS:
        project.fail(
            f"there is no way to place on '{args.device}'; the devices are "
            f"{', '.join(placers.PLACERS)}"
        )
    placers.grade_of(args.device, args.grade)
    if args.build and not args.build.is_dir():
        project.fail(f"--build {args.build}: there is no such folder; name that of a build")
    for flag in ("json", "record"):
        if path := getattr(args, flag):
            project.check_output(f"--{flag}", path)
    if args.clock and args.copies > 1:
        project.fail("--clock is of one core alone; leave out --copies")


def main() -> int:
    args = parse()
    try:
        check(args)
        names, build = chosen(args)
    except project.Failed as error:
        project.fail(error)
    if args.clock and rtl_files.CORE not in names:
        project.fail(f"--clock is that of {rtl_files.CORE}, which is not placed here; name it")
    run = Run(args, names)
    if not run.there:
        print(
            f"place: {run.placer['program']} is not on the PATH ({run.placer['where']}); what "
            "follows is Yosys's own timing",
            file=sys.stderr,
        )
    print(place_table.line(place_table.HEAD), flush=True)
    run.place(build)
    if run.failed():
        print(f"place: {run.summary()}", file=sys.stderr)
        return 1
    return 0
