
// Properties of a cache's fill, read inside the unit. What it writes to the row of a line, {line,
// address, valid, torn}, comes from one token, {line, address, .., invalidate}. The frame's registers
// stand still.
  localparam ADDRESS = 19;
  localparam LINE = $bits(lines_data_o) - ADDRESS - 2;
  localparam FILL = $bits(fill_data_i);
  localparam INDEX = $bits(lines_addr_o);

  (* anyconst *) wire [511:0] frame;
  reg was_reset_q = 1'b0;
  reg [FILL*(WRITTEN_IN+1)-1:0] fills_q;
  reg [WRITTEN_IN:0] taken_q = 0;
  wire [FILL*(WRITTEN_IN+1)-1:0] fills = {fills_q, fill_data_i};
  wire [WRITTEN_IN:0] taken = {taken_q, fill_valid_i && fill_ready_o && (rst_ni || WRITTEN_IN == 0)};
  wire [FILL-1:0] fill = fills[FILL*WRITTEN_IN+:FILL];
  always @(posedge clk_i) begin
    fills_q <= fills;
    taken_q <= rst_ni ? taken : 0;
    was_reset_q <= was_reset_q || !rst_ni;
  end
  always @* begin
    assume (was_reset_q || !rst_ni);
    assume (frame_i == frame);
  end

  always @* if (was_reset_q) begin
    written_when_taken: assert (lines_en_o == taken[WRITTEN_IN]);
    if (lines_en_o) begin
      line_and_tag_of_one_token: assert (lines_data_o == {fill[FILL-1-:LINE+ADDRESS], !fill[0], 1'b0});
      where_the_lookup_looks: assert (lines_addr_o ==
          (fill[FILL-LINE-ADDRESS+:INDEX] & frame[32+:INDEX]));
    end
  end
  always @* begin
    fills_a_line: cover (was_reset_q && lines_en_o && lines_data_o[1] && lines_addr_o != 0);
  end
