# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Jobs and their kept results: what a hash depends on, and what runs, fails, stops and goes on."""

import multiprocessing
import os
import shutil
import signal
import sys
import time
import unittest
from unittest import mock

from dynrt_tools import project, testing
from dynrt_tools.experiments import workflow
from dynrt_tools.experiments.jobs import OUT, RESULT, Core, File, Job, Maker, Of, Word, whole
from dynrt_tools.experiments.workflow import Workflow
from dynrt_tools.project import Failed

# Writes its second word to its first. The file `fail` names what fails, `slow` lets it sleep.
PROGRAM = """#!/usr/bin/python3
import os, pathlib, signal, sys, time
out, word = sys.argv[1:3]
with pathlib.Path("ran").open("a") as file:
    file.write(word + "\\n")
here = lambda name: pathlib.Path(name).exists() and word in pathlib.Path(name).read_text().split()
if here("fail"):
    sys.exit("what is wrong")
if here("kill"):
    os.kill(os.getpid(), signal.SIGKILL)
if here("slow"):
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
    time.sleep(60)
if here("refuse"):
    print("dynrt: the scene is too large", file=sys.stderr)
    sys.exit(2)
pathlib.Path(out).write_text('{"word": "%s"}' % word)
"""


class Case(testing.InFolder):
    """Jobs of a program that only pretends."""

    def setUp(self) -> None:
        super().setUp()
        self.program = self.folder / "dynrt"
        testing.write_program(self.program, PROGRAM)
        self.work = self.folder / "out.work"
        self.work.mkdir()

    def job(self, word: str, *after: Job, refusable: bool = False) -> Job:
        needed = (Of(job, RESULT) for job in after)
        words: tuple[Word, ...] = (File(self.program), OUT + RESULT, word, *needed)
        return Job("frame", f"blocks, {word}", words, refusable=refusable)

    def run_jobs(self, *goals: Job, slurm: bool = False) -> list[str]:
        """The sentences about jobs that failed."""
        (self.work / "ran").unlink(missing_ok=True)
        flow = Workflow(self.work)
        with flow.alone():
            return flow.run(goals, 2, slurm)

    def ran(self) -> list[str]:
        path = self.work / "ran"
        return path.read_text(encoding="utf-8").split() if path.exists() else []

    def mark(self, name: str, words: str) -> None:
        (self.work / name).write_text(words, encoding="utf-8")

    def wait_for_runs(self, count: int) -> None:
        for _ in range(600):
            if len(self.ran()) >= count:
                return
            time.sleep(0.1)
        self.fail(f"{count} runs did not begin within a minute")


class Hashes(Case):
    def test_every_cause_makes_another(self) -> None:
        scene, build = self.folder / "ball.obj", self.folder / "build.json"
        scene.write_text("v 0 0 0", encoding="utf-8")
        build.write_text("{}", encoding="utf-8")

        def frame(keys: project.Json | None = None, size: str = "8x8", expect: str = "f") -> str:
            maker = Maker(self.program, build, expect)
            keys = keys or {"packets": 4}
            core = Core("", maker.model("m", keys), maker.verilog("m", keys))
            words = (File(self.program), "measure", File(scene), "--size", size)
            return maker.frame("a", words, core).key

        first = frame()
        self.assertEqual(frame(), first)
        self.assertEqual(frame({"packets": 4, "about": "words"}), first)
        others = {frame({"packets": 5}), frame(size="9x9"), frame(expect="g")}
        scene.write_text("v 1 0 00", encoding="utf-8")
        others.add(frame())
        self.program.write_text(PROGRAM + "# changed\n", encoding="utf-8")
        others.add(frame())
        build.write_text('{"identity": "another compiler"}', encoding="utf-8")
        others.add(frame())
        self.assertEqual(len(others - {first}), 6)

    def test_the_name_is_none(self) -> None:
        job = self.job("a")
        self.assertEqual(job.key, Job("frame", "another", job.words).key)
        self.assertEqual(len(whole([job, self.job("b", job)])), 2)

    def test_the_verilog_of_several_pipelines_has_no_counters(self) -> None:
        build = self.folder / "build.json"
        build.write_text("{}", encoding="utf-8")
        maker = Maker(self.program, build, "f")
        several: project.Json = {"counters": False}
        none: project.Json = {}
        for pipelines, keys in ((1, none), (2, several)):
            job = maker.verilog("m", {"pipelines": pipelines})
            self.assertEqual(job.keys, {"pipelines": pipelines, **keys})
        self.assertEqual(maker.model("m", {"pipelines": 2}).keys, {"pipelines": 2})


class Runs(Case):
    def test_what_is_not_there_yet(self) -> None:
        first = self.job("a")
        self.assertEqual(self.run_jobs(self.job("b", first)), [])
        self.assertEqual(self.ran(), ["a", "b"])
        self.assertEqual(Workflow(self.work).result(first), {"word": "a"})
        self.assertEqual(self.run_jobs(self.job("b", first), self.job("c")), [])
        self.assertEqual(self.ran(), ["c"])
        self.assertEqual(self.run_jobs(self.job("c")), [])
        self.assertEqual(self.ran(), [])

    def test_failures_are_told_and_the_rest_is_kept(self) -> None:
        self.mark("fail", "a")
        self.mark("kill", "k")
        goals = [self.job("b", self.job("a")), self.job("c"), self.job("k")]
        sentences = sorted(self.run_jobs(*goals))
        self.assertEqual(
            sentences,
            [
                "blocks, a: rendering failed: what is wrong",
                "blocks, k: rendering failed: it ended without a word, as a program does that is "
                "killed",
            ],
        )
        (self.work / "fail").unlink()
        (self.work / "kill").unlink()
        self.assertEqual(self.run_jobs(*goals), [])
        self.assertEqual(sorted(self.ran()), ["a", "b", "k"])

    def test_refused_input_is_a_result(self) -> None:
        self.mark("refuse", "a")
        job = self.job("a", refusable=True)
        self.assertEqual(self.run_jobs(job), [])
        self.assertEqual(Workflow(self.work).result(job), {"refused": "the scene is too large"})
        self.assertEqual(len(self.run_jobs(self.job("a"))), 0, "the same words, the same result")

    def run_alone(self) -> None:
        signal.signal(signal.SIGTERM, signal.default_int_handler)
        try:
            self.run_jobs(self.job("a"))
        except KeyboardInterrupt:
            sys.exit(1)

    def in_background(self) -> None:
        """As a shell that starts it with & does."""
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        self.run_alone()

    def test_stopped_it_ends_and_goes_on(self) -> None:
        self.enterContext(mock.patch.object(workflow, "DEAF", 1))
        for target, number in (
            (self.run_alone, signal.SIGINT),
            (self.in_background, signal.SIGTERM),
        ):
            self.mark("slow", "a")
            process = multiprocessing.Process(target=target)
            process.start()
            self.wait_for_runs(1)
            assert process.pid is not None
            os.kill(process.pid, number)
            process.join(50)  # the job sleeps for longer
            self.assertNotIn(process.exitcode, (None, 0))
            self.assertFalse(Workflow(self.work).kept(self.job("a")).exists())
            (self.work / "ran").unlink()
        (self.work / "slow").unlink()
        self.assertEqual(self.run_jobs(self.job("a")), [])
        self.assertEqual(self.ran(), ["a"])

    def test_one_at_a_time(self) -> None:
        flow = Workflow(self.work)
        with flow.alone():
            with self.assertRaisesRegex(
                Failed, "another experiment runs there; wait for it or name"
            ):
                with flow.alone():
                    pass

    def test_without_snakemake(self) -> None:
        with mock.patch.object(shutil, "which", return_value=None):
            with self.assertRaisesRegex(Failed, "^snakemake is not installed; run scripts/setup"):
                self.run_jobs(self.job("a"))


class Slurm(Case):
    """With commands that stand in for Slurm's."""

    def stand_in(self, sbatch: str) -> None:
        folder = self.folder / "bin"
        folder.mkdir()
        testing.write_program(folder / "sbatch", sbatch)
        testing.write_program(folder / "scontrol", "#!/bin/bash\necho JobState=COMPLETED\n")
        # With CI Snakemake asks every second, not every ten.
        there = {"PATH": f"{folder}:{os.environ['PATH']}", "CI": "true"}
        self.enterContext(mock.patch.dict(os.environ, there))

    def test_jobs_are_submitted_by_their_kind(self) -> None:
        self.stand_in(
            '#!/bin/bash\n[ $1 = --parsable ] && echo $$ && echo "$@" >> submitted\n'
            'exec bash "${@: -1}" > /dev/null 2>&1\n'
        )
        self.assertEqual(self.run_jobs(self.job("b", self.job("a")), slurm=True), [])
        submitted = (self.work / "submitted").read_text(encoding="utf-8").splitlines()
        names = [project.searched("--job-name=([a-z-]+)", line)[1] for line in submitted]
        self.assertEqual(names, ["dynrt-frame", "dynrt-frame"])

    def test_one_that_takes_no_job(self) -> None:
        self.stand_in("#!/bin/bash\necho 'sbatch: error: no controller' >&2\nexit 1\n")
        with self.assertRaisesRegex(
            Failed, "^the workflow failed: sbatch: error: no controller; the whole log is "
        ):
            self.run_jobs(self.job("a"), slurm=True)

    def test_one_that_is_not_there(self) -> None:
        with mock.patch.object(shutil, "which", lambda name: None if name == "sbatch" else name):
            with self.assertRaisesRegex(
                Failed, "^--slurm: sbatch is not on the PATH; run the command"
            ):
                self.run_jobs(self.job("a"), slurm=True)

    def test_how_a_job_stands(self) -> None:
        scontrol = self.folder / "scontrol"
        environment = {**os.environ, "PATH": f"{self.folder}:{os.environ['PATH']}"}
        for said, status in (
            ("JobId=7 JobName=dynrt-frame JobState=COMPLETED Reason=None", "success"),
            ("JobId=7 JobName=dynrt-frame JobState=COMPLETING Reason=None", "running"),
            ("JobId=7 JobName=dynrt-frame JobState=OUT_OF_MEMORY Reason=OutOfMemory", "failed"),
            ("slurm_load_jobs error: Invalid job id specified", "failed"),
            ("slurm_load_jobs error: Unable to contact slurm controller", "running"),
        ):
            testing.write_program(scontrol, f"#!/bin/bash\necho '{said}' >&2\n")
            result = testing.run(workflow.PROFILE / "status", "7", env=environment)
            self.assertEqual((result.stdout.strip(), result.stderr), (status, ""), said)


if __name__ == "__main__":
    unittest.main()
