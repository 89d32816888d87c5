# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""scripts/configuration refuses what it cannot build, before it builds; and what its keys depend
on.
"""

import json
import os
import pathlib
import shutil
import subprocess
import unittest
from typing import Any
from unittest import mock

from dynrt_tools import project, testing
from dynrt_tools.build import configuration, fingerprint
from dynrt_tools.build.configs import load_configurations, read_file

SCRIPT = project.SCRIPTS / "configuration"
THESIS = load_configurations().listed()["thesis"]


class Configuration(testing.InFolder):
    def setUp(self) -> None:
        super().setUp()
        self.file = self.folder / "mine.json"
        # A project in miniature: the sources that decide, and what a build says of itself.
        self.source = self.folder / "source"
        names = (
            "hls/include/float.h",
            "host/board/board.h",
            "hls/units/list.h",
            "hls/configs/generate",
            "cmake/Loadable.cmake",
            "rtl/lib/fifo.v",
        )
        testing.write_tree(self.source, {name: name for name in names})
        self.hlsc = self.folder / "hlsc"
        self.hlsc.write_text("hlsc", encoding="utf-8")
        self.build: project.Json = {
            "identity": {"CMAKE_CXX_FLAGS": ""},
            "variables": {"DYNRT_CLOCK_NS": "10"},
            "source": str(self.source),
            "hlsc": str(self.hlsc),
        }

    def written(self, keys: str | project.Json) -> pathlib.Path:
        self.file.write_text(keys if isinstance(keys, str) else json.dumps(keys), encoding="utf-8")
        return self.file

    def run_on(
        self, keys: str | project.Json, *flags: testing.Word, **environment: str
    ) -> testing.Result:
        self.written(keys)
        build = self.folder / "build.json"
        build.write_text(json.dumps(self.build), encoding="utf-8")
        return testing.run(
            SCRIPT, self.file, "--build", build, *flags, env=os.environ | environment
        )

    def with_cmake(self, script: str) -> dict[str, str]:
        """The environment of a cache of its own and a cmake that runs these lines of a shell."""
        tools = self.folder / "tools"
        tools.mkdir()
        testing.write_program(tools / "cmake", f"#!/bin/sh\n{script}\n")
        (tools / "ninja").symlink_to("/bin/true")
        return {
            "DYNRT_CACHE": str(self.folder / "cache"),
            "PATH": f"{tools}:{os.environ['PATH']}",
        }

    def assert_refused(
        self,
        keys: str | project.Json,
        sentence: str,
        *flags: testing.Word,
        **environment: str,
    ) -> None:
        result = self.run_on(keys, *flags, **environment)
        self.assertEqual(result.stderr, f"configuration: {self.file}: {sentence}\n")
        self.assertEqual((result.returncode, result.stdout), (1, ""))

    def test_refused(self) -> None:
        self.assert_refused(
            THESIS | {"mantissa_bits": 99},
            "line 1: key 'mantissa_bits' (stored mantissa bits of the float) is 99; it must "
            "be a whole number from 8 to 29",
        )
        self.assert_refused(
            "{", "line 1: column 2 is no JSON: expecting property name enclosed in double quotes"
        )
        self.assert_refused("[]", "must be an object of keys")
        self.assert_refused(
            THESIS,
            "the sources have changed since this program was built; build it again",
            "--expect",
            "0",
        )
        self.hlsc.unlink()
        self.assert_refused(
            THESIS,
            f"{self.hlsc} is missing; build the target hlsc, which lowers "
            "the units (scripts/test --build-only does)",
            "--verilog",
        )

    def test_check_makes_nothing(self) -> None:
        self.assertEqual(self.run_on(THESIS, "--check").stdout, f"{self.file}\n")
        self.assert_refused(
            THESIS | {"ways": 4, "lines": 2},
            "line 1: with ways 4 the key 'lines' must be 4 or more, as a set has a line in each "
            "way; it is 2",
            "--check",
        )

    def test_refused_periods(self) -> None:
        for text in ("0", "-3", "ten", "nan", "inf", "10ns"):
            self.assert_refused(
                THESIS,
                f"--clock-ns {text}: this is no period of a clock; give the ns from edge to edge, "
                "a number above 0 such as 8.33, or least for the shortest that all units reach",
                f"--clock-ns={text}",
            )

    def test_the_least_period_is_that_of_the_unit_that_needs_the_longest(self) -> None:
        built: list[tuple[str, ...]] = []

        def pretend(_: configuration.Builder, command: list[Any], *_logs: object) -> None:
            if "--build" in command:
                built[-1] += (command[command.index("--target") + 1],)
                return
            said = [str(word) for word in command]
            found = dict(w[2:].split("=") for w in said if w.startswith("-DDYNRT_CL"))
            built.append((found["DYNRT_CLOCK_NS"],))
            if found["DYNRT_CLOCK_NS"] == "least":
                periods = {"a": 7.9, "b": 8.1, "c": 1.91}
                folder = "build/generated/loadable"
                testing.write_tree(
                    self.folder,
                    {f"{folder}/{u}.json": json.dumps({"clock_ns": p}) for u, p in periods.items()},
                )

        build = configuration.at_period(self.build, "least")
        with mock.patch.object(configuration.Builder, "_run", pretend):
            configuration.Builder("verilog", THESIS, build, 1, lambda text: None)(self.folder)
        self.assertEqual(built, [("least", "verilog"), ("8.1", "dynrt_loadable_core")])

    def test_the_core_of_a_listed_configuration_is_lowered_by_the_build(self) -> None:
        built: list[str] = []

        def pretend(_: configuration.Builder, command: list[Any], *_logs: object) -> None:
            built.append(" ".join(map(str, command[: command.index("--parallel")])))

        testing.write_tree(
            self.folder, {f"generated/thesis/{name}": name for name in ("list.v", "fresh/list.v")}
        )
        build = self.build | {"folder": str(self.folder)}
        listed = configuration.same_core(THESIS | {"made_for": "a sail"})
        builder = configuration.Builder("verilog", THESIS, build, 1, lambda text: None, listed)
        with mock.patch.object(configuration.Builder, "_run", pretend):
            made = builder(self.folder)
        self.assertEqual(built, [f"cmake --build {self.folder} --target dynrt_thesis_core"])
        self.assertEqual([path.name for path in made.iterdir()], ["list.v"])
        self.assertEqual(configuration.same_core(THESIS | {"packets": 16}), "")
        unlowered = load_configurations().listed()["compact"]
        self.assertFalse(unlowered["rtl"])
        self.assertEqual(configuration.same_core(unlowered), "")

    def test_programs_read_the_sentence_where_the_path_would_be(self) -> None:
        result = self.run_on(THESIS, "--expect", "0", "--for-program")
        self.assertEqual((result.returncode, result.stderr), (1, ""))
        self.assertEqual(
            result.stdout,
            "the sources have changed since this program was built; build it again\n",
        )

    def test_cache_that_cannot_be_written(self) -> None:
        blocked = self.folder / "file"
        blocked.write_text("", encoding="utf-8")
        self.assert_refused(
            THESIS,
            f"the cache {blocked} cannot be written (File exists); let "
            "DYNRT_CACHE name a folder that can",
            DYNRT_CACHE=str(blocked),
        )

    def test_tools_that_are_not_installed(self) -> None:
        tools = self.folder / "tools"
        tools.mkdir()
        testing.link_tools(tools, "python3")
        cache = {"PATH": str(tools), "DYNRT_CACHE": str(self.folder / "cache")}
        self.assert_refused(
            THESIS,
            "cmake is not installed; Debian's package cmake has it, and "
            "scripts/setup installs that",
            **cache,
        )
        (tools / "cmake").symlink_to("/bin/true")
        self.assert_refused(
            THESIS,
            "ninja is not installed; Debian's package ninja-build has it, "
            "and scripts/setup installs that",
            **cache,
        )

    def test_ends_with_the_program_that_has_called(self) -> None:
        began = self.folder / "began"
        places = self.with_cmake(f"echo $$ > {began}; while echo '[1/2] one'; do sleep 0.1; done")
        self.written({"like": "thesis"})
        build = self.folder / "build.json"
        build.write_text(json.dumps(self.build), encoding="utf-8")
        with subprocess.Popen(
            [SCRIPT, self.file, "--build", build, "--for-program", "--tell-steps"],
            env=os.environ | places,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        ) as called:
            assert called.stdout and called.stderr
            self.assertEqual(called.stdout.readline(), "? step 1/2\n")
            compiler = int(began.read_text(encoding="utf-8"))
            called.stdout.close()
            self.assertEqual(called.wait(60), 1)
            self.assertEqual(called.stderr.read(), "")
        with self.assertRaises(ProcessLookupError):
            os.kill(compiler, 0)
        self.assertEqual(list((self.folder / "cache").glob("*.partial")), [])

    def test_programs_read_of_a_file_that_cannot_be_written_there_too(self) -> None:
        (self.folder / "cache").mkdir()
        key = configuration.key_of("verilog", read_file(self.written(THESIS)), self.build)
        (self.folder / "cache" / f"configuration-verilog-{key}").mkdir()
        out = self.folder / "build.json"
        result = self.run_on(
            THESIS,
            "--verilog",
            "--for-program",
            "--out",
            out,
            DYNRT_CACHE=str(self.folder / "cache"),
        )
        self.assertEqual(
            (result.returncode, result.stdout, result.stderr), (1, f"{out}: File exists\n", "")
        )

    def test_a_build_that_fails_keeps_its_log(self) -> None:
        cache = self.folder / "cache"
        result = self.run_on(THESIS, DYNRT_CACHE=str(cache))
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr, f"cannot be built: .*; the whole log is {cache}/failed.log")
        self.assertIn("CMakeLists.txt", (cache / "failed.log").read_text("utf-8"))
        self.assertEqual(list(cache.glob("*.partial")), [])

    def test_cores_share_what_ccache_keeps(self) -> None:
        places = self.with_cmake('echo "$CCACHE_BASEDIR error: in $PWD"; exit 1')
        own = rf"{places['DYNRT_CACHE']}/configuration-native-\w+\.\w+\.partial"
        with mock.patch.dict(os.environ):
            os.environ.pop("CCACHE_BASEDIR", None)
            said = self.run_on(THESIS, **places).stderr
            self.assertRegex(said, f"cannot be built: {own} error: ")
        said = self.run_on(THESIS, CCACHE_BASEDIR="/of/the/caller", **places).stderr
        self.assertIn("cannot be built: /of/the/caller error: ", said)

    def test_key(self) -> None:
        def key(kind: str = "native", **keys: object) -> str:
            return configuration.key_of(kind, THESIS | keys, self.build)

        native, verilog = key(), key("verilog")
        self.assertNotEqual(key(made_for="a sail"), native)  # which the library hands out
        self.assertEqual(key("verilog", made_for="a sail"), verilog)
        self.assertEqual(key(rtl=False), native)  # the kind decides that
        self.assertNotEqual(native, verilog)
        self.assertNotEqual(key(mantissa_bits=15), native)
        slower = configuration.at_period(self.build, configuration.period("12.50"))
        self.assertEqual(slower["variables"]["DYNRT_CLOCK_NS"], "12.5")
        self.assertNotEqual(configuration.key_of("verilog", THESIS, slower), verilog)
        (self.source / "rtl/lib/fifo.v").write_text("changed", encoding="utf-8")
        self.assertEqual((key(), key("verilog")), (native, verilog))
        self.hlsc.write_text("changed", encoding="utf-8")
        self.assertEqual(key(), native)
        self.assertNotEqual(key("verilog"), verilog)
        (self.source / "cmake/Loadable.cmake").write_text("changed", encoding="utf-8")
        self.assertNotEqual(key(), native)

    def test_fingerprint(self) -> None:
        first = fingerprint.fingerprint(self.build)
        moved = self.folder / "moved"
        shutil.copytree(self.source, moved)
        self.assertEqual(fingerprint.fingerprint(self.build | {"source": str(moved)}), first)
        other = self.build | {"identity": {"CMAKE_CXX_FLAGS": "-fsanitize=address"}}
        self.assertNotEqual(fingerprint.fingerprint(other), first)
        (moved / "host/board/board.h").write_text("changed", encoding="utf-8")
        self.assertNotEqual(fingerprint.fingerprint(self.build | {"source": str(moved)}), first)

    def test_cmake_and_scripts_know_a_core_by_the_same_files(self) -> None:
        script = self.folder / "list.cmake"
        script.write_text(
            f"include({project.ROOT}/cmake/CoreSources.cmake)\n"
            "dynrt_core_sources(files ${PART})\n"
            'list(JOIN files "\n" files)\nfile(WRITE ${OUTPUT} "${files}\n")\n',
            encoding="utf-8",
        )
        output = self.folder / "files.txt"
        for part in ("code", "build", "verilog", "board"):
            subprocess.run(
                ["cmake", f"-DPART={part}", f"-DOUTPUT={output}", "-P", script], check=True
            )
            listed = sorted(map(pathlib.Path, output.read_text(encoding="utf-8").split("\n")[:-1]))
            self.assertGreater(len(listed), 1)
            self.assertEqual(listed, fingerprint.files_of(project.ROOT, part))


if __name__ == "__main__":
    unittest.main()
