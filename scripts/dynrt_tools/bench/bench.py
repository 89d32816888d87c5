# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Measures dynrt and prints each figure with its aim."""


import argparse
import os
import pathlib
import subprocess
import sys

from dynrt_tools.bench import board, board_levers, levers, memory, report_rows, scenes
from dynrt_tools.bench.rows import CONFIG, Bench, Options, Row
from dynrt_tools.bench.run import Dynrt, RunFailed
from dynrt_tools.build import configs
from dynrt_tools.project import ROOT, show_progress, write_json, write_rows

FULL_SIZE, QUICK_SIZE = "512x384", "128x96"
# The flags that ask for another table.
TABLES = ("scenes", "levers", "memory", "board", "board-levers", "report")

HOW = """\
Sets up and builds first, as scripts/demo does. The RTL counts the clocks, which are the same in
every run. Speeds are medians of several runs in seconds of processor time, less those of an image
of 2x2 pixels: they contain neither the reading of the scene nor other work of the machine. The
time of the tree is the median by the clock on the wall. The top level is built again over 50,000
turned and scaled boxes that stand as close as the trees of a wood, in processor time on one core.
The table marks and explains a figure that falls short of its aim; that is no failure."""


def shared(command: str) -> subprocess.CompletedProcess[str]:
    """Runs a function of scripts/common.sh, which says what is wrong in this script's name."""
    script = f'source "{ROOT}/scripts/common.sh"; {command}'
    return subprocess.run(
        ["bash", "-euo", "pipefail", "-c", script, "bench"],
        text=True,
        stdout=subprocess.PIPE if command == "help_packages" else None,
        check=False,
    )


def parse(arguments: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="scripts/bench",
        description=f"{__doc__}\n\n{HOW}",
        epilog=shared("help_packages").stdout,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument(
        "--scene",
        default="office",
        metavar="SCENE",
        help="a built-in name or a file (default: office)",
    )
    parser.add_argument(
        "--config",
        metavar="NAME",
        help=f"configuration of the table, one of hls/configs/configs.json (default: {CONFIG})",
    )
    parser.add_argument(
        "--quick",
        action="store_true",
        help=f"{QUICK_SIZE} pixels instead of {FULL_SIZE} and one run of each",
    )
    parser.add_argument(
        "--runs", type=int, metavar="N", help="number of runs that a median is of (default: 5)"
    )
    parser.add_argument(
        "--json",
        type=pathlib.Path,
        metavar="FILE",
        help="also write the table, and every counter of the frames, as data",
    )
    parser.add_argument(
        "--scenes",
        action="store_true",
        help="instead of the table: the thesis's four kinds of scene, one frame "
        "each, with the thesis's frame rates",
    )
    parser.add_argument(
        "--levers",
        action="store_true",
        help="instead of the table: the four kinds of scene with one key after another of "
        "the configuration fast, from the native model's exact clocks, and the room that Yosys "
        "counts; an hour or so",
    )
    parser.add_argument(
        "--memory",
        action="store_true",
        help="instead of the table: the four kinds of scene behind a memory port, at several "
        "latencies and with one key of the configuration fast_port changed at a time, from the "
        "native model's exact clocks; half an hour or so",
    )
    parser.add_argument(
        "--board",
        metavar="BOARD",
        help="instead of the table: the four kinds of scene on a board whose memory is an SDRAM, "
        "from the native model's exact clocks and a model of the chip; some minutes; "
        f"BOARD is one of {', '.join(board.BOARDS)}",
    )
    parser.add_argument(
        "--board-levers",
        metavar="BOARD",
        help="instead of the table: the same with one key of the caches or the layout changed at a "
        f"time, in frames of {board_levers.SIZE} pixels; builds a core for each",
    )
    parser.add_argument(
        "--report",
        action="store_true",
        help="instead of the table: how long `dynrt report error` takes when "
        "nothing is built yet, half an hour or so",
    )
    parser.add_argument(
        "--program",
        type=pathlib.Path,
        metavar="FILE",
        help="measure this dynrt; nothing is set up or built",
    )
    args = parser.parse_args(arguments)
    if args.runs is not None and args.runs < 1:
        parser.error(f"--runs {args.runs}: at least one run is needed")
    if args.json and not args.json.absolute().parent.is_dir():
        parser.error(
            f"--json {args.json}: there is no folder '{args.json.parent}'; create it or "
            "name a file elsewhere"
        )
    tables = [f"--{name}" for name in TABLES if getattr(args, name.replace("-", "_"))]
    if len(tables) > 1:
        parser.error(f"{' and '.join(tables[:2])} are two tables; ask for one of them")
    if args.config and tables:
        parser.error(
            f"--config {args.config}: {tables[0]} has its own configurations; leave one out"
        )
    for flag, name in (("--board", args.board), ("--board-levers", args.board_levers)):
        if name and name not in board.BOARDS:
            parser.error(f"{flag} {name}: unknown; the boards are {', '.join(board.BOARDS)}")
    args.config = args.config or CONFIG
    listed = configs.load_configurations().listed()
    if args.config not in listed:
        parser.error(f"--config {args.config}: unknown; the configurations are {', '.join(listed)}")
    args.core = listed[args.config]
    return args


def table(rows: list[Row]) -> str:
    cells = [("", "asked", "reached", "", "note")]
    marks = {True: "ok", False: "short", None: ""}
    cells += [(r.name, r.asked_text(), r.reached_text(), marks[r.met], r.note) for r in rows]
    widths = [max(len(row[column]) for row in cells) for column in range(4)]
    lines = []
    for name, asked, reached, met, note in cells:
        lines.append(
            f"{name:<{widths[0]}}  {asked:>{widths[1]}}  {reached:>{widths[2]}}  "
            f"{met:<{widths[3]}}  {note}".rstrip()
        )
    return "\n".join(lines)


def print_rows(rows: list[Row]) -> None:
    print(table(rows))
    causes: dict[str, list[str]] = {}
    for row in rows:
        if row.met is False and row.cause:
            causes.setdefault(row.cause, []).append(row.name)
    for cause, names in causes.items():
        print(f"\nShort: {', '.join(names)}: {cause}.")


def own_table(args: argparse.Namespace, dynrt: Dynrt, scene: str, size: str) -> bool:
    """Prints the table that a flag asks for; False if none does."""
    if args.scenes:
        measured = scenes.measure(dynrt, size, FULL_SIZE, show_progress)
        show_progress("")
        if args.json:
            write_json(args.json, {"size": size, "scenes": [m.data() for m in measured]})
        print(f"{size} pixels\n")
        print(scenes.report(measured))
    elif args.levers:
        steps = levers.measure(dynrt, size, show_progress)
        show_progress("")
        if args.json:
            write_json(args.json, {"size": size, "levers": steps})
        print(f"{size} pixels, rays a clock, busiest unit\n\n{levers.table(steps)}")
    elif args.memory:
        frames = memory.measure(dynrt, size, show_progress)
        show_progress("")
        if args.json:
            write_rows(args.json, frames, "frames", "aims")
        print(f"{size} pixels, hits in the caches, use of the port\n\n{memory.table(frames)}")
    elif args.report:
        rows = report_rows.rows(dynrt, scene, size, FULL_SIZE, show_progress)
        show_progress("")
        if args.json:
            data = {"scene": args.scene, "size": size, "rows": [row.data() for row in rows]}
            write_json(args.json, data)
        print_rows(rows)
    else:
        return False
    return True


def board_table(args: argparse.Namespace, dynrt: Dynrt, size: str) -> bool:
    """The same of the flags that name a board."""
    if args.board:
        measured = board.measure(dynrt, args.board, size, show_progress)
        text, lists = board.table(measured), ["systems", "budget", "frames"]
    elif args.board_levers:
        size = QUICK_SIZE if args.quick else board_levers.SIZE
        measured = board_levers.measure(dynrt, args.board_levers, size, show_progress)
        text, lists = board_levers.table(measured), ["levers"]
    else:
        return False
    show_progress("")
    if args.json:
        write_rows(args.json, measured, *lists)
    print(f"{measured['board']}, {size} pixels\n\n{text}")
    return True


def main() -> int:
    args = parse(sys.argv[1:])
    if args.program is None and shared("prepare release").returncode != 0:
        return 1
    program = args.program or ROOT / "build" / "release" / "dynrt"
    if not os.access(program, os.X_OK):
        print(f"bench: {program} is no program; build it or leave out --program", file=sys.stderr)
        return 1
    dynrt = Dynrt(program)
    scene = str(pathlib.Path(args.scene).resolve()) if os.path.exists(args.scene) else args.scene
    size = QUICK_SIZE if args.quick else FULL_SIZE
    try:
        if own_table(args, dynrt, scene, size) or board_table(args, dynrt, size):
            return 0
        reports = dynrt.program.parent / "generated" / args.config
        host = dynrt.program.parent / "host"
        options = Options(
            scene,
            size,
            args.runs or (1 if args.quick else 5),
            args.config,
            args.core["packets"],
            reports,
            host / "tree" / "tree_benchmark",
            host / "analysis" / "truth" / "truth_benchmark",
        )
        bench = Bench(dynrt, options, show_progress)
        rows = bench.rows()
    except RunFailed as failure:
        show_progress("")
        print(f"bench: {failure}", file=sys.stderr)
        return 1
    show_progress("")
    machine = {"cores": os.cpu_count(), "load": os.getloadavg()[0]}
    if args.json:
        data = {
            "scene": args.scene,
            "size": size,
            "configuration": args.config,
            "machine": machine,
            "rows": [row.data() for row in rows],
            "frames": bench.frames,
        }
        write_json(args.json, data)
    print(
        f"scene {args.scene}, {size} pixels, configuration {args.config}; "
        f"{machine['cores']} cores, load {machine['load']:.1f}\n"
    )
    print_rows(rows)
    if bench.missing:
        print(f"\nNothing of the RTL was measured: {bench.missing}")
    return 0
