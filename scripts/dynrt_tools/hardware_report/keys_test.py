# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Hardware reports whose figures go along a key: each of its values is a core of its own."""

import unittest
from unittest import mock

from dynrt_tools import project
from dynrt_tools.hardware_report import additions
from dynrt_tools.hardware_report.additions import Addition
from dynrt_tools.hardware_report.report_case import ALL_FRAMES, Case


class Keys(Case):
    def test_each_value_of_a_key_is_a_core_of_its_own(self) -> None:
        self.assertEqual(self.run_report("blocks", figure=[]), (0, ""))
        # The Verilog of each core, and the models of the eight. Of two of them an index is shown.
        self.assertEqual(len(self.ran()), 8 + 2 * 8 + 2 + ALL_FRAMES + 1)
        counted = sorted(line for line in self.ran() if line.startswith("gates wide-pipelines"))
        self.assertEqual(counted, ["gates wide-pipelines2", "gates wide-pipelines4"])
        for name, keys in (
            ("pipelines4", {"pipelines": 4}),
            ("memory_clocks8", {"memory_clocks": 8}),
        ):
            model = project.read_json(self.work / "models" / f"wide-{name}.json")
            self.assertEqual(
                model, {**project.read_json(self.work / "cores" / "wide.json"), **keys}
            )
            # Counters of several pipelines may be too many for the Verilog.
            counters = "pipelines" not in keys
            core = project.read_json(self.work / "cores" / f"wide-{name}.json")
            self.assertEqual(core, {**model, "counters": counters})
            (line,) = [line for line in self.ran() if f"--config models/wide-{name}.so" in line]
            self.assertIn(f"--schedule cores/wide-{name}/verilog", line)
        runs = [r for r in self.made()["runs"] if r["configuration"] == "wide"]
        (own,) = [r for r in runs if r["flags"] == {"packets": 4, "lines": 2, "order": "morton"}]
        (four,) = [r for r in runs if r["flags"].get("pipelines") == 4]
        self.assertEqual(own["clocks"], 4 * four["clocks"])
        self.assertEqual(4 * own["C_AU + C_IM"], four["C_AU + C_IM"])
        self.assertAlmostEqual(four["QGHW"], own["QGHW"])
        (sixteen,) = [r for r in runs if r["flags"].get("pipelines") == 16]
        self.assertNotIn("QGHW", sixteen)

    def test_a_model_that_cannot_be_built_is_named(self) -> None:
        """And a frame of the model that was there before does not count."""
        self.assertEqual(self.run_report("blocks", figure=["7.12"]), (0, ""))
        self.program.write_text(self.program.read_text() + "# changed\n", encoding="utf-8")
        (self.work / "fail_model").write_text("", encoding="utf-8")
        code, said = self.run_report("blocks", figure=["7.12"])
        self.assertEqual(code, 1)
        self.assertEqual(
            said.splitlines(),
            [
                "dynrt: missing: wide-pipelines2: building its model failed: configuration: cannot be "
                "built",
                "dynrt: missing: blocks, wide: 1 of 6 walks",
            ],
        )

    def test_cores_made_for_scenes(self) -> None:
        made = Addition("a core made for the scene", "wide", {}, made=True)
        self.enterContext(mock.patch.object(additions, "ADDITIONS", (made,)))
        self.assertEqual(self.run_report("blocks", "lamps", figure=["additions"]), (0, ""))
        self.assertEqual(
            sorted(line for line in self.ran() if line.startswith("specialise")),
            [f"specialise {scene} --keep counters" for scene in ("blocks", "lamps")],
        )
        (line,) = [line for line in self.ran() if "--config models/wide-made-lamps.so" in line]
        self.assertIn("--schedule cores/wide-made-lamps/verilog", line)
        self.assertNotIn("--packets", line)
        (row, other) = self.made()["additions"]
        self.assertEqual((row["scene"], other["scene"]), ("blocks", "lamps"))
        # Of 4 packets and 2 lines, and of 2 packets and 1 line.
        self.assertAlmostEqual(row["gates added"], 100 * ((1020 + 430) / (1040 + 860) - 1))
        self.assertAlmostEqual(row["frame rate gained"], -50)
        self.assertAlmostEqual(row["QGHW with"], 1e6 * (768 / 38400) / (1020 + 430))

        self.program.write_text(self.program.read_text() + "# changed\n", encoding="utf-8")
        (self.work / "fail_specialise").write_text("", encoding="utf-8")
        code, said = self.run_report("blocks", figure=["additions"])
        self.assertEqual(code, 1, said)
        self.assertEqual(
            said.splitlines(),
            [
                "dynrt: missing: blocks.wide: making a core for the scene failed: no core can be made",
                "dynrt: missing: blocks, wide: 1 of 3 walks",
            ],
        )
        (row,) = self.made()["additions"]
        self.assertIsNone(row["QGHW with"])
        self.assertIsNotNone(row["QGHW without"])

    def test_some_figures(self) -> None:
        self.assertEqual(self.run_report("blocks", figure=["7.11", "7.10"]), (0, ""))
        drawings = sorted(path.name for path in self.out.glob("*.svg"))
        self.assertEqual(drawings, ["figure_7_11.svg", "figure_7_5_and_7_10.svg"])
        flags = [r["flags"] for r in self.made()["runs"] if r["configuration"] == "wide"]
        self.assertEqual([f["memory_clocks"] for f in flags if "memory_clocks" in f], [2, 4, 8, 16])
        self.assertFalse(any("pipelines" in f for f in flags))
        self.assertEqual(
            self.run_report("blocks", figure=["7.13"]),
            (
                2,
                "dynrt: --figure 7.13: unknown; the figures are 7.5, 7.10, 7.6, 7.7, 7.8, 7.9, 7.11, "
                "7.12, additions\n",
            ),
        )


if __name__ == "__main__":
    unittest.main()
