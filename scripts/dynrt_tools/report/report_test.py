# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The small parts of an error report, and its workflow with programs that only pretend."""

import argparse
import csv
import json
import math
import multiprocessing
import os
import pathlib
import re
import signal
import subprocess
import tempfile
import time
import unittest
from unittest import mock

from dynrt_tools.hardware import area as hardware
from dynrt_tools.project import SCRIPTS, Failed
from dynrt_tools.report import choose, collect, variants, workflow

HERE = pathlib.Path(__file__).resolve().parent
THESIS = variants.base_configuration("thesis")
EXAMPLE = json.loads((HERE / "example.json").read_text(encoding="utf-8"))

# What a job runs in place of scripts/configuration, scripts/variant_hardware and
# scripts/run_variant: it writes its outputs, or fails where the file `fail` says so.
PRETEND = """#!/usr/bin/python3
import pathlib, sys
args = sys.argv[1:]
pathlib.Path("ran").open("a").write(f"{pathlib.Path(__file__).name} {args[0]}\\n")
if pathlib.Path("fail").exists() and pathlib.Path(__file__).name in pathlib.Path("fail").read_text():
    sys.exit("what is wrong")
"""
CONFIGURATION = (
    PRETEND
    + """
out = pathlib.Path(args[args.index("--out") + 1])
out.mkdir(parents=True) if "--verilog" in args else out.write_text("model")
"""
)
HARDWARE = (
    PRETEND
    + """
pathlib.Path(args[1]).write_text("{}")
"""
)
RUN = (
    PRETEND
    + """
import time
if pathlib.Path("slow").exists():
    time.sleep(60)
pathlib.Path(args[4]).write_text('{"clocks": 7}')
pathlib.Path(args[5]).mkdir(parents=True, exist_ok=True)
"""
)


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)


class Variants(InFolder):
    def read(self, text):
        path = self.folder / "v.json"
        path.write_text(text if isinstance(text, str) else json.dumps(text), encoding="utf-8")
        return variants.read_variants(path, THESIS)

    def assert_refused(self, text, sentence):
        with self.assertRaises(Failed) as caught:
            self.read(text)
        self.assertEqual(str(caught.exception), f"{self.folder}/v.json:{sentence}")

    def test_every_key(self):
        read = self.read({"a": {}, "b": {"mantissa_bits": 10}})
        self.assertEqual(list(read), ["a", "b"])
        self.assertEqual(read["b"]["differs"], {"mantissa_bits": 10})
        self.assertEqual(read["b"]["configuration"]["mantissa_bits"], 10)
        self.assertEqual(read["b"]["configuration"]["packets"], THESIS["packets"])
        self.assertEqual(read["b"]["configuration"]["lights"], 0)

    def test_those_of_the_issue_are_listed(self):
        listed = variants.read_variants(variants.LISTED, THESIS)
        values = lambda key: {v["configuration"][key] for v in listed.values()}
        self.assertLessEqual({8, 10, 12, 14, 16, 18, 20, 23}, values("mantissa_bits"))
        self.assertLessEqual({5, 6, 7, 8}, values("exponent_bits"))
        self.assertEqual({"nearest_even", "truncate"}, values("rounding"))
        self.assertGreaterEqual(len(values("epsilon")), 4)
        self.assertEqual({"digit_recurrence", "reciprocal"}, values("divider"))
        self.assertEqual({"unit_triangle", "watertight"}, values("triangle_test"))

    def test_refused(self):
        self.assert_refused(
            {"a": {}, "b": {"mantissa": 10}},
            " variant 'b': unknown key 'mantissa'; the keys are "
            + ", ".join(variants.configs.load_configurations().KEYS),
        )
        self.assert_refused(
            {"a": {}, "b": {"packets": 0}},
            " variant 'b': key 'packets' (packets in "
            "flight) is 0; it must be a whole number from 1 to 64",
        )
        self.assert_refused(
            {"a": {}, "b/c": {"packets": 1}},
            " variant 'b/c': is no name; write letters, digits, _, - and ., a letter first",
        )
        self.assert_refused(
            {"b": {"packets": 2}},
            " one variant, and no more, must be {}: that which the others differ from",
        )
        self.assert_refused(
            {"b": 2}, " must be an object of variants by name, each an object of keys"
        )
        self.assert_refused(
            "{", "1: column 2 is no JSON: expecting property name enclosed in double quotes"
        )

    def test_chosen(self):
        read = self.read({"a": {}, "b": {"packets": 2}, "c": {"packets": 3}})
        self.assertEqual(list(variants.chosen(read, ["c"])), ["a", "c"])
        self.assertEqual(list(variants.chosen(read, [])), ["a", "b", "c"])
        with self.assertRaisesRegex(Failed, "^--variant d: unknown; the variants are a, b, c$"):
            variants.chosen(read, ["d"])

    def test_base(self):
        with self.assertRaisesRegex(Failed, "^--config x: unknown; the configurations are thesis,"):
            variants.base_configuration("x")
        with self.assertRaisesRegex(Failed, "^--config x.so: a library does not tell its keys; "):
            variants.base_configuration("x.so")

    def test_base_that_a_file_states(self):
        path = self.folder / "mine.json"
        keys = {key: value for key, value in THESIS.items() if key != "about"}
        path.write_text(
            json.dumps(keys | {"packets": {"value": 7, "reason": "few"}}), encoding="utf-8"
        )
        listed = self.folder / "variants.json"
        listed.write_text(json.dumps({"a": {}, "b": {"lines": 2}}), encoding="utf-8")
        read = variants.read_variants(listed, variants.base_configuration(str(path)))
        self.assertEqual([v["configuration"]["packets"] for v in read.values()], [7, 7])
        path.write_text(json.dumps(keys | {"packets": 99}), encoding="utf-8")
        with self.assertRaisesRegex(
            Failed, f"^--config {path}: line 1: key 'packets' .* is 99; it must"
        ):
            variants.base_configuration(str(path))


class Collect(InFolder):
    def test_names(self):
        self.assertEqual(collect.scene_name("office"), "office")
        self.assertEqual(collect.scene_name("/a b/c d.gltf"), "c_d")
        self.assertEqual(collect.scene_name("maps.pk3:one"), "maps_one")

    def test_csv(self):
        collect.write_csv(self.folder / "error.csv", EXAMPLE)
        with (self.folder / "error.csv").open(encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([r["variant"] for r in rows], ["m10", "m16"])
        self.assertEqual(
            (rows[0]["mantissa_bits"], rows[0]["LUT"], rows[0]["clocks"]), ("10", "14210", "40210")
        )
        self.assertEqual(rows[1]["primary.t_p99"], "1.5e-05")
        self.assertEqual(rows[1]["refused"], "")

    def test_collected_as_the_example(self):
        work = self.folder / "work"
        pictures = work / "scenes" / "blocks" / "m16" / "pictures"
        pictures.mkdir(parents=True)
        for kind in ("image", "truth", "difference"):
            (pictures / f"{kind}.png").write_text(kind, encoding="utf-8")
        one = EXAMPLE["runs"][1]
        run = {k: one[k] for k in ("clocks", "counters", "seconds", "measures")}
        (pictures.parent / "run.json").write_text(json.dumps(run), encoding="utf-8")
        (work / "variants" / "m16").mkdir(parents=True)
        of_hardware = {
            k: EXAMPLE["variants"]["m16"][k] for k in ("area", "takes", "units", "schedule")
        }
        (work / "variants" / "m16" / "hardware.json").write_text(json.dumps(of_hardware), "utf-8")
        listed = {"m16": {k: EXAMPLE["variants"]["m16"][k] for k in ("differs", "configuration")}}
        scenes = {"blocks": {"about": EXAMPLE["scenes"]["blocks"]["about"]}}
        report, named = collect.collect(
            work, scenes, listed, "64x48", {"variables": {"DYNRT_CLOCK_NS": "10"}}
        )
        self.assertEqual(report["runs"], [one])
        self.assertEqual(
            {k: v for k, v in report.items() if k not in ("runs", "variants")},
            {k: v for k, v in EXAMPLE.items() if k not in ("runs", "variants")},
        )
        self.assertEqual(report["variants"]["m16"], EXAMPLE["variants"]["m16"])
        self.assertEqual(named["pictures/blocks/m16.difference.png"], pictures / "difference.png")

    def test_a_built_in_scene_goes_before_a_folder_of_its_name(self):
        (self.folder / "blocks").mkdir()
        for name in ("office", "ball.json", "maps.pk3"):
            (self.folder / name).write_text("", encoding="utf-8")
        before = pathlib.Path.cwd()
        self.addCleanup(os.chdir, before)
        os.chdir(self.folder)
        here = pathlib.Path.cwd()
        for scene, path in (
            ("blocks", "blocks"),
            ("office", "office"),
            ("no.obj", "no.obj"),
            ("ball.json", f"{here}/ball.json"),
            ("./ball.json", f"{here}/ball.json"),
            ("maps.pk3:mine", f"{here}/maps.pk3:mine"),
        ):
            self.assertEqual(collect.scene_path(scene), path)

    def test_a_full_disk_leaves_the_report_that_was_there(self):
        out = self.folder / "out"
        with collect.written_first(out) as new:
            (new / "error.csv").write_text("old", encoding="utf-8")
        with self.assertRaisesRegex(
            Failed,
            f"^--out {out}: cannot be written .the disk is full.; "
            "a report that was there is as it was",
        ):
            with collect.written_first(out) as new:
                (new / "error.csv").write_text("new", encoding="utf-8")
                raise OSError(28, "No space left on device")
        self.assertEqual([p.name for p in out.iterdir()], ["error.csv"])
        self.assertEqual((out / "error.csv").read_text(encoding="utf-8"), "old")

    def test_two_that_write_at_once(self):
        out = self.folder / "out"
        for left in (".new999999999.cut", ".newest"):  # of a process that is no more; a user's own
            (out / left).mkdir(parents=True)
        with collect.written_first(out) as first:
            (first / "a").write_text("first", encoding="utf-8")
            with collect.written_first(out) as second:
                (second / "b").write_text("second", encoding="utf-8")
        self.assertEqual(sorted(p.name for p in out.iterdir()), [".newest", "a", "b"])


class Choose(unittest.TestCase):
    def chosen(self, measure, bound):
        runs, holding = choose.choose(EXAMPLE, measure, bound)
        return [r["variant"] for r in runs], [r["variant"] for r in holding]

    def test_cheapest_first(self):
        self.assertEqual(self.chosen("primary.t_p99", 1e-3), (["m10", "m16"], ["m10", "m16"]))
        self.assertEqual(self.chosen("primary.t_p99", 1e-4)[1], ["m16"])
        self.assertEqual(self.chosen("primary.t_p99", 1e-9)[1], [])

    def test_cost_is_the_largest_part_of_the_device_times_the_time(self):
        part, resource = choose.part_of_device(EXAMPLE["variants"]["m16"])
        self.assertEqual((round(part, 4), resource), (round(24560 / 83640, 4), "LUT4"))
        self.assertEqual(
            choose.cost(EXAMPLE["variants"]["m16"], EXAMPLE["runs"][1]), (part * 0.40188, 19980)
        )

    def test_of_a_psnr_more_is_better_and_none_means_no_difference(self):
        self.assertEqual(self.chosen("image.psnr", 60)[1], ["m16"])
        self.assertTrue(choose.holds("image.psnr", None, 60))
        self.assertFalse(choose.holds("primary.t_p99", None, 60))

    def test_unknown_measure(self):
        with self.assertRaisesRegex(
            Failed,
            "^--measure x: this scene has none; its measures are "
            "primary.missed, primary.false, .*, image.largest$",
        ):
            self.chosen("x", 1)

    def test_what_is_wrong_is_said_before_anything_is_measured(self):
        for flags, sentence in (
            (("x", 1.0), "^--measure x: unknown; the measures are primary.missed, "),
            (("image.rms", math.nan), "^--max-error nan: must be a number$"),
        ):
            args = argparse.Namespace(measure=flags[0], max_error=flags[1])
            with self.assertRaisesRegex(Failed, sentence):
                choose.check_bound(args)


class Hardware(unittest.TestCase):
    VERILOG = (
        "// Generated from one (a.h)\nmodule one #(\n  parameter N = 8\n) (\n"
        "  input wire [N-1:0] a,  // a.h:7\n  output wire b\n);\n  assign b = ^a;\nendmodule\n"
    )

    REPORT = (
        "clock      10.00 ns\nstages     2\n\nstage  registers  longest path, ns  "
        "operations\n    0                      4.45  1 and\n    1         30        "
        "      9.90  2 eq\n\nThe longest path of each stage ends at\n    0  'both'\n"
    )

    def test_black_box(self):
        box = hardware.black_box(self.VERILOG)
        self.assertIn("input wire [N-1:0] a,", box)
        self.assertNotIn("assign", box)
        self.assertNotIn("//", box)

    def test_a_core_is_the_sum_of_its_units_and_of_what_joins_them(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "one.v").write_text(self.VERILOG, encoding="utf-8")
            (folder / "one.txt").write_text(self.REPORT, encoding="utf-8")
            (folder / "dynrt_core.vh").write_text("", encoding="utf-8")
            (folder / "dynrt_core.v").write_text(
                "module dynrt_core (\n  input wire [7:0] a,\n  input wire clk,\n"
                "  output reg [1:0] b\n);\n  wire [1:0] c;\n  one u_one_0 (\n    .a(a), .b(c[0]));\n"
                "  one u_one_1 (\n    .a(~a), .b(c[1]));\n  always @(posedge clk) b <= c;\nendmodule\n",
                encoding="utf-8",
            )
            with mock.patch.object(hardware.synthesis, "KEPT", folder / "kept"):
                figures = hardware.hardware(folder)
                one, join = figures["units"]["one"], figures["units"]["dynrt_core"]
                with mock.patch.object(hardware.synthesis, "run_yosys", side_effect=AssertionError):
                    self.assertEqual(hardware.hardware(folder), figures)
        self.assertEqual((one["instances"], one["area"]["FF"], join["area"]["FF"]), (2, 0, 2))
        self.assertGreaterEqual(one["area"]["LUT"], 2)
        self.assertEqual(figures["area"]["LUT"], 2 * one["area"]["LUT"] + join["area"]["LUT"])
        self.assertEqual(figures["takes"]["FF"], 2)
        self.assertEqual(
            figures["schedule"], {"stages": 2, "longest_path_ns": 9.9, "clock_mhz": 101.01}
        )


class Jobs(InFolder):
    """The Snakefile with jobs that pretend."""

    def setUp(self):
        super().setUp()
        scripts = self.folder / "scripts"
        scripts.mkdir()
        for path, text in (
            (scripts / "configuration", CONFIGURATION),
            (scripts / "variant_hardware", HARDWARE),
            (scripts / "run_variant", RUN),
        ):
            path.write_text(text, encoding="utf-8")
            path.chmod(0o755)
        patch = mock.patch.object(workflow, "SCRIPTS", scripts)
        patch.start()
        self.addCleanup(patch.stop)
        self.work = self.folder / "out.work"
        self.program = self.folder / "dynrt"
        self.program.write_text("program", encoding="utf-8")
        self.build = self.folder / "build.json"
        self.build.write_text(json.dumps({"hlsc": "hlsc"}), encoding="utf-8")

    def run_workflow(self, names=("a", "b"), hardware_too=True, slurm=False):
        """The jobs that ran."""
        flow = workflow.Workflow(self.work, self.program, self.build, "f")
        (self.work / "ran").unlink(missing_ok=True)
        listed = {name: {"configuration": {"name": name}} for name in names}
        with flow.alone():
            flow.prepare({"blocks": "blocks"}, listed, "32x24", hardware_too)
            flow.run(2, slurm)
        ran = self.work / "ran"
        return len(ran.read_text(encoding="utf-8").splitlines()) if ran.exists() else 0

    def test_runs_what_is_not_there_yet(self):
        self.assertEqual(self.run_workflow(("a",)), 4)
        self.assertEqual(self.run_workflow(("a", "b")), 4)
        self.assertEqual(self.run_workflow(("a", "b")), 0)
        figures = self.work / "scenes" / "blocks" / "b" / "run.json"
        self.assertEqual(json.loads(figures.read_text(encoding="utf-8")), {"clocks": 7})
        self.program.write_text("another", encoding="utf-8")
        self.assertEqual(self.run_workflow(("a", "b")), 8)

    def test_a_failure_is_told_and_the_rest_is_kept(self):
        self.work.mkdir()
        (self.work / "fail").write_text("run_variant", encoding="utf-8")
        with self.assertRaisesRegex(Failed, "^blocks.a: rendering failed: what is wrong$"):
            self.run_workflow(("a",))
        (self.work / "fail").unlink()
        self.assertEqual(self.run_workflow(("a",)), 1)

    def test_interrupted_it_goes_on_where_it_stopped(self):
        self.work.mkdir()
        (self.work / "slow").write_text("", encoding="utf-8")
        process = multiprocessing.Process(target=self.run_workflow, args=(("a", "b"), False))
        process.start()
        ran = self.work / "ran"
        for _ in range(600):
            if ran.exists() and "run_variant" in ran.read_text(encoding="utf-8"):
                break
            time.sleep(0.1)
        os.kill(process.pid, signal.SIGINT)
        process.join(60)
        self.assertNotEqual(process.exitcode, 0)
        self.assertEqual(list(self.work.glob("scenes/*/*/run.json")), [])
        (self.work / "slow").unlink()
        self.assertEqual(self.run_workflow(("a", "b"), False), 2)  # the models are there
        self.assertEqual(len(list(self.work.glob("scenes/*/*/run.json"))), 2)

    def test_slurm(self):
        sbatch = self.folder / "bin" / "sbatch"
        sbatch.parent.mkdir()
        sbatch.write_text(
            '#!/bin/bash\n[ $1 = --parsable ] && echo $$ && echo "$@" >> submitted\n'
            'exec bash "${@: -1}" > /dev/null 2>&1\n',
            encoding="utf-8",
        )
        sbatch.chmod(0o755)
        path = f"{sbatch.parent}:{os.environ['PATH']}"
        with mock.patch.dict(os.environ, {"PATH": path}):
            self.assertEqual(self.run_workflow(("a",), hardware_too=False, slurm=True), 2)
        submitted = (self.work / "submitted").read_text(encoding="utf-8").splitlines()
        self.assertEqual(
            [re.search("--job-name=([a-z-]+)", line)[1] for line in submitted],
            ["dynrt-model", "dynrt-run"],
        )

    def test_slurm_that_is_not_there(self):
        with mock.patch.object(
            workflow.shutil, "which", lambda name: None if name == "sbatch" else "snakemake"
        ):
            with self.assertRaisesRegex(
                Failed, "^--slurm: sbatch is not on the PATH; run the report on a node"
            ):
                self.run_workflow(slurm=True)

    def test_one_at_a_time(self):
        flow = workflow.Workflow(self.work, self.program, self.build, "f")
        with flow.alone():
            with self.assertRaisesRegex(
                Failed, "another report is being made there; wait for it or name another --out"
            ):
                with flow.alone():
                    pass

    def test_without_snakemake(self):
        with mock.patch.object(workflow.shutil, "which", return_value=None):
            with self.assertRaisesRegex(Failed, "^snakemake is not installed; run scripts/setup"):
                self.run_workflow()


class CommandLine(InFolder):
    def assert_mistake(self, script, arguments, sentence):
        build = self.folder / "build.json"
        build.write_text(json.dumps({"source": str(self.folder), "identity": {}}), encoding="utf-8")
        result = subprocess.run(
            [SCRIPTS / script, "--program", "dynrt", "--build", build, "--expect", "f", *arguments],
            capture_output=True,
            text=True,
            check=False,
            env=os.environ,
        )
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertEqual(result.stderr, f"dynrt: {sentence}\n")

    def test_mistakes(self):
        self.assert_mistake(
            "report_error",
            ["--colour"],
            "unrecognized arguments: --colour; dynrt report error --help lists what there is",
        )
        self.assert_mistake("report_error", ["--jobs", "0"], "--jobs 0: at least one is needed")
        self.assert_mistake(
            "report_error",
            ["--variant", "x"],
            "--variant x: unknown; the variants "
            "are " + ", ".join(variants.read_variants(variants.LISTED, THESIS)),
        )
        for script, more in (("report_error", []), ("choose", ["office", "--max-error", "1"])):
            self.assert_mistake(
                script,
                more,
                "the sources have changed since this program was built; build it again",
            )
        self.assert_mistake(
            "choose",
            ["office"],
            "the following arguments are required: "
            "--max-error; dynrt choose --help lists what there is",
        )


if __name__ == "__main__":
    unittest.main()
