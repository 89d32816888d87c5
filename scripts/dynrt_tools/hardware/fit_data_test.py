# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Holds the delay models to the kept placements, without a placer: by the residuals that
scripts/fit-delays --record leaves in docs/results/data."""

import unittest
from typing import NamedTuple

from dynrt_tools import project
from dynrt_tools.hardware import fit_data, fit_delays, fitting, kept_placement, model_file

FITS = sorted(kept_placement.DATA.glob("fit_*.json"))


class Bounds(NamedTuple):
    """--record leaves them as they are: what makes a model worse fails here."""

    good: float  # the least part of the predictions
    late: float  # the most by which a placement takes longer than hlsc promises
    predicted: float  # the least part of a placement's ends that limit


BOUNDS = {
    "fit_ecp5": Bounds(good=0.831, late=0.0, predicted=0.84),
    "fit_ecp5_8": Bounds(good=0.95, late=0.0, predicted=0.9),
    "fit_ice40_hx": Bounds(good=0.73, late=0.086, predicted=0.8),
}
# Placements that take longer than any other may: docs/results/devices.md says why.
LATE = {"place_core_full": 0.05}
# Placements with bounds of their own: wires take three quarters of what limits them. Each seed makes
# others long, of which the model, without places, knows nothing.
BOUND_BY_WIRES = {"place_core_fast": Bounds(good=0.5, late=0.15, predicted=0.66)}
RENEW = "run scripts/fit-delays --record after a change, or take the change back"


def share_within(ends: list[project.Json]) -> float | None:
    return fit_data.share(end["predicted"] / end["placed"] - 1 for end in ends)


class Models(unittest.TestCase):
    def test_the_data_are_of_the_present_constants(self) -> None:
        self.assertTrue(FITS)
        for path in FITS:
            data = project.read_json(path)
            model = model_file.read(project.ROOT / data["model"])
            for name, constant in data["constants"].items():
                where = f"{name} of {data['model']} and of {path.name}; {RENEW}"
                self.assertEqual(model[name], constant["value"], where)

    def test_no_model_is_worse_than_its_bounds(self) -> None:
        self.assertEqual({path.stem for path in FITS}, BOUNDS.keys())
        for path in FITS:
            data = project.read_json(path)
            bounds = BOUNDS[path.stem]
            self.assertEqual(share_within(data["ends"]), data["within"], path)
            judging = [end for end in data["ends"] if end["placement"] not in BOUND_BY_WIRES]
            self.assertGreaterEqual(share_within(judging) or 0, bounds.good, path)
            for placement in data["placements"]:
                name = placement["placement"]
                own = BOUND_BY_WIRES.get(name, bounds)
                if name in BOUND_BY_WIRES:
                    self.assertGreaterEqual(placement["within"], own.good, path)
                # hlsc promises for the present Verilog, and predicts other ends of an earlier one.
                kept = project.read_json(kept_placement.file_of(name))
                if name in data["earlier"] or kept_placement.is_earlier(kept):
                    continue
                where = f"{path}: {name}"
                late = placement["placed, ns"] / placement["promised, ns"] - 1
                self.assertLessEqual(late, LATE.get(name, own.late), where)
                least = own.predicted * placement["limiting"]
                self.assertGreaterEqual(placement["predicted"], least, where)

    def test_the_counts_of_an_end_make_its_prediction(self) -> None:
        for path in FITS:
            data = project.read_json(path)
            model = {name: c["value"] for name, c in data["constants"].items()}
            for end in data["ends"]:
                made = fitting.total(end["counts"], model)
                self.assertAlmostEqual(made, end["predicted"], delta=0.005, msg=(path, end))

    def test_each_is_of_kept_placements(self) -> None:
        groups = fit_delays.chosen([])
        self.assertEqual(
            {fit_delays.data_name(model) for model in groups}, {path.name for path in FITS}
        )
        for model, files in groups.items():
            data = project.read_json(kept_placement.DATA / fit_delays.data_name(model))
            self.assertEqual(project.ROOT / data["model"], model_file.base_of(model))
            placements = {p["placement"]: p for p in data["placements"]}
            self.assertEqual(placements.keys(), {path.stem for path in files})
            for path in files:
                kept = kept_placement.read(path)
                about = placements[path.stem]
                self.assertEqual(about["limiting"], len(kept_placement.that_limit(kept)))
                self.assertAlmostEqual(
                    about["placed, ns"], kept_placement.period(kept), delta=0.001
                )

    def test_every_limiting_end_is_predicted_or_has_a_reason(self) -> None:
        for path in FITS:
            data = project.read_json(path)
            self.assertEqual(
                len(data["ends"]) + len(data["without prediction"]), data["limiting"], path
            )
            self.assertEqual(sum(data["not predicted"].values()), len(data["without prediction"]))


if __name__ == "__main__":
    unittest.main()
