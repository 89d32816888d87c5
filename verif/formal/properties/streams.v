
// Properties of the output CHANNEL of a unit, read inside the unit.
  generate
    if (1) begin : CHANNEL_stream
      reg waiting_q = 1'b0;
      reg [$bits(CHANNEL_data_o)-1:0] offered_q;
      always @(posedge clk_i) begin
        waiting_q <= rst_ni && CHANNEL_valid_o && !CHANNEL_ready_i;
        offered_q <= CHANNEL_data_o;
      end
      always @* if (waiting_q) CHANNEL_steady: assert (CHANNEL_valid_o && CHANNEL_data_o == offered_q);
      always @* begin
    CHANNEL_waits: cover (waiting_q);
      end
    end
  endgenerate
