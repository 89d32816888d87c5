# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The jobs that experiments are made of. A job is a command whose result is kept in a folder; the
folder's name is a hash of all that made it, so that a result is measured once, for whichever
experiment."""

import functools
import hashlib
import json
import pathlib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from dynrt_tools.project import SCRIPTS, Json, hash_of_files, read_json

# A word of a command that begins so names a file of the job's folder, or of one that goes at its end.
OUT, SCRATCH = "{out}/", "{scratch}/"
CORE = SCRATCH + "core.json"  # where a job finds the keys that it is given
RESULT = "result.json"
TOOLS = SCRIPTS / "dynrt_tools" / "hardware"  # what counts cells and gates

DOING = {
    "made": "making a core for the scene",
    "model": "building its model",
    "verilog": "lowering its units",
    "area": "synthesizing its units",
    "gates": "counting its gates",
    "frame": "rendering",
}


@dataclass(frozen=True)
class File:
    """A word that names a file, on whose content the result depends."""

    path: pathlib.Path
    suffix: str = ""  # behind the path: the part of an archive

    def __str__(self) -> str:
        return f"{self.path}{self.suffix}"


@dataclass(frozen=True)
class Of:
    """A word that names a file of another job's folder."""

    job: "Job"
    name: str

    def __str__(self) -> str:
        return f"kept/{self.job.key}/{self.name}".rstrip("/")


Word = str | File | Of


@functools.cache
def content_of(path: pathlib.Path, changed: int) -> str:
    """A hash of a file that was changed at this time."""
    del changed
    return hash_of_files([path])


def hashed(path: pathlib.Path) -> str | None:
    """A hash of what stands in a file, if there is one."""
    return content_of(path, path.stat().st_mtime_ns) if path.is_file() else None


@dataclass(frozen=True)
class Job:
    """One command. `name` is for sentences, and `keys` are those of a core, if it is told any."""

    kind: str
    name: str
    words: tuple[Word, ...]
    keys: Mapping[str, object] | None = None
    causes: tuple[str, ...] = ()  # of its result, beside its words
    refusable: bool = False  # input that cannot be rendered is a result too

    @functools.cached_property
    def key(self) -> str:
        """Kind and hash: where its result lies below kept/."""
        causes = [self.kind, [self._cause(w) for w in self.words], self.keys, self.causes]
        text = json.dumps(causes, sort_keys=True)
        return f"{self.kind}/{hashlib.sha256(text.encode()).hexdigest()[:24]}"

    @staticmethod
    def _cause(word: Word) -> object:
        if isinstance(word, File):
            return [hashed(word.path), word.suffix]
        return [word.job.key, word.name] if isinstance(word, Of) else word

    @property
    def after(self) -> list["Job"]:
        """The jobs whose results it needs."""
        return [word.job for word in self.words if isinstance(word, Of)]

    def described(self) -> Json:
        """As run_job.py reads it."""
        return {
            "name": self.name,
            "words": [str(word) for word in self.words],
            "keys": self.keys,
            "refusable": self.refusable,
        }


def whole(goals: Sequence[Job]) -> dict[str, Job]:
    """The jobs and those that they need, by id, each once."""

    def found(jobs: Sequence[Job]) -> Iterator[Job]:
        for job in jobs:
            yield from found(job.after)
            yield job

    return {job.key: job for job in found(goals)}


@dataclass
class Maker:
    """Makes the jobs of one program and its build."""

    program: pathlib.Path
    build: pathlib.Path  # its description, by cmake/DescribeBuild.cmake
    expect: str  # the fingerprint of the sources that the program was made of
    made_of: tuple[str, ...] = field(init=False)  # the causes of every core

    def __post_init__(self) -> None:
        build = read_json(self.build)
        hlsc = hashed(pathlib.Path(build.get("hlsc", "")))
        self.made_of = (self.expect, json.dumps(build, sort_keys=True), hlsc or "")

    def _configuration(self, kind: str, name: str, core: Json | Job, *flags: Word) -> Job:
        """What scripts/configuration makes of keys, or of the core that a job makes."""
        keys = None if isinstance(core, Job) else stated(core)
        file: Word = Of(core, "configuration.json") if isinstance(core, Job) else CORE
        more = ("--build", str(self.build), "--expect", self.expect, "--jobs", "1")
        words = (str(SCRIPTS / "configuration"), file, *flags, *more)
        return Job(kind, name, words, keys, self.made_of)

    def model(self, name: str, core: Json | Job) -> Job:
        return self._configuration("model", name, core, "--out", OUT + "model.so")

    def verilog(self, name: str, core: Json | Job, clock_ns: str = "") -> Job:
        """Three pipelines count more than a core's counters can, and no unit depends on them: so
        the Verilog of several pipelines has none."""
        if not isinstance(core, Job) and core.get("pipelines", 1) > 1:
            core = {**core, "counters": False}
        clock = ("--clock-ns", clock_ns) if clock_ns else ()
        return self._configuration(
            "verilog", name, core, "--verilog", *clock, "--out", OUT + "verilog"
        )

    def counted(self, kind: str, verilog: Job) -> Job:
        """The `area` or the `gates` of a core."""
        tools = hash_of_files(sorted(TOOLS.glob("*.py")))
        script = {"area": "variant_hardware", "gates": "variant_gates"}[kind]
        words = (str(SCRIPTS / script), Of(verilog, "verilog"), OUT + RESULT)
        return Job(kind, verilog.name, words, causes=(tools,))

    def made(self, scene: Word, name: str, config: str, flags: Sequence[str]) -> Job:
        """A core made for a scene. The counters stay, as they tell the use of the units."""
        words = ("specialise", scene, "--config", config, "--no-hardware", "--keep", "counters")
        out = ("--jobs", "1", "--out", OUT.rstrip("/"))
        return Job("made", name, (File(self.program), *words, *flags, *out), causes=self.made_of)

    def frame(
        self, name: str, words: Sequence[Word], core: "Core", flags: Sequence[str] = ()
    ) -> Job:
        """What a command of the program, `words`, renders on a core and says of it."""
        clocks: tuple[Word, ...] = ()
        if core.verilog:
            clocks = ("--schedule", Of(core.verilog, "verilog"))
        config: Word = Of(core.model, "model.so") if core.model else core.named
        known: tuple[Word, ...] = ("--config", config) if config else ()
        return Job(
            "frame",
            name,
            (*words, *known, *flags, *clocks, "--json", OUT + RESULT),
            causes=self.made_of,
            refusable="measure" in words,
        )


@dataclass(frozen=True)
class Core:
    """A core as frames need it: known to the program by its name, or a model that a job builds."""

    named: str
    model: Job | None = None
    verilog: Job | None = None


def stated(keys: Mapping[str, object]) -> Json:
    """The keys that decide a core."""
    return {key: value for key, value in keys.items() if key not in ("name", "about")}
