# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What a page of results shows of kept placements and fits beside single figures: tables, and
whether a placement is of the Verilog that there is now."""

from dynrt_tools import project
from dynrt_tools.hardware import fit_table, kept_placement
from dynrt_tools.project import Json

PRESENT, EARLIER = "the present Verilog", "an earlier Verilog"


def state(kept: Json) -> str:
    """Which Verilog the placement of a core or a board is of."""
    if not kept_placement.of_checked_in(kept):
        raise project.Failed(f"only a build knows the Verilog of {kept['unit']}, {kept['config']}")
    return PRESENT if kept_placement.is_current(kept) else EARLIER


def placements(data: Json) -> str:
    """A row for each placement that a model was fitted to."""
    lines = [
        "| unit | configuration | seeds | limiting ends | predicted | within 10 % | placed, ns "
        "| hlsc, ns | of |",
        "|---|---|---:|---:|---:|---:|---:|---:|---|",
    ]
    for row in data["placements"]:
        kept = kept_placement.read(kept_placement.file_of(row["placement"]))
        verilog = EARLIER if row["placement"] in data["earlier"] else PRESENT
        if kept_placement.of_checked_in(kept):
            verilog = state(kept)
        lines.append(
            f"| `{row['unit']}` | `{kept['config']}` | {kept['seeds']} | {row['limiting']} | "
            f"{row['predicted']} | {fit_table.percent(row['within'])} | {row['placed, ns']:.2f} | "
            f"{row['promised, ns']:.2f} | {verilog} |"
        )
    return "\n".join(lines)


def constants(data: Json) -> str:
    """A row for each constant: that of the file, and the one that would fit best."""
    lines = ["| constant, ns | in the file | by the fit |", "|---|---:|---:|"]
    for name, constant in data["constants"].items():
        lines.append(f"| `{name}` | {constant['value']:g} | {constant['fitted']:g} |")
    return "\n".join(lines)


# By the word that stands for a figure's path on a template.
TEXTS = {"state": state, "placements": placements, "constants": constants}
