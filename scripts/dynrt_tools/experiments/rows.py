# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""An experiment whose result is a row for each variant and scene: its jobs, its rows, what is asked
of them, and all of it as text."""

import itertools
from collections.abc import Callable, Iterator, Mapping, Sequence

from dynrt_tools.experiments import frame, page, sdram
from dynrt_tools.experiments.jobs import Core, File, Job, Maker, Word
from dynrt_tools.experiments.table import THESIS, Variant
from dynrt_tools.experiments.workflow import Workflow
from dynrt_tools.hardware import placed_clocks
from dynrt_tools.project import Json

PLACED = "frames per second, placed"
RATES, VERDICT = "thesis's frames per second", "beside the thesis"
# How a figure stands beside that of another variant in the same scene.
RELATIONS: Mapping[str, Callable[[float, float], float]] = {
    "times as fast": lambda own, other: other / own,
    "times": lambda own, other: own / other,
    "percent more": lambda own, other: 100 * (own / other - 1),
}


def core_of(maker: Maker, variant: Variant, needs_model: bool = True) -> Core:
    """What frames need of a variant's core."""
    verilog = None
    if variant.setting("schedule", True):
        verilog = maker.verilog(variant.name, variant.configuration)
    known = variant.named if needs_model else ""
    model = None if known or not needs_model else maker.model(variant.name, variant.configuration)
    return Core(known, model, verilog)


def jobs_of(
    maker: Maker,
    experiment: Json,
    variants: Mapping[str, Variant],
    scenes: Mapping[str, Word],
    size: str,
) -> dict[tuple[str, str], Job]:
    """The frames by variant and scene; `scenes` are by the names that the rows have."""
    found = {}
    for name, variant in variants.items():
        settings, program = variant.settings, maker.program
        if "program" in settings:
            program = maker.program.parent / settings["program"]
        own = [] if "program" in settings else experiment["command"]
        command = settings.get("command", own)
        core = core_of(maker, variant, needs_model=bool(command))
        flags = settings.get("flags", experiment.get("flags", []))
        for scene in (one for one in scenes if one in variant.settings.get("scenes", scenes)):
            words: tuple[Word, ...] = (File(program), *command[:1], scenes[scene], *command[1:])
            words += ("--size", settings.get("size", size))
            if command[:1] == ["render"]:
                words += ("--out", "{scratch}/image.png")
            more = [*sdram.flags_of(variant), *flags]
            found[name, scene] = maker.frame(f"{scene}, {name}", words, core, more)
    return found


def rows_of(
    experiment: Json,
    variants: Mapping[str, Variant],
    found: Mapping[tuple[str, str], Json | None],
    size: str,
) -> list[Json]:
    """A row for each frame that there is."""
    rows = []
    for (name, scene), result in found.items():
        if result is None:
            continue
        one, variant = result.get("frame", result), variants[name]
        row: Json = {"variant": name, "scene": scene, **frame.figures_of(one)}
        row |= beside_the_thesis(row, variant.named or name, size)
        if "sdram" in one:
            row |= sdram.figures_of(one, variant)
        if experiment.get("frames"):
            row["frame"] = one
        rows.append(row)
    for row in rows:
        sram = found.get((sdram.SRAM, row["scene"]))
        if sram and "core_hz" in row:
            unit = sram["frame"]["units"][row["busiest unit"]]
            row["use with SRAM"] = 100 * unit["utilisation"]
    by_place = {(row["variant"], row["scene"]): row for row in rows}
    for column, relation in experiment.get("relations", {}).items():
        for row in rows:
            others: Json = dict(variants[row["variant"]].settings.get("beside", {}))
            other = by_place.get((others.get(column, relation.get("variant")), row["scene"]))
            row[column] = related(row, other, relation) if other else None
    return rows


def related(row: Json, other: Json, relation: Json) -> float | None:
    own, one = row.get(relation["figure"]), other.get(relation["figure"])
    return RELATIONS[relation["as"]](own, one) if own and one else None


def beside_the_thesis(row: Json, configuration: str, size: str) -> Json:
    """Frame rates, and the thesis's for a scene that it has."""
    found: Json = {PLACED: placed_clocks.rate_text(row["clocks"], configuration, ".2f")}
    if row["scene"] in THESIS["rates"]:
        low, high = THESIS["rates"][row["scene"]]
        found[RATES] = f"{low} to {high}"
        rate = row[frame.RATE]
        verdict = "above" if rate > high else "within" if rate >= low else "below"
        found[VERDICT] = verdict if size == THESIS["size"] else "-"
    return found


def aims_of(experiment: Json, rows: Sequence[Json]) -> list[Json]:
    """What is asked of the rows, and whether they reach it."""
    by_place = {(row["variant"], row["scene"]): row for row in rows}
    found = []
    for aim in experiment.get("aims", []):
        bound = "at least" if "at least" in aim else "at most"
        for scene, asked in aim[bound].items():
            row = by_place.get((aim["variant"], scene))
            if row is None:
                continue
            reached = row[aim["figure"]]
            met = reached >= asked if bound == "at least" else reached <= asked
            found.append(
                {
                    "variant": aim["variant"],
                    "figure": aim["figure"],
                    "scene": scene,
                    "bound": bound,
                    "asked": asked,
                    "reached": reached,
                    "verdict": "reached" if met else "missed",
                }
            )
    return found


def collected(
    experiment: Json,
    variants: Mapping[str, Variant],
    jobs: Mapping[tuple[str, str], Job],
    flow: Workflow,
    size: str,
) -> Json:
    """The report of an experiment."""
    rows = rows_of(experiment, variants, {k: flow.result(job) for k, job in jobs.items()}, size)
    kept = [*experiment["columns"], *filter(None, (experiment.get("sentences"),))]
    report: Json = {
        "about": experiment["about"],
        "size": size,
        "aims": aims_of(experiment, rows),
        **({"budget": sdram.budgets(rows, variants)} if experiment.get("budget") else {}),
        "rows": [
            {
                k: row.get(k)
                for k in ("variant", "scene", *kept, *(["frame"] if "frame" in row else []))
            }
            for row in rows
        ],
    }
    return report


def cell(value: object, form: str) -> str:
    return "-" if value is None else format(value, form if not isinstance(value, str) else "")


def aligned(lines: Sequence[Sequence[str]], words: int = 1) -> str:
    """Cells in columns, of which the first `words` stand to the left."""
    widths = [max(len(line[i]) for line in lines) for i in range(len(lines[0]))]
    return "\n".join(
        "  ".join(
            text.ljust(width) if i < words else text.rjust(width)
            for i, (text, width) in enumerate(zip(line, widths))
        ).rstrip()
        for line in lines
    )


def text(experiment: Json, report: Json) -> str:
    """A line for each row, or a column where there are more figures than rows; then what is
    asked."""
    columns = experiment["columns"]
    lines: list[tuple[str, ...]] = [("", "", *columns)]
    lines += [
        (row["variant"], row["scene"], *(cell(row.get(c), form) for c, form in columns.items()))
        for row in report["rows"]
    ]
    upright = len(columns) > len(report["rows"])
    turned = [tuple(line) for line in zip(*lines)]
    parts = [aligned(turned if upright else lines, 1 if upright else 2)]
    if report["aims"]:
        parts.append("\n".join(aim_text(aim, columns) for aim in report["aims"]))
    if "budget" in report:
        parts.append(sdram.text(report["budget"]))
    parts += sentences(experiment, report)
    return f"{experiment['about']} {report['size']} pixels.\n\n" + "\n\n".join(parts)


def aim_text(aim: Json, columns: Json) -> str:
    form = columns[aim["figure"]]
    return (
        f"{aim['variant']}, {aim['scene']}: {aim['figure']} {cell(aim['reached'], form)}, asked "
        f"{aim['bound']} {cell(aim['asked'], form)}: {aim['verdict']}"
    )


def sentences(experiment: Json, report: Json) -> Iterator[str]:
    """What holds up each frame that is no faster than the thesis's."""
    if column := experiment.get("sentences"):
        for row in report["rows"]:
            if row.get(VERDICT) in ("within", "below"):
                where = f"{row['variant']}, {row['scene']}, {row[VERDICT]} the thesis's range"
                yield f"{where}: {row[column]}."


def shown(
    name: str,
    experiment: Json,
    variants: Mapping[str, Variant],
    report: Json,
    scenes: Json,
    missing: Sequence[str],
) -> Json:
    """The page: any figure of the variants over any other."""
    numbers = [c for c, form in experiment["columns"].items() if form]
    found = []
    for row in report["rows"]:
        differs = variants[row["variant"]].differs
        known = {column: row[column] for column in experiment["columns"]}
        place: Json = {"scene": row["scene"], "variant": row["variant"], "figures": known}
        words = {"differs": page.described(differs, "thesis"), "family": " + ".join(differs)}
        found.append(place | words)
    about = f"{experiment['about']} {report['size']} pixels."
    return page.shown(
        name.replace("_", " "),
        about,
        {scene: {"about": scenes[scene]["about"]} for scene in scenes},
        found,
        name=name,
        columns=page.named()
        + [page.column(c, words=not f) for c, f in experiment["columns"].items()],
        axes={"y": numbers, "x": [numbers, []], "first": numbers[-1]},
        missing=list(missing),
    )


def scenes_of(experiment: Json, variants: Mapping[str, Variant]) -> list[str]:
    """The scenes of an experiment where the user names none, each once."""
    own = (variant.settings.get("scenes", []) for variant in variants.values())
    return list(dict.fromkeys([*experiment.get("scenes", []), *itertools.chain(*own)]))
