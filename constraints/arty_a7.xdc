# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
#
# The pins of the top dynrt_arty on an Arty A7-100T (XC7A100T-1CSG324C). The sites are those of
# Digilent's Arty-A7-100-Master.xdc for the board's revisions D and E. Those of the DDR3 come with its
# controller, as does the timing between the two.
set_property CFGBVS VCCO [current_design]
set_property CONFIG_VOLTAGE 3.3 [current_design]

# The oscillator
set_property -dict {PACKAGE_PIN E3 IOSTANDARD LVCMOS33} [get_ports {clk_100mhz_i}]
create_clock -name clk_100mhz -period 10.000 [get_ports {clk_100mhz_i}]

# RESET, low while it is pressed
set_property -dict {PACKAGE_PIN C2 IOSTANDARD LVCMOS33} [get_ports {button_ni}]
set_false_path -from [get_ports {button_ni}]

# The USB bridge: what it sends (uart_txd_in), and what is sent to it (uart_rxd_out). Both are slower
# than the clock by far, and what comes goes through a synchroniser.
set_property -dict {PACKAGE_PIN A9 IOSTANDARD LVCMOS33} [get_ports {serial_i}]
set_false_path -from [get_ports {serial_i}]
set_property -dict {PACKAGE_PIN D10 IOSTANDARD LVCMOS33} [get_ports {serial_o}]
set_false_path -to [get_ports {serial_o}]

# LEDs LD4 to LD7
set_property -dict {PACKAGE_PIN H5 IOSTANDARD LVCMOS33} [get_ports {led_o[0]}]
set_property -dict {PACKAGE_PIN J5 IOSTANDARD LVCMOS33} [get_ports {led_o[1]}]
set_property -dict {PACKAGE_PIN T9 IOSTANDARD LVCMOS33} [get_ports {led_o[2]}]
set_property -dict {PACKAGE_PIN T10 IOSTANDARD LVCMOS33} [get_ports {led_o[3]}]
set_false_path -to [get_ports {led_o[*]}]
