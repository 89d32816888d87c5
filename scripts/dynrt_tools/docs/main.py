# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Builds the documentation as a site with search, build/docs/index.html. Reading it needs no network.

Pages of docs/reference and docs/results that say so are made from the sources and from kept data:
--check finds those that are not current, and links that lead nowhere; --renew writes the pages.
"""

import argparse

from dynrt_tools import project
from dynrt_tools.docs import links, made


def parse() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="scripts/docs",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    what = parser.add_mutually_exclusive_group()
    what.add_argument("--check", action="store_true", help="write nothing; fail if a page is old")
    what.add_argument("--renew", action="store_true", help="write the pages that are not current")
    return parser.parse_args()


def check() -> int:
    problems = made.stale(made.from_sources()) + links.broken(project.ROOT)
    for problem in problems:
        print(problem)
    return 1 if problems else 0


def main() -> int:
    args = parse()
    if args.renew:
        for path in made.renew(made.from_sources()):
            print(path.relative_to(project.ROOT))
        return 0
    return check()
