# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""When hlsc predicts the ends of a kept placement, by any delay model.

hlsc makes the schedule of the placement again, by the delay model that the placement keeps, and
times it by the others; so the Verilog that the times are of is the one that was placed."""

import json
import pathlib
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass

from dynrt_tools import project
from dynrt_tools.command import Pool
from dynrt_tools.hardware import fitting, joining, kept_placement, lowering, rtl_files, synthesis
from dynrt_tools.project import Json, read_json


@dataclass(frozen=True)
class Predicted:
    """An end of a unit's paths: what it is, its line, and its time by each model."""

    kind: str
    source: str
    ns: tuple[float, ...]


class Predictor:
    """Of a kept placement, with the hlsc of a build."""

    def __init__(self, kept: Json, build: pathlib.Path, jobs: int) -> None:
        self._build, self._jobs = build, jobs
        self._kept = kept
        self._units = lowering.units(build, kept["config"])
        self._whole = kept["unit"] in rtl_files.WHOLE
        checked_in = rtl_files.checked_in(kept["config"])
        self._folder = checked_in or build / "generated" / kept["config"]
        if self._whole:
            core = self._folder / f"{rtl_files.CORE}.v"
            if not core.is_file():
                raise project.Failed(
                    f"{core}: there is no such file; build the configuration '{kept['config']}'"
                )
            self.joined = joining.Joined.of_core(core)
        else:
            self.joined = joining.Joined({kept["unit"]: kept["unit"]})
        self.modules = sorted(set(self.joined.modules.values()) & self._units.keys())
        if not self.modules:
            raise project.Failed(
                f"the build {build} has no unit '{kept['unit']}' of the configuration "
                f"'{kept['config']}'; name a build that has with --build"
            )
        self._same = True  # every module that was lowered again is that of the placed Verilog

    def times(self, models: Sequence[fitting.Model]) -> dict[joining.Place, Predicted]:
        """Every end of every instance, by the models. joining.READY is the latest of a unit's."""
        with tempfile.TemporaryDirectory() as scratch, Pool(self._jobs) as pool:
            folder = pathlib.Path(scratch)
            files = []
            for i, model in enumerate([self._kept["model"], *models]):
                files.append(folder / f"model_{i}.json")
                files[-1].write_text(json.dumps(model), encoding="utf-8")
            found = dict(
                zip(self.modules, pool.map(lambda m: self._unit(m, files, folder), self.modules))
            )
        times = {}
        for instance, module in self.joined.modules.items():
            ends = found.get(module, {})
            for signal, end in ends.items():
                times[joining.Place(instance, signal)] = end
            ready = [e for signal, e in ends.items() if signal.endswith(joining.READY[1:])]
            if ready:
                times[joining.Place(instance, joining.READY)] = max(ready, key=lambda e: e.ns)
        return times

    def _unit(
        self, module: str, models: list[pathlib.Path], folder: pathlib.Path
    ) -> dict[str, Predicted]:
        verilog, timing = folder / f"{module}.v", folder / f"{module}.json"
        others = [f"--time-by={path}" for path in models[1:]]
        made = lowering.command(
            self._build,
            self._units[module],
            self._kept["clock_ns"],
            models[0],
            self._kept["config"],
        )
        lowering.run([*made, *others, "-o", verilog, "--timing", timing])
        if not self._is_placed(module, verilog):
            self._same = False  # by any thread; none sets it back
        return {
            end["signal"]: Predicted(end["kind"], end["source"], tuple(end["ns"][1:]))
            for end in read_json(timing)["ends"]
        }

    def _is_placed(self, module: str, verilog: pathlib.Path) -> bool:
        """Whether a module that was lowered again is that of the placement: of a core's by the core
        that there is, which of_present_verilog() holds against the placed one."""
        if self._whole:
            there = self._folder / verilog.name
            return there.is_file() and synthesis.meaning(verilog) == synthesis.meaning(there)
        files = rtl_files.hand_written() + [verilog]
        return bool(self._kept["verilog"] == kept_placement.hash_of(module, files))

    def of_present_verilog(self) -> bool:
        """Whether the placement is of the Verilog that there is now, and the times are of that too;
        after times() alone."""
        current = not self._whole or kept_placement.is_current(self._kept, self._folder)
        return current and self._same
