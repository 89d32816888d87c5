# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Compares verif/stress/golden.json and docs/results/stress.md with the output of `dynrt stress`,
or renews them.

The digests of every case's hits and pixels go to golden.json. The tables of stress.md, between its
marks, come from the cases themselves: the trial, the number of rays, the errors counted, how many of
them are allowed and why.

Usage: python3 -m dynrt_tools.docs.stress [--check] DYNRT CONFIGURATION...
"""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

from dynrt_tools import project
from dynrt_tools.command import guarded

GOLDEN = project.ROOT / "verif" / "stress" / "golden.json"
PAGE = project.ROOT / "docs" / "results" / "stress.md"
BEGIN, END = "<!-- cases: written by the target update-stress -->\n", "<!-- end of cases -->\n"


def cases(program: pathlib.Path, config: str) -> tuple[dict[str, str], str]:
    """The digest of each case by its name, and the cases as tables. Exit code 1 means that a case
    exceeds its bound, which the tests of verif/stress report."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "stress.json"
        done = subprocess.run(
            [program, "stress", "--config", config, "--markdown", "--json", path],
            text=True,
            stdout=subprocess.PIPE,
            check=False,
        )
        if done.returncode not in (0, 1):
            sys.exit(done.returncode)
        digests = {case["name"]: case["digest"] for case in project.read_json(path)["cases"]}
    return digests, done.stdout


def with_tables(text: str, tables: str) -> str:
    """The page's text with these tables between its marks."""
    head, begin, rest = text.partition(BEGIN)
    _, end, tail = rest.partition(END)
    if not begin or not end:
        raise project.Failed(
            f"{PAGE}: the marks are missing between which the tables stand: a line "
            f"'{BEGIN.strip()}' and a line '{END.strip()}'"
        )
    return head + begin + tables + "\n" + end + tail


def check(wanted: dict[pathlib.Path, str]) -> None:
    for path, text in wanted.items():
        if path.read_text(encoding="utf-8") != text:
            raise project.Failed(
                f"{path}: differs from the output of dynrt stress; build the target update-stress"
            )


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--check", action="store_true", help="write nothing; fail if a file is old")
    parser.add_argument("program", type=pathlib.Path, help="the program dynrt")
    parser.add_argument("configurations", nargs="+", help="the cores that the cases run on")
    args = parser.parse_args()
    golden, tables = {}, ""
    for config in args.configurations:
        golden[config], table = cases(args.program, config)
        tables += f"\n## On `{config}`\n" + table
    try:
        wanted = {
            GOLDEN: json.dumps(golden, indent=2) + "\n",
            PAGE: with_tables(PAGE.read_text(encoding="utf-8"), tables),
        }
        if args.check:
            check(wanted)
    except project.Failed as error:
        project.fail(error)
    if not args.check:
        for path, text in wanted.items():
            path.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    guarded(main)
