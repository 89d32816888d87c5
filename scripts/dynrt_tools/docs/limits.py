# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The page of limits: its numbers come from the headers and the configurations that set them."""

import ast
import operator
import re
from collections.abc import Callable, Mapping

from dynrt_tools import project
from dynrt_tools.docs import keys
from dynrt_tools.hardware import board_clocks

MEMORY = "hls/units/memory_format.h"
WALK = "host/app/walk.cpp"
INSTANCE_TREE = "host/tree/instance_tree.h"
CONSTANT = re.compile(r"constexpr (?:unsigned|std::size_t) ([^;]*);")
OPERATORS: Mapping[type[ast.operator], Callable[[int, int], int]] = {
    ast.Add: operator.add,
    ast.Mult: operator.mul,
    ast.Div: operator.floordiv,
    ast.LShift: operator.lshift,
}
FIELD = re.compile(r"^  (Word|MatrixIndex|bool|uint<(\d+)>) \w+", re.MULTILINE)

PAGE = """\
# Limits

The numbers on this page come from [{memory}](../../{memory}), the sources
of the host and `hls/configs/configs.json`.

| limit | number | beyond it |
|---|---:|---|
| nodes of all trees | {nodes:,}; {nodes_of_pointers:,} where pointers are to leaves, as in `fast` | the host cuts the trees of the largest objects, and a note names them |
| list entries of all trees | {entries:,} | the same |
| matrices: triangles, instances, lights and the camera | {matrices:,} | the host refuses the scene |
| pixels of a side | {side:,} | the host refuses the size |
| pixels of an image, whose hit records fill a bank | {pixels:,} | the host refuses the size |
| entries of a stack, for each packet and level | {stack}, in `deep` {deep_stack} | the host builds no deeper tree |
| point lights | {lights} in `whitted` and its variants | the host refuses the scene |
| reflections of a ray | {reflections} in `whitted` and its variants | the host refuses the flag |
| pixels of a picture on the display of a board | {modes}, as its bitstream is made; a width that is a multiple of {pitch} | the host refuses the size on a simulated board; on one at a serial line the display stays off |
| frames of a walk | {frames:,} | the host refuses the flag |
| nodes, and list entries, of the top-level tree for each instance | {of_few}, with many instances {of_many} | the host builds a less deep tree |
| magnitude of a number | from 2^{low} to just below 2^{high} | it saturates |
| significant bits of a number | {significant} | it is rounded |

- **Memory.** Three banks of {words:,} words of 32 bits hold nodes, list entries and matrices. Three
  more hold pixels and hit records. If the host cuts trees, rays are tested against more triangles,
  and the note names the object, the new depth and the extra work to expect. The host refuses a
  top-level tree that leaves no space for the objects.
- **Stacks.** The core drops a push onto a full stack and counts it (`dropped_pushes` in `--json`, and a
  warning). Hits may be lost then. The host never builds such trees, but a test may.
- **Numbers.** There is no zero, no infinity and no NaN. The host moves the middle of a scene to the
  origin and scales it by a power of two so that it uses the exponents well. It prints the headroom
  that is left. Scaling changes no hit (`verif/core/scale_test`). Rays hit a triangle well if its size
  is a 4,000th of its distance from the middle. A triangle of a 30,000th has a ragged outline, and no
  ray hits one of a millionth; no message says so. [Stiff and extreme cases](../results/stress.md) has
  the errors at the ends of the numbers.
- **Rays.** Configurations without lights trace primary rays with eye light. Only `primitives` has
  spheres and rectangles. A texture counts with its mean colour. There is no refraction.
- **Walks.** Lights stand still.
- **Files.** dynrt reads the formats of Assimp and Quake 3 BSP. It writes PNG, EXR and GIF.
"""


def value(expression: str, known: dict[str, int]) -> int | None:
    """The number of `1u << 20`, of names and of what +, *, / and << make of such; None for anything
    else."""
    try:
        tree = ast.parse(" ".join(re.sub(r"(\d)u\b", r"\1", expression).split()), mode="eval")
    except SyntaxError:
        return None
    return _value(tree.body, known)


def _value(node: ast.expr, known: dict[str, int]) -> int | None:
    match node:
        case ast.Constant(value=int(number)):
            return number
        case ast.Name(id=name):
            return known.get(name)
        case ast.BinOp(left=left, op=operator_, right=right) if type(operator_) in OPERATORS:
            a, b = _value(left, known), _value(right, known)
            return None if a is None or b is None else OPERATORS[type(operator_)](a, b)
    return None


def constants(name: str, known: dict[str, int] | None = None) -> dict[str, int]:
    """The constants of a source whose values are plain numbers, added to those known."""
    found = dict(known or {})
    text = re.sub(r" *//[^\n]*", "", (project.ROOT / name).read_text(encoding="utf-8"))
    for declaration in CONSTANT.findall(text):
        for one in declaration.split(","):
            constant, _, expression = (part.strip() for part in one.partition("="))
            number = value(expression, found)
            if number is not None:
                found[constant] = number
    return found


def hit_words(matrix_bits: int) -> int:
    """Words that a hit takes in one of its two banks."""
    text = (project.ROOT / MEMORY).read_text(encoding="utf-8")
    struct = project.searched(r"struct HitPlace \{\n(.*?)HLS_FIELDS", text, re.DOTALL)[1]
    widths = {"Word": 32, "MatrixIndex": matrix_bits, "bool": 1}
    bits = sum(int(width) if width else widths[kind] for kind, width in FIELD.findall(struct))
    return bits // 32


def memory_constants() -> dict[str, int]:
    """Those of the memory's layout."""
    hits = hit_words(constants(MEMORY)["kMatrixBits"])
    return constants(MEMORY, {"kHitWords": hits})


def page() -> str:
    """The whole page."""
    memory = memory_constants()
    tree = constants(INSTANCE_TREE)
    configurations = keys.configurations()
    thesis, whitted = configurations["thesis"], configurations["whitted"]
    bias = (1 << (thesis["exponent_bits"] - 1)) - 1
    return PAGE.format(
        memory=MEMORY,
        nodes=memory["kMaxNodes"] - 1,
        nodes_of_pointers=memory["kMaxNodes"] // 2 - 1,
        entries=memory["kMaxListEntries"],
        matrices=memory["kMaxMatrices"],
        side=memory["kMaxSide"],
        pixels=memory["kMaxPixels"],
        words=memory["kBankWords"],
        stack=thesis["stack_depth"],
        deep_stack=configurations["deep"]["stack_depth"],
        lights=whitted["lights"],
        reflections=whitted["reflections"],
        modes=" or ".join(board_clocks.modes()),
        pitch=memory["kPitchStep"],
        frames=constants(WALK)["kMostFrames"],
        of_few=tree["kOfFew"],
        of_many=tree["kOfMany"],
        low=-bias,
        high=bias + 2,
        significant=thesis["mantissa_bits"] + 1,
    )
