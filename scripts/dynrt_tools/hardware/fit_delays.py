# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Holds hlsc's delay models against records of placements, and fits their constants to them.

A record is a file that `scripts/place --record` wrote. hlsc schedules its Verilog again, by the delay
model of that time, and predicts when the signals arrive that limited the clock. A least-squares fit of
the relative errors then finds the constants. No placer is needed.
"""

import argparse
import json
import pathlib
import sys
from collections import Counter
from collections.abc import Sequence

from dynrt_tools import options, project
from dynrt_tools.hardware import devices, fit_case, fitting, model_file, place_record, rtl_files
from dynrt_tools.project import Json

SAME = 0.002  # of a figure that --check makes again


def parse() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="scripts/fit-delays",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        epilog="""\
The model follows from device and grade of the placements: ecp5.json for ECP5 grade 6, ecp5-8.json
for grade 8, ice40-hx.json for iCE40 HX, in hls/compiler/delay. A grade without a file starts from
that of its family, and --write makes the file. An end that hlsc does not predict is counted with the
reason. The exit code is 1 if a file or hlsc fails.""",
    )
    parser.add_argument(
        "records",
        nargs="*",
        type=pathlib.Path,
        metavar="FILE",
        help="records of placements (default: all in docs/results/data)",
    )
    parser.add_argument(
        "--write",
        action="store_true",
        help="write the constants found into the models; then --record",
    )
    parser.add_argument(
        "--record",
        action="store_true",
        help="write how well each model fits to docs/results/data/fit_MODEL.json",
    )
    parser.add_argument(
        "--check",
        action="store_true",
        help="fail if a model fits otherwise than docs/results/data/fit_MODEL.json says",
    )
    parser.add_argument(
        "--worst",
        type=options.whole,
        default=12,
        metavar="N",
        help="the worst misses to print (default: 12)",
    )
    parser.add_argument(
        "--build",
        type=pathlib.Path,
        metavar="FOLDER",
        help="the build whose hlsc predicts (default: build/release, else build/dev)",
    )
    options.add_jobs(parser, "units to lower")
    return parser.parse_args()


class Fit:
    """Of one model to its placements."""

    def __init__(self, model: pathlib.Path, cases: Sequence[fit_case.Case]) -> None:
        self.path, self.cases = model, cases
        self.bounds = fitting.TIMES[devices.family_of(cases[0].record["device"])]
        self.start = model_file.read(model)
        self._known: dict[str, list[fit_case.Result]] = {}

    def results(self, model: fitting.Model) -> list[fit_case.Result]:
        """Every case by a model."""
        key = json.dumps(model, sort_keys=True)
        if key not in self._known:
            project.show_progress(f"{self.path.name}, model {len(self._known) + 1} of about 6")
            names = list(self.bounds)
            self._known[key] = [case.evaluate(model, names) for case in self.cases]
            project.show_progress("")
        return self._known[key]

    def fitted(self) -> fitting.Model:
        """The constants that fit best."""

        def samples(model: fitting.Model) -> list[fitting.Sample]:
            return [sample for result in self.results(model) for _, sample in result.ends]

        return fitting.fit(samples, self.start, self.bounds)

    def data(self, model: fitting.Model, fitted: fitting.Model) -> Json:
        """How well a model fits, beside the one that the fit found."""
        results, after = self.results(model), self.results(fitted)
        ends = [end for result in results for end in result.ends]
        return {
            "model": model_file.base_of(self.path).relative_to(project.ROOT).as_posix(),
            "constants": {n: {"value": model[n], "fitted": fitted[n]} for n in self.bounds},
            "within": fit_case.Result(ends).within(),
            "within by the fit": fit_case.Result([e for r in after for e in r.ends]).within(),
            "limiting": sum(len(case.ends) for case in self.cases),
            "predicted": len(ends),
            "placements": {
                case.name: {
                    "seeds": len(case.about["mhz"]),
                    "date": case.record["date"],
                    "limiting": len(case.ends),
                    "predicted": len(result.ends),
                    "within": result.within(),
                    "placed, ns": round(case.period, 3),
                    "promised, ns": round(result.promised, 3),
                }
                for case, result in zip(self.cases, results)
            },
            "not predicted": dict(sum((r.unpredicted for r in results), Counter()).most_common()),
        }

    def warn(self) -> None:
        """Names the placements of other signals by now."""
        for case in self.cases:
            if not case.current:
                print(
                    f"fit-delays: the Verilog of {case.name} has changed since it was placed on "
                    f"{project.day(case.record['date'])}; place it again",
                    file=sys.stderr,
                )

    def print(self, data: Json, worst: int) -> None:
        """The constants, the placements, the worst misses, and what is not predicted."""
        print(f"{data['model']}\n{'constant':<16}{'before':>8}{'after':>8}")
        for name, constant in data["constants"].items():
            at_bound = "  at its bound" if constant["fitted"] in self.bounds[name] else ""
            print(f"{name:<16}{constant['value']:>8g}{constant['fitted']:>8g}{at_bound}")
        form = "{:<34}{:>10}{:>10}{:>12}{:>12}{:>12}"
        head = ("limiting", "predicted", "within 10 %", "placed, ns", "hlsc, ns")
        print("\n" + form.format("placement", *head))
        for name, p in data["placements"].items():
            within = "-" if p["within"] is None else f"{p['within']:.0%}"
            times = f"{p['placed, ns']:.2f}", f"{p['promised, ns']:.2f}"
            print(form.format(name, p["limiting"], p["predicted"], within, *times))
        print("\nThe worst misses, by the constants before:")
        ends = [end for result in self.results(self.start) for end in result.ends]
        for end, sample in sorted(ends, key=lambda e: -abs(e[1].predicted / e[1].placed - 1))[
            :worst
        ]:
            made_of = " + ".join(f"{n:g} {name}" for name, n in sample.counts.items())
            port = f", {end['port']}" if end["port"] else ""
            source = f" ({end['source']})" if end["source"] else ""
            print(
                f"  {sample.placed:6.2f} ns placed, {sample.predicted:6.2f} predicted: "
                f"{end['unit']}: {end['signal']}{port}{source} = {made_of}"
            )
        print(f"\nNot predicted are {data['limiting'] - data['predicted']} limiting ends:")
        for why, count in data["not predicted"].items():
            print(f"  {count:4} at {why}", flush=True)


def cases_of(args: argparse.Namespace) -> dict[pathlib.Path, list[fit_case.Case]]:
    """The placed rows by the model that they are to fit."""
    build = rtl_files.find_build(args.build)
    groups: dict[pathlib.Path, list[fit_case.Case]] = {}
    for path in args.records or sorted(place_record.DATA.glob("place_*.json")):
        record = place_record.read(path)
        for row in place_record.for_a_fit(record):
            model = model_file.path_of(record["device"], record["grade"])
            groups.setdefault(model, []).append(fit_case.Case(record, row, build, args.jobs))
    if not groups:
        raise project.Failed(
            f"no record has {place_record.SEEDS_OF_A_MEDIAN} seeds or more that missed the clock asked "
            "for; make one with 'scripts/place UNIT --ask-mhz MHZ --record FILE'"
        )
    return groups


def file_of(model: pathlib.Path) -> pathlib.Path:
    """Where the documents keep how well a model fits."""
    return place_record.DATA / f"fit_{model.stem.replace('-', '_')}.json"


def check(model: pathlib.Path, data: Json) -> None:
    """Throws Failed where a model fits otherwise than the documents say."""
    kept = project.read_json(file_of(model))
    for name, placement in data["placements"].items():
        for key, value in placement.items():
            said = kept["placements"].get(name, {}).get(key)
            near = isinstance(value, float) and isinstance(said, float)
            if abs(value - said) > SAME * value if near else value != said:
                raise project.Failed(
                    f"{file_of(model)}: '{key}' of {name} is {said}, and now {value}; run "
                    "scripts/fit-delays --record, or take the change back"
                )


def main() -> int:
    args = parse()
    try:
        # All files are read before a model is written.
        for fit in [Fit(model, found) for model, found in cases_of(args).items()]:
            fitted = fit.start if args.check else fit.fitted()
            data = fit.data(fit.start, fitted)
            fit.warn()
            if args.check:
                check(fit.path, data)
                continue
            fit.print(data, args.worst)
            if args.write:
                placed = [f"{case.name} ({1000 / case.period:.0f} MHz)" for case in fit.cases]
                model_file.write(fit.path, fitted, ", ".join(placed))
                data = fit.data(fitted, fitted)
            if args.record or args.write:
                project.write_json(file_of(fit.path), data)
    except project.Failed as error:
        project.fail(error)
    return 0
