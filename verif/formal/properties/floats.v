
// What a float's operators are to give, from the definition of the format alone (hls/float.h): read
// inside the lowered unit formal::Floats. Numbers are integers here, in units of the smallest one's
// last place; an exact result is the fraction exact / scale. No number of the format, any of them,
// may be nearer to it than the one that was given.
  localparam E = 3;
  localparam M = 3;
  localparam N = 1 + E + M;
  localparam SHIFT = (1 << (E - 1)) - 1 + M;  // 1.0 is 2^SHIFT

  function signed [39:0] value_of(input [N-1:0] f);
    reg signed [39:0] magnitude;
    begin
      magnitude = {36'd1, f[M-1:0]};
      magnitude = magnitude << f[N-2:M];
      value_of = f[N-1] ? -magnitude : magnitude;
    end
  endfunction
  function signed [39:0] distance(input signed [39:0] p, input signed [39:0] q);
    distance = p < q ? q - p : p - q;
  endfunction
  function nearest(input [N-1:0] given, input [N-1:0] other, input signed [39:0] exact,
                   input signed [39:0] scale);
    reg signed [39:0] here;
    reg signed [39:0] there;
    begin
      here = distance(value_of(given) * scale, exact);
      there = distance(value_of({exact < 0, other[N-2:0]}) * scale, exact);
      nearest = given[N-1] == (exact < 0) &&
          (here < there || here == there && (given[N-2:0] == other[N-2:0] || !given[0]));
    end
  endfunction
  function truncated(input [N-1:0] given, input [N-1:0] other, input signed [39:0] exact,
                     input signed [39:0] scale);
    reg signed [39:0] size;
    reg signed [39:0] here;
    reg signed [39:0] there;
    begin
      size = exact < 0 ? -exact : exact;
      here = value_of({1'b0, given[N-2:0]}) * scale;
      there = value_of({1'b0, other[N-2:0]}) * scale;
      truncated = given[N-1] == (exact < 0) && (here <= size || given[N-2:0] == 0) &&
          (there > size || there <= here);
    end
  endfunction

  (* anyconst *) wire [N-1:0] other;
  wire [3*N:0] written = WRITTEN_DATA(results);  // what is written to the FIFO of the results
  wire written_valid = WRITTEN_VALID(results);
  reg was_reset_q = 1'b0;
  reg [2*N*LATENCY-1:0] operands_q;
  wire [2*N*LATENCY-1:0] operands = {operands_q, operands_data_i};
  always @(posedge clk_i) begin
    operands_q <= operands;
    was_reset_q <= was_reset_q || !rst_ni;
  end
  always @* assume (was_reset_q || !rst_ni);
  wire [N-1:0] a = operands[2*N*(LATENCY-1)+:N];
  wire [N-1:0] b = operands[2*N*(LATENCY-1)+N+:N];
  wire signed [39:0] value_a = value_of(a);
  wire signed [39:0] value_b = value_of(b);
  wire signed [39:0] scaled_a = value_a <<< SHIFT;

  always @* if (was_reset_q && written_valid) begin
    sum_right: assert (ROUNDED(written[N-1:0], other, value_a + value_b, 1));
    product_right: assert (ROUNDED(written[2*N-1:N], other, value_a * value_b, 1 <<< SHIFT));
    quotient_right: assert (ROUNDED(written[3*N-1:2*N], other, b[N-1] ? -scaled_a : scaled_a,
                                    b[N-1] ? -value_b : value_b));
    less_right: assert (written[3*N] == (value_a < value_b));
  end
  always @* begin
    cancels: cover (was_reset_q && written_valid && value_a == -value_b);
    saturates: cover (was_reset_q && written_valid && written[2*N-2:N] == {(N-1){1'b1}});
  end
