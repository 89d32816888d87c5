# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""How a configuration comes from needs and measurements, and what `dynrt specialise` refuses; a
program that only pretends stands in for dynrt."""

import contextlib
import io
import json
import os
import pathlib
import subprocess
import tempfile
import textwrap
import unittest

from dynrt_tools.build import configs
from dynrt_tools.project import SCRIPTS, Failed
from dynrt_tools.specialise import curve, decisions, flags, specialise, table

GENERATE = configs.load_configurations()
LISTED = GENERATE.listed()
THESIS = LISTED["thesis"]
WHITTED = LISTED["whitted"]


def decide(needed, measured=None, keep=(), general=THESIS, name="thesis"):
    needs = {
        key: {"value": value, "reason": f"as in {decisions.called(name)}: nothing decides it"}
        for key, value in general.items()
        if key not in decisions.TEXTS
    }
    needs |= {
        key: {"value": value, "reason": f"the scene needs {value}"} for key, value in needed.items()
    }
    return decisions.decide(GENERATE.KEYS, name, general, needs, measured or {}, keep)


class Decisions(unittest.TestCase):
    def test_every_key_has_a_reason(self):
        decided = decide({"stack_depth": 14})
        self.assertEqual(set(decided), set(GENERATE.KEYS) - set(decisions.TEXTS))
        for one in decided.values():
            self.assertGreater(len(one["reason"]), 10)
        self.assertEqual(decided["stack_depth"], {"value": 14, "reason": "the scene needs 14"})
        self.assertEqual(decided["mantissa_bits"]["value"], 16)

    def test_what_an_allowed_error_buys_is_told_beside_the_general_core(self):
        decided = decide({}, {"mantissa_bits": (12, "the cheapest that keeps the bound")})
        self.assertEqual(
            decided["mantissa_bits"], {"value": 12, "reason": "the cheapest that keeps the bound"}
        )
        self.assertIn("mantissa_bits", decisions.left_out(decided, THESIS))

    def test_counters_and_display_go_unless_they_are_kept(self):
        unused = {"counters": False, "scan_out": False}
        decided = decide(unused)
        self.assertEqual(
            (decided["counters"]["value"], decided["scan_out"]["value"]), (False, False)
        )
        decided = decide(unused | {"stack_depth": 3}, keep=["scan_out", "stack_depth"])
        self.assertEqual(
            (decided["counters"]["value"], decided["scan_out"]["value"]), (False, True)
        )
        self.assertEqual(
            decided["stack_depth"], {"value": 31, "reason": "as in thesis: --keep asks for it"}
        )
        with self.assertRaisesRegex(Failed, "^--keep speed: unknown; the keys are packets, "):
            decide({}, keep=["speed"])

    def test_the_configuration_is_one_that_can_be_built(self):
        decided = decide(
            {"stack_depth": 14, "lights": 2, "reflections": 0, "crossing": "none"},
            {"packets": (16, "with 32 a frame takes 100 clocks")},
            (),
            WHITTED,
            "whitted",
        )
        stated = decisions.configuration("lamps", "whitted", decided)
        config = GENERATE.checked("special", stated)
        self.assertEqual(
            (
                config["stack_depth"],
                config["lights"],
                config["packets"],
                config["made_for"],
                config["made_from"],
            ),
            (14, 2, 16, "lamps", "whitted"),
        )
        self.assertIn("stack_depth", decisions.left_out(decided, WHITTED))
        self.assertNotIn("mantissa_bits", decisions.left_out(decided, WHITTED))

    def test_a_general_configuration_that_a_file_states(self):
        decided = decide({}, name="/folder/mine.json")
        self.assertIn("as in mine: ", decided["mantissa_bits"]["reason"])
        stated = decisions.configuration("lamps", "/folder/mine.json", decided)
        self.assertEqual(
            (stated["about"], stated["made_from"]),
            ("made for the scene lamps, from the configuration mine", "/folder/mine.json"),
        )
        GENERATE.checked("special", stated)


class Curve(unittest.TestCase):
    CLOCKS = {32: 1000, 16: 1009, 8: 1100, 4: 1700, 2: 3000, 1: 6000}

    def test_the_smallest_number_that_costs_little_enough(self):
        for percent, expected in ((0, 32), (1, 16), (10, 8), (9.9, 16), (1000, 4)):
            _, chosen = curve.walk_down(self.CLOCKS.get, 32, percent)
            self.assertEqual(chosen, expected)

    def test_what_is_much_slower_is_measured_once_and_no_further(self):
        found, _ = curve.walk_down(self.CLOCKS.get, 32, 1)
        self.assertEqual(found, {n: self.CLOCKS[n] for n in (32, 16, 8, 4)})

    def test_numbers_between_powers_of_two(self):
        self.assertEqual(list(curve.powers_below(48)), [32, 16, 8, 4, 2, 1])
        self.assertEqual(list(curve.powers_below(64)), [32, 16, 8, 4, 2, 1])

    def test_the_reason_has_the_numbers_on_both_sides(self):
        self.assertEqual(
            curve.reason(self.CLOCKS, 16, 1, "a frame"),
            "with 32 a frame takes 1,000 clocks, with 16 0.9 % more, with 8 10.0 % "
            "more; 1 % are allowed",
        )
        self.assertEqual(
            curve.reason({1: 50}, 1, 1, "a frame of 64x48 at time 0"),
            "with 1 a frame of 64x48 at time 0 takes 50 clocks; 1 % are allowed",
        )

    def test_fewer_clocks_are_no_negative_part_more(self):
        self.assertEqual(
            curve.reason({32: 1000, 16: 961, 8: 1000}, 16, 1, "a frame"),
            "with 32 a frame takes 1,000 clocks, with 16 3.9 % fewer, with 8 0.0 % "
            "more; 1 % are allowed",
        )
        self.assertEqual(
            [curve.by_percent(p, "fewer") for p in (-3.94, -0.04, 0, 0.06)],
            ["3.9 % fewer", "0.0 %", "0.0 %", "0.1 %"],
        )

    def test_lines_are_measured_with_the_packets_that_were_chosen(self):
        class Meter:
            asked = []

            def clocks(self, packets, lines):
                self.asked.append((packets, lines))
                return 1000 if packets >= 16 and lines >= 64 else 2000

        meter = Meter()
        decided, curves = curve.choose(meter, 32, 512, 2)
        self.assertEqual((decided["packets"][0], decided["lines"][0]), (16, 64))
        self.assertEqual(list(curves["lines"]), [512, 256, 128, 64, 32])
        self.assertEqual({p for p, n in meter.asked if n < 512}, {16})


class Table(unittest.TestCase):
    def result(self):
        decided = decide({"stack_depth": 14, "lights": 0})
        costs = {
            "general": {"LUT4": 33000, "FF": 20000, "gates": 2800000, "clocks": 1000},
            "special": {"LUT4": 22000, "FF": 20000, "gates": 2100000, "clocks": 1010},
        }
        return {
            "configuration": decided,
            "left_out": decisions.left_out(decided, THESIS),
            "costs": costs,
            "curves": {"packets": {32: 1000, 16: 1010}, "lines": {512: 1010, 256: 1100}},
        }

    def test_what_is_left_out_and_what_it_saves(self):
        page = table.page("office: one object", "thesis", THESIS, self.result())
        self.assertRegex(page, r"(?m)^  stack_depth +31 +14 +the scene needs 14$")
        self.assertRegex(page, r"(?m)^  LUTs +33,000 +22,000 +33.3 %$")
        self.assertRegex(page, r"(?m)^  clocks of a frame +1,000 +1,010 +1.0 % more$")
        self.assertRegex(page, r"(?m)^  packets +32 +16$")
        self.assertIn("as in thesis: ", page)
        self.assertLessEqual(max(map(len, page.splitlines())), table.WIDTH + 4)


class Flags(unittest.TestCase):
    GIVEN = ["--program", "p", "--build", "b", "--expect", "e"]

    def test_values_may_begin_with_a_minus(self):
        args = flags.parse(
            ["office", "--position", "-1,2,3", "--light", "0,1,0", "--light=-1,1,0", *self.GIVEN]
        )
        self.assertEqual(
            flags.passed_on(args, flags.SEEN),
            ["--position=-1,2,3", "--light=0,1,0", "--light=-1,1,0"],
        )
        self.assertEqual(flags.passed_on(args, flags.ASKED), [])

    def test_help_has_no_flags_that_are_the_programs(self):
        with self.assertRaises(SystemExit), contextlib.redirect_stdout(io.StringIO()) as said:
            flags.parse(["--help"])
        self.assertIn("--max-error", said.getvalue())
        for hidden in ("--program", "--build", "--expect", "--for-program", "SUPPRESS"):
            self.assertNotIn(hidden, said.getvalue())

    def test_unknown_flags_are_told_in_a_sentence(self):
        with self.assertRaises(SystemExit), contextlib.redirect_stderr(io.StringIO()) as said:
            flags.parse(["office", "--speed", "9", *self.GIVEN])
        self.assertIn(
            "dynrt: unrecognized arguments: --speed 9; dynrt specialise --help lists",
            said.getvalue(),
        )


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)


class Delivered(InFolder):
    def core(self, *names):
        core = self.folder / "-".join(names)
        core.mkdir()
        for name in names:
            (core / name).write_text(name, encoding="utf-8")
        return core

    def deliver(self, core):
        configuration = self.folder / "office.json"
        configuration.write_text("{}", encoding="utf-8")
        specialise.deliver(self.folder / "out", configuration, core, {})
        return sorted(p.name for p in (self.folder / "out" / "verilog").iterdir())

    def test_what_is_of_the_build_alone_stays_there(self):
        core = self.core("list.v", "list.d", "list_ports.h", "list.json", "list.txt", "core.vh")
        self.assertEqual(self.deliver(core), ["core.vh", "list.json", "list.txt", "list.v"])

    def test_a_users_own_files_stay(self):
        self.deliver(self.core("list.v", "lights.v"))
        out = self.folder / "out"
        mine = [out / "verilog" / "mine.v", out / "json"]
        for path in mine:
            path.write_text("mine", encoding="utf-8")
        self.assertEqual(
            self.deliver(self.core("list.v", "mirrors.v")), ["list.v", "mine.v", "mirrors.v"]
        )
        self.assertEqual([path.read_text(encoding="utf-8") for path in mine], ["mine"] * 2)

    def test_an_earlier_analysis_that_is_none_or_names_others_files(self):
        out = self.folder / "out"
        out.mkdir()
        for text in ("", "[]", '{"verilog": [1]}', '{"verilog": ["../office.json"]}'):
            (out / "analysis.json").write_text(text, encoding="utf-8")
            self.assertEqual(specialise.written_earlier(out), [])

    def test_figures(self):
        figures = self.folder / "figures.json"
        specialise.write_figures(figures, {"a": 1})
        specialise.write_figures(figures, {"a": 2})
        self.assertEqual(json.loads(figures.read_text(encoding="utf-8")), {"a": 2})
        self.assertEqual(list(self.folder.iterdir()), [figures])

    def test_what_could_not_be_written(self):
        with self.assertRaisesRegex(Failed, f"^--json {self.folder}: is a folder; name a file$"):
            specialise.check_outputs(self.folder / "out", self.folder)
        blocked = self.folder / "file"
        blocked.write_text("", encoding="utf-8")
        with self.assertRaisesRegex(
            Failed,
            f"^--out {blocked}: cannot be written .File exists.; name a folder elsewhere$",
        ):
            specialise.check_outputs(blocked, None)
        specialise.check_outputs(self.folder / "out", None)
        self.assertFalse((self.folder / "out").exists())

    @unittest.skipIf(os.geteuid() == 0, "root may write everywhere")
    def test_a_folder_that_may_not_be_written(self):
        out = self.folder / "out"
        out.mkdir(0o500)
        with self.assertRaisesRegex(Failed, f"^--out {out}: cannot be written .Permission denied"):
            specialise.check_outputs(out, None)


class Command(InFolder):
    """scripts/specialise itself, up to where it needs more than the pretended program."""

    def setUp(self):
        super().setUp()
        self.program = self.folder / "dynrt"
        self.program.write_text(
            textwrap.dedent(
                """\
            #!/usr/bin/python3
            import json, pathlib, sys
            if "nowhere.obj" in sys.argv:
                sys.exit("dynrt: nowhere.obj: there is no such file")
            here = pathlib.Path(__file__).resolve().parent
            needs = {"general": "thesis", "content": "0", "needs": {"scene": "office"},
                     "keys": json.loads((here / "keys.json").read_text())}
            pathlib.Path(sys.argv[sys.argv.index("--json") + 1]).write_text(json.dumps(needs))
            print("scene       office: 2 triangles")
            """
            ),
            encoding="utf-8",
        )
        self.program.chmod(0o755)
        keys = {key: {"value": value, "reason": "as it is"} for key, value in THESIS.items()}
        (self.folder / "keys.json").write_text(json.dumps(keys), encoding="utf-8")
        self.build = self.folder / "build.json"
        self.build.write_text(
            json.dumps(
                {
                    "identity": {},
                    "variables": {},
                    "source": str(self.folder),
                    "hlsc": str(self.folder / "hlsc"),
                }
            ),
            encoding="utf-8",
        )

    def run_on(self, *words, **environment):
        return subprocess.run(
            [
                SCRIPTS / "specialise",
                *words,
                "--program",
                self.program,
                "--build",
                self.build,
                "--expect",
                "0",
            ],
            capture_output=True,
            text=True,
            check=False,
            cwd=self.folder,
            env=os.environ | {"DYNRT_CACHE": str(self.folder / "cache")} | environment,
        )

    def assert_refused(self, sentence, *words, **environment):
        result = self.run_on(*words, **environment)
        self.assertRegex(result.stderr, f"^dynrt: {sentence}\n$")
        self.assertEqual((result.returncode, result.stdout), (2, ""))

    def test_mistakes(self):
        self.assert_refused("nowhere.obj: there is no such file", "nowhere.obj")
        self.assert_refused(
            "--device fpga: unknown; the devices are ecp5-85, .*", "office", "--device", "fpga"
        )
        self.assert_refused(
            "--max-slowdown -1: a part in percent, 0 or more", "office", "--max-slowdown=-1"
        )
        for none in ("nan", "inf"):
            self.assert_refused(
                f"--max-slowdown {none}: a part in percent, 0 or more",
                "office",
                "--max-slowdown",
                none,
            )
        self.assert_refused("--jobs 0: at least one is needed", "office", "--jobs", "0")
        self.assert_refused("--max-error 0: must be above 0", "office", "--max-error", "0")
        self.assert_refused("--max-error nan: must be a number", "office", "--max-error", "nan")
        self.assert_refused(
            "--measure speed: unknown; the measures are .*",
            "office",
            "--measure",
            "speed",
            "--max-error",
            "1e-3",
        )
        self.assert_refused(
            "--measure primary.t_p99: there is no bound; --max-error says how large "
            "this error may be",
            "office",
            "--measure",
            "primary.t_p99",
        )
        self.assert_refused("--keep speed: unknown; the keys are .*", "office", "--keep", "speed")

    def test_yosys_is_looked_for_before_anything_is_measured(self):
        bare = {"PATH": str(self.folder)}
        self.assert_refused("yosys is not installed; .*", "nowhere.obj", **bare)
        self.assert_refused(
            "nowhere.obj: there is no such file", "nowhere.obj", "--no-hardware", **bare
        )

    def test_sources_that_are_not_the_programs(self):
        self.assert_refused(
            "the sources have changed since this program was built; build it again", "office"
        )

    def test_a_cache_that_cannot_be_written(self):
        blocked = self.folder / "file"
        blocked.write_text("", encoding="utf-8")
        self.assert_refused(
            f"the cache {blocked} cannot be written .*; let DYNRT_CACHE name a folder that can",
            "office",
            DYNRT_CACHE=str(blocked),
        )

    def test_programs_read_the_sentence_where_the_path_would_be(self):
        result = self.run_on("nowhere.obj", "--for-program")
        self.assertEqual(
            (result.returncode, result.stdout, result.stderr),
            (1, "nowhere.obj: there is no such file\n", ""),
        )

    def test_what_is_there_whole_is_taken_and_what_was_cut_off_is_not(self):
        first = self.run_on("office", "--for-program")  # fails, but where it would be is known
        self.assertEqual(first.returncode, 1)
        locks = list((self.folder / "cache").glob("specialised-*.lock"))
        self.assertEqual(len(locks), 1)
        entry = locks[0].with_suffix("")
        partial = entry.with_name(entry.name + ".cut.partial")
        partial.mkdir()
        (partial / "office.json").write_text("{", encoding="utf-8")
        again = self.run_on("office", "--for-program")
        self.assertEqual(again.returncode, 1)
        self.assertFalse(partial.exists())
        entry.mkdir()
        (entry / "analysis").mkdir()
        for name in ("office.json", "analysis/analysis.json"):
            (entry / name).write_text("", encoding="utf-8")  # as a machine without power leaves it
            self.assertEqual(self.run_on("office", "--for-program").returncode, 1)
            self.assertFalse(entry.exists())
            (entry / "analysis").mkdir(parents=True)
            for good in ("office.json", "analysis/analysis.json"):
                (entry / good).write_text("{}", encoding="utf-8")
        whole = self.run_on("office", "--for-program")
        self.assertEqual((whole.returncode, whole.stdout), (0, f"{entry / 'office.json'}\n"))


if __name__ == "__main__":
    unittest.main()
