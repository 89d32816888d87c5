# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""How a unit is opened, and that a pair is refused of which more must be proved."""
import unittest

from dynrt_tools import testing
from dynrt_tools.formal import flow, opened, pair

# Counts tokens in stage STATE; gives the count in stage 1.
UNIT = """module count (
  input  wire clk_i,
  input  wire rst_ni,
  input  wire add_valid_i,
  output wire add_ready_o,
  input  wire [3:0] add_data_i,
  output wire sum_valid_o,
  input  wire sum_ready_i,
  output wire [3:0] sum_data_o
);
  wire sum_room;
  wire valid_s0 = add_valid_i && sum_room;
  assign add_ready_o = sum_room;
  wire [3:0] add_s0 = add_data_i[3:0];
  reg valid_s1;
  reg  [3:0] add_s1;
  always @(posedge clk_i) begin
    valid_s1 <= rst_ni && valid_s0;
    add_s1 <= add_s0;
  end
  reg  [3:0] total_q;
  wire [3:0] sum_s1 = add_s1 + total_q;
  always @(posedge clk_i) begin
    if (!rst_ni) total_q <= 4'd0;
    else if (valid_sSTATE) total_q <= (sum_sSTATE);
  end
  hls_fifo #(.WIDTH(4), .DEPTH(8), .MARGIN(1), .BOUNDED(0)) sum_fifo (
    .clk_i(clk_i), .rst_ni(rst_ni),
    .valid_i(valid_s1), .ready_o(sum_room),
    .data_i(sum_s1),
    .valid_o(sum_valid_o), .ready_i(sum_ready_i), .data_o(sum_data_o));

endmodule
"""


class Opened(testing.InFolder):
    def unit(self, text: str) -> pair.Unit:
        path = self.folder / "count.v"
        path.write_text(text, encoding="utf-8")
        return pair.Unit(path)

    def test_state_becomes_ports(self) -> None:
        unit = self.unit(UNIT.replace("STATE", "1"))
        self.assertEqual(unit.ports["total_q"], ("input", 4))
        self.assertEqual(unit.ports["total_q_data_o"], ("output", 4))
        self.assertNotIn("reg  [3:0] total_q", opened.opened(UNIT))

    def test_stages_are_what_the_verilog_says(self) -> None:
        stage = self.unit(UNIT.replace("STATE", "1")).stage
        self.assertEqual(
            [stage[name] for name in ("add_data_i", "total_q", "sum_data_o")], [0, 1, 1]
        )

    def test_state_written_in_another_stage_than_it_is_read_is_refused(self) -> None:
        with self.assertRaisesRegex(flow.Broken, "total_q (is read|belongs)"):
            self.unit(UNIT.replace("STATE", "2"))

    def test_state_that_is_not_understood_is_refused(self) -> None:
        with self.assertRaisesRegex(flow.Broken, "remembers what is not made a port of it"):
            opened.opened(UNIT.replace("    if (!rst_ni) total_q <= 4'd0;\n    else if", "    if"))

    def test_units_of_different_ports_are_no_pair(self) -> None:
        unit = self.unit(UNIT.replace("STATE", "1"))
        other = self.unit(
            UNIT.replace("STATE", "1").replace("[3:0] sum_data_o", "[4:0] sum_data_o")
        )
        with self.assertRaisesRegex(flow.Broken, "different ports"):
            pair.compared(unit, other)


if __name__ == "__main__":
    unittest.main()
