
// The promise of a unit to the FIFO at its output, read inside hls_fifo.
  reg [31:0] late_q = 0;  // tokens that came since ready_o is low
  reg was_reset_q = 1'b0;
  always @(posedge clk_i) begin
    late_q <= !rst_ni || ready_o ? 0 : late_q + valid_i;
    was_reset_q <= was_reset_q || !rst_ni;
  end
  always @* assume (was_reset_q || !rst_ni);
  always @* if (was_reset_q && MARGIN > 0) begin
    kept: assert (!(valid_i && !ready_o && late_q >= MARGIN));
  end
  always @* begin
    late: cover (was_reset_q && valid_i && !ready_o && late_q + 1 == MARGIN);
  end
