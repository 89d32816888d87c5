# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Cores to measure that are no configuration of hls/configs/configs.json, but like one of them."""

import dataclasses
import pathlib
import subprocess

from dynrt_tools.bench.run import RunFailed
from dynrt_tools.project import SCRIPTS, Json, write_json


@dataclasses.dataclass
class Core:
    config: str  # the native core, as dynrt takes it
    schedules: pathlib.Path  # the folder of its Verilog


def built(program: pathlib.Path, config: pathlib.Path, *flags: str) -> pathlib.Path:
    """What scripts/configuration makes for this program of a configuration's file."""
    done = subprocess.run(
        [SCRIPTS / "configuration", config, *flags, "--build", program.parent],
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        check=False,
    )
    if done.returncode:
        raise RunFailed(done.stderr.strip())
    return pathlib.Path(done.stdout.splitlines()[-1])


def made(program: pathlib.Path, config: pathlib.Path, like: str, keys: Json) -> Core:
    """Writes a configuration to this file, and builds its native core and its Verilog."""
    core: Json = {"like": like, "about": config.stem, **keys}
    write_json(config, core)
    lowered = config
    if keys.get("pipelines", 1) > 1:
        # The Verilog has not room for the counters of many pipelines, but the same clocks without.
        lowered = config.with_stem(f"{config.stem}_lowered")
        write_json(lowered, {**core, "counters": False})
    return Core(str(built(program, config)), built(program, lowered, "--verilog"))
