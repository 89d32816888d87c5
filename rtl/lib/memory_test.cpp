// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The primitives that keep data, under random traffic, against what they stand for in C++.
#include <algorithm>
#include <deque>
#include <random>
#include <vector>

#include "Vhls_counters.h"
#include "Vhls_delay.h"
#include "Vhls_ram_1r1w.h"
#include "Vhls_ram_single.h"
#include "Vhls_ram_torn.h"
#include "Vhls_ram_words.h"
#include "Vhls_register_file.h"
#include "rtl/lib/lib_test.h"

namespace dynrt::rtl {
namespace {

TEST(HlsCounters, CountTheirEventsAndAreReadThreeClocksLater) {
  VerilatedContext context;
  context.randReset(2);
  Vhls_counters v(&context);  // 5 counters
  std::mt19937 random(9);
  v.clear_i = v.event_i = v.addr_i = 0;
  reset(v);
  std::vector<unsigned> counts(256, 0);
  std::deque<unsigned> expected;
  unsigned most = 0;
  for (unsigned t = 0; t < kClocks; ++t) {
    v.clear_i = random() % 2000 == 0;
    v.event_i = random() % 32;
    v.addr_i = static_cast<unsigned char>(random() % 4 ? random() % 5 : random() % 256);
    settle(v);
    if (expected.size() == 3) {
      ASSERT_EQ(v.data_o, expected.front()) << t;
      expected.pop_front();
    }
    expected.push_back(counts[v.addr_i]);
    most = std::max(most, expected.back());
    for (unsigned i = 0; i < 5; ++i) counts[i] += v.event_i >> i & 1;
    if (v.clear_i) counts.assign(256, 0);
    clock(v);
  }
  EXPECT_GT(most, 500u);
}

TEST(HlsDelay, DelaysByItsClocks) {
  VerilatedContext context;
  Vhls_delay v(&context);  // 20 bits, 9 clocks
  std::mt19937 random(4);
  reset(v);
  std::deque<unsigned> line;
  for (unsigned t = 0; t < 2000; ++t) {
    v.data_i = random() % (1u << 20);
    settle(v);
    if (line.size() == 9) {
      ASSERT_EQ(v.data_o, line.front()) << t;
      line.pop_front();
    }
    line.push_back(v.data_i);
    clock(v);
  }
}

TEST(HlsRam, ReadsARowOneClockLaterAndTellsWhetherItIsTorn) {
  VerilatedContext context;
  Vhls_ram_torn v(&context);  // 12 bits and the lowest, 10 rows
  std::mt19937 random(5);
  std::vector<unsigned> rows(10, 0);
  v.rst_ni = 1;
  v.read_en_i = 0;
  for (unsigned i = 0; i < 10; ++i) {
    v.write_en_i = 1;
    v.write_addr_i = static_cast<unsigned char>(i);
    v.write_data_i = 0;
    settle(v), clock(v);
  }
  unsigned expected = 0;
  unsigned torn = 0;
  bool known = false;
  unsigned together = 0;
  for (unsigned t = 0; t < kClocks; ++t) {
    v.write_en_i = random() % 2;
    v.write_addr_i = random() % 10;
    v.write_data_i = random() % 8192;
    v.read_en_i = random() % 4 != 0;
    v.read_addr_i = random() % 10;
    settle(v);
    if (known) {
      ASSERT_EQ(v.read_data_o & 1u, torn) << t;
      if (torn == 0) ASSERT_EQ(v.read_data_o >> 1, expected) << t;
    }
    if (v.read_en_i) {
      torn = v.write_en_i && v.write_addr_i == v.read_addr_i ? 1 : 0;
      together += torn;
      expected = rows[v.read_addr_i];
      known = true;
    }
    if (v.write_en_i) rows[v.write_addr_i] = v.write_data_i >> 1;
    clock(v);
  }
  EXPECT_GT(together, 100u);
}

TEST(HlsRam, ARowReadWhileItIsWrittenStopsTheSimulation) {
  VerilatedContext context;
  context.fatalOnError(false);
  Vhls_ram_1r1w v(&context);  // 12 bits, 10 rows
  std::mt19937 random(10);
  v.rst_ni = 1;
  const auto stops = [&](bool write, unsigned written, bool read, unsigned looked_at) {
    v.write_en_i = write;
    v.write_addr_i = static_cast<unsigned char>(written);
    v.write_data_i = random() % 4096;
    v.read_en_i = read;
    v.read_addr_i = static_cast<unsigned char>(looked_at);
    settle(v), clock(v);
    return context.gotError();
  };
  for (unsigned t = 0; t < 1000; ++t) {
    const unsigned row = random() % 10;
    ASSERT_FALSE(stops(true, row, true, (row + 1 + random() % 9) % 10)) << "other rows";
    ASSERT_FALSE(stops(true, row, false, row)) << "written only";
    ASSERT_FALSE(stops(false, row, true, row)) << "read only";
  }
  v.rst_ni = 0;
  EXPECT_FALSE(stops(true, 3, true, 3)) << "in reset, where the enables mean nothing";
  v.rst_ni = 1;
  EXPECT_TRUE(stops(true, 3, true, 3));
}

TEST(HlsRam, ASingleRowThatIsReadWhileItIsWrittenHasTheDataBefore) {
  VerilatedContext context;
  context.fatalOnError(false);
  Vhls_ram_single v(&context);  // 12 bits
  std::mt19937 random(11);
  v.rst_ni = 1;
  v.write_en_i = 1;
  unsigned row = 0;
  for (unsigned t = 0; t < 1000; ++t) {
    const unsigned before = row;
    row = random() % 4096;
    v.write_data_i = static_cast<unsigned short>(row);
    v.read_en_i = t != 0;
    settle(v), clock(v);
    ASSERT_FALSE(context.gotError());
    if (t != 0) ASSERT_EQ(v.read_data_o, before);
  }
}

TEST(HlsRamWords, IsWrittenByRowsAndReadByWords) {
  VerilatedContext context;
  context.randReset(2);
  Vhls_ram_words v(&context);  // 8 rows of 3 words of 10 bits
  std::mt19937 random(11);
  std::vector<std::vector<unsigned>> rows(8, {0, 0, 0});
  v.read_en_i = v.write_en_i = 0;
  reset(v);
  unsigned written = 0;
  unsigned known = 0;  // rows below it have been written
  unsigned since = 3;  // clocks since a row was written last
  unsigned last = 0;   // which
  unsigned expected = 0;
  bool read = false;
  for (unsigned t = 0; t < kClocks; ++t) {
    v.write_en_i = since >= 2 && (known < 8 || random() % 3 == 0);
    ++since;
    if (v.write_en_i) {
      last = known < 8 ? known : random() % 8;
      since = 0;
      for (unsigned& word : rows[last]) word = random() % 1024;
      v.write_data_i = rows[last][0] | rows[last][1] << 10 | rows[last][2] << 20;
    }
    v.write_addr_i = static_cast<unsigned char>(v.write_en_i ? last : random() % 8);
    if (!v.write_en_i) v.write_data_i = random() & 0x3fffffff;
    const unsigned row = random() % 8;
    const unsigned word = random() % 3;
    v.read_en_i = known == 8 && (since > 2 || row != last) && random() % 4 != 0;
    v.read_addr_i = static_cast<unsigned char>(word << 3 | row);
    settle(v);
    if (read) ASSERT_EQ(v.read_data_o, expected) << t;
    if (v.read_en_i) {
      expected = rows[row][word];
      read = true;
    }
    if (v.write_en_i) {
      ++written;
      known = std::max(known, last + 1);
    }
    clock(v);
  }
  EXPECT_GT(written, kClocks / 10);
}

TEST(HlsRamWords, BrokenPromisesStopTheSimulation) {
  for (const bool reads : {false, true}) {
    for (unsigned after = 0; after < 4; ++after) {
      VerilatedContext context;
      context.fatalOnError(false);
      Vhls_ram_words v(&context);
      v.read_en_i = v.write_en_i = 0;
      reset(v);
      v.write_addr_i = 2;
      v.read_addr_i = 1 << 3 | 2;
      for (unsigned t = 0; t <= after; ++t) {
        v.write_en_i = t == 0 || (t == after && !reads);
        v.read_en_i = t == after && reads;
        settle(v), clock(v);
      }
      const bool early = reads ? after < 3 : after == 1 || after == 2;
      EXPECT_EQ(context.gotError(), early) << (reads ? "read" : "written") << " after " << after;
    }
  }
}

TEST(HlsRegisterFile, ReadsInTheSameClockAndStartsWithZeros) {
  VerilatedContext context;
  context.randReset(2);
  Vhls_register_file v(&context);  // 12 bits, 10 rows
  std::mt19937 random(6);
  std::vector<unsigned> rows(10, 0);
  v.rst_ni = 0;
  v.write_en_i = 0;
  for (int i = 0; i < 16; ++i) settle(v), clock(v);
  v.rst_ni = 1;
  for (unsigned t = 0; t < kClocks; ++t) {
    v.write_en_i = random() % 2;
    v.write_addr_i = random() % 10;
    v.write_data_i = random() % 4096;
    v.read_addr_i = random() % 10;
    settle(v);
    ASSERT_EQ(v.read_data_o, rows[v.read_addr_i]) << t;
    if (v.write_en_i) rows[v.write_addr_i] = v.write_data_i;
    clock(v);
  }
}

}  // namespace
}  // namespace dynrt::rtl
