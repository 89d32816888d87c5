# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What scripts/fit-delays prints of a model: its constants before and after, how well each fits, and
the ends that it misses most."""

from dynrt_tools.project import Json


def text(data: Json, worst: int) -> str:
    """All of it."""
    return "\n".join(
        [
            *_constants(data),
            "",
            *_placements(data),
            "",
            *_worst(data, worst),
            "",
            *_unpredicted(data),
        ]
    )


def _constants(data: Json) -> list[str]:
    lines = [data["model"], f"{'constant':<16}{'before':>8}{'after':>8}"]
    for name, constant in data["constants"].items():
        at_bound = constant["fitted"] in (constant["least"], constant["most"])
        lines.append(
            f"{name:<16}{constant['value']:>8g}{constant['fitted']:>8g}"
            f"{'  at its bound' if at_bound else ''}"
        )
    return lines


def percent(part: float | None) -> str:
    """A share in words, of which there is none where nothing was predicted."""
    return "-" if part is None else f"{100 * part:.0f} %"


def _placements(data: Json) -> list[str]:
    form = "{:<22}{:>11}{:>11}{:>11}{:>10}{:>10}{:>10}{:>10}"
    lines = [
        "                       limiting ends         within 10 %           period, ns",
        form.format(
            "placement", "all", "predicted", "before", "after", "placed", "before", "after"
        ),
    ]
    for p in data["placements"]:
        lines.append(
            form.format(
                p["placement"],
                p["limiting"],
                p["predicted"],
                percent(p["within"]),
                percent(p["within by the fit"]),
                f"{p['placed, ns']:.2f}",
                f"{p['promised, ns']:.2f}",
                f"{p['promised by the fit, ns']:.2f}",
            )
            + ("  of an earlier Verilog" if p["placement"] in data["earlier"] else "")
        )
    return lines


def _end(end: Json) -> str:
    port = f", {end['port']}" if end["port"] else ""
    source = f" ({end['source']})" if end["source"] else ""
    return f"{end['unit']}: {end['signal']}{port}{source}"


def _worst(data: Json, count: int) -> list[str]:
    ends = sorted(data["ends"], key=lambda e: -abs(float(e["predicted"] / e["placed"]) - 1))
    lines = ["The worst misses, by the constants before:"]
    for end in ends[:count]:
        made_of = " + ".join(f"{n:g} {name}" for name, n in end["counts"].items())
        lines.append(
            f"  {end['placed']:6.2f} ns placed, {end['predicted']:6.2f} predicted: {_end(end)}"
            f" = {made_of}"
        )
    return lines


def _unpredicted(data: Json) -> list[str]:
    ends = data["without prediction"]
    lines = [f"Not predicted are {len(ends)} of {data['limiting']} limiting ends:"]
    for why, count in data["not predicted"].items():
        first = next(e for e in ends if e["why"] == why)
        lines.append(
            f"  {count:4} end at {why}; the worst, {first['placed']:.2f} ns: {_end(first)}"
        )
    return lines
