// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Properties of hls_repeat, read inside the module.
  reg [COUNT_WIDTH:0] sent_q;  // times that the present token has left
  reg held_q = 1'b0;
  reg [WIDTH-1:0] held_data_q;
  reg waiting_q = 1'b0;
  reg [WIDTH+COUNT_WIDTH:0] offered_q;
  reg was_reset_q = 1'b0;

  wire [COUNT_WIDTH-1:0] count = data_i[COUNT_WIDTH-1:0];
  wire [COUNT_WIDTH-1:0] number = data_o[COUNT_WIDTH-1:0];

  always @(posedge clk_i) begin
    if (valid_o && ready_i) sent_q <= ready_o ? 0 : sent_q + 1'b1;
    held_q <= valid_i && !ready_o;
    held_data_q <= data_i;
    waiting_q <= valid_o && !ready_i;
    offered_q <= data_o;
    if (!rst_ni) begin
      sent_q <= 0;
      held_q <= 1'b0;
      waiting_q <= 1'b0;
      was_reset_q <= 1'b1;
    end
  end

  // The writer keeps an offered token.
  always @* begin
    assume (rst_ni == was_reset_q);
    if (held_q) assume (valid_i && data_i == held_data_q);
  end

  always @* if (was_reset_q) begin
    if (valid_o) begin
      numbered: assert (number == sent_q && data_o[COUNT_WIDTH] == (sent_q == count));
      its_own_data: assert (data_o[WIDTH+COUNT_WIDTH:COUNT_WIDTH+1] == data_i);
    end
    if (valid_i && ready_i) taken_after_the_last: assert (ready_o == (sent_q == count));
    kept: assert (valid_o == valid_i && (!ready_o || ready_i));
    if (waiting_q) steady: assert (valid_o && data_o == offered_q);
  end

  // Why.
  always @* if (was_reset_q) begin
    assert (number_q == sent_q);
    if (valid_i) assert (sent_q <= count);
    if (!held_q) assert (sent_q == 0);
    if (held_q) assert (sent_q <= held_data_q[COUNT_WIDTH-1:0]);
    if (waiting_q) assert (held_q && offered_q == {held_data_q, sent_q == held_data_q[COUNT_WIDTH-1:0], number_q});
  end

  always @* if (was_reset_q) begin
    repeats: cover (valid_i && ready_o && sent_q == {COUNT_WIDTH{1'b1}});
    waits: cover (waiting_q && ready_o && sent_q == 2);
  end
