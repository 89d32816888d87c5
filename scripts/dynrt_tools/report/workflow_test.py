# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The workflow of an error report, with programs that only pretend."""

import json
import multiprocessing
import os
import shutil
import signal
import time
import unittest
from unittest import mock

from dynrt_tools import project, testing
from dynrt_tools.project import Failed
from dynrt_tools.report import jobs, workflow

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
if "--verilog" in args and args[args.index("--clock-ns") + 1] != "least":
    sys.exit("not the shortest period")
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


class Jobs(testing.InFolder):
    """The Snakefile with jobs that pretend."""

    def setUp(self) -> None:
        super().setUp()
        scripts = self.folder / "scripts"
        scripts.mkdir()
        for path, text in (
            (scripts / "configuration", CONFIGURATION),
            (scripts / "variant_hardware", HARDWARE),
            (scripts / "run_variant", RUN),
        ):
            testing.write_program(path, text)
        patch = mock.patch.object(jobs, "SCRIPTS", scripts)
        patch.start()
        self.addCleanup(patch.stop)
        self.work = self.folder / "out.work"
        self.program = self.folder / "dynrt"
        self.program.write_text("program", encoding="utf-8")
        self.build = self.folder / "build.json"
        self.build.write_text(json.dumps({"hlsc": "hlsc"}), encoding="utf-8")

    def run_workflow(
        self, names: tuple[str, ...] = ("a", "b"), hardware_too: bool = True, slurm: bool = False
    ) -> int:
        """The number of jobs that ran."""
        flow = workflow.Workflow(self.work, self.program, self.build, "f")
        (self.work / "ran").unlink(missing_ok=True)
        listed = {name: {"configuration": {"name": name}} for name in names}
        with flow.alone():
            flow.prepare({"blocks": "blocks"}, listed, "32x24", hardware_too)
            flow.run(2, slurm)
        ran = self.work / "ran"
        return len(ran.read_text(encoding="utf-8").splitlines()) if ran.exists() else 0

    def test_runs_what_is_not_there_yet(self) -> None:
        self.assertEqual(self.run_workflow(("a",)), 4)
        self.assertEqual(self.run_workflow(("a", "b")), 4)
        self.assertEqual(self.run_workflow(("a", "b")), 0)
        figures = self.work / "scenes" / "blocks" / "b" / "run.json"
        self.assertEqual(json.loads(figures.read_text(encoding="utf-8")), {"clocks": 7})
        self.program.write_text("another", encoding="utf-8")
        self.assertEqual(self.run_workflow(("a", "b")), 8)

    def test_a_failure_is_told_and_the_rest_is_kept(self) -> None:
        self.work.mkdir()
        (self.work / "fail").write_text("run_variant", encoding="utf-8")
        with self.assertRaisesRegex(Failed, "^blocks.a: rendering failed: what is wrong$"):
            self.run_workflow(("a",))
        (self.work / "fail").unlink()
        self.assertEqual(self.run_workflow(("a",)), 1)

    def run_in_background(self) -> None:
        """As a shell that starts it with & does."""
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        signal.signal(signal.SIGTERM, signal.default_int_handler)
        self.run_workflow(("a",), False)

    def test_it_ends_though_a_shell_started_it_in_the_background(self) -> None:
        self.enterContext(mock.patch.object(jobs, "DEAF", 1))
        self.work.mkdir()
        (self.work / "slow").write_text("", encoding="utf-8")
        process = multiprocessing.Process(target=self.run_in_background)
        process.start()
        self.wait_for_runs(1)
        process.terminate()
        process.join(50)  # the job sleeps for longer
        self.assertIsNotNone(process.exitcode)
        self.assertEqual(list(self.work.glob("scenes/*/*/run.json")), [])

    def wait_for_runs(self, count: int) -> None:
        ran = self.work / "ran"
        for _ in range(600):
            if ran.exists() and ran.read_text(encoding="utf-8").count("run_variant") >= count:
                return
            time.sleep(0.1)
        self.fail(f"{count} runs did not begin within a minute")

    def test_interrupted_it_goes_on_where_it_stopped(self) -> None:
        self.work.mkdir()
        (self.work / "slow").write_text("", encoding="utf-8")
        process = multiprocessing.Process(target=self.run_workflow, args=(("a", "b"), False))
        process.start()
        self.wait_for_runs(2)  # so that both models are done
        assert process.pid is not None
        os.kill(process.pid, signal.SIGINT)
        process.join(60)
        self.assertNotEqual(process.exitcode, 0)
        self.assertEqual(list(self.work.glob("scenes/*/*/run.json")), [])
        (self.work / "slow").unlink()
        self.assertEqual(self.run_workflow(("a", "b"), False), 2)  # the models are there
        self.assertEqual(len(list(self.work.glob("scenes/*/*/run.json"))), 2)

    def test_slurm(self) -> None:
        sbatch = self.folder / "bin" / "sbatch"
        sbatch.parent.mkdir()
        testing.write_program(
            sbatch,
            '#!/bin/bash\n[ $1 = --parsable ] && echo $$ && echo "$@" >> submitted\n'
            'exec bash "${@: -1}" > /dev/null 2>&1\n',
        )
        testing.write_program(sbatch.parent / "scontrol", "#!/bin/bash\necho JobState=COMPLETED\n")
        path = f"{sbatch.parent}:{os.environ['PATH']}"
        # With CI Snakemake asks every second, not every ten.
        with mock.patch.dict(os.environ, {"PATH": path, "CI": "true"}):
            self.assertEqual(self.run_workflow(("a",), hardware_too=False, slurm=True), 2)
        submitted = (self.work / "submitted").read_text(encoding="utf-8").splitlines()
        self.assertEqual(
            [project.searched("--job-name=([a-z-]+)", line)[1] for line in submitted],
            ["dynrt-model", "dynrt-run"],
        )

    def test_how_a_job_of_slurm_stands(self) -> None:
        scontrol = self.folder / "scontrol"
        environment = {**os.environ, "PATH": f"{self.folder}:{os.environ['PATH']}"}
        for said, status in (
            ("JobId=7 JobName=dynrt-run JobState=COMPLETED Reason=None", "success"),
            ("JobId=7 JobName=dynrt-run JobState=COMPLETING Reason=None", "running"),
            ("JobId=7 JobName=dynrt-run JobState=PENDING Reason=Resources", "running"),
            ("JobId=7 JobName=dynrt-run JobState=OUT_OF_MEMORY Reason=OutOfMemory", "failed"),
            ("JobId=7 JobName=dynrt-run JobState=NODE_FAIL Reason=NodeDown", "failed"),
            ("slurm_load_jobs error: Invalid job id specified", "failed"),
            ("slurm_load_jobs error: Unable to contact slurm controller", "running"),
        ):
            testing.write_program(scontrol, f"#!/bin/bash\necho '{said}' >&2\n")
            result = testing.run(jobs.PROFILE / "status", "7", env=environment)
            self.assertEqual((result.stdout.strip(), result.stderr), (status, ""), said)

    def test_slurm_that_takes_no_job(self) -> None:
        sbatch = self.folder / "bin" / "sbatch"
        sbatch.parent.mkdir()
        testing.write_program(
            sbatch, "#!/bin/bash\necho 'sbatch: error: no controller' >&2\nexit 1\n"
        )
        path = f"{sbatch.parent}:{os.environ['PATH']}"
        with mock.patch.dict(os.environ, {"PATH": path, "CI": "true"}):
            with self.assertRaisesRegex(
                Failed, "^the workflow failed: sbatch: error: no controller; the whole log is "
            ):
                self.run_workflow(("a",), hardware_too=False, slurm=True)

    def test_slurm_that_is_not_there(self) -> None:
        with mock.patch.object(
            shutil, "which", lambda name: None if name == "sbatch" else "snakemake"
        ):
            with self.assertRaisesRegex(
                Failed, "^--slurm: sbatch is not on the PATH; run the report on a node"
            ):
                self.run_workflow(slurm=True)

    def test_one_at_a_time(self) -> None:
        flow = workflow.Workflow(self.work, self.program, self.build, "f")
        with flow.alone():
            with self.assertRaisesRegex(
                Failed, "another report is being made there; wait for it or name another --out"
            ):
                with flow.alone():
                    pass

    def test_without_snakemake(self) -> None:
        with mock.patch.object(shutil, "which", return_value=None):
            with self.assertRaisesRegex(Failed, "^snakemake is not installed; run scripts/setup"):
                self.run_workflow()


if __name__ == "__main__":
    unittest.main()
