# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The models in ecp5_cells.v do what the Verilog does that Yosys makes such cells of, products and
block RAM with the registers that scripts/place moves into them too, and distributed RAM without
constants. Takes the folder to work in."""

import pathlib
import sys

from dynrt_tools import project
from dynrt_tools.hardware import block_registers, distributed_ram, replay, synthesis

# Blocks that take the registers behind the outputs `registered_*` of cells.v, and pins of its small
# RAMs: in two cells of eight rows and one of four, of which the eight are written in each clock.
CHANGED = {
    block_registers.MULTIPLIER: 1,
    block_registers.BLOCK_RAM: 2,
    distributed_ram.ADDRESS: 2 * 2 + 2 * 2,
    distributed_ram.ENABLE: 2,
}


def main() -> None:
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    library = [project.ROOT / "rtl/lib" / name for name in ("hls_ram_1r1w.v", "hls_fifo.v")]
    used = ["select -assert-min 3 t:DP16KD", "select -assert-min 3 t:MULT18X18D"]
    try:
        design = [
            *synthesis.read_commands([*library, replay.HERE / "cells.v"]),
            "synth_ecp5 -nowidelut -top cells",
            *used,
        ]
        changed = replay.packed(folder, "cells", design, ["rename cells gates"], "gates.v")
        if changed != CHANGED:
            sys.exit(
                f"cells_test: the netlist has changed in {dict(changed)}; right were {CHANGED}"
            )
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
            *library,
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
