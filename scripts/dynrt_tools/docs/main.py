# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Builds the documentation as a site with search, build/docs/site. Reading it needs no network.

Some pages of docs/reference and docs/results are made from the sources and from saved data, as their
first line says: --check finds pages that are out of date and broken links; --renew writes the pages.
"""

import argparse
import functools
import http.server
import pathlib

from dynrt_tools import project
from dynrt_tools.docs import links, made, record, site, times

PORT = 8000


def parse() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="scripts/docs",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    what = parser.add_mutually_exclusive_group()
    what.add_argument("--check", action="store_true", help="write nothing; fail if a page is old")
    what.add_argument("--renew", action="store_true", help="write the pages that are not current")
    what.add_argument(
        "--serve", action="store_true", help="build, then serve http://localhost:8000"
    )
    what.add_argument(
        "--draw",
        action="store_true",
        help="draw the pictures of the pages of results from their data; Chromium does",
    )
    what.add_argument(
        "--record",
        metavar="PAGE",
        help="measure the data of a page of docs/results again with the commands of its last table, "
        "draw its pictures and renew the pages; takes minutes to hours; PAGE is one of "
        f"{', '.join(record.pages())}",
    )
    parser.add_argument(
        "--build",
        type=pathlib.Path,
        metavar="FOLDER",
        help="check or renew the page of the programs too, with those of this build",
    )
    what.add_argument(
        "--times",
        nargs=2,
        metavar=("RUN", "LOG"),
        help="save the times that scripts/demo (RUN demo) or scripts/test (RUN fast or all) printed "
        "as the data of the page of build times, and renew the pages",
    )
    return parser.parse_args()


def made_pages(build: pathlib.Path | None) -> dict[str, str]:
    """What the pages that are made should say."""
    return made.from_sources() | (made.from_build(build) if build else {})


def check(build: pathlib.Path | None) -> int:
    """Prints what is wrong with the pages."""
    problems = made.stale(made_pages(build)) + made.stale_waves() + links.broken(project.ROOT)
    for problem in problems:
        print(problem)
    return 1 if problems else 0


def serve(folder: pathlib.Path) -> None:
    """Serves the site to this machine until it is interrupted."""
    handler = functools.partial(http.server.SimpleHTTPRequestHandler, directory=str(folder))
    with http.server.ThreadingHTTPServer(("localhost", PORT), handler) as server:
        print(f"http://localhost:{PORT}, until Ctrl-C", flush=True)
        try:
            server.serve_forever()
        except KeyboardInterrupt:
            print()


def main() -> int:
    args = parse()
    try:
        if args.check:
            return check(args.build)
        if args.times:
            times.keep(args.times[0], pathlib.Path(args.times[1]))
        if args.draw:
            record.draw()
            return 0
        if args.record:
            record.record(args.record)
        if args.renew or args.times or args.record:
            for path in made.renew(made_pages(args.build)) + made.renew_waves():
                print(path.relative_to(project.ROOT))
            return 0
        home = site.build()
    except project.Failed as error:
        project.fail(error)
    if args.serve:
        serve(home.parent)
    else:
        print(home.relative_to(project.ROOT))
    return 0
