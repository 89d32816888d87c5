# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
#
# The pins of the memory's port, for a board whose core has one (the key `memory` = `port`). Read it
# after dynrt_board.sdc, which has the clocks.
set period_ns 8.33
set outside_ns 4.16

# The memory's controller works on the same clock, and takes half of it on its side of each pin.
set_output_delay -clock clk $outside_ns [get_ports {memory_read_valid_o memory_read_id_o[*] memory_read_address_o[*] memory_read_last_o[*] memory_beat_ready_o memory_write_valid_o memory_write_address_o[*] memory_write_data_o[*] memory_write_mask_o[*] memory_write_left_o[*]}]
set_input_delay -clock clk $outside_ns [get_ports {memory_read_ready_i memory_write_ready_i memory_beat_valid_i memory_beat_id_i[*] memory_beat_data_i[*] memory_beat_last_i}]
