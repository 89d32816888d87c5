// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The Morton curve shared by several pipelines: each has a block of it, so that the packets of its
// caches lie side by side, and takes the next block when it has handed out its own. The larger the
// blocks, the fewer lines two pipelines fetch both, and the longer one may work alone at the end: a
// block is a 64th of the curve, at least 4 packets and at most 512. A block that begins outside the
// image lies outside, for it begins at its corner with the least x and y; the pipeline that takes
// it hands out one packet of it. Flags are known a transaction ahead, so that the loops are short.
#pragma once

#include <algorithm>
#include <array>

#include "units/pipelines.h"

namespace dynrt {

/// CounterBits are those of a packet's place on the curve.
template <class C, unsigned CounterBits>
class MortonBlocks {
  static constexpr unsigned kSmallestBits = 2;
  static constexpr unsigned kLargestBits = 9;
  static constexpr unsigned kShareBits = 6;  ///< of the curve's 64 blocks
  using Flag = hls::uint<1>;

 public:
  using Counter = hls::uint<CounterBits>;

  /// The packets of a block less one, of the curve whose last place this is.
  static Counter last_of_block(Counter last) {
    constexpr unsigned kEnd = std::min(kLargestBits + kShareBits, CounterBits);
    return last.template bits<kEnd - 1, kShareBits>().template zext<CounterBits>() |
           Counter((1u << kSmallestBits) - 1);
  }

  /// Where the next packet of a pipeline lies on the curve, if one is left for it.
  struct Next {
    Counter counter;
    bool is_over = false;
  };
  Next next(PipelineId<C> pipeline) const {
    bool within = false;
    Counter counter = corner();
    for (unsigned i = 0; i < kPipelines<C>; ++i) {
      if (pipeline == PipelineId<C>::from(i) && goes_on(i)) {
        within = true;
        counter = counter_[i];
      }
    }
    return {counter, !within && over_};
  }

  /// Where the next block begins.
  Counter corner() const { return corner_; }

  /// A packet of `pipeline` takes its place. `corner_is_inside` says so of corner() and the image,
  /// `last` is the last place on the curve.
  void advance(PipelineId<C> pipeline, bool corner_is_inside, Counter last) {
    const Counter within_block = last_of_block(last);
    bool takes_block = false;
    for (unsigned i = 0; i < kPipelines<C>; ++i) {
      const bool is_this = pipeline == PipelineId<C>::from(i);
      const bool within = goes_on(i);
      const bool begins = is_this && !within && !over_;
      within_[i] = Flag(begins || (within && !(is_this && last_[i])));
      if (is_this) {
        last_[i] = Flag(((counter_[i] ^ within_block) & within_block) == Counter(1));
        counter_[i] = within ? hls::next(counter_[i]) : corner_ | Counter(1);
      }
      began_[i] = Flag(begins);
      takes_block = takes_block || begins;
    }
    outside_ = Flag(!corner_is_inside);
    if (takes_block) {
      over_ = Flag((corner_ | within_block) == (last | within_block));
      corner_ = hls::next(corner_ | within_block);
    }
  }

 private:
  /// Whether pipeline i has a block that is not handed out yet.
  bool goes_on(unsigned i) const { return within_[i] && !(began_[i] && outside_); }

  std::array<Counter, kPipelines<C>> counter_;  ///< the next place in its block
  std::array<Flag, kPipelines<C>> within_;
  std::array<Flag, kPipelines<C>> last_;   ///< its place is the last of its block
  std::array<Flag, kPipelines<C>> began_;  ///< the packet before began the pipeline's block
  Flag outside_;                           ///< the block before the next lies outside the image
  Flag over_;                              ///< no block is left
  Counter corner_;
};

}  // namespace dynrt
