// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The Morton curve shared by several pipelines: each has a block of 64 packets of it, so that the
// packets of its caches lie side by side, and takes the next block when it has handed out its own.
// A block that begins outside the image lies outside, for it begins at its corner with the least x
// and y; the pipeline that takes it hands out one packet of it. Flags are known a transaction
// ahead, so that the loops are short.
#pragma once

#include <array>

#include "units/pipelines.h"

namespace dynrt {

/// CounterBits are those of a packet's place on the curve.
template <class C, unsigned CounterBits>
class MortonBlocks {
  static constexpr unsigned kPlaceBits = 6;
  static constexpr unsigned kNumberBits = CounterBits - kPlaceBits;
  using Place = hls::uint<kPlaceBits>;
  using Number = hls::uint<kNumberBits>;
  using Flag = hls::uint<1>;

 public:
  using Counter = hls::uint<CounterBits>;

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
        counter = hls::concat(number_[i], place_[i]);
      }
    }
    return {counter, !within && over_};
  }

  /// Where the next block begins.
  Counter corner() const { return hls::concat(next_number_, Place(0)); }

  /// A packet of `pipeline` takes its place. `corner_is_inside` says so of corner() and the image,
  /// `last` is the last place on the curve.
  void advance(PipelineId<C> pipeline, bool corner_is_inside, Counter last) {
    bool takes_block = false;
    for (unsigned i = 0; i < kPipelines<C>; ++i) {
      const bool is_this = pipeline == PipelineId<C>::from(i);
      const bool within = goes_on(i);
      const bool begins = is_this && !within && !over_;
      within_[i] = Flag(begins || (within && !(is_this && last_[i])));
      if (begins) number_[i] = next_number_;
      if (is_this) {
        last_[i] = Flag(place_[i] == Place((1u << kPlaceBits) - 2));
        place_[i] = within ? hls::next(place_[i]) : Place(1);
      }
      began_[i] = Flag(begins);
      takes_block = takes_block || begins;
    }
    outside_ = Flag(!corner_is_inside);
    if (takes_block) {
      over_ = Flag(next_number_ == last.template bits<CounterBits - 1, kPlaceBits>());
      next_number_ = hls::next(next_number_);
    }
  }

 private:
  /// Whether pipeline i has a block that is not handed out yet.
  bool goes_on(unsigned i) const { return within_[i] && !(began_[i] && outside_); }

  std::array<Place, kPipelines<C>> place_;
  std::array<Number, kPipelines<C>> number_;
  std::array<Flag, kPipelines<C>> within_;
  std::array<Flag, kPipelines<C>> last_;   ///< its place is the last of its block
  std::array<Flag, kPipelines<C>> began_;  ///< the packet before began the pipeline's block
  Flag outside_;                           ///< the block before the next lies outside the image
  Flag over_;                              ///< no block is left
  Number next_number_;
};

}  // namespace dynrt
