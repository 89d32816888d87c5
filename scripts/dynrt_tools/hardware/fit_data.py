# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What a fit leaves in docs/results/data: the residual of each limiting end, with the counts of the
constants that make its prediction. So a test can hold the constants of the model to the placements
without a placer and without hlsc."""

import pathlib
from collections import Counter
from collections.abc import Iterable, Mapping

from dynrt_tools import project
from dynrt_tools.hardware import devices, fit_case, fitting, kept_placement
from dynrt_tools.project import Json

NEAR = 0.1  # a prediction is good within this part of the placed time


def of_cases(
    model_file: str,
    model: fitting.Model,
    fitted: fitting.Model,
    results: Mapping[str, tuple[fit_case.Case, fit_case.Result]],
    after: Mapping[str, fit_case.Result],
) -> Json:
    """The data of a model: `results` by its constants, `after` by those that the fit found."""
    family = devices.family_of(next(iter(results.values()))[0].kept["device"])
    bounds = fitting.TIMES[family]
    placements = []
    for name, (case, result) in results.items():
        placements.append(
            {
                "placement": name,
                "unit": case.kept["unit"],
                "device": case.kept["device"],
                "grade": case.kept["grade"],
                "placed, ns": round(case.period, 3),
                "promised, ns": round(result.promised, 3),
                "promised by the fit, ns": round(after[name].promised, 3),
                "limiting": len(case.ends),
                "predicted": len(result.rows),
                "within": share(row.miss() for row in result.rows),
                "within by the fit": share(row.miss() for row in after[name].rows),
            }
        )
    rows = [row for _, result in results.values() for row in result.rows]
    fit_rows = [row for result in after.values() for row in result.rows]
    reasons = Counter(why for _, r in results.values() for _, why in r.unpredicted)
    return {
        "model": model_file,
        "constants": {
            name: {
                "value": model[name],
                "fitted": fitted[name],
                "least": least,
                "most": most,
            }
            for name, (least, most) in bounds.items()
        },
        "within": share(row.miss() for row in rows),
        "within by the fit": share(row.miss() for row in fit_rows),
        "limiting": sum(p["limiting"] for p in placements),
        "predicted": len(rows),
        "placements": placements,
        # Placed units whose Verilog hlsc now lowers otherwise. What is checked in tells by itself.
        "earlier": [
            name
            for name, (case, _) in results.items()
            if not kept_placement.of_checked_in(case.kept) and not case.of_present_verilog()
        ],
        "not predicted": dict(reasons.most_common()),
        "ends": [
            {
                **_named(name, row.end),
                "source": row.source or row.end["source"],
                "kind": row.kind,
                "placed": row.sample.placed,
                "predicted": round(row.sample.predicted, 3),
                "counts": row.sample.counts,
            }
            for name, (_, result) in results.items()
            for row in sorted(result.rows, key=fit_case.Row.miss)
        ],
        "without prediction": [
            {**_named(name, end), "source": end["source"], "placed": end["median"], "why": why}
            for name, (_, result) in results.items()
            for end, why in result.unpredicted
        ],
    }


def _named(placement: str, end: Json) -> Json:
    return {"placement": placement, **{k: end[k] for k in ("unit", "signal", "port")}}


def share(misses: Iterable[float]) -> float | None:
    """Of misses, the part within NEAR, rounded; None where there are none."""
    near = [abs(miss) <= NEAR for miss in misses]
    return round(sum(near) / len(near), 4) if near else None


def write(path: pathlib.Path, data: Json) -> None:
    project.write_rows(path, data, "ends", "without prediction")
