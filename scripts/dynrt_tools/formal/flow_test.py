# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The runner of the proofs: what it must refuse, and that it tells true from false."""
import unittest

from dynrt_tools import testing
from dynrt_tools.formal import flow

COUNTER = """module counter (input wire clk_i, input wire up_i);
  reg [3:0] count_q = 0;
  always @(posedge clk_i) if (up_i && count_q != 9) count_q <= count_q + 1'b1;
endmodule
"""


class Flow(testing.InFolder):
    def design(self, properties: str, solver: str = "smt") -> flow.Design:
        text = flow.with_properties(COUNTER, "counter", properties)
        return flow.Design(self.folder, [("counter.v", text)], "counter", {}, solver)

    def test_tells_true_from_false(self) -> None:
        for solver in ("smt", "sat"):
            with self.subTest(solver):
                true = self.design("always @* below_ten: assert (count_q < 10);\n", solver)
                self.assertEqual(true.assertions, ["below_ten"])
                self.assertTrue(true.holds(12)[0])
                self.assertTrue(true.steps(1)[0])
                false = self.design("always @* assert (count_q < 9);\n", solver)
                self.assertTrue(false.holds(5)[0])
                self.assertFalse(false.holds(12)[0])
                self.assertFalse(false.steps(1)[0])

    def test_no_assertion_is_an_error(self) -> None:
        with self.assertRaisesRegex(flow.Broken, "no assertion was found in counter"):
            self.design("wire nothing = 1'b1;\n")

    def test_no_module_is_an_error(self) -> None:
        with self.assertRaisesRegex(flow.Broken, "there is no module timer"):
            flow.with_properties(COUNTER, "timer", "")

    def test_verilog_that_cannot_be_read_is_an_error(self) -> None:
        with self.assertRaisesRegex(flow.Broken, "yosys cannot read it"):
            self.design("always @* assert (\n")

    def test_a_mutation_must_be_found_once(self) -> None:
        for text in ("nowhere", "count_q"):
            with self.assertRaisesRegex(flow.Broken, "it must be there once"):
                flow.mutated(COUNTER, {"in": "counter.v", "from": text, "to": ""})

    def test_a_mutation_finds_its_stage(self) -> None:
        text = "assign a = b_s3 & c_s4;\nassign d = b_s3;\n"
        mutation = {"in": "counter.v", "from": "b_s1 & c_s2", "to": "~b_s1 & c_s2"}
        self.assertEqual(
            flow.mutated(text, mutation), "assign a = ~b_s3 & c_s4;\nassign d = b_s3;\n"
        )
        with self.assertRaisesRegex(flow.Broken, "it must be there once"):
            flow.mutated(text, {**mutation, "from": "b_s1 & c_s3"})

    def test_a_text_that_stands_twice_in_its_stage_is_looked_for_in_no_other(self) -> None:
        text = "assign a = b_s1;\nassign d = b_s1;\nassign e = b_s2;\n"
        mutation = {"in": "counter.v", "from": "= b_s1", "to": "= ~b_s1"}
        with self.assertRaisesRegex(flow.Broken, "is 2 times in counter.v, .*: = b_s1$"):
            flow.mutated(text, mutation)

    def test_covers_become_assertions_that_they_are_not_reached(self) -> None:
        text = "  always @* begin\n    nine: cover (count_q == 9);\n  end\n"
        self.assertEqual(flow.covers(text), ["nine"])
        self.assertNotIn("cover", flow.without_covers(text))
        self.assertFalse(self.design(flow.covers_as_assertions(text)).holds(12)[0])


if __name__ == "__main__":
    unittest.main()
