# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Runs a Snakemake workflow whose jobs keep their results in a folder, and says which of them failed:
the part that the reports share."""

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
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from dynrt_tools.project import SCRIPTS, Failed, Json, hash_of_files, read_json, show_progress

PROFILE = pathlib.Path(__file__).resolve().parent / "slurm"
STEP = re.compile(r"^(\d+) of (\d+) steps")
FAILED = re.compile(r"^Error in rule (\w+):")
LOG = re.compile(r"^ +log: (\S+)")
SLURM_JOB = re.compile(r"^ +cluster_jobid: (\d+)")
ENDED_BY_SLURM = re.compile(r"^slurmstepd\S*: error: (?:\*\*\* )?(.+?)(?: \*\*\*)?$", re.MULTILINE)
REFUSED = re.compile(r"^(sbatch: error: .+)$", re.MULTILINE)
NO_WORD = "it ended without a word, as a program does that is killed"
DEAF = 20  # seconds after which Snakemake is taken to ignore SIGINT
STAMP = "made_by.json"


def write_if_new(path: pathlib.Path, text: str) -> None:
    """Snakemake goes by the time of a file: a file whose text is the same is not written."""
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists() or path.read_text(encoding="utf-8") != text:
        part = path.with_name(path.name + ".part")
        part.write_text(text, encoding="utf-8")
        part.replace(path)


def content_of(path: pathlib.Path) -> str | None:
    return hash_of_files([path]) if path.is_file() else None


def stop(process: subprocess.Popen[str]) -> None:
    """Ends Snakemake and its jobs, as a terminal would; it removes their unfinished files. Where a
    shell started all of this in the background, SIGINT is ignored."""
    os.killpg(process.pid, signal.SIGINT)
    try:
        process.wait(DEAF)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGTERM)
        process.wait()


@dataclass
class FailedJob:
    rule: str
    log: str = ""
    slurm_job: str = ""


class Failures:
    """The jobs that failed, by what Snakemake prints."""

    def __init__(self) -> None:
        self._jobs: list[FailedJob] = []
        self._told = True  # the lines that come are not about the last one

    def read(self, line: str) -> None:
        if error := FAILED.match(line):
            self._jobs.append(FailedJob(error[1]))
            self._told = False
        elif not line.startswith(" "):
            self._told = True
        elif not self._told and (found := LOG.match(line)):
            self._jobs[-1].log = found[1]
        elif not self._told and (found := SLURM_JOB.match(line)):
            self._jobs[-1].slurm_job = found[1]

    def jobs(self) -> list[FailedJob]:
        """Each once: of a job of a cluster Snakemake may speak twice."""
        return list({job.log: job for job in self._jobs if job.log}.values())


class Jobs:
    """The jobs of a Snakefile, in a folder that keeps their results between runs. `doing` says what a
    rule does, for sentences about jobs that failed."""

    def __init__(
        self,
        snakefile: pathlib.Path,
        doing: Mapping[str, str],
        folder: pathlib.Path,
        program: pathlib.Path,
        build: pathlib.Path,
        expect: str,
    ) -> None:
        self.snakefile, self.doing = snakefile, doing
        self.folder, self.program, self.build, self.expect = folder, program, build, expect

    @contextlib.contextmanager
    def alone(self) -> Iterator[None]:
        self.folder.mkdir(parents=True, exist_ok=True)
        with (self.folder / "lock").open("w") as file:
            try:
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError as error:
                raise Failed(
                    f"{self.folder}: another report is being made there; wait for it or "
                    "name another --out"
                ) from error
            yield

    def configure(self, config: Json) -> None:
        """Writes what the Snakefile reads: `config`, and what every report's jobs are told."""
        build = read_json(self.build)
        # All that the jobs' results depend on, besides the files that they read.
        stamp = {
            "program": content_of(self.program),
            "build": build,
            "hlsc": content_of(pathlib.Path(build["hlsc"])),
        }
        write_if_new(self.folder / STAMP, json.dumps(stamp, indent=1))
        told = {
            **config,
            "stamp": STAMP,
            "program": str(self.program),
            "build": str(self.build),
            "scripts": str(SCRIPTS),
            "fingerprint": self.expect,
        }
        write_if_new(self.folder / "config.json", json.dumps(told, indent=1))

    def failures(self, jobs: int, slurm: bool) -> list[str]:
        """Runs the jobs that have no result yet. Gives a sentence for each that failed; those that do
        not depend on it run all the same."""
        snakemake = shutil.which("snakemake")
        if snakemake is None:
            raise Failed(
                "snakemake is not installed; run scripts/setup, or: apt-get install snakemake"
            )
        if slurm and shutil.which("sbatch") is None:
            raise Failed(
                "--slurm: sbatch is not on the PATH; run the report on a node from which "
                "jobs can be submitted, or leave the flag out"
            )
        command: list[str | pathlib.Path] = [
            snakemake,
            "--snakefile",
            self.snakefile,
            "--directory",
            self.folder,
            "--configfile",
            self.folder / "config.json",
            "--nolock",
            "--rerun-incomplete",
            "--keep-going",
            "--nocolor",
        ]
        # As a command of a shell, whose words the profile could not quote.
        status = ["--cluster-status", shlex.quote(str(PROFILE / "status"))]
        command += ["--profile", PROFILE, *status] if slurm else ["--cores", str(jobs)]
        environment = os.environ | {"PYTHONDONTWRITEBYTECODE": "1"}
        log = self.folder / "snakemake.log"
        failures = Failures()
        with log.open("w", encoding="utf-8", buffering=1) as file, subprocess.Popen(
            command,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            env=environment,
            start_new_session=True,
        ) as process:
            show_progress("looking for jobs")
            try:
                for line in process.stdout or ():
                    file.write(line)
                    if step := STEP.match(line):
                        show_progress(f"{step[1]} of {step[2]} jobs are done")
                    failures.read(line)
            except KeyboardInterrupt:
                stop(process)
                raise
        show_progress("")
        failed = failures.jobs()
        if process.returncode != 0 and not failed:
            raise Failed(_last_words(log))
        return [self._reason(job) for job in failed]

    def _reason(self, failed: FailedJob) -> str:
        path = self.folder / failed.log
        lines = _text(path).strip().splitlines()
        said = lines[-1].removeprefix("dynrt: ") if lines else NO_WORD
        slurm_log = self.folder / "logs" / "slurm" / f"{failed.slurm_job}.log"
        if ended := ENDED_BY_SLURM.findall(_text(slurm_log)):
            said = f"Slurm ended it: {ended[-1]}"
        job = path.name.removesuffix(f".{failed.rule}.log")
        return f"{job}: {self.doing.get(failed.rule, failed.rule)} failed: {said}"


def _text(path: pathlib.Path) -> str:
    return path.read_text(encoding="utf-8") if path.is_file() else ""


def _last_words(log: pathlib.Path) -> str:
    text = log.read_text(encoding="utf-8")
    refused = REFUSED.findall(text)
    last = [x for x in text.splitlines() if x.strip() and not x.startswith("Complete log")]
    said = (refused or last or ["it printed nothing"])[-1].strip()
    return f"the workflow failed: {said}; the whole log is {log}"
