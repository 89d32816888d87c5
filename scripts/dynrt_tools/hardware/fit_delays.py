# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Holds hlsc's delay models against kept placements, and fits their constants to them.

A kept placement is a file that `scripts/place --keep` wrote. hlsc schedules its Verilog again, by the
delay model of that time, and predicts when the signals arrive that limited the clock; the constants
then get the values that make the least squares of the relative misses least. No placer is needed."""

import argparse
import json
import pathlib
import sys
from collections.abc import Sequence

from dynrt_tools import options, project
from dynrt_tools.hardware import (
    devices,
    fit_case,
    fit_data,
    fit_plot,
    fit_table,
    fitting,
    kept_placement,
    model_file,
    rtl_files,
)

PICTURES = project.ROOT / "docs" / "pictures"


def parse() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="scripts/fit-delays",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        epilog="""\
The model follows from device and grade of the placements: ecp5.json for ECP5 grade 6, ecp5-8.json
for grade 8, ice40-hx.json for iCE40 HX, in hls/compiler/delay. A grade without a file starts from
that of its family, and --write makes the file. An end that hlsc does not predict is counted and
listed with the reason. The exit code is 1 if a file or hlsc fails.""",
    )
    parser.add_argument(
        "kept",
        nargs="*",
        type=pathlib.Path,
        metavar="FILE",
        help="kept placements (default: all in docs/results/data)",
    )
    parser.add_argument(
        "--write",
        action="store_true",
        help="write the constants found into the models; then --record",
    )
    parser.add_argument(
        "--record",
        action="store_true",
        help="write the residuals of the models' constants to docs/results/data/fit_MODEL.json and "
        "their plot to docs/pictures",
    )
    parser.add_argument(
        "--out",
        type=pathlib.Path,
        metavar="FOLDER",
        help="write residuals and plot into this folder, not into docs",
    )
    parser.add_argument(
        "--worst",
        type=int,
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


def chosen(files: Sequence[pathlib.Path]) -> dict[pathlib.Path, list[pathlib.Path]]:
    """The kept placements by the model that they are to fit."""
    if not files:
        found = sorted(
            [*kept_placement.DATA.glob("place_*.json"), *kept_placement.DATA.glob("placed/*.json")]
        )
        files = [path for path in found if kept_placement.is_for_a_fit(path)]
    if not files:
        raise project.Failed(
            f"{kept_placement.DATA}: no kept placement is there; make one with "
            "'scripts/place UNIT --keep FILE'"
        )
    groups: dict[pathlib.Path, list[pathlib.Path]] = {}
    for path in files:
        kept = kept_placement.read(path)
        model = model_file.path_of(kept["device"], kept["grade"])
        groups.setdefault(model, []).append(path)
    return groups


def data_name(model: pathlib.Path) -> str:
    """The file of docs/results/data with the residuals of a model."""
    return f"fit_{model.stem.replace('-', '_')}.json"


class Fit:
    """Of one model to its placements."""

    def __init__(
        self, model: pathlib.Path, files: Sequence[pathlib.Path], args: argparse.Namespace
    ):
        build = rtl_files.find_build(args.build)
        self.path = model
        self.cases = [fit_case.Case(path, build, args.jobs) for path in files]
        self.bounds = fitting.TIMES[devices.family_of(self.cases[0].kept["device"])]
        self.start = model_file.read(model)
        self._known: dict[str, dict[str, fit_case.Result]] = {}

    def results(self, model: fitting.Model) -> dict[str, fit_case.Result]:
        """Every case by a model."""
        key = json.dumps(model, sort_keys=True)
        if key not in self._known:
            project.show_progress(f"{self.path.name}, model {len(self._known) + 1} of about 6")
            self._known[key] = {
                case.name: case.evaluate(model, list(self.bounds)) for case in self.cases
            }
        return self._known[key]

    def run(self) -> fitting.Model:
        """The constants that fit best."""

        def samples(model: fitting.Model) -> list[fitting.Sample]:
            return [row.sample for result in self.results(model).values() for row in result.rows]

        return fitting.fit(samples, self.start, self.bounds)

    def placed(self) -> str:
        """The placements with their clocks, in words."""
        return ", ".join(f"{case.name} ({1000 / case.period:.0f} MHz)" for case in self.cases)

    def warn(self) -> None:
        """Names the placements that say little: of other signals by now, or without haste."""
        project.show_progress("")
        for case in self.cases:
            asked = 1000 / case.kept["asked_mhz"]
            if case.period < asked:
                print(
                    f"fit-delays: {case.name} takes {case.period:.2f} ns, and the placer was asked "
                    f"for {asked:.2f}, so it need not hurry; place it with a higher --ask-mhz",
                    file=sys.stderr,
                )
            if not case.of_present_verilog():
                print(
                    f"fit-delays: {case.name} is of an earlier Verilog of {case.kept['unit']}; place "
                    "it again",
                    file=sys.stderr,
                )

    def data(self, model: fitting.Model, fitted: fitting.Model) -> project.Json:
        """What the documents keep: the residuals of a model, beside those of the fit."""
        by_model, by_fit = self.results(model), self.results(fitted)
        project.show_progress("")
        pairs = {case.name: (case, by_model[case.name]) for case in self.cases}
        name = model_file.base_of(self.path).relative_to(project.ROOT).as_posix()
        return fit_data.of_cases(name, model, fitted, pairs, by_fit)


def main() -> int:
    args = parse()
    if args.out and not args.out.is_dir():
        project.fail(f"--out {args.out}: there is no such folder; create it or name another")
    try:
        # All files are read before a model is written.
        for fit in [Fit(model, files, args) for model, files in chosen(args.kept).items()]:
            model = fit.path
            fitted = fit.run()
            fit.warn()
            data = fit.data(fit.start, fitted)
            print(fit_table.text(data, args.worst), flush=True)
            if args.write:
                model_file.write(model, fitted, fit.placed())
                data = fit.data(fitted, fitted)
            if args.out or args.record or args.write:
                name = data_name(model)
                fit_data.write((args.out or kept_placement.DATA) / name, data)
                fit_plot.draw((args.out or PICTURES) / name.replace(".json", ".svg"), data)
    except project.Failed as error:
        project.show_progress("")
        print(f"fit-delays: {error}", file=sys.stderr)
        return 1
    return 0
