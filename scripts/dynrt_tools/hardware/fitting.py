# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Fits the constants of a delay model to placed ends by least squares of the relative misses.

A predicted time is the longest of sums of constants, so it is a sum of them by counts: a path of
three LUTs out of a register is clock_overhead + 3 lut. The counts come from hlsc, which times the
same schedule by models that differ in one constant each. Other constants may make another path the
longest, hence the fit takes several steps."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

Model = dict[str, float]
Counts = dict[str, float]

# The constants that are times, with the least and the most that a fit may give them, in ns. The least
# is near to what the cell takes alone, the most about thrice the time with usual wires.
TIMES: dict[str, dict[str, tuple[float, float]]] = {
    "ecp5": {
        "clock_overhead": (0.8, 3.0),
        "lut": (0.6, 2.0),
        "fanout_two": (0.0, 1.0),
        "fanout": (0.0, 1.0),
        "carry_start": (0.9, 3.0),
        "carry_bit": (0.03, 0.15),
        "compare_out": (0.6, 3.0),
        "multiply": (3.0, 8.0),
        "block_register": (0.3, 3.0),
        "ram_out": (5.4, 8.0),
        "ram_in": (0.3, 4.0),
        "lut_ram": (1.0, 5.0),
        "token_in": (0.0, 3.0),
        "token_out": (0.0, 4.0),
        "token_enable": (0.5, 6.0),
    },
    # HX has no multipliers and no LUT RAM.
    "ice40": {
        "clock_overhead": (0.6, 3.0),
        "lut": (0.7, 2.5),
        "fanout_two": (0.0, 1.0),
        "fanout": (0.0, 1.5),
        "carry_start": (0.7, 3.0),
        "carry_bit": (0.1, 0.3),
        "compare_out": (0.6, 3.0),
        "ram_out": (2.1, 6.0),
        "ram_in": (0.2, 3.0),
        "token_in": (0.0, 3.0),
        "token_out": (0.0, 4.0),
        "token_enable": (0.5, 5.0),
    },
}

# A constant keeps its value where no end speaks against it: a miss of this part of a placed time
# weighs as much as a change by that part of the constant.
MISS, CHANGE = 0.05, 0.5
STEPS = 6  # at most
STILL = 0.02  # ns; a step that changes no constant by more is the last
# The counts are found a little beside the constants, where no two paths take the same time.
ASIDE, APART = 1e-3, 1e-5


@dataclass(frozen=True)
class Sample:
    """A placed end: its time, the predicted one, and by which counts of constants."""

    placed: float
    predicted: float
    counts: Counts


Evaluate = Callable[[Model], Sequence[Sample]]


def beside(model: Model, names: Sequence[str]) -> list[Model]:
    """A model beside the given one, and for each constant a model that differs from that in it."""
    base = dict(model)
    for i, name in enumerate(names):
        base[name] *= 1 + ASIDE * (((i + 1) * 0.618034) % 1 - 0.5)
    return [base] + [{**base, name: base[name] + _apart(base[name])} for name in names]


def _apart(value: float) -> float:
    return APART * max(value, 0.1)


def counts(model: Model, names: Sequence[str], times: Sequence[float]) -> Counts:
    """Of an end's times by the models that beside() gives."""
    base = beside(model, names)[0]
    found = {n: (t - times[0]) / _apart(base[n]) for n, t in zip(names, times[1:])}
    return {name: round(count, 3) for name, count in found.items() if abs(count) > 5e-4}


def total(of: Counts, model: Model) -> float:
    """The time that the counts make of a model's constants."""
    return sum(count * model[name] for name, count in of.items())


def cost(samples: Sequence[Sample], model: Model, start: Model, names: Sequence[str]) -> float:
    """What a fit makes small."""
    misses = sum(((s.predicted / s.placed - 1) / MISS) ** 2 for s in samples)
    return float(misses + sum(((model[n] - start[n]) / _scale(start[n])) ** 2 for n in names))


def _scale(value: float) -> float:
    return CHANGE * max(value, 0.2)


def step(
    samples: Sequence[Sample], model: Model, start: Model, bounds: dict[str, tuple[float, float]]
) -> Model:
    """The constants at which the least squares are least if every end keeps its counts."""
    names = list(bounds)
    rows, wants = [], []
    for s in samples:
        weight = 1 / (MISS * s.placed)
        fixed = s.predicted - total(s.counts, model)
        rows.append([weight * s.counts.get(n, 0.0) for n in names])
        wants.append(weight * (s.placed - fixed))
    for i, n in enumerate(names):
        rows.append([1 / _scale(start[n]) if j == i else 0.0 for j in range(len(names))])
        wants.append(start[n] / _scale(start[n]))
    matrix, vector = np.array(rows), np.array(wants)
    square, right = matrix.T @ matrix, matrix.T @ vector
    at = np.array([model[n] for n in names])
    for _ in range(2000):
        before = at.copy()
        for i, n in enumerate(names):
            best = at[i] + (right[i] - square[i] @ at) / square[i, i]
            at[i] = min(max(best, bounds[n][0]), bounds[n][1])
        if np.abs(at - before).max() < 1e-7:
            break
    return {**model, **{n: float(v) for n, v in zip(names, at)}}


def fit(evaluate: Evaluate, start: Model, bounds: dict[str, tuple[float, float]]) -> Model:
    """The constants that fit the samples that `evaluate` gives for a model, rounded to 0.01 ns or,
    where they are small, to 0.001."""
    names = list(bounds)
    best, samples = dict(start), evaluate(start)
    least = cost(samples, best, start, names)
    for _ in range(STEPS):
        wanted = step(samples, best, start, bounds)
        for part in (1.0, 0.5, 0.25):
            tried = {**best, **{n: best[n] + part * (wanted[n] - best[n]) for n in names}}
            found = evaluate(tried)
            now = cost(found, tried, start, names)
            if now < least:
                break
        else:
            break
        moved = max(abs(tried[n] - best[n]) for n in names)
        best, samples, least = tried, found, now
        if moved < STILL:
            break
    return {**best, **{n: round(best[n], 3 if best[n] < 0.2 else 2) for n in names}}
