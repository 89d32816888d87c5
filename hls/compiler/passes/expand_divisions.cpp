// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "passes/passes.h"
#include "passes/rewrite.h"

namespace hlsc {
namespace {

class ExpandDivisions : public Rewrite {
 public:
  ExpandDivisions(const Netlist& from, const DelayModel& delay) : Rewrite(from), delay_(delay) {}

 private:
  NodeId make(const Node& n, const std::vector<NodeId>& v) override {
    if (n.op != Op::kUDiv) return Rewrite::make(n, v);
    return builder_.zext(divide(v[0], v[1]), n.width);
  }

  NodeId divide(NodeId a, NodeId b) {
    b = builder_.trunc(b, std::max(1u, builder_.active_bits(b)));
    const unsigned width = std::max(1u, builder_.active_bits(a));
    a = builder_.trunc(a, width);
    const unsigned divisor_width = builder_.width(b);
    // The dividend's highest bits are below the divisor's least value: no digits come of them.
    const unsigned least = builder_.known(b).getMinValue().getActiveBits();
    const unsigned skipped = std::min(width, least == 0 ? 0 : least - 1);
    const NodeId head =
        skipped == 0 ? builder_.constant(1, 0) : builder_.slice(a, width - skipped, skipped);
    // One bit for the sign of the difference, one for the next bit of the dividend.
    const unsigned work = divisor_width + 1;
    const unsigned digits = width - skipped;
    if (delay_.free_add_sub) return non_restoring(a, b, head, digits, work);
    return delay_.division_digits == 2 ? two_digits(a, b, head, digits, work)
                                       : restoring(a, b, head, digits, work);
  }

  /// The remainder after one more bit of the dividend. It is below the divisor, so remainder and
  /// next bit less divisor fit `work` bits.
  NodeId one_digit(NodeId rest, NodeId bit, NodeId b, unsigned work, std::vector<NodeId>& missing) {
    const NodeId next = builder_.zext(builder_.concat({rest, bit}), work);
    const NodeId difference = builder_.sub(next, builder_.zext(b, work));
    const NodeId too_small = builder_.slice(difference, work - 1, 1);
    missing.push_back(too_small);
    return builder_.trunc(builder_.mux(too_small, next, difference), std::max(1u, work - 1));
  }

  NodeId restoring(NodeId a, NodeId b, NodeId rest, unsigned digits, unsigned work) {
    std::vector<NodeId> missing;  // digits, inverted
    for (unsigned i = digits; i-- > 0;) {
      rest = one_digit(rest, builder_.slice(a, i, 1), b, work, missing);
    }
    return quotient(missing);
  }

  /// Two digits of a restoring division in the time of one, by three differences at once (radix 4;
  /// M. Ercegovac, T. Lang, "Digital Arithmetic", 2004, chapter 5, without redundancy).
  NodeId two_digits(NodeId a, NodeId b, NodeId rest, unsigned digits, unsigned work) {
    std::vector<NodeId> missing;  // digits, inverted
    if (digits % 2 == 1) {
      rest = one_digit(rest, builder_.slice(a, digits - 1, 1), b, work, missing);
    }
    const unsigned wide = work + 1;
    const NodeId once = builder_.zext(b, wide);
    const NodeId twice = builder_.concat({builder_.zext(b, work), builder_.constant(1, 0)});
    const NodeId thrice = builder_.add(once, twice);
    for (unsigned i = digits / 2; i-- > 0;) {
      const NodeId next = builder_.zext(builder_.concat({rest, builder_.slice(a, 2 * i, 2)}), wide);
      const auto less = [&](NodeId multiple) {
        return builder_.sub(builder_.zext(next, wide + 1), builder_.zext(multiple, wide + 1));
      };
      const NodeId less_1 = less(once), less_2 = less(twice), less_3 = less(thrice);
      const auto below = [&](NodeId difference) { return builder_.slice(difference, wide, 1); };
      const NodeId below_1 = below(less_1), below_2 = below(less_2), below_3 = below(less_3);
      missing.push_back(below_2);
      missing.push_back(builder_.mux(below_2, below_1, below_3));
      const auto low = [&](NodeId value) { return builder_.trunc(value, std::max(1u, work - 1)); };
      rest = builder_.mux(below_2, builder_.mux(below_1, low(next), low(less_1)),
                          builder_.mux(below_3, low(less_2), low(less_3)));
    }
    return quotient(missing);
  }

  /// The remainder is signed, from -divisor to divisor; a negative one has the divisor added.
  NodeId non_restoring(NodeId a, NodeId b, NodeId head, unsigned digits, unsigned work) {
    std::vector<NodeId> missing;  // digits, inverted
    NodeId rest = builder_.zext(head, work);
    NodeId negative = builder_.constant(1, 0);
    const NodeId divisor = builder_.zext(b, work);
    for (unsigned i = digits; i-- > 0;) {
      const NodeId next =
          builder_.concat({builder_.trunc(rest, work - 1), builder_.slice(a, i, 1)});
      rest = builder_.mux(negative, builder_.add(next, divisor), builder_.sub(next, divisor));
      negative = builder_.slice(rest, work - 1, 1);
      missing.push_back(negative);
    }
    return quotient(missing);
  }

  NodeId quotient(const std::vector<NodeId>& missing) {
    if (missing.empty()) return builder_.constant(1, 0);
    return builder_.invert(builder_.concat(missing));
  }

  const DelayModel& delay_;
};

}  // namespace

Netlist expand_divisions(const Netlist& netlist, const DelayModel& delay) {
  return ExpandDivisions(netlist, delay).run();
}

}  // namespace hlsc
