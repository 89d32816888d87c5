# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""A row of the table of scripts/place: what is placed, lowered and synthesized for it beforehand, and
the seeds that it has."""

import argparse
import concurrent.futures
import pathlib
import sys
from dataclasses import dataclass, field

from dynrt_tools import project
from dynrt_tools.hardware import (
    area,
    devices,
    lowering,
    model_file,
    placers,
    placing,
    rtl_files,
    synthesis,
)
from dynrt_tools.project import Json

NO_FIT = "does not fit: "


def reason(row: Json) -> str:
    """Why a row has no placement."""
    return str(row.get("note") or "no seed was placed")


@dataclass
class Row:
    """What becomes one row of the table: its figures so far, and the seeds that are under way."""

    name: str
    data: Json
    subject: placing.Subject | None = None
    placed: list[Json] = field(default_factory=list)
    failures: list[Json] = field(default_factory=list)

    def add(self, seed: int, job: concurrent.futures.Future[Json], program: str) -> None:
        """The result of a seed, or a sentence that says why there is none."""
        try:
            self.placed.append(job.result())
        except project.Failed as error:
            fits = not isinstance(error, placers.DoesNotFit)
            said = str(error) if fits else f"{NO_FIT}{error}"
            self.failures.append({"seed": seed, "error": said})
            project.show_progress("")
            print(
                f"place: {program} placed no {self.name} with seed {seed}: {said}", file=sys.stderr
            )

    def finish(self) -> None:
        """Puts the seeds in their order, and in place of all that are missing Yosys's timing."""
        self.data["placed"] = sorted(self.placed, key=lambda p: int(p["seed"]))
        self.data["failures"] = sorted(self.failures, key=lambda f: int(f["seed"]))
        if self.failures and not self.placed:
            first = self.data["failures"][0]["error"]
            self.data["note"] = first if first.startswith(NO_FIT) else f"failed: {first}"
        if not self.placed and self.subject and self.name not in rtl_files.WHOLE:
            try:
                self.data["logic_ns"] = placing.logic_delay(self.name, list(self.subject.files))
            except project.Failed as error:
                print(f"place: no timing of {self.name} by Yosys: {error}", file=sys.stderr)


def prepare(name: str, args: argparse.Namespace, build: pathlib.Path | None) -> Row:
    """A row with all that is known before the placer runs; without a subject there is no more."""
    if name in rtl_files.WHOLE:
        files = rtl_files.library() + rtl_files.generated(args.config, args.build)
        files += rtl_files.board() if name == rtl_files.BOARD else []
        return Row(name, {"unit": name}, placing.Subject(name, files, args.copies, True))
    assert build is not None  # units are of a build
    grade = placers.grade_of(args.device, args.grade)
    model = model_file.base_of(model_file.path_of(args.device, grade))
    delay = model.relative_to(project.ROOT).as_posix()
    unit = lowering.units(build, args.config)[name]
    try:
        folder = lowering.lower(build, unit, args.clock_ns, delay, args.config)
    except project.Failed as error:
        return Row(name, {"unit": name, "note": f"not lowered: {error}"})
    files = rtl_files.hand_written() + [folder / f"{name}.v"]
    data: Json = {"unit": name, "delay": delay}
    data |= area.schedule((folder / f"{name}.txt").read_text(encoding="utf-8"))
    family = devices.DEVICES[args.device]["family"]
    cells, _ = synthesis.cells(name, files, devices.FAMILIES[family]["synth"], name)
    data["resources"] = devices.resources(family, cells)
    taken = {resource: args.copies * n for resource, n in data["resources"].items()}
    if short := devices.shortages(args.device, taken):
        data["note"] = NO_FIT + "; ".join(short)
    return Row(name, data, placing.Subject(name, files, args.copies))
