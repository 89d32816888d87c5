// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Asks the memory for the picture ahead of the display, a burst for each place that the FIFO of the
// answers has for one (rtl/display/picture_stream.v). A transaction is a clock, or several, and
// tells what happened in it. A picture is asked for to its end, also if the next one begins before;
// of those that begin meanwhile the latest is next. State: the next burst, how many are left,
// places for bursts, the picture that is next.
#pragma once

#include "hls/ports.h"
#include "units/picture_format.h"

namespace dynrt {

/// What has happened since the transaction before.
struct PictureEvents {
  bool begins = false;  ///< the display is going to show the picture at `base`
  uint<20> base;        ///< its first pixel, counted from that at kPixelsAt
  bool room = false;    ///< a burst has left the FIFO
  HLS_FIELDS(begins, base, room)
};

/// A read at the memory's port.
struct PictureRead {
  uint<kMemoryAddressBits> address;  ///< of its first byte
  uint<4> last;                      ///< beats less one
  HLS_FIELDS(address, last)
};

/// `Ahead` is the number of bursts for which the FIFO has room, `BeatBytes` the port's width.
template <class Pixel, unsigned BeatBytes, unsigned Ahead>
struct PictureReader {
  static_assert(BeatBytes <= kBurstBytes && kBurstBytes / BeatBytes <= 16);

  hls::In<PictureEvents> events;
  hls::Config<ScanConfig> config;
  hls::Out<PictureRead> read;
  HLS_PORTS(events, config, read)

  void step() {
    const PictureEvents e = events.read();
    const Bursts bursts = picture_bursts<Pixel>(config.get());

    const bool begins = waiting_ && !busy_;
    const bool asks = busy_ && has_room_;
    if (asks) {
      read.write({hls::concat(next_, uint<5>(0)), uint<4>(kBurstBytes / BeatBytes - 1)});
    }

    waiting_ = e.begins || (waiting_ && !begins);
    busy_ = begins ? bursts != Bursts(0) : busy_ && !(asks && left_ == Bursts(0));
    next_ = begins ? first_burst(base_) : asks ? hls::next(next_) : next_;
    left_ = begins ? before(bursts) : asks ? before(left_) : left_;
    if (e.begins) base_ = e.base;
    has_room_ = e.room || (asks ? room_ != Room(1) : has_room_);
    room_ = e.room == asks ? room_ : asks ? before(room_) : hls::next(room_);
  }

 private:
  using Room = uint<hls::index_width(Ahead + 1)>;

  static Bursts first_burst(uint<20> base) {
    constexpr unsigned kShift = hls::index_width(kBurstPixels<Pixel>);
    const auto number = base.template shr<kShift>();
    return Bursts::from(number.raw() | kPixelsAt / kBurstBytes);
  }

  template <unsigned W>
  static uint<W> before(uint<W> value) {
    return (value + uint<W>::ones()).template trunc<W>();
  }

  bool waiting_ = false;                ///< a picture is next
  uint<20> base_;                       ///< its
  bool busy_ = false;                   ///< with a picture
  Bursts next_;                         ///< of it
  Bursts left_;                         ///< behind that one
  Room room_{static_cast<int>(Ahead)};  ///< bursts that the FIFO has room for
  bool has_room_ = true;                ///< for one
};

/// As it is lowered with the core of configuration C.
template <class C, unsigned Ahead = kPictureAhead>
using PictureReaderOf = PictureReader<PixelOf<C>, C::kPortBytes, Ahead>;

}  // namespace dynrt
