# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Builds one configuration of the core as a shared library, which dynrt takes as --config
FILE.so."""

import argparse
import fcntl
import hashlib
import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
from typing import Any, TextIO

from dynrt_tools import options
from dynrt_tools.project import read_json
from dynrt_tools.build import fingerprint
from dynrt_tools.build.cache import BuildCache, full_disk
from dynrt_tools.build.configs import load_configurations, read_file
from dynrt_tools.project import ROOT, Failed, Json, Progress, require_tool, show_progress

NAME = "loadable"  # of the configuration in the C++ and the Verilog, whatever the file's name is

# Of each kind: the CMake target, and the parts of a core (cmake/core_sources.json) that it is made
# from, besides the code, which its fingerprint covers.
KINDS: dict[str, dict[str, Any]] = {
    "native": {"target": NAME, "parts": ["build"]},
    "verilog": {"target": f"dynrt_{NAME}_core", "parts": ["build", "verilog"]},
    "rtl": {"target": NAME, "parts": ["build", "verilog", "board"]},
}
LIBRARY = "configuration.so"
CLOCK = "DYNRT_CLOCK_NS"
LEAST = "least"  # a period: the shortest that every unit reaches, as hlsc says it of one
TOOLS = {"cmake": "cmake", "ninja": "ninja-build"}  # and Debian's packages that have them


def find_build(named: pathlib.Path | None) -> Json:
    """The description that cmake/DescribeBuild.cmake wrote of a build."""
    candidates = (
        [named, named / "build.json"]
        if named
        else [ROOT / "build" / p / "build.json" for p in ("release", "dev", "model")]
    )
    for path in candidates:
        if path.is_file():
            return dict(read_json(path))
    raise Failed(
        f"no build is at {' nor '.join(map(str, candidates))}; build the project first, "
        "or name its folder with --build"
    )


def key_of(kind: str, config: Json, build: Json) -> str:
    """The key of all that the result depends on. A library hands out every key of its configuration;
    the Verilog depends on those alone that decide the core."""
    keys = load_configurations().KEYS
    said = {
        key: value
        for key, value in config.items()
        if keys[key].of_core or (kind != "verilog" and key != "rtl")
    }
    digest = hashlib.sha256(
        json.dumps(
            [kind, said, build["variables"], fingerprint.fingerprint(build)], sort_keys=True
        ).encode()
    )
    for part in KINDS[kind]["parts"]:
        fingerprint.add_files(digest, pathlib.Path(build["source"]), part)
    if kind != "native":
        hlsc = pathlib.Path(build["hlsc"])
        if not hlsc.is_file():
            raise Failed(
                f"{hlsc} is missing; build the target hlsc, which lowers the units "
                "(scripts/test --build-only does)"
            )
        digest.update(hlsc.read_bytes())
    return digest.hexdigest()[:40]


def same_core(config: Json) -> str:
    """The listed configuration that a build lowers and that has the same core, or nothing."""
    loaded = load_configurations()
    of_core = [key for key, said in loaded.KEYS.items() if said.of_core]
    return next(
        (
            name
            for name, listed in loaded.listed().items()
            if listed["rtl"] and all(listed[key] == config[key] for key in of_core)
        ),
        "",
    )


def longest_period(folder: pathlib.Path) -> str:
    """Of the schedules in this folder, in ns."""
    return str(max(read_json(path)["clock_ns"] for path in folder.glob("*.json")))


def at_period(build: Json, clock: str | None) -> Json:
    """A build that schedules units for this period; without one, for its own."""
    if not clock:
        return build
    return build | {"variables": build["variables"] | {CLOCK: clock}}


def period(text: str) -> str:
    """A period as --clock-ns takes it: a number of ns, always written in the same way, or LEAST."""
    if text == LEAST:
        return text
    try:
        number = float(text)
    except ValueError:
        number = 0
    if not 0 < number < math.inf:
        raise Failed(
            f"--clock-ns {text}: this is no period of a clock; give the ns from edge to edge, a "
            f"number above 0 such as 8.33, or {LEAST} for the shortest that all units reach"
        )
    return f"{number:g}"


class Builder:
    """Runs CMake for one configuration."""

    def __init__(
        self,
        kind: str,
        config: Json,
        build: Json,
        jobs: int,
        progress: Progress,
        listed: str = "",
    ) -> None:
        """`listed`: the configuration of the build whose Verilog it is, if there is one."""
        self.kind, self.config, self.build = kind, config, build
        self.jobs, self.progress, self.listed = jobs, progress, listed

    def __call__(self, folder: pathlib.Path) -> pathlib.Path:
        for tool, package in TOOLS.items():
            require_tool(tool, package)
        tree = folder / "build"
        target, clock = KINDS[self.kind]["target"], self.build["variables"][CLOCK]
        if self.listed:
            return self._take_from_build(folder)
        if self.kind != "native" and clock == LEAST:
            self._build(folder, "verilog", LEAST)  # each unit for the shortest that it reaches
            clock = longest_period(tree / "generated" / NAME)
        self._build(folder, target, clock)
        if self.kind == "verilog":
            made = tree / "generated" / NAME
            shutil.rmtree(made / "fresh", ignore_errors=True)
            return made
        made = folder / "made"
        made.mkdir()
        (tree / "host" / "board" / f"{NAME}.so").rename(made / LIBRARY)
        return made

    def _take_from_build(self, folder: pathlib.Path) -> pathlib.Path:
        """What the build itself lowers, which is renewed if it is not there or has become old."""
        tree, made = pathlib.Path(self.build["folder"]), folder / "made"
        with (tree / "lowering.lock").open("w", encoding="utf-8") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            self._make(folder, tree, f"dynrt_{self.listed}_core")
            shutil.copytree(
                tree / "generated" / self.listed, made, ignore=shutil.ignore_patterns("fresh")
            )
        return made

    def configure(self, folder: pathlib.Path, clock: str) -> pathlib.Path:
        """Where CMake can build its targets, units scheduled for this period."""
        configs, tree, log = folder / "configs.json", folder / "build", folder / "log"
        stated = self.config | {"rtl": self.kind != "native"}
        configs.write_text(json.dumps([{"name": NAME, **stated}]), encoding="utf-8")
        variables = self.build["variables"] | {
            "DYNRT_LOADABLE": "ON",
            "DYNRT_CONFIGS_FILE": configs,
            "DYNRT_RTL": "OFF" if self.kind == "native" else "ON",
            "DYNRT_HLSC": self.build["hlsc"],
            "DYNRT_FINGERPRINT": fingerprint.fingerprint(self.build),
            CLOCK: clock,
        }
        with log.open("w", encoding="utf-8") as file:
            self._run(
                [
                    "cmake",
                    "-S",
                    self.build["source"],
                    "-B",
                    tree,
                    "-G",
                    "Ninja",
                    *(f"-D{name}={value}" for name, value in variables.items()),
                ],
                file,
                log,
            )
        return tree

    def _build(self, folder: pathlib.Path, target: str, clock: str) -> None:
        self._make(folder, self.configure(folder, clock), target)

    def _make(self, folder: pathlib.Path, tree: pathlib.Path, target: str) -> None:
        log = folder / "log"
        with log.open("a", encoding="utf-8") as file:
            self._run(
                [
                    "cmake",
                    "--build",
                    tree,
                    "--target",
                    target,
                    "--parallel",
                    str(self.jobs),
                ],
                file,
                log,
            )

    def _run(self, command: list[Any], file: TextIO, log: pathlib.Path) -> None:
        # ccache takes what is below this folder as relative, so that cores share what is compiled alike
        # for them.
        surroundings = {"CCACHE_BASEDIR": str(log.parent.resolve()), **os.environ}
        with subprocess.Popen(
            command,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            errors="replace",
            env=surroundings,
        ) as process:
            try:
                for line in process.stdout or ():
                    file.write(line)
                    if step := re.match(r"\[(\d+/\d+)\]", line):
                        self.progress(f"step {step[1]}")
            except BaseException:
                process.terminate()
                raise
        if process.returncode != 0:
            file.flush()
            raise Failed(self._reason(log))

    def _reason(self, log: pathlib.Path) -> str:
        text = log.read_text(encoding="utf-8", errors="replace")
        if "No space left on device" in text:
            return full_disk(log.parent.parent)
        kept = log.parent.parent / "failed.log"
        shutil.copyfile(log, kept)
        lines = [line.strip() for line in text.splitlines() if line.strip()]
        error = next((line for line in lines if "error:" in line or "FAILED" in line), lines[-1])
        return f"cannot be built: {error}; the whole log is {kept}"


def tell(step: str) -> None:
    """To the program that has called; once that has ended, nobody needs the result."""
    try:
        print(f"? {step}", flush=True)
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        sys.exit(1)


def make(args: argparse.Namespace) -> pathlib.Path:
    """The path of the result."""
    config = read_file(args.file)
    if args.kind == "check":
        return pathlib.Path(args.file)
    build = at_period(find_build(args.build), args.clock_ns and period(args.clock_ns))
    if args.clock_ns:
        config["clock_ns"] = 0
    if args.expect and args.expect != fingerprint.fingerprint(build):
        raise Failed("the sources have changed since this program was built; build it again")

    def progress(text: str) -> None:
        show_progress(f"building configuration {args.file.stem}: {text}")
        if args.tell_steps:
            tell(text)

    listed = same_core(config) if args.kind == "verilog" and not args.clock_ns else ""
    entry = BuildCache().get(
        f"configuration-{args.kind}-{key_of(args.kind, config, build)}",
        Builder(args.kind, config, build, args.jobs, progress, listed),
        lambda: progress("another program builds it; waiting"),
    )
    made = entry if args.kind == "verilog" else entry / LIBRARY
    if not args.out:
        return made
    if args.kind == "verilog":
        shutil.copytree(made, args.out, dirs_exist_ok=True)
    else:
        part = args.out.with_name(f"{args.out.name}.{os.getpid()}")
        try:
            shutil.copyfile(made, part)
            part.replace(args.out)
        finally:
            part.unlink(missing_ok=True)
    return pathlib.Path(args.out)


def main() -> int:
    parser = argparse.ArgumentParser(
        prog="scripts/configuration",
        description=__doc__,
        epilog="The folder that DYNRT_CACHE names (default: dynrt in the user's cache folder) keeps "
        "each result. A change of the configuration, the sources, the compiler or its flags makes "
        "another one. Prints where the result is.",
    )
    parser.add_argument(
        "file",
        type=pathlib.Path,
        metavar="FILE.json",
        help='an object with keys of a configuration; "like": NAME takes the '
        "others from one of hls/configs/configs.json",
    )
    kinds = parser.add_mutually_exclusive_group()
    kinds.add_argument(
        "--rtl",
        dest="kind",
        action="store_const",
        const="rtl",
        help="build the Verilated board too, not only the native model; takes minutes",
    )
    kinds.add_argument(
        "--verilog",
        dest="kind",
        action="store_const",
        const="verilog",
        help="make a folder with the Verilog and hlsc's reports instead",
    )
    kinds.add_argument(
        "--check",
        dest="kind",
        action="store_const",
        const="check",
        help="make nothing; only say whether the keys keep the rules between them",
    )
    parser.set_defaults(kind="native")
    parser.add_argument(
        "--clock-ns",
        metavar="NS",
        help="schedule the units for this period; least: the shortest that all units reach "
        "(default: the configuration's clock_ns, else that of the build)",
    )
    parser.add_argument("--out", type=pathlib.Path, metavar="PATH", help="copy the result there")
    parser.add_argument(
        "--build",
        type=pathlib.Path,
        metavar="FOLDER",
        help="the build whose program will load it (default: build/release, else "
        "build/dev or build/model)",
    )
    options.add_jobs(parser, "compilers")
    parser.add_argument(
        "--expect",
        metavar="FINGERPRINT",
        help="for programs: fail if the sources have another fingerprint",
    )
    parser.add_argument(
        "--for-program",
        action="store_true",
        help="for programs: print a mistake in place of the path",
    )
    parser.add_argument(
        "--tell-steps",
        action="store_true",
        help="for programs: print each step as a line that begins with '? '",
    )
    args = parser.parse_args()
    try:
        made = make(args)
    except Failed as error:
        show_progress("")
        if args.for_program:
            print(error)
            return 1
        sys.exit(f"configuration: {args.file}: {error}")
    except OSError as error:
        sentence = f"{error.filename or args.file}: {error.strerror}"
        if args.for_program:
            print(sentence)
            return 1
        sys.exit(f"configuration: {sentence}")
    show_progress("")
    print(made)
    return 0
