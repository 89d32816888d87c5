# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The models in ecp5_cells.v do what the Verilog does that Yosys makes such cells of, products and
block RAM with the registers that scripts/place moves into them too. Takes the folder to work in."""

import pathlib
import sys

from dynrt_tools import project
from dynrt_tools.hardware import block_registers, replay, synthesis

# Blocks that take the registers behind the outputs `registered_*` of cells.v.
MOVED = {block_registers.MULTIPLIER: 1, block_registers.BLOCK_RAM: 2}


def main() -> None:
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    ram = project.ROOT / "rtl/lib/hls_ram_1r1w.v"
    used = ["select -assert-min 3 t:DP16KD", "select -assert-min 3 t:MULT18X18D"]
    try:
        design = [
            *synthesis.read_commands([ram, replay.HERE / "cells.v"]),
            "synth_ecp5 -nowidelut -top cells",
            *used,
        ]
        moved = replay.packed(folder, "cells", design, ["rename cells gates"], "gates.v")
        if moved != MOVED:
            sys.exit(f"cells_test: moved registers into {dict(moved)}; right were {MOVED}")
    except project.Failed as error:
        sys.exit(f"cells_test: {error}")
    shipped = replay.shipped_cells()
    replay.run(
        [
            "iverilog",
            "-g2005",
            "-o",
            folder / "cells.vvp",
            "-s",
            "cells_bench",
            f"-I{shipped}",
            ram,
            replay.HERE / "cells.v",
            replay.HERE / "cells_bench.v",
            folder / "gates.v",
            shipped / "cells_sim.v",
            replay.HERE / "ecp5_cells.v",
        ],
        silent=True,
    )
    output = replay.run(["vvp", folder / "cells.vvp"])
    print(output)
    if output.splitlines()[-1] != "the same":
        sys.exit("cells_test: the models differ from the Verilog")


if __name__ == "__main__":
    main()
