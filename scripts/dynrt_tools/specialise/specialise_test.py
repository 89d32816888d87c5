# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The flags of `dynrt specialise`, the mistakes that it refuses, and the files that it delivers; a
program that only pretends stands in for dynrt."""

import contextlib
import io
import json
import os
import pathlib
import subprocess
import textwrap
import unittest

from dynrt_tools import project, testing
from dynrt_tools.build import configs
from dynrt_tools.project import Failed
from dynrt_tools.specialise import flags, specialise

THESIS = configs.load_configurations().listed()["thesis"]


# What the program lists (host/app/scene_flags.h), in part.
LISTED = [
    {"name": "--size", "value": "WxH [512x384]", "several": False, "of_frame": True},
    {"name": "--position", "value": "X,Y,Z", "several": False, "of_frame": True},
    {"name": "--fov", "value": "DEGREES", "several": False, "of_frame": True},
    {"name": "--light", "value": "X,Y,Z", "several": True, "of_frame": True},
    {"name": "--uncompressed", "value": "", "several": False, "of_frame": True},
    {"name": "--config", "value": "NAME", "several": False, "of_frame": True},
    {"name": "--frames", "value": "N", "several": False, "of_frame": False},
]


class Flags(testing.InFolder):
    given: list[str]

    def setUp(self) -> None:
        super().setUp()
        program = self.folder / "dynrt"
        testing.write_program(program, f"#!/bin/sh\ncat <<'END'\n{json.dumps(LISTED)}\nEND\n")
        self.given = ["--program", str(program), "--build", "b", "--expect", "e"]

    def test_values_may_begin_with_a_minus(self) -> None:
        args = flags.parse(
            ["office", "--position", "-1,2,3", "--light", "0,1,0", "--light=-1,1,0", *self.given]
        )
        self.assertEqual(
            flags.passed_on(args, of_frame=True),
            ["--position=-1,2,3", "--light=0,1,0", "--light=-1,1,0"],
        )
        self.assertEqual(flags.passed_on(args, of_frame=False), [])

    def test_flags_of_the_program_go_on_to_it(self) -> None:
        words = ["office", "--uncompressed", "--frames=3", "--config=full", "--keep=lines"]
        args = flags.parse([*words, *self.given])
        self.assertEqual(flags.passed_on(args, of_frame=True), ["--uncompressed"])
        self.assertEqual(flags.passed_on(args, of_frame=False), ["--frames=3"])
        self.assertEqual((args.config, args.keep), ("full", ["lines"]))

    def test_without_a_program(self) -> None:
        with self.assertRaises(SystemExit), contextlib.redirect_stderr(io.StringIO()) as said:
            flags.parse(["office"])
        self.assertIn("required: --program", said.getvalue())

    def test_help_has_no_flags_that_are_the_programs(self) -> None:
        with self.assertRaises(SystemExit), contextlib.redirect_stdout(io.StringIO()) as said:
            flags.parse(["--help", *self.given])
        self.assertIn("--max-error", said.getvalue())
        self.assertIn("--position X,Y,Z", said.getvalue())
        for hidden in ("--program", "--build", "--expect", "--for-program", "SUPPRESS"):
            self.assertNotIn(hidden, said.getvalue())

    def test_unknown_flags_are_told_in_a_sentence(self) -> None:
        with self.assertRaises(SystemExit), contextlib.redirect_stderr(io.StringIO()) as said:
            flags.parse(["office", "--speed", "9", *self.given])
        self.assertIn(
            "dynrt: unrecognized arguments: --speed 9; dynrt specialise --help lists",
            said.getvalue(),
        )


class Delivered(testing.InFolder):
    def core(self, *names: str) -> pathlib.Path:
        core = self.folder / "-".join(names)
        core.mkdir()
        for name in names:
            (core / name).write_text(name, encoding="utf-8")
        return core

    def deliver(self, core: pathlib.Path) -> list[str]:
        configuration = self.folder / "office.json"
        configuration.write_text("{}", encoding="utf-8")
        specialise.deliver(self.folder / "out", configuration, core, {})
        return sorted(p.name for p in (self.folder / "out" / "verilog").iterdir())

    def test_what_is_of_the_build_alone_stays_there(self) -> None:
        core = self.core("list.v", "list.d", "list_ports.h", "list.json", "list.txt", "core.vh")
        self.assertEqual(self.deliver(core), ["core.vh", "list.json", "list.txt", "list.v"])

    def test_a_users_own_files_stay(self) -> None:
        self.deliver(self.core("list.v", "lights.v"))
        out = self.folder / "out"
        mine = [out / "verilog" / "mine.v", out / "json"]
        for path in mine:
            path.write_text("mine", encoding="utf-8")
        self.assertEqual(
            self.deliver(self.core("list.v", "mirrors.v")), ["list.v", "mine.v", "mirrors.v"]
        )
        self.assertEqual([path.read_text(encoding="utf-8") for path in mine], ["mine"] * 2)

    def test_an_earlier_analysis_that_is_none_or_names_others_files(self) -> None:
        out = self.folder / "out"
        out.mkdir()
        for text in ("", "[]", '{"verilog": [1]}', '{"verilog": ["../office.json"]}'):
            (out / "analysis.json").write_text(text, encoding="utf-8")
            self.assertEqual(specialise.written_earlier(out), [])

    def test_figures(self) -> None:
        figures = self.folder / "figures.json"
        specialise.write_figures(figures, {"a": 1})
        specialise.write_figures(figures, {"a": 2})
        self.assertEqual(json.loads(figures.read_text(encoding="utf-8")), {"a": 2})
        self.assertEqual(list(self.folder.iterdir()), [figures])

    def test_what_could_not_be_written(self) -> None:
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
    def test_a_folder_that_may_not_be_written(self) -> None:
        out = self.folder / "out"
        out.mkdir(0o500)
        with self.assertRaisesRegex(Failed, f"^--out {out}: cannot be written .Permission denied"):
            specialise.check_outputs(out, None)


class Command(testing.InFolder):
    """scripts/specialise itself, up to where it needs more than the pretended program."""

    def setUp(self) -> None:
        super().setUp()
        keys = {key: {"value": value, "reason": "as it is"} for key, value in THESIS.items()}
        self.needs = {
            "general": "thesis",
            "content": "0",
            "needs": {"scene": "office"},
            "keys": keys,
            "about": "office: 2 triangles",
        }
        self.refusal = {"refused": "nowhere.obj: there is no such file"}
        (self.folder / "needs.json").write_text(json.dumps(self.needs), encoding="utf-8")
        self.program = self.folder / "dynrt"
        testing.write_program(
            self.program,
            textwrap.dedent(
                f"""\
                #!/usr/bin/python3
                import pathlib, sys
                if "--list-flags" in sys.argv:
                    sys.exit(print({json.dumps(json.dumps(LISTED))}))
                if "--fov=wide" in sys.argv:
                    sys.exit("dynrt: --fov: wide is not a finite number")
                for question in sys.stdin:
                    if "nowhere.obj" in sys.argv:
                        print({json.dumps(json.dumps(self.refusal))}, flush=True)
                    else:
                        print(pathlib.Path({str(self.folder / "needs.json")!r}).read_text(), flush=True)
                """
            ),
        )
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

    def command(self, *words: str) -> list[str | pathlib.Path]:
        given: list[str | pathlib.Path] = ["--program", self.program, "--build", self.build]
        given += ["--expect", "0"]
        return [project.SCRIPTS / "specialise", *words, *given]

    def environment(self, **more: str) -> dict[str, str]:
        return os.environ | {"DYNRT_CACHE": str(self.folder / "cache")} | more

    def run_on(self, *words: str, **environment: str) -> testing.Result:
        return testing.run(
            *self.command(*words), cwd=self.folder, env=self.environment(**environment)
        )

    def run_for_program(self, scene: str) -> tuple[int, str]:
        """The test is the program that runs the script and answers it: exit code and output."""
        said = ""
        with subprocess.Popen(
            self.command(scene, "--for-program"),
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            cwd=self.folder,
            env=self.environment(),
        ) as process:
            for line in process.stdout or ():
                if line.startswith("? "):
                    answer = self.refusal if scene == "nowhere.obj" else self.needs
                    print(json.dumps(answer), file=process.stdin, flush=True)
                else:
                    said += line
        return process.returncode, said

    def assert_refused(self, sentence: str, *words: str, **environment: str) -> None:
        result = self.run_on(*words, **environment)
        self.assertRegex(result.stderr, f"^dynrt: {sentence}\n$")
        self.assertEqual((result.returncode, result.stdout), (2, ""))

    def test_mistakes(self) -> None:
        self.assert_refused("nowhere.obj: there is no such file", "nowhere.obj")
        self.assert_refused("--fov: wide is not a finite number", "office", "--fov", "wide")
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

    def test_yosys_is_looked_for_before_anything_is_measured(self) -> None:
        bare = {"PATH": str(self.folder)}
        self.assert_refused("yosys is not installed; .*", "nowhere.obj", **bare)
        self.assert_refused(
            "nowhere.obj: there is no such file", "nowhere.obj", "--no-hardware", **bare
        )

    def test_a_program_that_was_built_alone(self) -> None:
        build = json.loads(self.build.read_text(encoding="utf-8")) | {"program_only": True}
        self.build.write_text(json.dumps(build), encoding="utf-8")
        self.assert_refused(
            "specialising a core needs hlsc, and scripts/demo built this program without; "
            "scripts/test --build-only builds the whole program",
            "nowhere.obj",
        )

    def test_sources_that_are_not_the_programs(self) -> None:
        self.assert_refused(
            "the sources have changed since this program was built; build it again", "office"
        )

    def test_a_cache_that_cannot_be_written(self) -> None:
        blocked = self.folder / "file"
        blocked.write_text("", encoding="utf-8")
        self.assert_refused(
            f"the cache {blocked} cannot be written .*; let DYNRT_CACHE name a folder that can",
            "office",
            DYNRT_CACHE=str(blocked),
        )

    def test_programs_read_the_sentence_where_the_path_would_be(self) -> None:
        self.assertEqual(
            self.run_for_program("nowhere.obj"), (1, "nowhere.obj: there is no such file\n")
        )

    def test_a_program_that_ends_before_it_answers(self) -> None:
        result = self.run_on("office", "--for-program")
        self.assertEqual(
            (result.returncode, result.stdout.splitlines()[-1], result.stderr),
            (1, "the program that analyses the scene has ended", ""),
        )

    def test_what_is_there_whole_is_taken_and_what_was_cut_off_is_not(self) -> None:
        first, _ = self.run_for_program("office")  # fails, but where it would be is known
        self.assertEqual(first, 1)
        locks = list((self.folder / "cache").glob("specialised-*.lock"))
        self.assertEqual(len(locks), 1)
        entry = locks[0].with_suffix("")
        partial = entry.with_name(entry.name + ".cut.partial")
        partial.mkdir()
        (partial / "office.json").write_text("{", encoding="utf-8")
        again, _ = self.run_for_program("office")
        self.assertEqual(again, 1)
        self.assertFalse(partial.exists())
        entry.mkdir()
        (entry / "analysis").mkdir()
        for name in ("office.json", "analysis/analysis.json"):
            (entry / name).write_text("", encoding="utf-8")  # as a machine without power leaves it
            self.assertEqual(self.run_for_program("office")[0], 1)
            self.assertFalse(entry.exists())
            (entry / "analysis").mkdir(parents=True)
            for good in ("office.json", "analysis/analysis.json"):
                (entry / good).write_text("{}", encoding="utf-8")
        whole = self.run_for_program("office")
        self.assertEqual(whole, (0, f"{entry / 'office.json'}\n"))


if __name__ == "__main__":
    unittest.main()
