  // The slower one may take a token whenever the faster one does; how long none has come.
  reg was_reset_q = 1'b0;
  reg [7:0] quiet_q = 0;
  always @(posedge clk_i) begin
    was_reset_q <= was_reset_q || !rst_ni;
    quiet_q <= fire_o ? 0 : quiet_q + (quiet_q != 8'hff);
  end
  always @* begin
    assume (rst_ni == was_reset_q);
    if (fire_o) assume (slow_fire);
  end
