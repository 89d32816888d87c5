# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Counts the core's gates by the thesis's rule. Writes docs/results/gates.md: tables 7.3 to 7.5
beside ours, and the formulas C_RTC(P, CL) and Bits_RTC(P, CL) fitted to ours."""

import argparse
import json
import os
import pathlib
import subprocess
from collections.abc import Iterable

from dynrt_tools import options, project
from dynrt_tools.command import Pool
from dynrt_tools.hardware import gate_count, gate_report, gate_units, rtl_files
from dynrt_tools.hardware.gate_report import Counts

DOCUMENT = project.ROOT / "docs" / "results" / "gates.md"
# The configurations that the formulas are fitted to, beside the thesis's own.
POINTS = ((64, 512), (8, 512), (32, 64))
TOLERANCE = 0.03  # --check: how far a figure may have moved


def lower(packets: int, lines: int, folder: pathlib.Path) -> list[pathlib.Path]:
    """The Verilog of the thesis's configuration with other packets and lines."""
    path = folder / f"packets{packets}_lines{lines}.json"
    path.write_text(
        json.dumps({"like": "thesis", "packets": packets, "lines": lines}), encoding="utf-8"
    )
    result = subprocess.run(
        [project.SCRIPTS / "configuration", "--verilog", path],
        capture_output=True,
        text=True,
        check=False,
        env={"DYNRT_CACHE": str(folder), **os.environ},
    )
    if result.returncode != 0:
        raise project.Failed(result.stderr.strip().splitlines()[-1])
    return rtl_files.units_in(pathlib.Path(result.stdout.strip()))


def measure(points: Iterable[tuple[int, int]], jobs: int) -> Counts:
    """The counts of every configuration, by (packets, lines)."""
    folder = project.ROOT / "build" / "configurations"
    folder.mkdir(parents=True, exist_ok=True)
    counts = {}
    with Pool(jobs) as pool:
        for packets, lines in points:
            project.show_progress(f"counting {packets} packets, {lines} lines")
            if (packets, lines) == (gate_units.PACKETS, gate_units.LINES):
                files = rtl_files.units_in(rtl_files.GENERATED)
            else:
                files = lower(packets, lines, folder)
            counts[packets, lines] = gate_count.count_core(files, pool)
    project.show_progress("")
    return counts


def check(counts: Counts) -> list[str]:
    """A sentence for each figure of docs/results/gates.md that no longer holds."""
    written = gate_report.figures(DOCUMENT.read_text(encoding="utf-8"))
    now = gate_report.summary(counts[gate_units.PACKETS, gate_units.LINES])
    if set(written) != set(now):
        return [f"{DOCUMENT.name} has other rows: {', '.join(sorted(set(written) ^ set(now)))}"]
    return [
        f"{DOCUMENT.name} says {said:,} for {name}, but the Verilog has {now[name]:,}"
        for name, said in written.items()
        if abs(said - now[name]) > TOLERANCE * max(said, now[name], 1000)
    ]


def main() -> int:
    parser = argparse.ArgumentParser(prog="scripts/gates", description=__doc__)
    parser.add_argument(
        "--check",
        action="store_true",
        help="write nothing; fail if a figure of docs/results/gates.md differs by "
        f"more than {100 * TOLERANCE:.0f} %% from that of the checked-in Verilog",
    )
    options.add_jobs(parser, "Yosys processes")
    parser.add_argument(
        "--out",
        type=pathlib.Path,
        default=DOCUMENT,
        metavar="FILE",
        help="where to write (default: docs/results/gates.md)",
    )
    args = parser.parse_args()
    thesis = (gate_units.PACKETS, gate_units.LINES)
    try:
        counts = measure((thesis,) if args.check else (thesis, *POINTS), args.jobs)
    except project.Failed as error:
        project.fail(error)
    if args.check:
        stale = check(counts)
        if stale:
            project.fail("; ".join(stale) + "; scripts/gates writes it again")
        print(f"{DOCUMENT.name} holds")
        return 0
    project.check_output("--out", args.out)
    args.out.write_text(gate_report.document(counts), encoding="utf-8")
    print(f"written: {args.out}")
    return 0
