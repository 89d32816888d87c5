# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Lints all Verilog: the files written by hand in rtl/ and those that hlsc made of a configuration and
of the parts of boards, which needs a full build (scripts/test --build-only).

1. Every waiver in rtl/lint/*.vlt names a rule and a file that exists, and the comment above it
   gives the reason.
2. `verilator --lint-only -Wall` on every file, its module as the top.
3. Yosys reads all files together: hierarchy -check, proc, check -assert.

The cells of a vendor are known to Verilator from the models of verif/vendor, to Yosys from its own
list.
"""

import argparse
import fnmatch
import os
import pathlib
import re
import subprocess
import sys

from dynrt_tools import project
from dynrt_tools.command import Pool
from dynrt_tools.hardware import rtl_files
from dynrt_tools.hardware.verilator import remarks

VENDOR_CELLS = ("+/ecp5/cells_sim.v", "+/ecp5/cells_bb.v")
WAIVER = re.compile(r'lint_off\s+-rule\s+(\w+)\s+-file\s+"([^"]+)"(\s+-match\s+"[^"]*")?\s*$')


def check_waivers(root: pathlib.Path, sources: list[pathlib.Path]) -> list[str]:
    problems = []
    for path in sorted((root / "rtl" / "lint").glob("*.vlt")):
        explained = False
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            where = f"{path.relative_to(root)}:{number}"
            text = line.strip()
            if text.startswith("//"):
                explained = True
                continue
            if text.startswith("lint_off"):
                waiver = WAIVER.match(text)
                if not waiver:
                    problems.append(
                        f'{where}: a waiver is written lint_off -rule RULE -file "FILE" '
                        '[-match "TEXT"], never by line number'
                    )
                elif not any(fnmatch.fnmatch(str(s), waiver.group(2)) for s in sources):
                    problems.append(
                        f"{where}: no Verilog file matches {waiver.group(2)}; remove the waiver"
                    )
                if not explained:
                    problems.append(
                        f"{where}: the waiver has no reason; write it as a comment above"
                    )
            elif not text:
                explained = False
    return problems


def run(command: list[str]) -> tuple[int, str]:
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    return result.returncode, (result.stdout + result.stderr).strip()


def verilator(
    root: pathlib.Path, path: pathlib.Path, sources: list[pathlib.Path]
) -> tuple[int, str]:
    command = ["verilator", "--lint-only", "--timing", "-Wall", "+define+HLS_ASSERT"]
    command += ["--top-module", path.stem]
    vendor = root / "verif" / "vendor"
    for waivers in (root / "rtl" / "lint", vendor):
        command += [str(v) for v in sorted(waivers.glob("*.vlt"))]
    for folder in [*rtl_files.include_folders(sources), vendor]:
        command += ["-y", str(folder)]
    code, output = run([*command, str(path)])
    return code, remarks(output)


def yosys(sources: list[pathlib.Path]) -> tuple[int, str]:
    script = [f"verilog_defaults -add -I{f}" for f in rtl_files.include_folders(sources)]
    script += [f"read_verilog -lib {c}" for c in VENDOR_CELLS]
    script += [f"read_verilog {f}" for f in sources]
    return run(["yosys", "-q", "-p", "; ".join([*script, "hierarchy -check; proc; check -assert"])])


def main() -> int:
    parser = argparse.ArgumentParser(
        prog="scripts/lint",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    rtl_files.add_arguments(parser)
    args = parser.parse_args()
    root = project.ROOT
    if not rtl_files.all_hand_written():
        project.fail(f"{root / 'rtl'} holds no Verilog; is this the project's folder?")
    try:
        core = rtl_files.generated(args.config, args.build)
        boards = (root / "rtl" / "link").is_dir()
        made = rtl_files.made_by(args.build, rtl_files.FOR_BOARDS) if boards else None
    except project.Failed as error:
        project.fail(error)
    sources = rtl_files.sources(core, made)

    problems = check_waivers(root, rtl_files.all_hand_written() + core)
    with Pool(os.cpu_count()) as pool:
        jobs = {
            f"verilator: {os.path.relpath(f, root)}": pool.submit(verilator, root, f, sources)
            for f in sources
        }
        jobs["yosys"] = pool.submit(yosys, sources)
        for name, job in jobs.items():
            code, output = job.result()
            # Yosys warns with exit code 0; a clean design prints nothing at all with -q.
            if code != 0 or output:
                problems.append(f"{name}\n{output}")
    for problem in problems:
        print(problem, file=sys.stderr)
    if problems:
        return 1
    print(f"{len(sources)} Verilog files are clean")
    return 0
