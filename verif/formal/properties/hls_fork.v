// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Properties of hls_fork, read inside the module; it has no state.
  wire taken = valid_i && ready_o;
  wire [OUTPUTS-1:0] takes = valid_o & ready_i;

  always @* begin
    all_or_none: assert (takes == (taken ? {OUTPUTS{1'b1}} : {OUTPUTS{1'b0}}));
    its_own_data: assert (data_o == data_i);
    taken_when_all_are_ready: assert (ready_o == (ready_i == {OUTPUTS{1'b1}}));
    all_take: cover (taken);
    waits: cover (valid_i && ready_i != 0 && !ready_o);
  end
