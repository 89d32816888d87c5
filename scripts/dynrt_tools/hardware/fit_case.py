# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""A row of a record of placements as a fit sees it: its limiting ends, each with the time that hlsc
predicts by a delay model, or with the reason why it predicts none.

hlsc schedules the placed Verilog again, by the delay model that the record keeps, and times the
schedule by other models."""

import json
import pathlib
import statistics
import tempfile
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field

from dynrt_tools import project
from dynrt_tools.command import Pool
from dynrt_tools.hardware import fitting, joining, lowering, place_record, rtl_files
from dynrt_tools.project import Json, read_json

NEAR = 0.1  # a prediction is good within this part of the placed time


@dataclass
class Result:
    """A case by one model."""

    ends: list[tuple[Json, fitting.Sample]] = field(default_factory=list)
    unpredicted: Counter[str] = field(default_factory=Counter)  # by the reason
    promised: float = 0.0  # the longest predicted time of any end

    def within(self) -> float | None:
        """The part of the predictions that are good; None where there are none."""
        near = [abs(s.predicted / s.placed - 1) <= NEAR for _, s in self.ends]
        return round(sum(near) / len(near), 4) if near else None


class Case:
    """A row and its predictions, with the hlsc of a build."""

    def __init__(self, record: Json, row: str, build: pathlib.Path, jobs: int) -> None:
        self.record, self.row, self.config = record, row, str(record["config"])
        self.about: Json = record["units"][row]
        self.period = 1000 / float(statistics.median(self.about["mhz"]))
        self.ends = [
            end
            for end in record["ends"]
            if end["row"] == row and end["median"] >= record["limits"] * self.period
        ]
        self.current = True  # the placed Verilog is that which there is now
        self._build, self._jobs = build, jobs
        self._units = lowering.units(build, self.config)
        self.joined = joining.Joined({row: row})
        if row == rtl_files.CORE:
            files = rtl_files.library() + rtl_files.generated(self.config, build)
            self.joined = joining.Joined.of_core(next(f for f in files if f.stem == row))
            self.current = self.about["verilog"] == place_record.hash_of(row, files)
        self._modules = sorted(set(self.joined.modules.values()) & self._units.keys())
        if not self._modules:
            raise project.Failed(
                f"the build {build} has no unit '{row}' of the configuration '{self.config}'; name a "
                "build that has with --build"
            )

    @property
    def name(self) -> str:
        """What the row is called in texts and in the documents."""
        grade = f", grade {self.record['grade']}" if self.record["grade"] else ""
        what = self.config if self.row == rtl_files.CORE else self.row
        return f"{what} on {self.record['device']}{grade}"

    def evaluate(self, model: fitting.Model, names: Sequence[str]) -> Result:
        """All ends by a model, with the counts of the constants of these names."""
        times = self._times([*fitting.beside(model, names), model])
        result = Result(promised=max(ns[-1] for ns in times.values()))
        for end in self.ends:
            found = joining.places(end, self.joined)
            known = [] if isinstance(found, str) else [times[p] for p in found if p in times]
            if known:
                ns = max(known, key=lambda one: one[-1])
                sample = fitting.Sample(
                    end["median"], ns[-1], fitting.counts(model, names, ns[:-1])
                )
                result.ends.append((end, sample))
            else:
                result.unpredicted[found if isinstance(found, str) else joining.UNKNOWN] += 1
        return result

    def _times(self, models: Sequence[fitting.Model]) -> dict[joining.Place, list[float]]:
        """When the signals of every instance arrive, by the models. joining.READY is the latest of
        a unit's."""
        with tempfile.TemporaryDirectory() as scratch, Pool(self._jobs) as pool:
            folder = pathlib.Path(scratch)
            files = [folder / f"model_{i}.json" for i in range(len(models) + 1)]
            for path, model in zip(files, [self.record["models"][self.about["delay"]], *models]):
                path.write_text(json.dumps(model), encoding="utf-8")
            found = dict(
                zip(self._modules, pool.map(lambda m: self._unit(m, files), self._modules))
            )
        times: dict[joining.Place, list[float]] = {}
        for instance, module in self.joined.modules.items():
            ends = found.get(module, {})
            times |= {joining.Place(instance, signal): ns for signal, ns in ends.items()}
            ready = [ns for signal, ns in ends.items() if signal.endswith(joining.READY[1:])]
            if ready:
                times[joining.Place(instance, joining.READY)] = max(ready)
        return times

    def _unit(self, module: str, models: Sequence[pathlib.Path]) -> dict[str, list[float]]:
        folder = models[0].parent
        verilog, timing = folder / f"{module}.v", folder / f"{module}.json"
        others = [f"--time-by={path}" for path in models[1:]]
        made = lowering.command(
            self._build, self._units[module], self.about["clock_ns"], models[0], self.config
        )
        lowering.run([*made, *others, "-o", verilog, "--timing", timing])
        if self.row == module:
            files = rtl_files.hand_written() + [verilog]
            self.current = self.about["verilog"] == place_record.hash_of(module, files)
        return {end["signal"]: end["ns"][1:] for end in read_json(timing)["ends"]}
