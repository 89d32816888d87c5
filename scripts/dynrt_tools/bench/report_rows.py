# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The rows of scripts/bench --report: how long an error report takes when nothing is built yet."""

import os
import pathlib
import resource
import subprocess
import tempfile
import time

from dynrt_tools.bench.rows import Row
from dynrt_tools.bench.run import Dynrt, RunFailed
from dynrt_tools.project import Json, Progress, read_json

ASKED_MINUTES = 30  # on two cores, office at 512x384 with all variants
ASKED_TRUTH = 0.2  # million rays a second

CAUSE = (
    "compiling the models, lowering and synthesis take the time, which other work on the "
    "machine makes longer: compare the processor time"
)


def run_report(
    dynrt: Dynrt, scene: str, size: str, folder: pathlib.Path
) -> tuple[float, float, Json]:
    """Minutes by the clock and of processor time, and the report."""
    environment = os.environ | {"DYNRT_CACHE": str(folder / "cache")}
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    result = subprocess.run(
        [dynrt.program, "report", "error", scene, "--size", size, "--out", folder / "report"],
        env=environment,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
        check=False,
    )
    if result.returncode != 0:
        raise RunFailed(result.stderr.strip())
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    processor = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    report = read_json(folder / "report" / "error.json")
    return (time.monotonic() - start) / 60, processor / 60, report


def rows(dynrt: Dynrt, scene: str, size: str, full_size: str, progress: Progress) -> list[Row]:
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        progress("report with an empty cache")
        minutes, processor, report = run_report(dynrt, scene, size, folder)
        progress("report again")
        again, _, _ = run_report(dynrt, scene, size, folder)
    runs = [run for run in report["runs"] if "refused" not in run]
    width, height = map(int, size.split("x"))
    truth = [run["seconds"]["truth"] for run in runs if run["seconds"].get("truth")]
    relation = "<=" if size == full_size else ""
    return [
        Row(
            "error report, nothing built yet",
            "min",
            ASKED_MINUTES,
            relation,
            minutes,
            1,
            f"{len(runs)} variants on {len(os.sched_getaffinity(0))} cores, "
            f"{processor:.1f} minutes of processor time",
            CAUSE,
        ),
        Row("the same again", "min", reached=again, digits=2, note="only collected"),
        Row(
            "truth, primary rays",
            "million/s",
            ASKED_TRUTH,
            ">=",
            width * height / min(truth) / 1e6 if truth else None,
            2,
            "fastest of the runs",
            CAUSE,
        ),
    ]
