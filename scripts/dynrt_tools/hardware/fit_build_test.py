# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Holds the kept residuals of the delay models to the hlsc of a build: its predictions of what was
placed are still those, and what is of an earlier Verilog is marked as such."""

import os
import pathlib
import sys
import unittest

from dynrt_tools import project
from dynrt_tools.hardware import fit_case, kept_placement, model_file
from dynrt_tools.project import Json

BUILD = pathlib.Path(sys.argv.pop()) if __name__ == "__main__" else project.ROOT / "build/release"
RENEW = "run scripts/fit-delays --record"
SAME = 0.002  # part of a time; the data have them rounded


def named(end: Json) -> tuple[str, ...]:
    return end["unit"], end["signal"], end["port"]


class Predictions(unittest.TestCase):
    def test_the_data_are_what_hlsc_predicts(self) -> None:
        for path in sorted(kept_placement.DATA.glob("fit_*.json")):
            data = project.read_json(path)
            for placement in data["placements"]:
                with self.subTest(path.name, placement=placement["placement"]):
                    self.compare(data, placement)

    def compare(self, data: Json, placement: Json) -> None:
        name = placement["placement"]
        case = fit_case.Case(kept_placement.file_of(name), BUILD, os.cpu_count() or 1)
        model = model_file.read(project.ROOT / data["model"])
        result = case.evaluate(model, list(data["constants"]))
        present = case.of_present_verilog()
        if kept_placement.of_checked_in(case.kept):
            # What tells by itself is of the present Verilog is what hlsc makes again.
            self.assertEqual(present, kept_placement.is_current(case.kept))
        else:
            self.assertEqual(name in data["earlier"], not present, RENEW)
        if not present:
            self.skipTest(f"{name} is of an earlier Verilog, of which hlsc predicts nothing now")
        predicted = {named(row.end): row.sample.predicted for row in result.rows}
        kept = {named(e): e["predicted"] for e in data["ends"] if e["placement"] == name}
        self.assertEqual(kept.keys(), predicted.keys(), RENEW)
        for end, ns in kept.items():
            self.assertAlmostEqual(predicted[end], ns, delta=SAME * ns, msg=f"{end}; {RENEW}")
        promised = result.promised
        self.assertAlmostEqual(promised, placement["promised, ns"], delta=SAME * promised)


if __name__ == "__main__":
    unittest.main()
