// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The clocks that the C++ states for the primitives, by hand, against those that the Verilog takes.
#include <functional>

#include "Vhls_fifo.h"
#include "Vhls_ram_1r1w.h"
#include "Vhls_ram_words.h"
#include "Vhls_register_file.h"
#include "hls/clocks.h"
#include "hls/ports.h"
#include "rtl/lib/lib_test.h"

namespace dynrt::rtl {
namespace {

constexpr unsigned kRow = 3;
constexpr unsigned kData = 77;

/// Clocks from an access to the one in which `seen` holds; the access lasts one clock.
template <class V>
unsigned clocks_until(V& v, const std::function<void()>& end_access,
                      const std::function<bool()>& seen) {
  constexpr unsigned kPatience = 100;
  for (unsigned after = 0; after < kPatience; ++after) {
    settle(v);
    if (seen()) return after;
    clock(v);
    end_access();
  }
  return kPatience;
}

/// From the address of a row to its data.
template <class V>
unsigned read_latency(V& v) {
  reset(v);
  v.write_en_i = 1;
  v.write_addr_i = kRow;
  v.write_data_i = kData;
  settle(v), clock(v);
  v.write_en_i = 0;
  for (int i = 0; i < 4; ++i) settle(v), clock(v);
  v.read_addr_i = kRow;
  if constexpr (requires { v.read_en_i; }) v.read_en_i = 1;
  return clocks_until(v, [] {}, [&] { return v.read_data_o == kData; });
}

TEST(Latency, OfARamIsThatOfAPort) {
  constexpr unsigned kStated = hls::RamRead<hls::uint<12>, 10>::kPort.latency;
  VerilatedContext context;
  Vhls_ram_1r1w ram(&context);
  EXPECT_EQ(read_latency(ram), kStated);
  Vhls_ram_words words(&context);
  EXPECT_EQ(read_latency(words), kStated);
}

TEST(Latency, OfARegisterFileIsNone) {
  VerilatedContext context;
  Vhls_register_file file(&context);
  EXPECT_EQ(read_latency(file), 0u);
}

TEST(Latency, OfAQueueBehindAForkIsThatOfTheClockedModel) {
  constexpr std::uint64_t kSent = 5;
  constexpr unsigned kDepth = 6;
  hls::Clocks clocks;
  hls::Clocks::Queue* input = clocks.input();
  input->push(kSent);
  const auto branches = clocks.fork({input, [] { return true; }}, {}, 1, kDepth);
  clocks.run();
  ASSERT_FALSE(branches.at(0)->empty());

  VerilatedContext context;
  Vhls_fifo v(&context);
  v.valid_i = v.ready_i = 0;
  reset(v);
  v.valid_i = 1;
  v.data_i = kData;
  const unsigned taken =
      clocks_until(v, [&] { v.valid_i = 0; }, [&] { return v.valid_o && v.data_o == kData; });
  EXPECT_EQ(branches.at(0)->front(), kSent + taken);
}

}  // namespace
}  // namespace dynrt::rtl
