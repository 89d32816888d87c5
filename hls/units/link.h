// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The board's end of the serial line: frames come in, reads and writes of memory and registers go
// out, their answers come back and leave as frames (units/link_format.h). A beat of the memory has
// `Bytes` bytes. Requests are carried out one after another, each answered before the next begins.
// A read that the memory takes behind a write must see what was written.
//
// With LinkLine::kBytes the ends of the line are bytes, for models that count no bits: events go
// into `link_receive.event`, and `bytes` come out.
#pragma once

#include <memory>
#include <vector>

#include "hls/join.h"
#include "units/link_answer.h"
#include "units/link_data.h"
#include "units/link_execute.h"
#include "units/link_order.h"
#include "units/link_receive.h"
#include "units/link_serialise.h"
#include "units/link_stuff.h"
#include "units/uart_receive.h"
#include "units/uart_send.h"

namespace dynrt {

enum class LinkLine { kBits, kBytes };

template <unsigned Bytes>
struct Link {
  UartReceive uart_receive;
  LinkReceive link_receive;
  LinkOrder<Bytes> link_order;
  LinkExecute<Bytes> link_execute;
  LinkBeats<Bytes> link_beats;
  LinkRegisters<Bytes> link_registers;
  LinkAnswer<Bytes> link_answer;
  LinkSerialise<Bytes> link_serialise;
  LinkStuff link_stuff;
  UartSend uart_send;

  std::shared_ptr<hls::Fifo<uint<1>>> sample, bit;
  std::shared_ptr<hls::Fifo<LineByte>> bytes;
  std::shared_ptr<hls::Fifo<LinkWrite<Bytes>>> write;
  std::shared_ptr<hls::Fifo<LinkRead>> read;
  std::shared_ptr<hls::Fifo<LinkBeat<Bytes>>> beat;
  std::shared_ptr<hls::Fifo<BusAccess>> access;
  std::shared_ptr<hls::Fifo<uint<32>>> word;
  std::shared_ptr<LinkWords> identity = std::make_shared<LinkWords>();
  std::shared_ptr<LineDivisor> divisor = std::make_shared<LineDivisor>();

  explicit Link(hls::Join& join, LinkLine line = LinkLine::kBits) {
    name_units(join, line);
    join_line(join, line);
    join_requests(join);
    join_answers(join);
    join.leave_out_counters();
  }

  /// Joins nothing yet: for tools that only list the units.
  Link() = default;

  template <class J>
  void name_units(J& join, LinkLine line = LinkLine::kBits) {
    if (line == LinkLine::kBits) join.unit("uart_receive", "uart_receive", uart_receive);
    join.unit("link_receive", "link_receive", link_receive);
    join.unit("link_order", "link_order", link_order);
    join.unit("link_execute", "link_execute", link_execute);
    join.unit("link_beats", "link_beats", link_beats);
    join.unit("link_registers", "link_registers", link_registers);
    join.unit("link_answer", "link_answer", link_answer);
    join.unit("link_serialise", "link_serialise", link_serialise);
    join.unit("link_stuff", "link_stuff", link_stuff);
    if (line == LinkLine::kBits) join.unit("uart_send", "uart_send", uart_send);
  }

 private:
  void join_line(hls::Join& join, LinkLine line) {
    if (line == LinkLine::kBytes) {
      join.channel("event", link_answer.free, link_receive.event);
      bytes = join.output("byte", link_stuff.out);
      return;
    }
    sample = join.input("sample", uart_receive.sample);
    join.config("divisor", divisor, std::vector{&uart_receive.divisor});
    join.channel<LinkEvent>("event", {&uart_receive.event, &link_answer.free},
                            {&link_receive.event});
    join.repeat("bit_of_byte", hls::Writers{&link_stuff.out}, uart_send.byte);
    bit = join.output("bit", uart_send.bit);
  }

  void join_requests(hls::Join& join) {
    join.ram("ring", link_receive.ring, std::vector{&link_execute.ring});
    join.channel("request", link_receive.request, link_order.request, kLinkWaiting);
    join.channel<uint<1>>("turn", {&link_receive.turn, &link_answer.turn}, {&link_order.turn});
    join.repeat("step_of_job", hls::Writers{&link_order.job}, link_execute.job);
    join.config("identity", identity, std::vector{&link_execute.identity});
    write = join.output("write", link_execute.write);
    read = join.output("read", link_execute.read);
    beat = join.input("beat", link_beats.beat);
    access = join.output("access", link_execute.access);
    word = join.input("word", link_registers.word);
  }

  void join_answers(hls::Join& join) {
    join.repeat("data_of_reply", hls::Writers{&link_execute.reply}, link_answer.reply);
    join.channel<LinkData<Bytes>>("data",
                                  {&link_execute.data, &link_beats.data, &link_registers.data},
                                  {&link_answer.data}, kReplyTokens);
    join.repeat("byte_of_part", hls::Writers{&link_answer.part}, link_serialise.part);
    join.repeat("twice", hls::Writers{&link_serialise.byte}, link_stuff.byte);
  }
};

}  // namespace dynrt
