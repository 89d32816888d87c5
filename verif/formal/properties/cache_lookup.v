
// Properties of a cache's lookup, read inside the unit. A row of the cache is {line, address,
// valid, torn}, as units/cache_fill.h writes it, a request {address, context}, a reply {line, ..,
// context}; the row comes the clock after the request. The frame's registers stand still.
  localparam ADDRESS = 19;
  localparam LINE = $bits(lines_data_i) - ADDRESS - 2;
  localparam REQUEST = $bits(request_data_i);
  localparam INDEX = $bits(lines_addr_o);
  localparam REPLY = $bits(reply_data_o);
  localparam ROW = $bits(lines_data_i);

  wire [REPLY-1:0] replied = WRITTEN_DATA(reply);  // written to the FIFO of the replies
  wire replied_valid = WRITTEN_VALID(reply);
  wire missed_valid = WRITTEN_VALID(miss);  // whether something is written to that of the misses
  (* anyconst *) wire [511:0] frame;
  reg was_reset_q = 1'b0;
  wire fired = request_valid_i && request_ready_o && rst_ni;
  reg [LATENCY-2:0] fired_q = 0;
  reg [REQUEST*LATENCY-1:0] requests_q;
  reg [ROW*LATENCY-1:0] rows_q;
  wire [REQUEST*LATENCY-1:0] requests = {requests_q, request_data_i};
  wire [ROW*LATENCY-1:0] rows = {rows_q, lines_data_i};
  wire [LATENCY-1:0] fires = {fired_q, fired};
  always @(posedge clk_i) begin
    requests_q <= requests;
    rows_q <= rows;
    fired_q <= rst_ni ? fires : 0;
    was_reset_q <= was_reset_q || !rst_ni;
  end
  wire [ADDRESS-1:0] address = requests[REQUEST*LATENCY-1-:ADDRESS];
  wire [ROW-1:0] row = rows[ROW*(LATENCY-2)+:ROW];

  always @* begin
    assume (was_reset_q || !rst_ni);
    assume (frame_i == frame);
  end
  always @* if (was_reset_q) begin
    if (replied_valid) begin
      of_its_own_address: assert (!row[0] && row[1] && row[ADDRESS+1:2] == address);
      the_whole_line: assert (replied[REPLY-1-:LINE] == row[ROW-1-:LINE]);
    end
    hit_or_miss: assert ((replied_valid || missed_valid) == fires[LATENCY-1] &&
        !(replied_valid && missed_valid));
    where_the_fill_wrote: assert (!lines_en_o || lines_addr_o ==
        (request_data_i[REQUEST-ADDRESS+:INDEX] & frame_i[32+:INDEX]));
    hits: cover (replied_valid && address != 0);
    misses: cover (missed_valid && row[1] && !row[0]);
    tears: cover (missed_valid && row[0]);
  end
