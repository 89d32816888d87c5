# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What a board renders whose memory is an SDRAM: frames of the native core with the twin of the
SDRAM's controller and the chip's model behind its port, each at its own clock, beside `fast` with its
banks of SRAM; and the budget of the memory's peak."""

import dataclasses
import itertools
import os
import pathlib
import subprocess
import tempfile

from dynrt_tools.bench.memory import SCENES, SHARE, SRAM, PORT, busiest
from dynrt_tools.bench.run import Dynrt, RunFailed, rays
from dynrt_tools.command import Pool
from dynrt_tools.hardware import bitstream, board_clocks, placed_clocks
from dynrt_tools.project import Json, Progress, read_json

BYTES = 2  # that the SDRAM moves in a clock
SAFE = 0.85  # of the peak: no aim asks for more


@dataclasses.dataclass(frozen=True)
class System:
    """A core and its SDRAM."""

    name: str
    about: str
    core_mhz: float
    sdram_mhz: int  # the period is a multiple of half a ns: 133 stands for 7.5 ns
    core: str  # its configuration

    def flags(self) -> list[str]:
        return ["--core-mhz", f"{self.core_mhz:g}", "--sdram-mhz", str(self.sdram_mhz)]


PLACED, OWN = "placed", "own"
OWN_CORE = bitstream.BOARDS["ulx3s"].config


def ulx3s() -> tuple[System, ...]:
    """The first is the one that aims are for."""
    placed = placed_clocks.of(SRAM).mhz
    own = board_clocks.ulx3s()
    return (
        System(PLACED, f"the clock that {SRAM} reaches placed", placed, 133, PORT),
        System(
            OWN,
            "the clocks and the core of rtl/ulx3s",
            own[board_clocks.CORE],
            round(own[board_clocks.SDRAM]),
            OWN_CORE,
        ),
    )


BOARDS = {"ulx3s": ulx3s}
# Of the frames with SRAM, in the first system of a board.
ASKED = {"office": 0.7, "cistern": 0.9, "conference": 0.65}
# Frames that the second system is held against the board's Verilog with.
HELD, HELD_SIZE = ("office", "conference"), "128x96"


def build(folder: pathlib.Path, target: str) -> None:
    """Makes a target of a build."""
    done = subprocess.run(
        ["cmake", "--build", folder, "--target", target, "--parallel", str(os.cpu_count())],
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        check=False,
    )
    if done.returncode:
        lines = [line for line in done.stdout.splitlines() if "error" in line.lower()]
        reason = lines[0].strip() if lines else "cmake says no more"
        raise RunFailed(f"{folder}: {target} cannot be built: {reason}")


def frame_of(
    dynrt: Dynrt,
    core: str,
    schedules: pathlib.Path,
    scene: str,
    size: str,
    system: System,
    *flags: str,
) -> Json:
    """What the program of a core writes of a frame with the SDRAM."""
    program = dynrt.program.parent / "verif" / "sdram" / f"sdram_frames_{core}"
    with tempfile.TemporaryDirectory() as folder:
        figures = pathlib.Path(folder, "figures.json")
        command = [str(program), scene, "--size", size, *system.flags(), *flags]
        done = subprocess.run(
            [*command, "--schedule", str(schedules), "--json", str(figures)],
            text=True,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            check=False,
        )
        if done.returncode:
            raise RunFailed(done.stderr.strip() or f"{program} ended with {done.returncode}")
        return dict(read_json(figures))


def figures_of(frame: Json, system: System) -> Json:
    """What the tables have of a frame with the SDRAM."""
    sdram, clocks = frame["sdram"], frame["cycles"]
    seconds = clocks / system.core_mhz / 1e6
    # Those of the port look a line that is on its way up again and again.
    others = {name: unit for name, unit in frame["units"].items() if "memory_" not in name}
    stalls = {name: float(unit["stalled"]) for name, unit in frame["units"].items()}
    stalled = max(stalls, key=lambda name: stalls[name])
    moves, idle = sdram["busy"] / sdram["clocks"], sdram["idle"] / sdram["clocks"]
    kinds = {
        f"{kind} bytes per ray": sdram[f"{kind}_bytes_read"] / rays(frame)
        for kind in ("node", "list", "matrix")
    }
    return {
        "core_hz": system.core_mhz * 1e6,  # divided by the clocks: frames per second
        "clocks": clocks,
        "bytes read per ray": sdram["bytes_read"] / rays(frame),
        **kinds,
        "bytes written per ray": sdram["bytes_written"] / rays(frame),
        "MB per second read": sdram["bytes_read"] / seconds / 1e6,
        "MB per second written": sdram["bytes_written"] / seconds / 1e6,
        "MB per second displayed": sdram["bytes_displayed"] / seconds / 1e6,
        "share of the peak": moves,
        "waits for the core": idle,
        "waits for rows and turns": 1 - moves - idle,
        "rows opened per burst": sdram["activations"] / sdram["bursts"],
        "ns of a read": sdram["read_nanoseconds"] / sdram["reads"],
        "reads under way": sdram["read_nanoseconds"] / (seconds * 1e9),
        "second hits": frame["caches"].get("second", {}).get("hit_rate"),
        "busiest unit": busiest(others)[0],
        "use": busiest(others)[1],
        "stalled unit": stalled,
        "stalled": stalls[stalled],
    }


def budget_of(frame: Json, fixed: Json, asked: float | None) -> Json:
    """What the rate of SRAM would ask of the SDRAM in MB/s, and the aim that this leaves."""
    rays_per_second = frame["SRAM rays per clock"] * frame["core_hz"]
    read = frame["bytes read per ray"] * rays_per_second / 1e6
    written = frame["bytes written per ray"] * rays_per_second / 1e6
    whole = read + written + fixed["displayed"] + fixed["refresh"]
    room = SAFE * fixed["peak"] - fixed["displayed"] - fixed["refresh"]
    reachable = min(1, room / (read + written))
    aim = None if asked is None else min(asked, reachable)
    return {
        "system": frame["system"],
        "scene": frame["scene"],
        "read": read,
        "written": written,
        **fixed,
        "sum": whole,
        "of the peak": whole / fixed["peak"],
        "reachable": reachable,
        "asked": asked,
        "aim": aim,
        "reached": frame[SHARE],
        "verdict": "no aim" if aim is None else "reached" if frame[SHARE] >= aim else "missed",
    }


def sram_frame(dynrt: Dynrt, scene: str, size: str) -> Json:
    schedules = dynrt.program.parent / "generated" / SRAM
    flags = ("--schedule", str(schedules), "--no-hits")
    frame = dynrt.render(scene, "model", SRAM, size, *flags).frame
    if not frame["cycles"]:
        raise RunFailed(f"the frame of {SRAM} has no clocks")
    return frame


def fixed_of(frame: Json, system: System) -> Json:
    """The peak, and what does not depend on the core's rate, in MB/s."""
    sdram = frame["sdram"]
    seconds = frame["cycles"] / system.core_mhz / 1e6
    peak = sdram["clocks"] * BYTES / seconds / 1e6
    lost = sdram["refreshes"] * sdram["refresh_clocks"] / sdram["clocks"]
    displayed = sdram["bytes_displayed"] / seconds / 1e6
    return {"peak": peak, "displayed": displayed, "refresh": lost * peak}


def verilog_of(dynrt: Dynrt, board: str, scene: str, system: System, progress: Progress) -> Json:
    """The clocks of a small frame on the board's Verilog, whose display reads a picture that is as
    small, and of this one's without a display."""
    progress(f"{board}: {scene}, on its Verilog")
    verilog = dynrt.render(scene, board, system.core, HELD_SIZE, "--no-hits").frame["cycles"]
    schedules = dynrt.program.parent / "generated" / system.core
    here = frame_of(dynrt, system.core, schedules, scene, HELD_SIZE, system, "--no-display")
    return {"scene": scene, "clocks of the Verilog": verilog, "clocks here": here["cycles"]}


def measure(dynrt: Dynrt, board: str, size: str, progress: Progress) -> Json:
    """A frame of each system and scene, as many at a time as there are processors."""
    progress(f"building the programs of {board}")
    build(dynrt.program.parent, "sdram_frames")
    systems = BOARDS[board]()
    generated = dynrt.program.parent / "generated"
    jobs = [(system, scene) for scene in reversed(SCENES) for system in (None, *systems)]
    begun = itertools.count(1)

    def one(job: tuple[System | None, str]) -> Json:
        system, scene = job
        name = SRAM if system is None else system.name
        progress(f"{name}: {scene}, frame {next(begun)} of {len(jobs)}")
        if system is None:
            return sram_frame(dynrt, scene, size)
        return frame_of(dynrt, system.core, generated / system.core, scene, size, system)

    with Pool(os.cpu_count()) as pool:
        measured = dict(zip(jobs, pool.map(one, jobs)))
        held = [(dynrt, board, scene, systems[1], progress) for scene in HELD]
        verilog = list(pool.map(lambda each: verilog_of(*each), held))
    frames, budget = [], []
    for system, scene in itertools.product(systems, SCENES):
        sram, frame = measured[None, scene], measured[system, scene]
        row = {
            "system": system.name,
            "scene": scene,
            **figures_of(frame, system),
            SHARE: sram["cycles"] / frame["cycles"],
            "SRAM rays per clock": rays(sram) / sram["cycles"],
        }
        row["use with SRAM"] = sram["units"][row["busiest unit"]]["utilisation"]
        frames.append(row)
        asked = ASKED.get(scene) if system == systems[0] else None
        budget.append(budget_of(row, fixed_of(frame, system), asked))
    return {
        "board": board,
        "size": size,
        "systems": [dataclasses.asdict(system) for system in systems],
        "budget": budget,
        "frames": frames,
        "verilog": verilog,
    }


def share(value: float) -> str:
    return f"{100 * value:.1f}%"


def table(measured: Json) -> str:
    """The budget, then for each system what its frames cost and what waits for what."""
    lines = ["MB/s at the rate of SRAM: read, written, displayed, refresh; sum, of the peak; aim"]
    for row in measured["budget"]:
        aim = "-" if row["aim"] is None else share(row["aim"])
        parts = "".join(f"{row[p]:>7.0f}" for p in ("read", "written", "displayed", "refresh"))
        lines.append(
            f"{row['system']:8}{row['scene']:12}{parts}{row['sum']:>7.0f}"
            f"{share(row['of the peak']):>9}{aim:>8}, is {share(row['reached'])}: {row['verdict']}"
        )
    for system in measured["systems"]:
        lines.append(
            f"\n{system['name']}: {system['about']}: core {system['core_mhz']:g} MHz, "
            f"SDRAM {system['sdram_mhz']} MHz"
        )
        lines.append(
            f"{'':12}{'frames/s':>9}{'of SRAM':>9}{'B/ray':>8}{'written':>9}{'MB/s':>7}{'written':>9}"
            f"{'shown':>7}{'of peak':>9}{'rows':>6}{'ns':>7}{'waits':>8}{'idle':>7}{'reads':>7}"
            "  busiest"
        )
        for row in measured["frames"]:
            if row["system"] != system["name"]:
                continue
            lines.append(
                f"{row['scene']:12}{row['core_hz'] / row['clocks']:>9.1f}{share(row[SHARE]):>9}"
                f"{row['bytes read per ray']:>8.2f}{row['bytes written per ray']:>9.2f}"
                f"{row['MB per second read']:>7.0f}{row['MB per second written']:>9.0f}"
                f"{row['MB per second displayed']:>7.0f}{share(row['share of the peak']):>9}"
                f"{row['rows opened per burst']:>6.2f}{row['ns of a read']:>7.0f}"
                f"{share(row['waits for rows and turns']):>8}{share(row['waits for the core']):>7}"
                f"{row['reads under way']:>7.1f}  {row['busiest unit']} {share(row['use'])}, with "
                f"SRAM {share(row['use with SRAM'])}; {row['stalled unit']} stalled "
                f"{share(row['stalled'])}"
            )
    lines.append(f"\nclocks of {HELD_SIZE} pixels: of the board's Verilog, and here")
    for row in measured["verilog"]:
        lines.append(f"{row['scene']:12}{row['clocks of the Verilog']:>9}{row['clocks here']:>9}")
    lines.append(
        "\nwaits: of the SDRAM's clocks, in which bursts wait for rows and turns of the bus; idle: in "
        "which none has come; reads: under way in the mean."
    )
    return "\n".join(lines)
