# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Makes the bitstream of a board: Yosys synthesizes its top, nextpnr-ecp5 places and routes it on the
board's pins, ecppack packs it. Says what clock it may run at and what it runs at, and how full the
chip is. That takes some twenty minutes. hlsc makes the Verilog of its core, which needs a full build
(scripts/test --build-only). nextpnr-ecp5 and ecppack come with the OSS CAD Suite, not with Debian 12.

Where a tool is not on the PATH, says which, and checks what can be checked without it: that each pin
of the top has a site and no other has, and with Yosys that it is synthesized and the chip has room.
"""

import argparse
import pathlib
import re
import shutil
import sys
import tempfile
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass

from dynrt_tools import options, project
from dynrt_tools.hardware import (
    block_registers,
    board_clocks,
    devices,
    distributed_ram,
    placer_log,
    placers,
    rtl_files,
    synthesis,
)
from dynrt_tools.project import Json, read_json, write_json


@dataclass(frozen=True)
class Board:
    """A board that has a top."""

    top: str
    config: str  # of its core
    device: str
    grade: str
    constraints: str
    modes: Mapping[str, int]  # of the display, the usual one first: PIXEL_MHZ of the top
    clocks: Callable[[int], Mapping[str, float]]  # in MHz, by the net: all that registers have
    pins_ns: Mapping[str, float]  # by such a clock: how late a pin that it drives may be


def ulx3s_clocks(pixel_mhz: int) -> Mapping[str, float]:
    made = board_clocks.ulx3s(pixel_mhz)
    return {net: made[net] for net in (board_clocks.CORE, board_clocks.SDRAM, board_clocks.DVI)}


BOARDS = {
    "ulx3s": Board(
        "dynrt_ulx3s",
        "fast_ulx3s",
        "ecp5-85",
        "6",
        "ulx3s.lpf",
        board_clocks.modes(),
        ulx3s_clocks,
        # docs/how-to/ulx3s.md: what the SDRAM's pins have beside 3 ns of the pad itself.
        {board_clocks.SDRAM: 5.5},
    )
}


@dataclass(frozen=True)
class Routed:
    """What the placer says of the board."""

    clocks: dict[str, dict[str, float]]  # by net: the MHz achieved and asked for
    pins_ns: dict[str, float]  # by the clock's net: from its edge to the last pin
    crossings_ns: dict[str, float]  # by the nets of two clocks, "A to B": the longest wire between


PACKER = "ecppack"
# nextpnr gives up on a cell after as many attempts as the square of the number of cells has, which
# overflows for so many cells.
PATIENT = ("--placer-heap-cell-placement-timeout", "0")
ROUTER = ("--router", "router2")
# What a wire costs that several nets want: more with each of them, and more in each round. nextpnr
# takes it from the netlist alone. With its own growth of 2.0 a round, nets take detours so long that
# from the 18th or 26th round on ever more wires are wanted by several.
ROUTER_COSTS = {
    "router2/initCurrCongWeight": "1.0",
    "router2/currCongWeightMult": "0.5",
    "router2/histCongWeight": "1.0",
}
GLOBAL = "$glbnet$"  # before a net's name where it goes over the chip's net for clocks
SUITE = "the OSS CAD Suite has yosys and all others"
PORT = re.compile(r"^ +(?:input|output|inout) +(?:wire|reg) +(?:\[(\d+):0\] *)?(\w+)", re.MULTILINE)
CROSSING = re.compile(r"Max delay posedge (\S+)\s+-> posedge (\S+)\s*: ([\d.]+) ns")
TO_PIN = re.compile(r"Max delay posedge (\S+)\s+-> <async>\s*: ([\d.]+) ns")
SAME_MHZ = 0.01  # a report rounds the period to a picosecond
LOCATED = re.compile(r'^LOCATE COMP "([^"]+)" SITE', re.MULTILINE)
BOUNDED = re.compile(r'^IOBUF PORT "([^"]+)"', re.MULTILINE)


def parse() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="scripts/bitstream",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        epilog="The exit code is 1 if there is no bitstream, as a tool is missing or failed, or if a "
        "clock is missed; that leaves the file and says by how much.",
    )
    parser.add_argument("board", choices=sorted(BOARDS), help="the board")
    parser.add_argument(
        "--mode",
        metavar="MODE",
        help=f"of the display: {' or '.join(board_clocks.modes())} (default: the first)",
    )
    parser.add_argument(
        "--out",
        type=pathlib.Path,
        metavar="FILE",
        help="the bitstream (default: dynrt_BOARD.bit, or dynrt_BOARD_MODE.bit)",
    )
    parser.add_argument(
        "--seed", type=options.whole, default=1, metavar="N", help="of the placer (default: 1)"
    )
    parser.add_argument(
        "--timeout",
        type=options.positive,
        default=120,
        metavar="MINUTES",
        help="the time that the placer may take (default: 120)",
    )
    rtl_files.add_build(parser)
    parser.add_argument("--json", type=pathlib.Path, metavar="FILE", help="also write the figures")
    return parser.parse_args()


def top_of(board: Board) -> pathlib.Path:
    return next((project.ROOT / "rtl").rglob(f"{board.top}.v"))


def pins_of(top: pathlib.Path) -> list[str]:
    """The pins of a top's ports."""
    found = []
    for high, name in PORT.findall(top.read_text(encoding="utf-8")):
        found += [f"{name}[{i}]" for i in range(int(high) + 1)] if high else [name]
    return found


def pin_problems(board: Board) -> list[str]:
    """Sentences on what the constraints and the ports of the top do not agree in."""
    file = placers.CONSTRAINTS / board.constraints
    text = file.read_text(encoding="utf-8")
    pins, located, bounded = pins_of(top_of(board)), LOCATED.findall(text), BOUNDED.findall(text)
    where = file.relative_to(project.ROOT)
    said = [f"{where} has no site for pin {p} of {board.top}" for p in pins if p not in located]
    said += [f"{where} has no IOBUF for pin {p} of {board.top}" for p in pins if p not in bounded]
    said += [
        f"{where} has a site for {p}, which is no pin of {board.top}"
        for p in located
        if p not in pins
    ]
    sites = re.findall(r'SITE "(\w+)"', text)
    said += [
        f"{where} gives site {s} to two pins"
        for s in sorted({s for s in sites if sites.count(s) > 1})
    ]
    return said


def synthesize(board: Board, args: argparse.Namespace) -> tuple[pathlib.Path, Json]:
    """The netlist, and what it takes of the device."""
    family = devices.family_of(board.device)
    synth = devices.FAMILIES[family]["synth"]
    files = verilog_of(board, args.build)

    def make(folder: pathlib.Path) -> None:
        synthesis.run_yosys(
            [
                *synthesis.read_commands(files),
                f"chparam -set PIXEL_MHZ {board.modes[args.mode]} {board.top}",
                synth.format(top=board.top),
                f"write_json {folder}/netlist.json",
                f"tee -q -o {folder}/stat.json stat -json",
            ],
            folder,
            board.top,
        )
        block_registers.pack(folder / "netlist.json")
        design = read_json(folder / "netlist.json")
        distributed_ram.spare(design)
        design["modules"][board.top]["settings"] = ROUTER_COSTS
        write_json(folder / "netlist.json", design)

    said = [synthesis.tool_version("yosys", "-V", "yosys"), synth, board.top]
    said += [block_registers.version(), distributed_ram.version(), str(ROUTER_COSTS), args.mode]
    folder = synthesis.kept("bitstream", said, files, make)
    cells = read_json(folder / "stat.json")["design"]["num_cells_by_type"]
    return folder / "netlist.json", devices.resources(family, cells)


def print_room(board: Board, taken: Json) -> list[str]:
    """Says how full the chip gets; gives sentences on what it has too little of."""
    device = devices.DEVICES[board.device]
    for resource, amount in taken.items():
        has = device["has"][resource]
        print(f"{resource:12}{amount:8,.0f} of {has:,}, {amount / has:.0%}")
    return [
        f"{device['name']} has not the room: {said}"
        for said in devices.shortages(board.device, taken)
    ]


def route(
    board: Board, args: argparse.Namespace, netlist: pathlib.Path, work: pathlib.Path
) -> Routed:
    """Places and routes."""
    program = placers.PLACERS[board.device]["program"]
    command = [
        program,
        *placers.PLACERS[board.device]["flags"],
        *PATIENT,
        *ROUTER,
        *("--speed", board.grade),
        *("--json", str(netlist), "--lpf", str(placers.CONSTRAINTS / board.constraints)),
        *("--seed", str(args.seed), "--timing-allow-fail"),
        *("--textcfg", str(work / "config"), "--report", str(work / "report.json")),
        *("-q", "-l", str(work / "log")),
    ]
    with placer_log.followed(work / "log", project.show_progress):
        placers.run(command, program, args.timeout * 60)
    with placers.reading(program):
        clocks = {
            net.removeprefix(GLOBAL): {
                name: float(clock[name]) for name in ("achieved", "constraint")
            }
            for net, clock in read_json(work / "report.json")["fmax"].items()
        }
        log = (work / "log").read_text(encoding="utf-8", errors="replace").replace(GLOBAL, "")
        # A log has them before and after the routing; the last counts.
        pins = {net: float(delay) for net, delay in TO_PIN.findall(log)}
        crossings = {f"{a} to {b}": float(delay) for a, b, delay in CROSSING.findall(log)}
        if len(clocks) > 1 and not crossings:
            raise KeyError("Max delay posedge")
    return Routed(clocks, {net: pins.get(net, 0.0) for net in board.pins_ns}, crossings)


def check_clocks(board: Board, mode: str, routed: Routed, program: str) -> None:
    """The clocks that the placer was asked for are those that the board makes."""
    for net, mhz in board.clocks(board.modes[mode]).items():
        asked = routed.clocks.get(net, {}).get("constraint", 0.0)
        if abs(asked - mhz) > SAME_MHZ:
            raise project.Failed(
                f"{program} was asked for {asked:.2f} MHz of clock {net}, which the PLL makes "
                f"{mhz:.2f} MHz: this version of it follows the clock through the PLL otherwise"
            )


def print_clocks(board: Board, routed: Routed) -> list[str]:
    """Says what clocks and pins reach; gives sentences on those that are missed."""
    missed = []
    for net, clock in routed.clocks.items():
        reached, asked = clock["achieved"], clock["constraint"]
        print(f"clock       {net} reaches {reached:.1f} MHz and runs at {asked:.1f}")
        if reached < asked:
            missed.append(
                f"clock {net} runs at {asked:.1f} MHz, and its paths end at {reached:.1f}"
            )
    missed += print_crossings(routed)
    for net, late in routed.pins_ns.items():
        most = board.pins_ns[net]
        where = f"to the last pin {late:.1f} ns of {most:.1f}" if late else "in the pins' cells"
        print(f"pins        {net} {where}")
        if late > most:
            missed.append(f"a pin is {late:.1f} ns behind clock {net}, and {most:.1f} is the most")
    return missed


def print_crossings(routed: Routed) -> list[str]:
    """A count in Gray code that another clock sees changes by one bit if its wires differ by less
    than a period of its own clock (rtl/lib/hls_clock_fifo.v). A placer leaves them as long as it
    likes."""
    missed = []
    for crossing, late in routed.crossings_ns.items():
        period = 1e3 / routed.clocks[crossing.split(" to ")[0]]["constraint"]
        print(f"crossing    {crossing} {late:.1f} ns of {period:.1f}")
        if late > period:
            missed.append(f"{crossing} takes {late:.1f} ns, and a period is {period:.1f}")
    return missed


def verilog_of(board: Board, build: pathlib.Path | None) -> list[pathlib.Path]:
    """What its bitstream is made of."""
    made = rtl_files.made_by(build, rtl_files.FOR_BOARDS)
    core = rtl_files.units_in(made / board.config)
    return synthesis.needed(board.top, rtl_files.sources(core, made))


def make_bitstream(board: Board, args: argparse.Namespace, out: pathlib.Path) -> list[str]:
    """All steps for which there are tools; gives sentences on what is wrong."""
    problems = pin_problems(board)
    if problems:
        return problems
    placer = placers.PLACERS[board.device]["program"]
    missing = [tool for tool in (placer, PACKER) if not shutil.which(tool)]
    lacks = f"{project.enumerated(missing)} {'is' if len(missing) == 1 else 'are'} not on the PATH"
    if missing:
        print(f"tools       {lacks}: pins, synthesis and room alone are checked", flush=True)
    print(f"pins        all {len(pins_of(top_of(board)))} have their sites")
    netlist, taken = synthesize(board, args)
    lacking = print_room(board, taken)
    if lacking:
        return lacking
    if missing:
        return [f"{lacks}, so there is no bitstream; {SUITE}"]
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        routed = route(board, args, netlist, work)
        check_clocks(board, args.mode, routed, placer)
        missed = print_clocks(board, routed)
        packed = work / "bitstream"
        pack = [PACKER, "--compress", "--input", str(work / "config"), "--bit", str(packed)]
        placers.run(pack, PACKER, args.timeout * 60)
        if not packed.exists():
            raise project.Failed(f"{PACKER} wrote no bitstream")
        shutil.copyfile(packed, out)
    print(f"bitstream   {out}")
    if args.json:
        figures = {
            "board": args.board,
            "mode": args.mode,
            "date": project.today(),
            "tools": {
                "yosys": synthesis.tool_version("yosys", "-V", "yosys").split(" (")[0],
                "placer": synthesis.tool_version(placer, "--version", placer),
            },
            "resources": taken,
            "seed": args.seed,
        }
        write_json(args.json, figures | asdict(routed))
    return missed


def main() -> int:
    args = parse()
    board = BOARDS[args.board]
    usual = next(iter(board.modes))
    args.mode = args.mode or usual
    if args.mode not in board.modes:
        project.fail(
            f"--mode {args.mode}: {args.board} has no such mode; it has {' and '.join(board.modes)}"
        )
    name = args.board if args.mode == usual else f"{args.board}_{args.mode}"
    out = args.out or pathlib.Path(f"dynrt_{name}.bit")
    project.check_output("--out", out)
    if args.json:
        project.check_output("--json", args.json)
    try:
        problems = make_bitstream(board, args, out)
    except project.Failed as error:
        project.fail(error)
    for problem in problems:
        print(f"bitstream: {problem}", file=sys.stderr)
    return 1 if problems else 0
