// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Properties of memory_switch, read inside the module. A wire with the attribute hierconn is that of
// the instance in its name.
  wire       read_leaves = read_valid_o && read_ready_i;
  wire       write_leaves = write_valid_o && write_ready_i;
  wire       write_comes = writes_valid && writes_ready;
  wire       beat_taken = beat_valid_i && beat_ready_o;
  wire [1:0] reader = read_id_o[ID_BITS+:2];

  reg                  was_reset_q = 1'b0;
  reg                  read_waits_q = 1'b0, write_waits_q = 1'b0;
  reg [READ_BITS-1:0]  read_before_q;
  reg [WRITE_BITS-1:0] write_before_q;
  reg                  host_waits_before_q = 1'b0; // its read
  reg [24:0]           host_address_before_q;
  reg [3:0]            host_last_before_q;
  // What the memory has taken and not yet answered, and the row of the display's reads there.
  reg [7:0]            display_there_q = 0;
  reg [ID_BITS:0]      core_there_q = 0;
  reg                  host_there_q = 0;
  reg [2:0]            writes_there_q = 0;
  reg [14:0]           row_there_q;
  // Writes that came and are not in the memory; the host's beats of its read that came back, and the
  // last one's number.
  reg [3:0]            writes_q = 0;
  reg [3:0]            given_q = 0;
  reg [3:0]            last_q = 0;
  // One read and one write, whichever the solver likes: how many of it came and have not left.
  (* anyconst *) wire [READ_BITS-1:0] some_read;
  (* anyconst *) wire [WRITE_BITS-1:0] some_write;
  reg [1:0]            some_reads_q = 0, some_writes_q = 0;
  wire [24:0] host_address = host_read_address_i + {21'd0, given_q} * BEAT_BYTES[24:0];
  wire some_read_comes =
      (display_begins && some_read == {DISPLAY, NO_ID, display_read_address_i, display_read_last_i}) ||
      (core_begins && some_read == {CORE, core_read_id_i, 1'b0, core_read_address_i, core_read_last_i}) ||
      (host_asks && some_read == {HOST, NO_ID, host_address, 4'd0});
  wire some_read_leaves = read_leaves && some_read == {read_id_o, read_address_o, read_last_o};
  wire core_writes = core_write_valid_i && core_write_ready_o;
  wire host_writes = host_write_valid_i && host_write_ready_o;
  wire some_write_comes =
      (core_writes && some_write == {core_write_address_i, core_write_data_i, core_write_mask_i}) ||
      (host_writes && some_write == {host_write_address_i, host_write_data_i, host_write_mask_i});
  wire some_write_leaves = write_leaves && some_write == {write_address_o, write_data_o, write_mask_o};
  (* anyseq *) wire    write_done;
  wire                 done = write_done && writes_there_q != 0;
  wire [3:0]           host_beats = host_ends ? (host_beat_last_o ? 4'd0 : given_q + 4'd1) : given_q;

  always @(posedge clk_i) begin
    read_waits_q <= read_valid_o && !read_ready_i;
    read_before_q <= {read_id_o, read_address_o, read_last_o};
    write_waits_q <= write_valid_o && !write_ready_i;
    write_before_q <= {write_address_o, write_data_o, write_mask_o};
    host_waits_before_q <= host_read_valid_i && !host_read_ready_o;
    host_address_before_q <= host_read_address_i;
    host_last_before_q <= host_read_last_i;
    display_there_q <= display_there_q + (read_leaves && reader == DISPLAY) - display_ends;
    core_there_q <= core_there_q + (read_leaves && reader == CORE) - core_ends;
    host_there_q <= host_there_q + (read_leaves && reader == HOST) - host_ends;
    if (read_leaves && reader == DISPLAY) row_there_q <= read_address_o[24:10];
    writes_there_q <= writes_there_q + write_leaves - done;
    writes_q <= writes_q + write_comes - done;
    given_q <= host_beats;
    some_reads_q <= some_reads_q + some_read_comes - some_read_leaves;
    some_writes_q <= some_writes_q + some_write_comes - some_write_leaves;
    if (host_asks) last_q <= host_read_last_i;
    if (!rst_ni) begin
      was_reset_q <= 1'b1;
      read_waits_q <= 1'b0;
      write_waits_q <= 1'b0;
      host_waits_before_q <= 1'b0;
      display_there_q <= 0;
      core_there_q <= 0;
      host_there_q <= 0;
      writes_there_q <= 0;
      writes_q <= 0;
      given_q <= 0;
      some_reads_q <= 0;
      some_writes_q <= 0;
      last_q <= 0;
    end
  end

  // The promises. The memory answers what it was asked for, a read of the host with one beat, and tells
  // whether all writes are in it. The core's ids differ. The host keeps the read that it offers.
  always @* begin
    assume (rst_ni == was_reset_q);
    if (beat_valid_i) begin
      assume (beat_for == DISPLAY || beat_for == CORE || beat_for == HOST);
      if (beat_for == DISPLAY) assume (display_there_q != 0);
      if (beat_for == CORE) assume (core_there_q != 0);
      if (beat_for == HOST) assume (host_there_q && beat_last_i);
    end
    assume (writes_idle_i == (writes_there_q == 0));
    if (&writes_there_q) assume (!write_ready_i);
    if (core_reads_q[ID_BITS]) assume (!core_read_valid_i);
    if (host_waits_before_q) assume (host_read_valid_i && host_read_address_i == host_address_before_q &&
                                     host_read_last_i == host_last_before_q);
  end

  always @* if (was_reset_q) begin
    if (read_waits_q) read_is_steady:
      assert (read_valid_o && {read_id_o, read_address_o, read_last_o} == read_before_q);
    if (write_waits_q) write_is_steady:
      assert (write_valid_o && {write_address_o, write_data_o, write_mask_o} == write_before_q);
    if (read_leaves && reader == DISPLAY && display_there_q != 0) display_asks_for_one_row:
      assert (read_address_o[24:10] == row_there_q);
    if (read_leaves && reader == HOST) host_asks_for_one_beat:
      assert (!host_there_q && read_last_o == 4'd0);
    if (host_asks) host_sees_its_writes: assert (writes_q == 0 && !host_write_valid_i);
    reads_are_what_was_asked:
      assert (display_begins + core_begins + host_asks <= 1 && (!some_read_leaves || some_reads_q != 0) &&
              (read_valid_o || some_reads_q == 0));
    writes_are_what_was_written:
      assert (core_writes + host_writes <= 1 && (!some_write_leaves || some_writes_q != 0) &&
              (write_valid_o || some_writes_q == 0));
    if (host_read_valid_i && !host_waits_q) core_writes_wait_for_the_host:
      assert (!core_writes && (!write_comes || host_write_valid_i));
    if (host_asks) host_gets_its_beats:
      assert (asked[28:4] == host_address);
    if (host_ends) host_knows_the_last_beat: assert (host_beat_last_o == (given_q == last_q));
    idle_if_nothing_is_under_way: assert (core_idle_o == (core_reads == 0 && writes_q == 0));
    beats_reach_who_asked:
      assert (beat_taken == ((display_beat_valid_o && display_beat_ready_i) ||
                             (core_beat_valid_o && core_beat_ready_i) ||
                             (host_beat_valid_o && host_beat_ready_i) ||
                             (beat_valid_i && core_stop_i && beat_for == CORE)));
    if (core_stop_i) nothing_comes_in_a_stop: assert (!core_beat_valid_o);
  end

  // Why they hold: what is counted lies in the buffers or at the memory.
  (* hierconn *) wire \next_read.valid_q ;
  (* hierconn *) wire \next_read.full_q ;
  (* hierconn *) wire [READ_BITS-1:0] \next_read.data_q ;
  (* hierconn *) wire [READ_BITS-1:0] \next_read.second_q ;
  (* hierconn *) wire \next_write.valid_q ;
  (* hierconn *) wire \next_write.full_q ;
  (* hierconn *) wire [WRITE_BITS-1:0] \next_write.data_q ;
  (* hierconn *) wire [WRITE_BITS-1:0] \next_write.second_q ;
  (* hierconn *) wire [2:0] \reads.grant_q ;
  (* hierconn *) wire [1:0] \writes.grant_q ;
  wire       first = \next_read.valid_q ;
  wire       second = \next_read.full_q ;
  wire [1:0] first_reader = \next_read.data_q [READ_BITS-1-:2];
  wire [1:0] second_reader = \next_read.second_q [READ_BITS-1-:2];
  wire       first_display = first && first_reader == DISPLAY;
  wire       second_display = second && second_reader == DISPLAY;
  wire [1:0] core_waits = (first && first_reader == CORE) + (second && second_reader == CORE);
  wire [1:0] host_waits = (first && first_reader == HOST) + (second && second_reader == HOST);
  wire [ID_BITS+1:0] core_reads = core_there_q + core_waits;
  wire [7:0] display_waits = first_display + second_display;
  always @* if (was_reset_q) begin
    assert (\reads.grant_q == 3'd1 || \reads.grant_q == 3'd2 || \reads.grant_q == 3'd4);
    assert (\writes.grant_q == 2'd1 || \writes.grant_q == 2'd2);
    assert (first || !second);
    if (first) assert (first_reader != 2'd3);
    if (second) assert (second_reader != 2'd3);
    assert (display_reads_q == display_there_q + display_waits && display_reads_q <= 8'd128);
    assert (display_there_q <= 8'd128);
    if (first_display) assert (\next_read.data_q [28:14] == display_row_q);
    if (second_display) assert (\next_read.second_q [28:14] == display_row_q);
    if (display_there_q != 0) assert (row_there_q == display_row_q);
    assert (core_reads_q == core_reads && core_reads_q <= 1 << ID_BITS);
    assert (host_waits_q == host_there_q + host_waits && host_there_q + host_waits <= 1);
    if (first && first_reader == HOST) assert (\next_read.data_q [3:0] == 4'd0);
    if (second && second_reader == HOST) assert (\next_read.second_q [3:0] == 4'd0);
    assert (\next_write.valid_q || !\next_write.full_q );
    assert (writes_q == writes_there_q + \next_write.valid_q + \next_write.full_q );
    assert (some_reads_q == (first && \next_read.data_q == some_read) +
                            (second && \next_read.second_q == some_read));
    assert (some_writes_q == (\next_write.valid_q && \next_write.data_q == some_write) +
                             (\next_write.full_q && \next_write.second_q == some_write));
    if (!host_waits_q) assert (host_beat_q == given_q);
    else if (host_last_q) assert (host_beat_q == 0 && given_q == last_q);
    else assert (host_beat_q == given_q + 4'd1 && given_q < last_q);
    if (host_beat_q != 0) assert (host_waits_before_q && last_q == host_last_before_q && host_beat_q <= last_q);
  end

  always @* if (was_reset_q) begin
    display_reads_a_row: cover (display_there_q == 2);
    display_waits_for_its_row: cover (display_read_valid_i && !display_read_allowed);
    host_reads: cover (host_ends && host_beat_last_o && given_q == 1);
    host_waits_for_writes: cover (host_read_valid_i && writes_q != 0);
    core_reads_and_writes: cover (core_there_q != 0 && core_writes);
    host_writes_while_the_core_would: cover (host_writes && core_write_valid_i);
    is_stopped: cover (core_ends && core_stop_i);
  end
