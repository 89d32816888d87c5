# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The keys of a configuration; rules.py says what the value of one asks of another.

KEYS is all there is to know about a key: a new line here gives it to every configuration, to the
struct that the units take, to CoreConfiguration and its JSON, and to the reference.
"""

from dataclasses import dataclass

from configurations.kinds import Choice, Flag, Kind, Number, Sentence, Subset, Whole


@dataclass(frozen=True)
class Key:
    """One key. `constant` is its name in the struct that the units take; None: the units do not
    know it. `default` None: every configuration states it. `of_core` false: it is about the
    configuration and decides nothing of the core."""

    kind: Kind
    constant: str | None
    about: str
    default: object = None
    inherited: bool = True  # by a configuration that is like another
    of_core: bool = True

    @property
    def required(self) -> bool:
        return self.default is None


ROUNDINGS = Choice("hls::Rounding", {"nearest_even": "kNearestEven", "truncate": "kTruncate"})
MEMORIES = Choice("MemoryPath", {"banks": "kBanks", "port": "kPort"})
CROSSINGS = Choice("Crossing", {"none": "kNone", "split": "kSplit", "remember": "kRemember"})
DATAPATHS = Choice("Datapath", {"thesis": "kThesis", "fast": "kFast"})
ORIGINS = Choice("Origins", {"each": "kEach", "common": "kCommon"})
MATRICES = Choice(
    "TriangleMatrix",
    {"normal_consistent": "kNormalConsistent", "memory_efficient": "kMemoryEfficient"},
)
TRIANGLE_TESTS = Choice(
    "TriangleTest", {"unit_triangle": "kUnitTriangle", "watertight": "kWatertight"}
)
PRIMITIVES = Subset("Primitives", ("triangle", "sphere", "rectangle"))

KEYS: dict[str, Key] = {
    "about": Key(Sentence(), None, "what it is for", inherited=False, of_core=False),
    "made_for": Key(
        Sentence(),
        None,
        "the scene that it was specialised for",
        "any scene",
        inherited=False,
        of_core=False,
    ),
    "made_from": Key(
        Sentence(),
        None,
        "the configuration that it was specialised from",
        "no other",
        inherited=False,
        of_core=False,
    ),
    "rtl": Key(
        Flag(),
        None,
        "whether builds make its Verilog too, not the model alone",
        True,
        of_core=False,
    ),
    "pipelines": Key(
        Whole(1, 16),
        "kPipelines",
        "pipelines that trace packets; they share ray generation, the memory and the writing of pixels",
        1,
    ),
    "packets": Key(Whole(1, 64), "kPackets", "packets in flight in a pipeline"),
    "packet_rays": Key(
        Whole(4, 16, power_of_two=True),
        "kPacketRays",
        "rays of a packet: 4 are 2x2 pixels, 8 are 4x2, 16 are 4x4",
        4,
    ),
    "datapath": Key(
        DATAPATHS,
        "kDatapath",
        "the thesis's, or a smaller and quicker one: rays that are not in a leaf are left out, slices "
        "multiply with reciprocals, a unit of its own makes camera rays, a transformation's sums are "
        "rounded once, the pointer to a leaf is that to its list, and most FIFOs of packets are short",
        "thesis",
    ),
    "lines": Key(
        Whole(1, 512, power_of_two=True),
        "kLines",
        "lines of each cache; its nodes or entries, where a line has several",
    ),
    "ways": Key(
        Whole(1, 4, power_of_two=True),
        "kWays",
        "ways of each cache: lines that an address may lie in; a miss replaces the one that "
        "pseudo-LRU names",
        1,
    ),
    "levels": Key(
        Whole(1, 2),
        "kLevels",
        "of trees: 2, of instances and of each object; 1, of the one object there is",
        2,
    ),
    "stack_depth": Key(
        Whole(1, 63),
        "kStackDepth",
        "entries of a packet's stack in a tree, those for nodes with two children on a path; where "
        "origins are common, a stack keeps four of them, and a packet starts again at the root for an "
        "older one",
    ),
    "object_slots": Key(
        Whole(0, 32),
        "kObjectSlots",
        "objects remembered per packet; 0: it enters each as often as it is listed",
        8,
    ),
    "triangle_slots": Key(
        Whole(0, 32),
        "kTriangleSlots",
        "primitives remembered per packet; 0: it intersects each as often as it is listed",
        8,
    ),
    "exponent_bits": Key(Whole(2, 10), "Real::kExponentBits", "of the float, see hls/float.h"),
    "mantissa_bits": Key(Whole(8, 29), "Real::kMantissaBits", "stored mantissa bits of the float"),
    "rounding": Key(ROUNDINGS, "Real::kRounding", "of every operation of the float"),
    "epsilon": Key(Number(0, 1), "kEpsilon", "how far outside the unit triangle a hit may lie"),
    "memory_clocks": Key(
        Whole(1, 16),
        "kMemoryClocks",
        "clocks that the scene's banks take for a read; more than 1 stand for a slower memory",
        1,
    ),
    "memory": Key(
        MEMORIES,
        "kMemory",
        "what holds the scene: banks of SRAM, or any memory behind one port",
        "banks",
    ),
    "port_bytes": Key(
        Whole(2, 32, power_of_two=True), "kPortBytes", "bytes that the port moves in a clock", 8
    ),
    "second_level": Key(
        Whole(4, 128, power_of_two=True, or_zero=True),
        "kSecondLevel",
        "kilobytes of a second level of cache before the port, which all pipelines share, in four "
        "ways; 0: none",
        0,
    ),
    "pixel_bits": Key(
        Whole(16, 32, power_of_two=True),
        "kPixelBits",
        "bits of a pixel in the memory: 32, a byte for each colour and one that is empty, or 16, five "
        "for red and blue and six for green",
        32,
    ),
    "lights": Key(Whole(0, 8), "kLights", "passes of light rays from a packet's hits, at most", 0),
    "reflections": Key(Whole(0, 15), "kReflections", "bounces of a ray, at most", 0),
    "scan_out": Key(
        Flag(),
        None,
        "whether the board shows its framebuffer on a VGA display",
        False,
        inherited=False,
    ),
    "crossing": Key(
        CROSSINGS,
        "kCrossing",
        "what happens to a packet whose rays disagree on the nearer child",
        "none",
    ),
    "origins": Key(
        ORIGINS,
        "kOrigins",
        "whether each ray of a packet has an origin in the traversal, or all have one, which is "
        "subtracted from a plane once; then rays that miss an object's box in the world do not enter "
        "the object",
        "each",
    ),
    "triangle_matrix": Key(
        MATRICES, "kTriangleMatrix", "what is stored of a triangle", "normal_consistent"
    ),
    "primitives": Key(PRIMITIVES, "kPrimitives", "unit objects that are intersected", ["triangle"]),
    "triangle_test": Key(
        TRIANGLE_TESTS, "kTriangleTest", "how a ray meets a triangle", "unit_triangle"
    ),
    "address_bits": Key(
        Whole(4, 19),
        "kAddressBits",
        "of the numbers of nodes and list entries within the core",
        19,
    ),
    "matrix_bits": Key(
        Whole(2, 17), "kMatrixBits", "of the numbers of matrices within the core", 17
    ),
    "uncompressed": Key(
        Flag(), "kUncompressed", "whether a frame may have every ray's origin transformed", True
    ),
    "one_colour": Key(
        Flag(),
        "kOneColour",
        "whether every surface has the same colour, which the frame states",
        False,
    ),
    "line_nodes": Key(
        Whole(1, 4, power_of_two=True),
        "kLineNodes",
        "nodes of a line of the node cache, which come in one read and are a subtree; from 2 on, a "
        "line of the list cache has twice as many entries",
        1,
    ),
    "main_first": Key(
        Flag(),
        "kMainFirst",
        "whether rays enter the scene's main object, whose box nearly fills it, before they come to "
        "the tree over the others",
        False,
    ),
    "clock_ns": Key(
        Number(1, 100, or_zero=True),
        None,
        "nanoseconds of the clock that hlsc schedules the units for; 0: those of the build",
        0,
    ),
    "counters": Key(Flag(), "kCounters", "whether the core counts what its units do", True),
}
