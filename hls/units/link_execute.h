// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Carries out a request in the memory or the registers. A transaction is a byte to write, a word of
// registers to read, a word of the board's identity, or a read of memory. State: the part of a beat
// or a word that is gathered.
#pragma once

#include "hls/ports.h"
#include "units/link_tokens.h"

namespace dynrt {

template <unsigned Bytes>
struct LinkExecute {
  hls::In<NumberedLinkJob> job;
  hls::RamRead<uint<8>, kLinkRingBytes> ring;
  hls::Config<LinkWords> identity;
  hls::Out<LinkWrite<Bytes>> write;
  hls::Out<LinkRead> read;
  hls::Out<BusAccess> access;
  hls::Out<LinkReply> reply;
  hls::Out<LinkData<Bytes>> data;
  HLS_PORTS(job, ring, identity, write, read, access, reply, data)

  void step() {
    const NumberedLinkJob n = job.read();
    const LinkJob& j = n.job;
    uint<8> byte;
    if (j.action == LinkAction::kWriteMemory || j.action == LinkAction::kWriteRegisters) {
      byte = ring.read((j.start + n.index).template trunc<RingPlace::kWidth>());
    }
    const auto address = (j.address + n.index).template trunc<kBusAddressBits>();
    switch (j.action) {
      case LinkAction::kWriteMemory:
        gather(n, address, byte);
        break;
      case LinkAction::kReadMemory:
        read.write({j.address.template trunc<kLinkAddressBits>(),
                    uint<4>::from(beats_before(j.length).raw())});
        break;
      case LinkAction::kWriteRegisters:
        word_ = hls::concat(byte, word_.template bits<31, 8>());
        if (n.index.template trunc<2>() == uint<2>(3)) {
          access.write({true, whole_word(address), word_});
        }
        break;
      case LinkAction::kReadRegisters:
        access.write(
            {false,
             (j.address + hls::concat(n.index, uint<2>(0))).template trunc<kBusAddressBits>(),
             uint<32>(0)});
        break;
      case LinkAction::kIdentify:
      case LinkAction::kAnswer:
        break;
    }
    // A write is answered with its last byte. An answer without data takes an empty token of them.
    const bool has_data = j.length != LinkLength(0);
    const bool answers = has_data ? n.index == uint<9>(0) : n.last;
    if (answers) reply.write(reply_of(j));
    if (j.action == LinkAction::kIdentify || (!has_data && n.last)) {
      data.write(j.action == LinkAction::kIdentify ? word_of_identity(n) : LinkData<Bytes>{});
    }
  }

 private:
  using Lane = uint<hls::index_width(Bytes)>;

  /// Beats of a memory read less one.
  static LinkLength beats_before(LinkLength length) {
    return LinkLength::from((length.raw() - 1u) / Bytes);
  }
  static uint<kBusAddressBits> whole_word(uint<kBusAddressBits> address) {
    return hls::concat(address.template bits<kBusAddressBits - 1, 2>(), uint<2>(0));
  }

  void gather(const NumberedLinkJob& n, uint<kBusAddressBits> address, uint<8> byte) {
    const Lane lane = address.template trunc<Lane::kWidth>();
    const bool begins = n.index == uint<9>(0) || lane == Lane(0);
    LinkWrite<Bytes> w;
    w.address = hls::concat(address.template bits<kLinkAddressBits - 1, Lane::kWidth>(),
                            uint<Lane::kWidth>(0));
    w.last = n.last;
    if (!begins) w.mask = mask_;
    for (unsigned half = 0; half < Bytes / 2; ++half) {
      w.data[half] = data_[half];
      if (lane == Lane::from(2 * half)) {
        w.data[half] = uint<16>(byte);
        w.mask = w.mask | uint<Bytes / 2>::from(1u << half);
      }
      if (lane == Lane::from(2 * half + 1)) {
        w.data[half] = hls::concat(byte, data_[half].template trunc<8>());
      }
    }
    data_ = w.data;
    mask_ = w.mask;
    if (lane == Lane::ones() || n.last) write.write(w);
  }

  LinkData<Bytes> word_of_identity(const NumberedLinkJob& n) const {
    const LinkWords words = identity.get();
    uint<32> word = words[0];
    for (unsigned i = 1; i < kLinkIdentityWords; ++i) {
      if (n.index == uint<9>::from(i)) word = words[i];
    }
    if (n.index == uint<9>::from(kLinkFacts)) {
      word = word | hls::concat(n.job.address.template trunc<8>(), uint<8>(0));
    }
    LinkData<Bytes> d;
    for (unsigned i = 0; i < 4; ++i) d.bytes[i] = uint<8>::from(word.raw() >> (8 * i));
    return d;
  }

  static LinkReply reply_of(const LinkJob& j) {
    LinkReply r;
    r.kind = j.kind;
    r.sequence = j.sequence;
    r.length = j.length;
    r.room = j.room;
    if (j.action == LinkAction::kReadMemory) {
      r.repeat = beats_before(j.length).template trunc<4>();
      r.size = uint<6>::from(Bytes);
    } else if (j.length != LinkLength(0)) {
      r.repeat = LinkLength::from(j.length.raw() - 1u).template shr<2>().template trunc<4>();
      r.size = uint<6>(4);
    }
    return r;
  }

  BeatHalves<Bytes> data_;
  uint<Bytes / 2> mask_;
  uint<32> word_;
};

}  // namespace dynrt
