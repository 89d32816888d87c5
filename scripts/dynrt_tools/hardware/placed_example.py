# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The SDF file of a small placed design, for tests."""

# Two registers and two cells between them; `g` closes a loop, which no path goes through.
#   start.Q -1.0-> f.A ... f.F -2.0-> end.D           0.5 + 1.0 + 0.25 + 2.0 + 0.1 = 3.85
#   start.Q -0.7-> g.A ... g.F -0.3-> f.B             0.5 + 0.7 + 0.2 + 0.3 + 0.3 + 2.0 + 0.1 = 4.1
SDF = """\
(DELAYFILE
  (CELL
    (CELLTYPE "placed")
    (INSTANCE )
    (DELAY
      (ABSOLUTE
        (INTERCONNECT clk/O start/CLK (0:0:0) (0:0:0))
        (INTERCONNECT clk/O end\\[0\\]/CLK (0:0:0) (0:0:0))
        (INTERCONNECT start/Q f/A (900:950:1000) (900:950:990))
        (INTERCONNECT start/Q g/A (700:700:700) (700:700:700))
        (INTERCONNECT g/F f/B (300:300:300) (300:300:300))
        (INTERCONNECT f/F g/B (300:300:300) (300:300:300))
        (INTERCONNECT f/F end\\[0\\]/D (2000:2000:2000) (1000:1000:1000))
      )
    )
  )
  (CELL
    (CELLTYPE "LUT")
    (INSTANCE f)
        (IOPATH A F (250:250:250) (250:250:250))
        (IOPATH B F (300:300:300) (300:300:300))
  )
  (CELL
    (CELLTYPE "LUT")
    (INSTANCE g)
        (IOPATH A F (200:200:200) (200:200:200))
        (IOPATH B F (200:200:200) (200:200:200))
  )
  (CELL
    (CELLTYPE "FF")
    (INSTANCE start)
        (IOPATH CLK Q (500:500:500) (400:400:400))
  )
  (CELL
    (CELLTYPE "FF")
    (INSTANCE end\\[0\\])
      (SETUPHOLD (posedge D) (posedge CLK) (100:100:100) (0:0:0))
      (SETUPHOLD (negedge D) (posedge CLK) (100:100:100) (0:0:0))
  )
)
"""


def with_second_bit(picoseconds: int = 2000) -> str:
    """The file with a second bit of `end`, whose wire from f takes so many picoseconds."""
    wires = [line for line in SDF.splitlines() if "end" in line and "INTERCONNECT" in line]
    start = SDF.index('  (CELL\n    (CELLTYPE "FF")\n    (INSTANCE end')
    cell = SDF[start : SDF.rindex(")")]

    def second(text: str) -> str:
        return text.replace("end\\[0\\]", "end\\[1\\]")

    more = second("\n".join(wires)).replace("2000", str(picoseconds))
    before = "        (INTERCONNECT g/F"
    wired = SDF[:start].replace(before, f"{more}\n{before}", 1)
    return f"{wired}{cell}{second(cell)})\n"
