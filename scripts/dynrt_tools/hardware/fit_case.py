# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""A kept placement as a fit sees it: its limiting ends with hlsc's predictions, and those that have
none with the reason."""

import pathlib
from collections.abc import Sequence
from dataclasses import dataclass, field

from dynrt_tools.hardware import fitting, joining, kept_placement, predictions
from dynrt_tools.project import Json


@dataclass(frozen=True)
class Row:
    """A limiting end with its prediction."""

    end: Json
    kind: str
    source: str
    sample: fitting.Sample

    def miss(self) -> float:
        """How much the prediction is above the placed time, as a part of that."""
        return self.sample.predicted / self.sample.placed - 1


@dataclass
class Result:
    """A case by one model."""

    rows: list[Row] = field(default_factory=list)
    unpredicted: list[tuple[Json, str]] = field(default_factory=list)
    promised: float = 0.0  # the longest predicted time of any end


class Case:
    """A kept placement and its predictor."""

    def __init__(self, file: pathlib.Path, build: pathlib.Path, jobs: int) -> None:
        self.name = file.stem
        self.kept = kept_placement.read(file)
        self.period = kept_placement.period(self.kept)
        self.ends = kept_placement.that_limit(self.kept)
        self._predictor = predictions.Predictor(self.kept, build, jobs)

    def of_present_verilog(self) -> bool:
        """After evaluate() alone."""
        return self._predictor.of_present_verilog()

    def evaluate(self, model: fitting.Model, names: Sequence[str]) -> Result:
        """All ends by a model, with the counts of the constants of these names."""
        times = self._predictor.times([*fitting.beside(model, names), model])

        def sample(place: joining.Place, placed: float) -> fitting.Sample:
            ns = times[place].ns
            return fitting.Sample(placed, ns[-1], fitting.counts(model, names, ns[:-1]))

        result = Result()
        for end in self.ends:
            found = joining.places(end, self._predictor.joined)
            known = [] if isinstance(found, str) else [p for p in found if p in times]
            if not known:
                reason = found if isinstance(found, str) else joining.UNKNOWN
                result.unpredicted.append((end, reason))
                continue
            latest = max(known, key=lambda place: times[place].ns[-1])
            about = times[latest]
            result.rows.append(Row(end, about.kind, about.source, sample(latest, end["median"])))
        result.promised = max(end.ns[-1] for end in times.values())
        return result
