# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Holds the delay models to the kept placements, without a placer: by the residuals that
scripts/fit-delays --record leaves in docs/results/data."""

import copy
import unittest

from dynrt_tools import project
from dynrt_tools.hardware import fit_data, fit_delays, kept_placement, model_file
from dynrt_tools.project import Json

FITS = sorted(fit_delays.DATA.glob("fit_*.json"))


class Models(unittest.TestCase):
    def test_each_holds_what_its_data_record(self) -> None:
        self.assertTrue(FITS)
        for path in FITS:
            data = project.read_json(path)
            where = path.relative_to(project.ROOT).as_posix()
            self.assertEqual(fit_data.check(data, fit_data.model_of(data), where), [])

    def test_each_is_of_kept_placements(self) -> None:
        groups = fit_delays.chosen([])
        self.assertEqual(
            {fit_delays.data_name(model) for model in groups}, {path.name for path in FITS}
        )
        for model, files in groups.items():
            data = project.read_json(fit_delays.DATA / fit_delays.data_name(model))
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


class Changed(unittest.TestCase):
    """What check() says of two ends of 2 and 6 ns; of 3 constants each takes two."""

    MODEL = {"clock_overhead": 1.0, "lut": 1.0, "carry_start": 2.0}
    DATA: Json = {
        "model": "m.json",
        "constants": {name: {"value": value} for name, value in MODEL.items()},
        "bound": {"within": 1.0, "missed": 0.05},
        "ends": [
            {"placed": 2.1, "counts": {"clock_overhead": 1, "lut": 1}},
            {"placed": 6.2, "counts": {"clock_overhead": 1, "lut": 3, "carry_start": 1}},
        ],
        "placements": [
            {
                "placement": "p",
                "placed, ns": 6.2,
                "longest": [{"counts": {"clock_overhead": 1, "lut": 3, "carry_start": 1}}],
            }
        ],
    }

    def said(self, data: Json | None = None, **constants: float) -> str:
        return "\n".join(fit_data.check(data or self.DATA, {**self.MODEL, **constants}, "f.json"))

    def test_the_same_constants_hold(self) -> None:
        self.assertEqual(self.said(), "")

    def test_another_constant_is_named(self) -> None:
        self.assertIn(
            "m.json: lut is 1.6, and the residuals of f.json are those of 1.0; run",
            self.said(lut=1.6),
        )

    def test_fewer_ends_within_the_bound_are_an_error(self) -> None:
        self.assertIn(
            "m.json: 0.0 % of the 2 limiting ends in f.json are within 10 %", self.said(lut=1.6)
        )
        self.assertIn("m.json: 50.0 % of the 2", self.said(carry_start=1.0))

    def test_a_promise_that_is_missed_by_more_is_an_error(self) -> None:
        said = self.said(carry_start=1.0)
        self.assertIn("p takes 6.2 ns, which misses the promised 5.00 ns by 24.0 %", said)
        self.assertNotIn("misses", self.said(carry_start=2.2))

    def test_without_ends_the_constants_count_alone(self) -> None:
        data: Json = copy.deepcopy(self.DATA) | {"ends": [], "placements": []}
        self.assertEqual(self.said(data), "")


if __name__ == "__main__":
    unittest.main()
