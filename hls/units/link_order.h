// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Decides what is done for a request: carried out if it is the next in the sequence, answered again
// if it was carried out before, refused if the board cannot do it. A request behind a missing one
// is answered with the number that is expected, so that the host goes back to it. After a reset
// nothing is done before the host has asked what the board is: else requests of a host that has not
// noticed the reset could pass for ones that were carried out before it. A transaction is a
// request; the turn holds it until the one before is answered. State: the number that is expected.
#pragma once

#include "hls/ports.h"
#include "units/link_tokens.h"

namespace dynrt {

template <unsigned Bytes>
struct LinkOrder {
  hls::In<LinkRequest> request;
  hls::In<uint<1>> turn;
  hls::Out<LinkJob> job;
  HLS_PORTS(request, turn, job)

  void step() {
    turn.read();
    const LinkRequest r = request.read();
    LinkJob j;
    j.sequence = r.sequence;
    j.start = r.start;
    j.room = r.room;
    j.address = r.address.template trunc<kBusAddressBits>();
    const bool is_identify = is(r, LinkCommand::kIdentify);
    const bool can = r.good && !is_identify && possible(r);
    const bool in_sequence = can && identified_;
    const bool is_next = r.sequence == expected_;
    const auto behind = uint<8>::of_raw(expected_.raw() - r.sequence.raw());
    const bool was_before = !is_next && !behind.template bit<7>();
    if (r.good && is_identify) {
      identify(j);
    } else if (r.good && !can) {
      j.kind = uint<8>::from(kLinkRefused);
    } else if (in_sequence && (is_next || (was_before && is_read(r)))) {
      carry_out(j, r);
    } else if (in_sequence && was_before) {
      j.kind = r.command | uint<8>::from(kLinkAnswer);
    } else {
      j.kind = uint<8>::from(kLinkExpected);
      j.sequence = expected_;
    }
    if (in_sequence && is_next) expected_ = hls::next(expected_);
    identified_ = identified_ || (r.good && is_identify);
    job.write(j);
  }

 private:
  static bool is(const LinkRequest& r, LinkCommand command) {
    return r.command == uint<8>::from(static_cast<unsigned>(command));
  }
  static bool is_read(const LinkRequest& r) {
    return is(r, LinkCommand::kReadMemory) || is(r, LinkCommand::kReadRegisters);
  }

  /// Whether the board has what the request asks for.
  static bool possible(const LinkRequest& r) {
    const bool of_memory = is(r, LinkCommand::kWriteMemory) || is(r, LinkCommand::kReadMemory);
    const bool of_registers =
        is(r, LinkCommand::kWriteRegisters) || is(r, LinkCommand::kReadRegisters);
    const unsigned most = is(r, LinkCommand::kReadMemory)      ? kLinkReadBytes<Bytes>
                          : is(r, LinkCommand::kReadRegisters) ? 4 * kLinkReadWords
                                                               : kLinkDataBytes;
    const uint<32> both = r.address | uint<32>(r.length);
    const bool halves = !both.template bit<0>();
    const bool words = halves && !both.template bit<1>();
    const bool beats = both.template trunc<kBeatBits>() == uint<kBeatBits>(0);
    const bool aligned = is(r, LinkCommand::kWriteMemory)  ? halves
                         : is(r, LinkCommand::kReadMemory) ? beats
                                                           : words;
    const auto last = r.address + uint<16>::of_raw(r.length.raw() - 1u);
    const bool in_reach = of_memory ? last.template bits<32, kLinkAddressBits>() == uint<8>(0)
                                    : last.template bits<32, kBusAddressBits>() == uint<7>(0);
    return (of_memory || of_registers) && r.whole && aligned && in_reach &&
           r.length != uint<16>(0) && r.length <= uint<16>::from(most);
  }

  void identify(LinkJob& j) const {
    j.action = LinkAction::kIdentify;
    j.kind = uint<8>::from(kLinkAnswer | static_cast<unsigned>(LinkCommand::kIdentify));
    j.repeat = uint<9>::from(kLinkIdentityWords - 1);
    j.length = LinkLength::from(4 * kLinkIdentityWords);
    j.address = expected_;
  }
  static void carry_out(LinkJob& j, const LinkRequest& r) {
    const LinkLength length = r.length.template trunc<LinkLength::kWidth>();
    const auto before = LinkLength::from(length.raw() - 1u);
    j.kind = r.command | uint<8>::from(kLinkAnswer);
    if (is(r, LinkCommand::kWriteMemory)) {
      j.action = LinkAction::kWriteMemory;
      j.repeat = before.template trunc<9>();
    } else if (is(r, LinkCommand::kReadMemory)) {
      j.action = LinkAction::kReadMemory;
      j.length = length;
    } else if (is(r, LinkCommand::kWriteRegisters)) {
      j.action = LinkAction::kWriteRegisters;
      j.repeat = before.template trunc<9>();
    } else {
      j.action = LinkAction::kReadRegisters;
      j.repeat = before.template shr<2>().template trunc<9>();
      j.length = length;
    }
  }

  static constexpr unsigned kBeatBits = hls::index_width(Bytes);

  bool identified_ = false;
  uint<8> expected_;
};

}  // namespace dynrt
