# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Bits of the float, and how it divides, by the error that the user allows: what `dynrt choose` finds
among the formats."""

import argparse
import pathlib

from variants import Refused
import choose
import report

FORMATS = pathlib.Path(__file__).resolve().parent / "formats.json"
KEYS = ("exponent_bits", "mantissa_bits", "rounding", "divider")


def chosen(args, general, scene):
    """What the cheapest format that keeps the bound says of KEYS."""
    out = args.out or pathlib.Path("specialised")
    asked = argparse.Namespace(
        program=pathlib.Path(args.program), build=pathlib.Path(args.build), expect=args.expect,
        size=args.size or "512x384", config=general, variants=FORMATS, variant=[], jobs=args.jobs,
        slurm=False, out=out.with_name(out.name + ".formats"))
    found, _ = report.measured(asked, [scene])
    _, holding = choose.choose(found, args.measure, args.max_error)
    if not holding:
        raise Refused(f"--max-error {args.max_error:g}: no format of {FORMATS.name} keeps "
                      f"{args.measure} below that on this scene; allow more")
    best = found["variants"][holding[0]["variant"]]["configuration"]
    return {key: best[key] for key in KEYS}
