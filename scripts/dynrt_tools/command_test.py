# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Ctrl-C ends a command with one sentence and exit code 130."""

import os
import pathlib
import signal
import subprocess
import time
import unittest

from dynrt_tools import project, testing

# Stands for a tool that runs for minutes; its file says that it has begun.
TOOL = '#!/bin/sh\n[ "$1" = -V ] && echo Yosys 0.23 && exit\ntouch "$BEGUN.$$"\nexec sleep 60\n'
SENTENCE = "interrupted before its end"


def scripts() -> list[pathlib.Path]:
    """The commands of scripts/ that are Python."""
    files = (p for p in project.SCRIPTS.iterdir() if p.is_file())
    return [p for p in sorted(files) if p.read_bytes().startswith(b"#!/usr/bin/python3")]


class Interrupted(testing.InFolder):
    def interrupted(self, *command: testing.Word) -> tuple[int, str]:
        """Exit code and errors of a command that SIGINT reaches while its tool runs."""
        bin_ = self.folder / "bin"
        bin_.mkdir(exist_ok=True)
        for name in ("yosys", "verilator"):
            testing.write_program(bin_ / name, TOOL)
        environment = {
            **os.environ,
            "PATH": f"{bin_}:{os.environ['PATH']}",
            "BEGUN": str(self.folder / "begun"),
            "DYNRT_CACHE": str(self.folder / "cache"),
        }
        with subprocess.Popen(
            command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment
        ) as process:
            end = time.monotonic() + 30
            while not list(self.folder.glob("begun.*")):
                self.assertLess(time.monotonic(), end, "no tool has begun")
                time.sleep(0.05)
            process.send_signal(signal.SIGINT)
            _, errors = process.communicate(timeout=20)
        return process.returncode, errors

    def begun(self) -> set[int]:
        """The tools that have begun."""
        return {int(p.suffix[1:]) for p in self.folder.glob("begun.*")}

    def test_tools_in_threads(self) -> None:
        for name, *arguments in (("synth", "list", "shading", "--jobs", "1"), ("lint",)):
            code, errors = self.interrupted(project.SCRIPTS / name, *arguments)
            self.assertEqual((code, errors), (130, f"{name}: {SENTENCE}\n"))
            for process in self.begun():
                self.assertFalse(pathlib.Path(f"/proc/{process}").exists(), "a tool is left")
            for file in self.folder.glob("begun.*"):
                file.unlink()

    def test_no_job_begins_afterwards(self) -> None:
        self.interrupted(project.SCRIPTS / "synth", "list", "shading", "--jobs", "1")
        self.assertEqual(len(self.begun()), 1)

    def test_every_command_begins_with_it(self) -> None:
        self.assertGreater(len(scripts()), 20)
        for script in scripts():
            text = script.read_text(encoding="utf-8")
            self.assertRegex(text, r'\ncommand\.run\("[\w.]+"\)\n$', script.name)

    def test_jobs_are_in_pools_that_end_their_tools(self) -> None:
        for path in (project.SCRIPTS / "dynrt_tools").rglob("*.py"):
            if path.name not in ("command.py", "command_test.py"):
                text = path.read_text(encoding="utf-8")
                self.assertNotIn("ThreadPoolExecutor", text, f"{path}: take command.Pool")


class Reports(testing.InFolder):
    """Commands that go on where they stopped say so."""

    def test_the_exit_code_is_the_same(self) -> None:
        script = self.folder / "report"
        text = (
            "#!/usr/bin/python3\nimport argparse, sys\n"
            f"sys.path.insert(0, '{project.SCRIPTS}')\n"
            "from dynrt_tools.experiments.command import guarded\n"
            "def stop(args):\n    raise KeyboardInterrupt\n"
            "sys.exit(guarded(stop, argparse.Namespace()))\n"
        )
        testing.write_program(script, text)
        result = testing.run(script)
        self.assertEqual(result.returncode, 130)
        self.assertEqual(
            result.stderr, "\ndynrt: interrupted; the same command goes on from here\n"
        )


if __name__ == "__main__":
    unittest.main()
