# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Runs jobs that have no result yet, with Snakemake on this machine or on a Slurm cluster, and says
which of them failed."""

import contextlib
import fcntl
import json
import os
import pathlib
import re
import shlex
import shutil
import signal
import subprocess
from collections.abc import Iterator, Mapping, Sequence

from dynrt_tools.experiments.jobs import DOING, RESULT, Job, whole
from dynrt_tools.experiments.run_job import KILLED
from dynrt_tools.project import SCRIPTS, Failed, Json, read_json, show_progress

FOLDER = pathlib.Path(__file__).resolve().parent
PROFILE = FOLDER / "slurm"
STEP = re.compile(r"^(\d+) of (\d+) steps")
FAILED = re.compile(r"^Error in rule job:")
LOG = re.compile(r"^ +log: logs/(\w+)\.(\w+)\.log")
SLURM_JOB = re.compile(r"^ +cluster_jobid: (\d+)")
ENDED_BY_SLURM = re.compile(r"^slurmstepd\S*: error: (?:\*\*\* )?(.+?)(?: \*\*\*)?$", re.MULTILINE)
REFUSED = re.compile(r"^(sbatch: error: .+)$", re.MULTILINE)
DEAF = 20  # seconds after which Snakemake is taken to ignore SIGINT


def stop(process: subprocess.Popen[str]) -> None:
    """Ends Snakemake and its jobs, as a terminal would; it removes their unfinished files. Where a
    shell started all of this in the background, SIGINT is ignored."""
    os.killpg(process.pid, signal.SIGINT)
    try:
        process.wait(DEAF)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGTERM)
        process.wait()


class Failures:
    """The jobs that failed, with the number that Slurm gave them, by what Snakemake prints."""

    def __init__(self) -> None:
        self.found: dict[str, str] = {}
        self._job = ""
        self._told = True  # the lines that come are not about the last one

    def read(self, line: str) -> None:
        if FAILED.match(line):
            self._told, self._job = False, ""
        elif not line.startswith(" "):
            self._told = True
        elif not self._told and (log := LOG.match(line)):
            self._job = f"{log[1]}/{log[2]}"
            self.found.setdefault(self._job, "")
        elif not self._told and self._job and (number := SLURM_JOB.match(line)):
            self.found[self._job] = number[1]


class Workflow:
    """A folder that keeps the results of jobs."""

    def __init__(self, folder: pathlib.Path) -> None:
        self.folder = folder

    @contextlib.contextmanager
    def alone(self) -> Iterator[None]:
        self.folder.mkdir(parents=True, exist_ok=True)
        with (self.folder / "lock").open("w") as file:
            try:
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError as error:
                raise Failed(
                    f"{self.folder}: another experiment runs there; wait for it or name another --out"
                ) from error
            yield

    def kept(self, job: Job) -> pathlib.Path:
        return self.folder / "kept" / job.key

    def result(self, job: Job | None) -> Json | None:
        """What a job has found out; None if it has no result."""
        path = self.kept(job) / RESULT if job else None
        return dict(read_json(path)) if path and path.is_file() else None

    def run(self, goals: Sequence[Job], jobs: int, slurm: bool) -> list[str]:
        """Runs the jobs that have no result. Gives a sentence for each that failed; those that do
        not depend on it run all the same."""
        missing = {key: job for key, job in whole(goals).items() if not self.kept(job).exists()}
        if not missing:
            return []
        for key, job in missing.items():
            path = self.folder / "jobs" / f"{key}.json"
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(json.dumps(job.described(), indent=1), encoding="utf-8")
            (self.folder / "logs" / f"{key.replace('/', '.')}.log").unlink(missing_ok=True)
        after = {k: [a.key for a in job.after if a.key in missing] for k, job in missing.items()}
        config = {"after": after, "script": str(SCRIPTS / "run_job")}
        (self.folder / "config.json").write_text(json.dumps(config), encoding="utf-8")
        failures, code = self._snakemake(jobs, slurm)
        if code and not failures:
            raise Failed(self._last_words())
        return [self._reason(missing[key], number) for key, number in failures.items()]

    def _command(self, jobs: int, slurm: bool) -> list[str]:
        snakemake = shutil.which("snakemake")
        if snakemake is None:
            raise Failed(
                "snakemake is not installed; run scripts/setup, or: apt-get install snakemake"
            )
        if slurm and shutil.which("sbatch") is None:
            raise Failed(
                "--slurm: sbatch is not on the PATH; run the command on a node from which "
                "jobs can be submitted, or leave the flag out"
            )
        # As a command of a shell, whose words the profile could not quote.
        status = ["--cluster-status", shlex.quote(str(PROFILE / "status"))]
        where = ["--profile", str(PROFILE), *status] if slurm else ["--cores", str(jobs)]
        files = ["--snakefile", str(FOLDER / "Snakefile"), "--directory", str(self.folder)]
        files += ["--configfile", str(self.folder / "config.json")]
        return [
            snakemake,
            *files,
            "--nolock",
            "--rerun-incomplete",
            "--keep-going",
            "--nocolor",
        ] + where

    def _snakemake(self, jobs: int, slurm: bool) -> tuple[Mapping[str, str], int]:
        """The jobs that failed, and the exit code."""
        failures = Failures()
        with (self.folder / "snakemake.log").open("w", encoding="utf-8", buffering=1) as log:
            with subprocess.Popen(
                self._command(jobs, slurm),
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                text=True,
                env=os.environ | {"PYTHONDONTWRITEBYTECODE": "1"},
                start_new_session=True,
            ) as process:
                try:
                    for line in process.stdout or ():
                        log.write(line)
                        if step := STEP.match(line):
                            show_progress(f"{step[1]} of {step[2]} jobs are done")
                        failures.read(line)
                except KeyboardInterrupt:
                    stop(process)
                    raise
        show_progress("")
        return failures.found, process.returncode

    def _reason(self, job: Job, slurm_job: str) -> str:
        logs = self.folder / "logs"
        lines = _text(logs / f"{job.key.replace('/', '.')}.log").strip().splitlines()
        said = lines[-1] if lines else KILLED
        if ended := ENDED_BY_SLURM.findall(_text(logs / "slurm" / f"{slurm_job}.log")):
            said = f"Slurm ended it: {ended[-1]}"
        return f"{job.name}: {DOING[job.kind]} failed: {said}"

    def _last_words(self) -> str:
        log = self.folder / "snakemake.log"
        text = _text(log)
        refused = REFUSED.findall(text)
        last = [x for x in text.splitlines() if x.strip() and not x.startswith("Complete log")]
        said = (refused or last or ["it printed nothing"])[-1].strip()
        return f"the workflow failed: {said}; the whole log is {log}"


def _text(path: pathlib.Path) -> str:
    return path.read_text(encoding="utf-8") if path.is_file() else ""
