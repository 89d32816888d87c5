# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""scripts/fit-delays from its files to its files, with a stand-in for hlsc."""

import json
import pathlib
import shutil
import unittest

from dynrt_tools import project, testing
from dynrt_tools.hardware import kept_placement, model_file, rtl_files
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
        kept_placement.write(self.kept, self.placement())

    def placement(self) -> Json:
        ends = [("near_s1", 6.0), ("far_s2", 9.0), ("out_fifo.space_q", 8.9)]
        start = {"unit": "sum", "signal": "out_fifo.read_q"}
        return {
            **{"unit": "sum", "config": "thesis", "device": "ecp5-85", "grade": "6", "placer": "1"},
            **{
                "clock_ns": 8.0,
                "asked_mhz": 125.0,
                "seeds": 1,
                "copies": 1,
                "mhz": [1000 / 9],
                "limits": 0.5,
            },
            "verilog": kept_placement.hash_of("sum", [self.folder / "build/hls/compiler/sum.v"]),
            "model": model_file.constants(project.ROOT / "hls/compiler/delay/ecp5.json"),
            "ends": [
                {
                    **{"unit": "sum", "signal": signal, "port": "", "source": "sum.v:1"},
                    **{"from": start, "ns": [ns], "median": ns},
                }
                for signal, ns in ends
            ],
        }

    def call(self, *words: testing.Word) -> testing.Result:
        build = f"--build={self.folder / 'build'}"
        return testing.run(project.SCRIPTS / "fit-delays", build, "--jobs=1", *words)

    def test_constants_before_and_after(self) -> None:
        done = self.call(self.kept, "--out", self.folder)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        before = model_file.constants(project.ROOT / "hls/compiler/delay/ecp5.json")["ram_out"]
        self.assertRegex(done.stdout, rf"ram_out +{before:g} +[5678](\.\d+)?\n")
        self.assertIn("Not predicted are 1 of 3 limiting ends:", done.stdout)
        self.assertRegex(done.stdout, r"1 end at a FIFO's pointers.*sum: out_fifo.space_q")
        data = project.read_json(self.folder / "fit_ecp5.json")
        self.assertEqual(data["model"], "hls/compiler/delay/ecp5.json")
        self.assertEqual((data["limiting"], data["predicted"]), (3, 2))
        by_signal = {end["signal"]: end for end in data["ends"]}
        self.assertEqual(by_signal["near_s1"]["counts"], {"clock_overhead": 1.0, "lut": 3.0})
        self.assertEqual(by_signal["far_s2"]["source"], "units/sum.h:5")
        self.assertLess(
            data["constants"]["ram_out"]["value"], data["constants"]["ram_out"]["fitted"]
        )
        self.assertEqual(data["earlier"], [])
        self.assertIn("<svg", (self.folder / "fit_ecp5.svg").read_text(encoding="utf-8"))

    def test_another_grade_starts_from_the_model_of_its_family(self) -> None:
        self.kept.write_text(
            self.kept.read_text("utf-8").replace('"grade": "6"', '"grade": "7"'), "utf-8"
        )
        done = self.call(self.kept, "--out", self.folder)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        model = project.read_json(self.folder / "fit_ecp5_7.json")["model"]
        self.assertEqual(model, "hls/compiler/delay/ecp5.json")

    def test_two_runs_draw_the_same(self) -> None:
        drawn = []
        for _ in range(2):
            self.call(self.kept, "--out", self.folder)
            drawn.append((self.folder / "fit_ecp5.svg").read_bytes())
        self.assertEqual(drawn[0], drawn[1])

    def test_an_earlier_verilog_is_named(self) -> None:
        (self.hlsc.parent / "sum.v").write_text(VERILOG.replace("clk_i", "clock_i"), "utf-8")
        done = self.call(self.kept, "--out", self.folder)
        self.assertEqual(done.returncode, 0)
        self.assertIn(
            "fit-delays: place_sum is of an earlier Verilog of sum; place it again", done.stderr
        )
        self.assertEqual(project.read_json(self.folder / "fit_ecp5.json")["earlier"], ["place_sum"])

    def test_a_core_that_hlsc_makes_otherwise_is_named(self) -> None:
        build = self.folder / "build"
        core = VERILOG.replace("sum", rtl_files.CORE).replace(
            "endmodule", "  sum u_adder (\n    .clk_i(clk_i));\nendmodule"
        )
        units = {f"{rtl_files.CORE}.v": core, "sum.v": VERILOG}
        testing.write_tree(build / "generated" / "small", units)
        testing.write_tree(build, {"hls/units/list_units.txt": "small|sum|units/sum.h|Sum\n"})
        kept = project.read_json(self.kept) | {"unit": rtl_files.CORE, "config": "small"}
        files = rtl_files.core_files(build / "generated" / "small")
        kept["verilog"] = kept_placement.hash_of(rtl_files.CORE, files)
        kept_placement.write(self.kept, kept)
        self.assertEqual(self.call(self.kept).stderr, "")
        (self.hlsc.parent / "sum.v").write_text(VERILOG.replace("clk_i", "clock_i"), "utf-8")
        done = self.call(self.kept, "--out", self.folder)
        self.assertEqual(done.returncode, 0)
        self.assertIn("place_sum is of an earlier Verilog of dynrt_core", done.stderr)
        self.assertEqual(project.read_json(self.folder / "fit_ecp5.json")["earlier"], ["place_sum"])

    def test_a_placement_without_haste_is_named(self) -> None:
        self.assertEqual(self.call(self.kept).stderr, "")
        self.kept.write_text(self.kept.read_text("utf-8").replace("125.0", "100.0"), "utf-8")
        said = "place_sum takes 9.00 ns, and the placer was asked for 10.00, so it need not hurry"
        self.assertIn(said, self.call(self.kept).stderr)

    def fails(self, said: str, *words: testing.Word) -> None:
        done = self.call(*words)
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertIn(said, done.stderr)

    def test_what_hlsc_refuses_ends_it(self) -> None:
        (self.hlsc.parent / "refuses").touch()
        self.fails("fit-delays: units/sum.h:3: error: no", self.kept)

    def test_a_unit_that_the_build_lacks(self) -> None:
        self.kept.write_text(self.kept.read_text("utf-8").replace('"sum"', '"total"'), "utf-8")
        self.fails("has no unit 'total' of the configuration 'thesis'", self.kept)

    def test_files_that_are_no_placements(self) -> None:
        self.fails("none.json: cannot be read (No such file", self.folder / "none.json")
        other = self.folder / "other.json"
        other.write_text("{}", encoding="utf-8")
        self.fails("other.json: is no kept placement, as it has no 'unit'", other)

    def test_a_device_without_a_model(self) -> None:
        text = self.kept.read_text("utf-8").replace("ecp5-85", "virtex2-6000")
        self.kept.write_text(text, "utf-8")
        self.fails("hlsc has no delay model of 'virtex2-6000'", self.kept)

    def test_no_folder_to_write_into(self) -> None:
        self.fails("--out", self.kept, "--out", self.folder / "nowhere")


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
