# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
#
# Timing of rtl/board/dynrt_board.v for any tool that reads SDC: the 8.33 ns that hlsc schedules the
# units of the checked-in configuration for. core_clk_i is clk_i, gated while the core is idle; on a
# device without a clock gate both are one net.
#
# outside_ns is the part of a period that a signal spends outside the FPGA, on the wire and in the
# other device: half, as no device is chosen. Change it here for all pins. For one group of pins, put
# in its command what the other device's data sheet says and add the wire: its setup time for an
# output, the time from its clock to its data for an input.
set period_ns 8.33
set outside_ns 4.16

create_clock -name clk -period $period_ns [get_ports clk_i]
create_clock -name core_clk -period $period_ns [get_ports core_clk_i]

# The SRAM banks are synchronous on the same clock: a bank takes an address at its edge and gives the
# data of a read within the next period.
set_output_delay -clock clk $outside_ns [get_ports {sram_en_o[*] sram_we_o[*] sram_addr_o[*] sram_wdata_o[*]}]
set_input_delay -clock clk $outside_ns [get_ports {sram_rdata_i[*]}]

# The bus bridge works on the same clock. bus_ready_o and irq_o are logic behind registers, not
# registers, so the FPGA needs its half.
set_input_delay -clock clk $outside_ns [get_ports {bus_valid_i bus_write_i bus_addr_i[*] bus_wdata_i[*]}]
set_output_delay -clock clk $outside_ns [get_ports {bus_ready_o bus_rvalid_o bus_rdata_o[*] irq_o}]

# The reset is synchronous: whatever drives it must bring it to the clock first.
set_input_delay -clock clk $outside_ns [get_ports {rst_ni}]

# The gate of core_clk_i holds its enable while the clock is high, so the enable must come in the half
# of the period before the edge that it lets through.
set_output_delay -clock clk $outside_ns [get_ports {core_clk_en_o}]

# A video converter looks at the VGA pins when vga_clock_o rises, a whole clock after they changed.
set_output_delay -clock clk $outside_ns [get_ports {vga_clock_o vga_hsync_o vga_vsync_o vga_visible_o vga_colour_o[*]}]
