# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What a fit leaves in docs/results/data: the residual of each limiting end, with the counts of the
constants that make its prediction. So a test can hold the constants of the model to the placements
without a placer and without hlsc."""

import math
import pathlib
from collections import Counter
from collections.abc import Mapping

from dynrt_tools import project
from dynrt_tools.hardware import fit_case, fitting, kept_placement
from dynrt_tools.project import Json

NEAR = 0.1  # a prediction is good within this part of the placed time
ROUND = 4


def of_cases(
    model_file: str,
    model: fitting.Model,
    fitted: fitting.Model,
    results: Mapping[str, tuple[fit_case.Case, fit_case.Result]],
    after: Mapping[str, fit_case.Result],
) -> Json:
    """The data of a model: `results` by its constants, `after` by those that the fit found."""
    family = family_of(next(iter(results.values()))[0].kept["device"])
    bounds = fitting.TIMES[family]
    placements = []
    for name, (case, result) in results.items():
        promised = result.promised[0][1].predicted
        placements.append(
            {
                "placement": name,
                "unit": case.kept["unit"],
                "device": case.kept["device"],
                "grade": case.kept["grade"],
                "placed, ns": round(case.period, 3),
                "promised, ns": round(promised, 3),
                "promised by the fit, ns": round(after[name].promised[0][1].predicted, 3),
                "missed": round(case.period / promised - 1, ROUND),
                "limiting": len(case.ends),
                "predicted": len(result.rows),
                "within": share(result.rows),
                "within by the fit": share(after[name].rows),
                "longest": [
                    {"unit": p.unit, "signal": p.signal, "counts": s.counts}
                    for p, s in result.promised
                ],
            }
        )
    rows = [row for _, result in results.values() for row in result.rows]
    fit_rows = [row for result in after.values() for row in result.rows]
    reasons = Counter(why for _, r in results.values() for _, why in r.unpredicted)
    missed = max(p["missed"] for p in placements)
    near = share(rows)
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
        "within": near,
        "within by the fit": share(fit_rows),
        "missed": missed,
        "limiting": sum(p["limiting"] for p in placements),
        "predicted": len(rows),
        # What no change of a constant may make worse.
        "bound": {
            "within": None if near is None else math.floor(near * 1000) / 1000,
            "missed": math.ceil(missed * 1000) / 1000,
        },
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


def share(rows: list[fit_case.Row]) -> float | None:
    """Within NEAR, rounded; None where there are none."""
    part = fit_case.within(rows, NEAR)
    return None if part is None else round(part, ROUND)


def family_of(device: str) -> str:
    """The key of fitting.TIMES."""
    return "ecp5" if device.startswith("ecp5") else "ice40"


def write(path: pathlib.Path, data: Json) -> None:
    project.write_rows(path, data, "ends", "without prediction")


def check(data: Json, model: fitting.Model, where: str) -> list[str]:
    """A sentence for each way in which a model's constants do not hold what the data record."""
    renew = "run scripts/fit-delays --record after a change, or take the change back"
    found = [
        f"{data['model']}: {name} is {model[name]}, and the residuals of {where} are those of "
        f"{constant['value']}; {renew}"
        for name, constant in data["constants"].items()
        if model[name] != constant["value"]
    ]
    ends = data["ends"]
    near = [abs(fitting.total(e["counts"], model) / e["placed"] - 1) <= NEAR for e in ends]
    part = round(sum(near) / len(near), ROUND) if near else None
    bound = data["bound"]
    if part is not None and part < bound["within"]:
        found.append(
            f"{data['model']}: {100 * part:.1f} % of the {len(near)} limiting ends in {where} are "
            f"within {100 * NEAR:.0f} % of their placed time; its bound is "
            f"{100 * bound['within']:.1f} %; {renew}"
        )
    for placement in data["placements"]:
        promised = max(fitting.total(e["counts"], model) for e in placement["longest"])
        missed = round(placement["placed, ns"] / promised - 1, ROUND)
        if missed > bound["missed"]:
            found.append(
                f"{data['model']}: {placement['placement']} takes {placement['placed, ns']} ns, "
                f"which misses the promised {promised:.2f} ns by {100 * missed:.1f} %; the bound in "
                f"{where} is {100 * bound['missed']:.1f} %; {renew}"
            )
    return found


def model_of(data: Json) -> fitting.Model:
    """The present constants of the model that the data are of."""
    path = project.ROOT / data["model"]
    return {k: float(v) for k, v in project.read_json(path).items() if k in data["constants"]}
