#!/usr/bin/env python3
# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Records a frame of the native model and renders it again in Icarus Verilog, from the core's
Verilog; every word that the core writes must be the model's. Icarus must read it without a word."""

import argparse
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
HERE = pathlib.Path(__file__).resolve().parent


def run(command, silent=False):
    result = subprocess.run([str(c) for c in command], capture_output=True, text=True, check=False)
    output = (result.stdout + result.stderr).strip()
    if result.returncode != 0 or (silent and output):
        sys.exit(f"replay: {pathlib.Path(command[0]).name} failed or complained:\n{output}")
    return output


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--record", required=True, metavar="PROGRAM", help="record_frame")
    parser.add_argument("--scene", required=True)
    parser.add_argument("--size", required=True, metavar="WxH")
    parser.add_argument("--config", default="thesis")
    parser.add_argument("--verilog", type=pathlib.Path, metavar="FOLDER",
                        default=ROOT / "rtl/generated/thesis", help="of the configuration")
    parser.add_argument("--work", type=pathlib.Path, required=True, metavar="FOLDER")
    args = parser.parse_args()

    args.work.mkdir(parents=True, exist_ok=True)
    run([args.record, args.scene, args.config, args.size, args.work])
    sources = sorted((ROOT / "rtl/lib").glob("*.v")) + sorted(args.verilog.glob("*.v"))
    program = args.work / "core_bench.vvp"
    run(["iverilog", "-g2005", "-Wall", "-o", program, "-s", "core_bench", f"-I{args.work}",
         f"-I{args.verilog}", *sources, HERE / "core_bench.v"], silent=True)
    output = run(["vvp", program, f"+folder={args.work}"])
    print(output)
    if output.splitlines()[-1] != "the same":
        sys.exit("replay: the core rendered something else")


if __name__ == "__main__":
    main()
