
// The right results of a float's operators, from the definition of the format alone (hls/float.h):
// read inside the lowered unit formal::Floats. Numbers are integers here, in units of the smallest
// one's last place. The two neighbours of the result must not be nearer to the exact result, hence
// no number is.
  localparam E = 3;
  localparam M = 3;
  localparam N = 1 + E + M;
  localparam SHIFT = (1 << (E - 1)) - 1 + M;  // 1.0 is 2^SHIFT

  function signed [23:0] value_of(input [N-1:0] f);
    reg [22:0] size;
    begin
      size = {1'b1, f[M-1:0]};
      size = size << f[N-2:M];
      value_of = f[N-1] ? -size : size;
    end
  endfunction
  function signed [23:0] product_of(input [N-1:0] f, input [N-1:0] g);
    reg [22:0] size;
    reg [2*M+1:0] significands;
    reg [E:0] exponents;
    begin
      significands = {{(M+1){1'b0}}, 1'b1, f[M-1:0]} * {{(M+1){1'b0}}, 1'b1, g[M-1:0]};
      exponents = {1'b0, f[N-2:M]} + {1'b0, g[N-2:M]};
      size = significands;
      size = size << exponents;
      product_of = f[N-1] != g[N-1] ? -size : size;
    end
  endfunction
  // What was given, the next larger and the next smaller magnitude, as they are compared with the
  // exact result; `even`: the mantissa that was given is; `top`, `low`: nothing is larger, smaller.
  function signed [24:0] distance(input signed [23:0] p, input signed [23:0] q);
    distance = p < q ? q - p : p - q;
  endfunction
  function nearest(input even, input low, input top, input signed [23:0] smaller,
                   input signed [23:0] given, input signed [23:0] larger,
                   input signed [23:0] exact);
    nearest = (given < 0) == (exact < 0) &&
        (top || distance(given, exact) < distance(larger, exact) + even) &&
        (low || distance(given, exact) < distance(smaller, exact) + even);
  endfunction
  function truncated(input even, input low, input top, input signed [23:0] smaller,
                     input signed [23:0] given, input signed [23:0] larger,
                     input signed [23:0] exact);
    truncated = (given < 0) == (exact < 0) &&
        (top || distance(larger, 0) > distance(exact, 0)) &&
        (low || distance(given, 0) <= distance(exact, 0));
  endfunction

  wire [3*N:0] written = WRITTEN_DATA(results);  // written to the FIFO of the results
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
  wire [N-1:0] size_b = {1'b0, b[N-2:0]};
  wire [N-1:0] signed_a = {a[N-1] != b[N-1], a[N-2:0]};
  wire signed [23:0] value_a = value_of(a);
  wire signed [23:0] value_b = value_of(b);
  wire signed [23:0] exact_sum = value_a + value_b;
  wire signed [23:0] exact_product = product_of(a, b);
  wire signed [23:0] exact_quotient = value_of(signed_a) <<< SHIFT;  // times b
  wire [N-1:0] sum = written[N-1:0];
  wire [N-1:0] product = written[2*N-1:N];
  wire [N-1:0] quotient = written[3*N-1:2*N];
  wire less = written[3*N];

  always @* if (was_reset_q && written_valid) begin
    sum_right: assert (ROUNDED(!sum[0], sum[N-2:0] == 0, &sum[N-2:0],
        value_of(sum - 1'b1), value_of(sum),
        value_of(sum + 1'b1), exact_sum));
    product_right: assert (ROUNDED(!product[0], product[N-2:0] == 0, &product[N-2:0],
        value_of(product - 1'b1) <<< SHIFT, value_of(product) <<< SHIFT,
        value_of(product + 1'b1) <<< SHIFT, exact_product));
    quotient_right: assert (ROUNDED(!quotient[0], quotient[N-2:0] == 0, &quotient[N-2:0],
        product_of(quotient - 1'b1, size_b), product_of(quotient, size_b),
        product_of(quotient + 1'b1, size_b), exact_quotient));
    less_right: assert (less == (value_a < value_b));
  end
  always @* begin
    cancels: cover (was_reset_q && written_valid && value_a == -value_b);
    saturates: cover (was_reset_q && written_valid && product[N-2:0] == {(N-1){1'b1}});
  end
