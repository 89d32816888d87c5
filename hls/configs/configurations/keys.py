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
    configuration and decides nothing of the core. `in_memory` false: no word of the memory depends
    on it, or only the order of words, which every core can read. `kept`: why a core that is made for
    a scene has the value of its general core; empty: a rule of host/specialise decides, or another
    value would change the bits."""

    kind: Kind
    constant: str | None
    about: str
    default: object = None
    inherited: bool = True  # by a configuration that is like another
    of_core: bool = True
    in_memory: bool = True
    kept: str = ""

    @property
    def required(self) -> bool:
        return self.default is None


MEASURED = "measurements decide this number"
HITS_STAY = "hits and pixels do not depend on it"
OF_BOARD = "the board decides it"

ROUNDINGS = Choice("hls::Rounding", {"nearest_even": "kNearestEven", "truncate": "kTruncate"})
MEMORIES = Choice(
    "MemoryPath",
    {"banks": "kBanks", "port": "kPort"},
    "The core's way to the memory that holds the scene.",
    {
        "banks": "three banks of SRAM (thesis chapter 7)",
        "port": "any memory behind one port (units/memory_port.h)",
    },
)
CROSSINGS = Choice(
    "Crossing",
    {"none": "kNone", "split": "kSplit", "remember": "kRemember"},
    "The treatment of a packet whose rays enter the children in different orders (thesis 3.1.3).",
    {
        "none": "the first ray's order is taken: right for rays of one origin",
        "split": "packets are split by the signs of their rays' directions",
        "remember": "the child that is left out at first is remembered",
    },
)
DATAPATHS = Choice(
    "Datapath",
    {"thesis": "kThesis", "fast": "kFast"},
    "The core's datapath.",
    {
        "thesis": "all rays of a packet meet what any of them meets (thesis 4.3.2), slices divide "
        "(6.1.1), the transformation makes camera rays (6.2.1), every operation is rounded, and "
        "leaves are nodes",
        "fast": "a later one, smaller and quicker (units/packet.h says what is different)",
    },
)
ORIGINS = Choice(
    "Origins",
    {"each": "kEach", "common": "kCommon"},
    "The origins of a packet's rays in the traversal.",
    {
        "each": "every slice has its ray's, and subtracts it from the plane",
        "common": "one for all, subtracted once for the packet: reflected rays have none",
    },
)
MATRICES = Choice(
    "TriangleMatrix",
    {"normal_consistent": "kNormalConsistent", "memory_efficient": "kMemoryEfficient"},
    "The stored form of a triangle (thesis 5.1).",
    {
        "normal_consistent": "12 numbers: the plane's normal is a row",
        "memory_efficient": "9 numbers, and two bits that say which column is (1, 1, 1)",
    },
)
TRIANGLE_TESTS = Choice(
    "TriangleTest",
    {"unit_triangle": "kUnitTriangle", "watertight": "kWatertight"},
    "The test of a ray against a triangle.",
    {
        "unit_triangle": "the triangle's matrix takes the ray to the unit triangle (thesis 5.2)",
        "watertight": "an exact rule for the edges: a ray's shear takes the corners to the plane, or "
        "with the fast datapath its plane map does, in integers",
    },
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
        kept=HITS_STAY,
    ),
    "packets": Key(
        Whole(1, 64),
        "kPackets",
        "packets in flight in a pipeline",
        in_memory=False,
        kept=MEASURED,
    ),
    "packet_rays": Key(
        Whole(4, 16, power_of_two=True),
        "kPacketRays",
        "rays of a packet: 4 are 2x2 pixels, 8 are 4x2, 16 are 4x4",
        4,
        in_memory=False,
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
        in_memory=False,
        kept=MEASURED,
    ),
    "ways": Key(
        Whole(1, 4, power_of_two=True),
        "kWays",
        "ways of each cache: lines that an address may lie in; a miss replaces the one that "
        "pseudo-LRU names",
        1,
        in_memory=False,
        kept=HITS_STAY,
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
        in_memory=False,
    ),
    "triangle_slots": Key(
        Whole(0, 32),
        "kTriangleSlots",
        "primitives remembered per packet; 0: it intersects each as often as it is listed",
        8,
        in_memory=False,
    ),
    "exponent_bits": Key(Whole(2, 10), "Real::kExponentBits", "of the float, see hls/float.h"),
    "mantissa_bits": Key(Whole(8, 29), "Real::kMantissaBits", "stored mantissa bits of the float"),
    "rounding": Key(ROUNDINGS, "Real::kRounding", "of every operation of the float"),
    "epsilon": Key(
        Number(0, 1),
        "kEpsilon",
        "how far outside the unit triangle a hit may lie",
        in_memory=False,
        kept="with another value, rays would hit other triangles",
    ),
    "memory_clocks": Key(
        Whole(1, 16),
        "kMemoryClocks",
        "clocks that the scene's banks take for a read; more than 1 stand for a slower memory",
        1,
        kept=OF_BOARD,
    ),
    "memory": Key(
        MEMORIES,
        "kMemory",
        "what holds the scene: banks of SRAM, or any memory behind one port",
        "banks",
        kept=OF_BOARD,
    ),
    "port_bytes": Key(
        Whole(2, 32, power_of_two=True),
        "kPortBytes",
        "bytes that the port moves in a clock",
        8,
        kept=OF_BOARD,
    ),
    "second_level": Key(
        Whole(4, 128, power_of_two=True, or_zero=True),
        "kSecondLevel",
        "kilobytes of a second level of cache before the port, which all pipelines share, in four "
        "ways; 0: none",
        0,
        kept=HITS_STAY,
    ),
    "pixel_bits": Key(
        Whole(16, 32, power_of_two=True),
        "kPixelBits",
        "bits of a pixel in the memory: 32, a byte for each colour and one that is empty, or 16, five "
        "for red and blue and six for green",
        32,
        kept=OF_BOARD,
    ),
    "lights": Key(
        Whole(0, 8),
        "kLights",
        "passes of light rays from a packet's hits, at most",
        0,
        in_memory=False,
    ),
    "reflections": Key(
        Whole(0, 15),
        "kReflections",
        "bounces of a ray, at most",
        0,
        in_memory=False,
    ),
    "scan_out": Key(
        Flag(),
        None,
        "whether the board shows its framebuffer on a VGA display",
        False,
        inherited=False,
        in_memory=False,
    ),
    "crossing": Key(
        CROSSINGS,
        "kCrossing",
        "what happens to a packet whose rays disagree on the nearer child",
        "none",
        in_memory=False,
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
        Flag(),
        "kUncompressed",
        "whether a frame may have every ray's origin transformed",
        True,
        in_memory=False,
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
        in_memory=False,
        kept=MEASURED,
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
        in_memory=False,
        kept=OF_BOARD,
    ),
    "counters": Key(
        Flag(),
        "kCounters",
        "whether the core counts what its units do",
        True,
        in_memory=False,
    ),
}
