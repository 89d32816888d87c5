
// Properties of a packet's restart trail, read inside the lowered unit formal::Trail, of any trail that
// is possible and any event that may follow. A trail is {entries that the stack has, on the way back,
// forks passed, forks that wait}; an event is {is a fork, event, trail}. Progress is a number:
// from the root, a bit for each fork of the packet's path, 1 if it does not wait. On the way back the
// path is the one that leads there, and its last fork waits no more.
  localparam D = 6;
  localparam ENTRIES = 2;
  localparam TRAIL = 2 * D + 3;
  localparam BEFORE = TRAIL + 3;
  localparam PUSH = 2'd0, NEAR = 2'd1, FAR = 2'd2, POP = 2'd3;

  function [D-1:0] lowest(input [D-1:0] forks);
    lowest = forks & (~forks + 1'b1);
  endfunction
  function [2:0] count_of(input [D-1:0] forks);
    count_of = forks[0] + forks[1] + forks[2] + forks[3] + forks[4] + forks[5];
  endfunction
  function possible(input [TRAIL-1:0] t);
    reg [D-1:0] waiting, passed, ahead;
    begin
      waiting = t[D-1:0];
      passed = t[2*D-1:D];
      ahead = ~passed;
      possible = (ahead & (ahead + 1'b1)) == 0 &&
          (!t[2*D] || (waiting & ahead) != 0) &&
          t[2*D+1+:2] <= ENTRIES && t[2*D+1+:2] <= count_of(waiting & passed);
    end
  endfunction
  function [D-1:0] progress(input [TRAIL-1:0] t);
    reg [D-1:0] waiting, passed, last;
    begin
      waiting = t[D-1:0];
      passed = t[2*D-1:D];
      last = lowest(waiting);
      progress = t[2*D] ? (~waiting | last) & ~(last - 1'b1) : passed & ~waiting;
    end
  endfunction

  wire [TRAIL+2:0] after = WRITTEN_DATA(after);
  wire written = WRITTEN_VALID(after);
  reg was_reset_q = 1'b0;
  reg [BEFORE*LATENCY-1:0] befores_q;
  wire [BEFORE*LATENCY-1:0] befores = {befores_q, before_data_i};
  always @(posedge clk_i) begin
    befores_q <= befores;
    was_reset_q <= was_reset_q || !rst_ni;
  end
  wire [BEFORE-1:0] before = befores[BEFORE*(LATENCY-1)+:BEFORE];
  wire [TRAIL-1:0] trail = before[TRAIL-1:0];
  wire [1:0] event_kind = before[TRAIL+:2];
  wire is_fork = before[TRAIL+2];
  wire [TRAIL-1:0] next = after[TRAIL-1:0];
  wire was_done = after[TRAIL];
  wire in_far = after[TRAIL+1];
  wire near_done = after[TRAIL+2];

  // What the decision does: it pushes where both children are entered, which it does not do where the
  // near one is done. A path that is too long pushes nothing.
  always @* begin
    assume (was_reset_q || !rst_ni);
    if (written) begin
      assume (possible(trail));
      assume (event_kind != PUSH || (!trail[D] && !in_far && !near_done));
      assume (event_kind != NEAR || !is_fork || !near_done);
      assume (event_kind != POP || !was_done);
    end
  end

  always @* if (was_reset_q && written) begin
    stays_possible: assert (possible(next));
    never_goes_back: assert (progress(next) >= progress(trail));
    gets_on_with_each_pop: assert (event_kind != POP || progress(next) > progress(trail));
    finds_its_place: assert (!(near_done && is_fork && event_kind == FAR) ||
        (!next[2*D] && progress(next) == progress(trail)));
    is_done_when_none_waits: assert (was_done == ((trail[D-1:0] & trail[2*D-1:D]) == 0));
  end

  always @* begin
    restarts: cover (was_reset_q && written && event_kind == POP && next[2*D]);
    comes_back: cover (was_reset_q && written && near_done && is_fork && event_kind == FAR);
    passes_a_fork: cover (was_reset_q && written && in_far && is_fork && event_kind == FAR);
  end
