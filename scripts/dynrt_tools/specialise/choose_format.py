# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The bits of the float and the datapath, by the error that the user allows: what `dynrt choose`
finds among the formats."""

import argparse
import contextlib
import pathlib

from dynrt_tools.project import Failed
from dynrt_tools.experiments import choose, command
from dynrt_tools.specialise.decisions import Measured

FORMATS = pathlib.Path(__file__).resolve().parent / "formats.json"
SIZE = "512x384"  # of a frame, unless --size says another
KEYS = ("exponent_bits", "mantissa_bits", "rounding", "datapath")


def check(args: argparse.Namespace) -> None:
    """Refuses, before the work, a bound that is none."""
    if args.max_error is None:
        if args.measure:
            raise Failed(
                f"--measure {args.measure}: there is no bound; --max-error says how large "
                "this error may be"
            )
        return
    args.measure = args.measure or choose.DEFAULT_MEASURE
    choose.check_bound(args)
    if args.max_error <= 0:
        raise Failed(f"--max-error {args.max_error:g}: must be above 0")


def chosen(args: argparse.Namespace, general: str, scene: str, out: pathlib.Path) -> Measured:
    """The decisions for KEYS: what the cheapest format that keeps the bound says of them. What is
    measured is kept beside the folder `out`."""
    out = out.with_name(out.name + ".formats")
    asked = argparse.Namespace(
        program=pathlib.Path(args.program),
        build=pathlib.Path(args.build),
        expect=args.expect,
        size=args.size or SIZE,
        config=general,
        variants=FORMATS,
        variant=[],
        jobs=args.jobs,
        slurm=False,
        out=out,
    )
    found = command.measured(asked, [scene])
    with contextlib.suppress(OSError):
        out.rmdir()  # of a report, which is not written; OUT.formats.work is kept
    _, holding = choose.choose(found, args.measure, args.max_error)
    if not holding:
        raise Failed(
            f"--max-error {args.max_error:g}: no format of {FORMATS.name} keeps "
            f"{args.measure} below that on this scene; allow more"
        )
    best = found["variants"][holding[0]["variant"]]["configuration"]
    reason = (
        f"of {FORMATS.name} the cheapest that keeps {args.measure} within {args.max_error:g} "
        f"in a frame of {asked.size}"
    )
    return {key: (best[key], reason) for key in KEYS}
