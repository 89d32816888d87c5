// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The stress cases on cores that were made for a scene: each case gives the general core's hit
// records or is refused with the key that the core lacks. The keys of the core for
// `office` are those that the rules of host/specialise decide.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>

#include "configs/thesis.h"
#include "core/specialised.h"
#include "host/analysis/stress/run.h"
#include "host/format/configuration_json.h"
#include "host/specialise/decide.h"

namespace dynrt::host::specialised {
/// Configuration C with a transformation of its own, below.
template <class C>
struct KeepsIdentity : C {};
}  // namespace dynrt::host::specialised

namespace dynrt {

/// A transformation that gives a component as it is where the matrix's row is one of the identity.
/// The real one multiplies the other components with the row's zeros, which the format does not
/// have: they are its smallest positive number, and so are, more or less, the products. A component
/// that is not far from zero itself changes by that.
template <class Base>
struct Transformation<host::specialised::KeepsIdentity<Base>> {
  using C = host::specialised::KeepsIdentity<Base>;
  using Real = typename C::Real;
  static constexpr unsigned kPackets = 1u << PacketId<C>::kWidth;

  hls::In<PacketVector<C>> vector;
  hls::Out<PacketVector<C>> transformed;
  hls::RamRead<Vector<Real>, kPackets> column[4];
  HLS_PORTS(vector, transformed, column)

  void step() {
    const PacketVector<C> in = vector.read();
    const Vector<Real> c[] = {column[0].read(in.packet), column[1].read(in.packet),
                              column[2].read(in.packet), column[3].read(in.packet)};
    PacketVector<C> out = in;
    out.vector.x = component(in, c[0].x, c[1].x, c[2].x, c[3].x);
    out.vector.y = component(in, c[0].y, c[1].y, c[2].y, c[3].y);
    out.vector.z = component(in, c[0].z, c[1].z, c[2].z, c[3].z);
    transformed.write(out);
  }

 private:
  static Real component(const PacketVector<C>& in, Real m0, Real m1, Real m2, Real n) {
    const Vector<Real>& v = in.vector;
    const auto row_is = [&](double x, double y, double z) {
      return m0 == Real::from_double(x) && m1 == Real::from_double(y) &&
             m2 == Real::from_double(z) && n == Real::from_double(0);
    };
    if (row_is(1, 0, 0)) return v.x;
    if (row_is(0, 1, 0)) return v.y;
    if (row_is(0, 0, 1)) return v.z;
    const Real last = m2 * v.z;
    return (m0 * v.x + m1 * v.y) + (in.point ? last + n : last);
  }
};

}  // namespace dynrt

namespace dynrt::host::specialised {
namespace {

using Thesis = config::thesis;
using ::testing::ContainsRegex;

/// Of two levels, with short stacks and few addresses: for `blocks`.
struct ForBlocks : Thesis {
  static constexpr unsigned kStackDepth = 20;
  static constexpr unsigned kAddressBits = 13;
  static constexpr unsigned kMatrixBits = 11;
  static constexpr bool kUncompressed = false;
  static constexpr bool kCounters = false;
};
/// Of one level: for `office`.
struct ForOffice : Thesis {
  static constexpr unsigned kLevels = 1;
  static constexpr unsigned kStackDepth = 25;
  static constexpr unsigned kObjectSlots = 0;
  static constexpr unsigned kAddressBits = 18;
  static constexpr unsigned kMatrixBits = 16;
  static constexpr bool kUncompressed = false;
  static constexpr bool kCounters = false;
};

constexpr char kSpecial[] = "special";

/// The core that an object's core is held against: the general one or, of the same keys, General.
template <class General>
std::unique_ptr<Board> general_board() {
  CoreInfo core = core_info_of<Thesis>();
  core.name = "thesis";
  return std::make_unique<ModelBoard>(std::move(core), std::make_unique<NativeCoreOf<General>>());
}

template <class C>
std::unique_ptr<Board> made_for(const std::string& scene) {
  CoreInfo core = core_info_of<C>();
  core.name = kSpecial;
  core.made_for = scene;
  core.general = std::make_shared<CoreConfiguration>(core_info_of<Thesis>());
  return std::make_unique<ModelBoard>(std::move(core), std::make_unique<NativeCoreOf<C>>());
}

/// Hits of two cores lie in one place if their distances are no farther apart than this many steps
/// of the mantissa; the two triangles of an edge that a ray grazes do.
constexpr std::uint32_t kSameSteps = 16;

/// The records of a special core beside those of the general one.
struct Tally {
  std::size_t cases = 0, refused = 0, records = 0, hits = 0;
  std::size_t other_bits = 0;  ///< the same triangle in the same place, with other bits
  std::size_t neighbours = 0;  ///< another triangle in the same place
  std::size_t lost = 0, invented = 0;
  std::size_t wrong = 0;          ///< in another place
  std::size_t other_objects = 0;  ///< of another instance

  std::size_t different() const {
    return other_bits + neighbours + lost + invented + wrong + other_objects;
  }
  void take(const HitRecord& found, const HitRecord& expected) {
    ++records;
    hits += expected.hit;
    if (found == expected) return;
    if (!found.hit || !expected.hit) {
      ++(found.hit ? invented : lost);
    } else if (found.object != expected.object) {
      ++other_objects;
    } else if (std::max(found.t, expected.t) - std::min(found.t, expected.t) > kSameSteps) {
      ++wrong;
    } else {
      ++(found.triangle == expected.triangle ? other_bits : neighbours);
    }
  }
  void take(const std::vector<Frame>& found, const std::vector<Frame>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t f = 0; f < found.size(); ++f) {
      ASSERT_EQ(found[f].hits.size(), expected[f].hits.size());
      for (std::size_t i = 0; i < found[f].hits.size(); ++i) {
        take(found[f].hits[i], expected[f].hits[i]);
      }
    }
  }
};

/// Struct C has what the rules decide of every key for a scene in the picture's usual size.
template <class C>
void expect_decided(const std::string& scene) {
  CoreInfo general = core_info_of<Thesis>();
  general.name = "thesis";
  const View usual;
  const MemoryImage image = host::laid_out(scene, usual.width, usual.height, general);
  const std::vector<Decision> decisions = decide(image.needs(), general, {});
  EXPECT_GT(decisions.size(), 20u);
  const CoreInfo special = core_info_of<C>();
  for (const Decision& one : decisions) {
    EXPECT_EQ(value_of(special, one.key), one.value) << one.key << ": " << one.reason;
  }
}

template <class C, class General = Thesis>
Tally run_all(const std::string& scene) {
  const auto board = [](const std::string& name) {
    if (name == "thesis") return general_board<General>();
    const bool listed =
        std::ranges::find(configurations(), name, &Configuration::name) != configurations().end();
    return listed ? make_board(configurations(), {"model", name, ""}) : nullptr;
  };
  stress::Boards general(board, "thesis");
  stress::Boards special(
      [&](const std::string& name) { return name == kSpecial ? made_for<C>(scene) : board(name); },
      kSpecial);
  Tally tally;
  for (const stress::Case* c : stress::find_cases({})) {
    std::vector<Frame> expected, found;
    try {
      stress::run_case(*c, general, &expected);
    } catch (const stress::NoBoard&) {
      continue;  // of a configuration that the table lacks
    }
    SCOPED_TRACE(c->full_name());
    const stress::Result result = stress::run_case(*c, special, &found);
    ++tally.cases;
    EXPECT_TRUE(result.within()) << stress::line_of(result);
    if (result.outcome.exceeds_core) {
      ++tally.refused;
      EXPECT_THAT(result.outcome.refusal,
                  ContainsRegex("needs [a-z_]+ .*, and configuration special, made for '" + scene +
                                "', has "));
      continue;
    }
    tally.take(found, expected);
  }
  fmt::print(
      "{}: {} cases, {} refused; of {} records {} with other bits, {} of a neighbour, {} lost, {} "
      "invented, {} wrong, {} of another object\n",
      scene, tally.cases, tally.refused, tally.records, tally.other_bits, tally.neighbours,
      tally.lost, tally.invented, tally.wrong, tally.other_objects);
  return tally;
}

TEST(SpecialisedStress, TheOfficesCoreIsThatWhichTheRulesDecide) {
  expect_decided<ForOffice>("office");
}

TEST(SpecialisedStress, ACoreOfTwoLevelsGivesTheGeneralCoresRecords) {
  const Tally tally = run_all<ForBlocks>("blocks");
  EXPECT_GT(tally.refused, 0u);
  EXPECT_GT(tally.cases - tally.refused, tally.cases / 2);
  EXPECT_GT(tally.hits, 10'000u);
  EXPECT_EQ(tally.different(), 0u);
}

TEST(SpecialisedStress, OneLevelGivesTheRecordsOfTwoIfTheyKeepTheIdentity) {
  const Tally tally = run_all<KeepsIdentity<ForOffice>, KeepsIdentity<Thesis>>("office");
  EXPECT_GT(tally.hits, 1000u);
  EXPECT_EQ(tally.different(), 0u);
}

// On one level no ray is multiplied with an instance's matrix, the identity. The test above shows
// that nothing else differs. Rays along an axis or from an origin with a zero, which graze an edge,
// may so take the neighbouring triangle.
TEST(SpecialisedStress, ACoreOfOneLevelGivesTheGeneralCoresHits) {
  const Tally tally = run_all<ForOffice>("office");
  EXPECT_GT(tally.refused, 0u);
  EXPECT_GT(tally.cases - tally.refused, tally.cases / 4);
  EXPECT_GT(tally.hits, 1000u);
  EXPECT_EQ(tally.other_objects, 0u);
  // Measured over all cases.
  EXPECT_LE(tally.lost, 2u);
  EXPECT_LE(tally.invented, 49u);
  EXPECT_LE(tally.wrong, 1u);
  EXPECT_LE(tally.neighbours, 278u);
}

}  // namespace
}  // namespace dynrt::host::specialised
