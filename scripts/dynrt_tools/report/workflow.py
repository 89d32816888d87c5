# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Sets up the Snakemake workflow of an error report beside its folder, and runs it."""

import contextlib
import fcntl
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
from collections.abc import Iterator

from dynrt_tools.project import SCRIPTS, Failed, Json, hash_of_files, read_json, show_progress

HERE = pathlib.Path(__file__).resolve().parent
STEP = re.compile(r"^(\d+) of (\d+) steps")
FAILED = re.compile(r"^Error in rule (\w+):")
LOG = re.compile(r"^ +log: (\S+)")
DOING = {
    "model": "building its model",
    "verilog": "lowering its units",
    "hardware": "synthesizing its units",
    "run": "rendering",
}


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
    """Ends Snakemake and its jobs, as a terminal would; it removes their unfinished files."""
    os.killpg(process.pid, signal.SIGINT)
    process.wait()


class Workflow:
    """The jobs of these scenes and variants, in a folder that keeps their results between runs."""

    def __init__(
        self, folder: pathlib.Path, program: pathlib.Path, build: pathlib.Path, expect: str
    ) -> None:
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

    def prepare(
        self, scenes: dict[str, str], variants: dict[str, Json], size: str, hardware: bool
    ) -> None:
        for name, variant in variants.items():
            write_if_new(
                self.folder / "variants" / f"{name}.json",
                json.dumps(variant["configuration"], indent=1),
            )
        build = read_json(self.build)
        # All that the jobs' results depend on, besides the files that they read.
        stamp = {
            "program": content_of(self.program),
            "build": build,
            "hlsc": content_of(pathlib.Path(build["hlsc"])),
        }
        write_if_new(self.folder / "made_by.json", json.dumps(stamp, indent=1))
        config = {
            "scenes": scenes,
            "variants": list(variants),
            "size": size,
            "stamp": "made_by.json",
            "program": str(self.program),
            "build": str(self.build),
            "hardware": hardware,
            "scripts": str(SCRIPTS),
            "fingerprint": self.expect,
        }
        write_if_new(self.folder / "config.json", json.dumps(config, indent=1))

    def run(self, jobs: int, slurm: bool) -> None:
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
            HERE / "Snakefile",
            "--directory",
            self.folder,
            "--configfile",
            self.folder / "config.json",
            "--nolock",
            "--rerun-incomplete",
            "--keep-going",
            "--nocolor",
        ]
        command += ["--profile", HERE / "slurm"] if slurm else ["--cores", str(jobs)]
        environment = os.environ | {"PYTHONDONTWRITEBYTECODE": "1"}
        log = self.folder / "snakemake.log"
        failed: dict[str, str] = {}
        with log.open("w", encoding="utf-8", buffering=1) as file, subprocess.Popen(
            command,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            env=environment,
            start_new_session=True,
        ) as process:
            rule = None
            show_progress("looking for jobs")
            try:
                for line in process.stdout or ():
                    file.write(line)
                    if step := STEP.match(line):
                        show_progress(f"{step[1]} of {step[2]} jobs are done")
                    if error := FAILED.match(line):
                        rule = error[1]
                    if rule and (found := LOG.match(line)):
                        failed.setdefault(found[1], rule)
                        rule = None
            except KeyboardInterrupt:
                stop(process)
                raise
        show_progress("")
        if process.returncode != 0:
            raise Failed(self._reason(failed, log))

    def _reason(self, failed: dict[str, str], log: pathlib.Path) -> str:
        for name, rule in failed.items():
            path = self.folder / name
            lines = path.read_text(encoding="utf-8").strip().splitlines() if path.exists() else []
            variant = path.name.removesuffix(f".{rule}.log")
            return (
                f"{variant}: {DOING.get(rule, rule)} failed: "
                f"{lines[-1] if lines else 'no reason was given'}"
            )
        text = log.read_text(encoding="utf-8")
        last = next((x for x in reversed(text.splitlines()) if x.strip()), "it printed nothing")
        return f"the workflow failed: {last.strip()}; the whole log is {log}"
