# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""scripts/fit-delays from its files to its files, with a stand-in for hlsc."""

import json
import pathlib
import shutil
import unittest

from dynrt_tools import project, testing
from dynrt_tools.hardware import model_file, place_record, rtl_files
from dynrt_tools.project import Json

# Times two ends by any model: after 3 LUTs, and behind a RAM. The Verilog is that of the folder.
STAND_IN = """#!/usr/bin/python3
import json, pathlib, sys
args = sys.argv[1:]
value = {a: b for a, b in zip(args, args[1:]) if a.startswith("-")}
folder = pathlib.Path(__file__).parent
if (folder / "refuses").exists():
    sys.exit("units/sum.h:3: error: no")
paths = [value["--delay"]] + [a.partition("=")[2] for a in args if a.startswith("--time-by=")]
models = [json.loads(pathlib.Path(p).read_text()) for p in paths]
ends = {
    "near_s1": ("units/sum.h:4", [m["clock_overhead"] + 3 * m["lut"] for m in models]),
    "far_s2": ("units/sum.h:5", [m["clock_overhead"] + m["ram_out"] for m in models]),
}
pathlib.Path(value["-o"]).write_text((folder / "sum.v").read_text())
pathlib.Path(value["--timing"]).write_text(json.dumps({"ends": [
    {"signal": s, "kind": "register", "source": at, "ns": ns} for s, (at, ns) in ends.items()]}))
"""
# The least part of the predictions that is good. --record leaves it as it is.
GOOD = {"fit_ecp5": 0.82, "fit_ecp5_8": 0.95, "fit_ice40_hx": 0.73}
RENEW = "run scripts/fit-delays --record after a change, or take the change back"
VERILOG = "module sum (input clk_i);\nendmodule\n"


class Called(testing.InFolder):
    def setUp(self) -> None:
        super().setUp()
        build = self.folder / "build"
        testing.write_tree(
            build,
            {
                "hls/units/list_units.txt": "thesis|sum|units/sum.h|Sum\n",
                "hls/compiler/sum.v": VERILOG,
            },
        )
        self.hlsc = build / "hls" / "compiler" / "hlsc"
        testing.write_program(self.hlsc, STAND_IN)
        self.kept = self.folder / "place_sum.json"
        place_record.write(self.kept, self.record())

    def record(self) -> Json:
        ends = [("near_s1", 6.0), ("far_s2", 9.0), ("out_fifo.space_q", 8.9)]
        start = {"unit": "sum", "signal": "out_fifo.read_q"}
        delay = "hls/compiler/delay/ecp5.json"
        verilog = place_record.hash_of("sum", [self.hlsc.parent / "sum.v"])
        row = {"mhz": 3 * [1000 / 9], "clock_ns": 8.0, "delay": delay, "verilog": verilog}
        return {
            **{"config": "thesis", "device": "ecp5-85", "grade": "6", "asked_mhz": 125.0},
            **{"copies": 1, "date": "2026-11-25", "limits": 0.5, "units": {"sum": row}},
            "models": {delay: model_file.constants(project.ROOT / delay)},
            "ends": [
                {
                    **{"row": "sum", "unit": "sum", "signal": signal, "port": ""},
                    **{"source": "sum.v:1", "from": start, "ns": 3 * [ns], "median": ns},
                }
                for signal, ns in ends
            ],
        }

    def call(self, *words: testing.Word) -> testing.Result:
        build = f"--build={self.folder / 'build'}"
        return testing.run(project.SCRIPTS / "fit-delays", build, "--jobs=1", *words)

    def changed(self, old: str, new: str) -> pathlib.Path:
        """The record with another text."""
        self.assertIn(old, self.kept.read_text("utf-8"))
        self.kept.write_text(self.kept.read_text("utf-8").replace(old, new), "utf-8")
        return self.kept

    def test_constants_before_and_after(self) -> None:
        done = self.call(self.kept)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        before = model_file.constants(project.ROOT / "hls/compiler/delay/ecp5.json")["ram_out"]
        self.assertRegex(done.stdout, rf"ram_out +{before:g} +[5678](\.\d+)?\n")
        self.assertRegex(done.stdout, r"\nsum on ecp5-85, grade 6 +3 +2 +\d+% +9.00 +\d")
        self.assertIn("sum: near_s1 (sum.v:1) = 1 clock_overhead + 3 lut\n", done.stdout)
        self.assertIn(
            "Not predicted are 1 limiting ends:\n     1 at a FIFO's pointers", done.stdout
        )

    def test_another_grade_starts_from_the_model_of_its_family(self) -> None:
        done = self.call(self.changed('"grade": "6"', '"grade": "7"'))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertTrue(done.stdout.startswith("hls/compiler/delay/ecp5.json\n"))

    def test_a_changed_verilog_is_named(self) -> None:
        (self.hlsc.parent / "sum.v").write_text(VERILOG.replace("clk_i", "clock_i"), "utf-8")
        done = self.call(self.kept)
        self.assertEqual(done.returncode, 0)
        said = (
            "the Verilog of sum on ecp5-85, grade 6 has changed since it was placed on 25 November"
        )
        self.assertIn(said, done.stderr)

    def test_a_core_is_predicted_by_its_units(self) -> None:
        build = self.folder / "build"
        core = VERILOG.replace("sum", rtl_files.CORE).replace(
            "endmodule", "  sum u_sum (\n    .clk_i(clk_i));\nendmodule"
        )
        units = {f"{rtl_files.CORE}.v": core, "sum.v": VERILOG}
        testing.write_tree(build / "generated" / "small", units)
        testing.write_tree(build, {"hls/units/list_units.txt": "small|sum|units/sum.h|Sum\n"})
        self.changed('"thesis"', '"small"')
        self.changed('"row": "sum"', f'"row": "{rtl_files.CORE}"')
        self.changed('"sum": {', f'"{rtl_files.CORE}": {{')
        done = self.call(self.kept)
        self.assertEqual(done.returncode, 0)
        self.assertIn("the Verilog of small on ecp5-85, grade 6 has changed", done.stderr)
        self.assertRegex(done.stdout, r"\nsmall on ecp5-85, grade 6 +3 +2 ")

    def fails(self, said: str, *words: testing.Word) -> None:
        done = self.call(*words)
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertIn(said, done.stderr)

    def test_what_hlsc_refuses_ends_it(self) -> None:
        (self.hlsc.parent / "refuses").touch()
        self.fails("fit-delays: units/sum.h:3: error: no", self.kept)

    def test_wrong_records(self) -> None:
        self.fails("none.json: is no record of placements", self.folder / "none.json")
        text = self.kept.read_text("utf-8")
        for old, new, said in (
            ('"sum"', '"total"', "has no unit 'total' of the configuration 'thesis'"),
            ("ecp5-85", "virtex2-6000", "hlsc has no delay model of 'virtex2-6000'"),
            ('"copies": 1', '"copies": 2', "no record has 3 seeds or more that missed the clock"),
            (
                '"asked_mhz": 125',
                '"asked_mhz": 100',
                "make one with 'scripts/place UNIT --ask-mhz MHZ --record FILE'",
            ),
        ):
            self.kept.write_text(text, "utf-8")
            self.fails(said, self.changed(old, new))

    def test_a_model_that_fits_otherwise_is_found(self) -> None:
        self.fails("is None, and now 3; run scripts/fit-delays --record", self.kept, "--check")


class Recorded(unittest.TestCase):
    """How well the models fit, as the documents keep it."""

    def test_it_is_of_the_present_constants_and_good(self) -> None:
        paths = sorted(place_record.DATA.glob("fit_*.json"))
        self.assertEqual([path.stem for path in paths], list(GOOD))
        for path in paths:
            data = project.read_json(path)
            constants = model_file.read(project.ROOT / data["model"])
            for name, constant in data["constants"].items():
                self.assertEqual(constants[name], constant["value"], f"{name}; {RENEW}")
            self.assertGreaterEqual(data["within"], GOOD[path.stem], RENEW)


class Model(testing.InFolder):
    def setUp(self) -> None:
        super().setUp()
        self.path = self.folder / "ecp5.json"
        shutil.copyfile(project.ROOT / "hls/compiler/delay/ecp5.json", self.path)

    def test_constants_are_written_in_their_lines(self) -> None:
        before = self.path.read_text(encoding="utf-8")
        model = model_file.read(self.path)
        model_file.write(self.path, {**model, "lut": 1.23}, "a, b")
        text = self.path.read_text(encoding="utf-8")
        self.assertEqual(model_file.read(self.path), {**model, "lut": 1.23})
        self.assertEqual(
            set(text.splitlines()) - set(before.splitlines()),
            {'  "lut": 1.23,', f'    "{model_file.FITTED} to a, b.",'},
        )

    def test_what_a_file_says_of_its_fit_is_written_anew(self) -> None:
        for path in sorted((project.ROOT / "hls/compiler/delay").glob("*.json")):
            copy = self.folder / path.name
            shutil.copyfile(path, copy)
            model_file.write(copy, model_file.read(path), "a")
            comment = project.read_json(path)["comment"]
            expected = [comment[0], f"{model_file.FITTED} to a.", *comment[2:]]
            self.assertEqual(project.read_json(copy)["comment"], expected, path)

    def test_a_grade_starts_from_that_of_its_family(self) -> None:
        path = self.folder / "ecp5-8.json"
        model_file.write(path, {**model_file.read(path), "lut": 0.9}, "a")
        data = json.loads(path.read_text(encoding="utf-8"))
        self.assertEqual((data["name"], data["lut"]), ("Lattice ECP5, speed grade 8", 0.9))
        self.assertEqual(model_file.read(path)["lut"], 0.9)

    def test_devices_have_their_files(self) -> None:
        names = [
            model_file.path_of(device, grade).name
            for device, grade in (("ecp5-85", "6"), ("ecp5-85", "8"), ("ice40-hx8k", ""))
        ]
        self.assertEqual(names, ["ecp5.json", "ecp5-8.json", "ice40-hx.json"])
        self.assertTrue(pathlib.Path(model_file.path_of("ecp5-85", "6")).exists())


if __name__ == "__main__":
    unittest.main()
