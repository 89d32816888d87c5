# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
#
# Timing of rtl/board/dynrt_board.v for any tool that reads SDC: the 10 ns that hlsc schedules the
# units of the checked-in configuration for. core_clk_i is clk_i, gated while the core is idle; on a
# device without a clock gate both are one net.
create_clock -name clk -period 10.0 [get_ports clk_i]
create_clock -name core_clk -period 10.0 [get_ports core_clk_i]

# The SRAM banks are synchronous on the same clock: half of the period is theirs and the board's.
set_output_delay -clock clk 5.0 [get_ports {sram_en_o[*] sram_we_o[*] sram_addr_o[*] sram_wdata_o[*]}]
set_input_delay -clock clk 5.0 [get_ports {sram_rdata_i[*]}]

# A video converter looks at the VGA pins when vga_clock_o rises, a whole clock after they changed.
set_output_delay -clock clk 5.0 [get_ports {vga_*}]
