// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The binding of tally.v, as hlsc writes one for the Verilog that it makes.
#pragma once

template <class V, class F>
void visit_ports_tally(V& v, F&& f) {
  f.clock(v.clk_i, v.rst_ni);
  f.in("job", 99, v.job_valid_i, v.job_ready_o, v.job_data_i);
  f.in("extra", 7, v.extra_valid_i, v.extra_ready_o, v.extra_data_i);
  f.config("offset", 9, v.offset_i);
  f.ram_read("table", 40, 32, 2, v.table_en_o, v.table_addr_o, v.table_data_i);
  f.out("result", 108, v.result_valid_o, v.result_ready_i, v.result_data_o);
  f.out("copy_0", 5, v.copy_0_valid_o, v.copy_0_ready_i, v.copy_0_data_o);
  f.out("copy_1", 5, v.copy_1_valid_o, v.copy_1_ready_i, v.copy_1_data_o);
  f.ram_write("last", 16, 16, v.last_en_o, v.last_addr_o, v.last_data_o);
}
