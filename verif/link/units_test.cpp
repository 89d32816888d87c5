// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Each unit of the link: its RTL against its C++.
#include "Vlink_answer.h"
#include "Vlink_beats.h"
#include "Vlink_execute.h"
#include "Vlink_order.h"
#include "Vlink_receive.h"
#include "Vlink_registers.h"
#include "Vlink_serialise.h"
#include "Vlink_stuff.h"
#include "Vuart_receive.h"
#include "Vuart_send.h"
#include "link_answer_ports.h"
#include "link_beats_ports.h"
#include "link_execute_ports.h"
#include "link_order_ports.h"
#include "link_receive_ports.h"
#include "link_registers_ports.h"
#include "link_serialise_ports.h"
#include "link_stuff_ports.h"
#include "uart_receive_ports.h"
#include "uart_send_ports.h"
#include "unit/cosimulate.h"
#include "units/link.h"

namespace dynrt::cosim {
namespace {

constexpr unsigned kBytes = 16;
constexpr auto kAsTheyCome = [](auto&, const Run&) {};

DYNRT_COSIM(UartSend, UartSend, uart_send, kAsTheyCome)
DYNRT_COSIM(LinkBeats, LinkBeats<kBytes>, link_beats, kAsTheyCome)
DYNRT_COSIM(LinkRegisters, LinkRegisters<kBytes>, link_registers, kAsTheyCome)
DYNRT_COSIM(LinkStuff, LinkStuff, link_stuff, kAsTheyCome)
DYNRT_COSIM(LinkSerialise, LinkSerialise<kBytes>, link_serialise, kAsTheyCome)

/// Bytes with a random time between them; some bits are wrong.
void line(Bench<UartReceive>& bench, const Run& run) {
  bench.shape<LineDivisor>(
      "divisor", [&run](LineDivisor& d, Random&) { d = LineDivisor::from(4 + run.number); });
  bench.shape<uint<1>>("sample", [left = 0u, bits = 1u, number = run.number](
                                     uint<1>& sample, Random& random) mutable {
    const unsigned period = 4 + number;
    if (left == 0) {  // the stop bit, eight of data, the start bit; or an idle line
      const bool idle = random.below(4) == 0;
      bits = idle ? 0x3ff : 0x200 | static_cast<unsigned>(random.below(256)) << 1;
      left = 10 * period;
    }
    const unsigned bit = (10 * period - left--) / period;
    const bool wrong = random.below(200) == 0;
    sample = uint<1>(((bits >> bit & 1) != 0) != wrong);
  });
}
DYNRT_COSIM(UartReceive, UartReceive, uart_receive, line)

/// Frames that are whole, most of them; each is answered later.
class Frames {
 public:
  void next(LinkEvent& event, Random& random) {
    if (waiting_ > 0 && random.below(200) == 0) {
      event = {LinkEventKind::kFree, LinkLength::from(taken_[--waiting_])};
      return;
    }
    if (bytes_.empty()) begin(random);
    event = {random.below(2000) == 0 ? LinkEventKind::kBadByte : LinkEventKind::kByte,
             LinkLength::from(bytes_.back())};
    bytes_.pop_back();
  }

 private:
  void begin(Random& random) {
    const bool writes = random.below(2) == 0;
    const unsigned most = random.below(4) == 0 ? kLinkDataBytes : 24;
    const unsigned data = writes ? 1 + static_cast<unsigned>(random.below(most)) : 0;
    std::vector<unsigned> frame = {writes ? 2u : 3u, static_cast<unsigned>(random.below(256)),
                                   data % 256, data / 256};
    while (frame.size() < kLinkHeaderBytes + data) {
      frame.push_back(static_cast<unsigned>(random.below(256)));
    }
    if (random.below(16) == 0) frame.pop_back();
    Crc crc = kCrcStart;
    for (const unsigned byte : frame) crc = crc_step(crc, uint<8>::from(byte));
    for (unsigned i = 0; i < kLinkCrcBytes; ++i) {
      frame.push_back(static_cast<unsigned>((~crc).to_u64() >> (8 * i)) % 256);
    }
    if (random.below(8) == 0) frame[random.below(frame.size())] ^= 1u << random.below(8);
    bytes_ = {kLinkFlag};
    for (std::size_t i = frame.size(); i-- > 0;) {
      const bool escapes = frame[i] == kLinkFlag || frame[i] == kLinkEscape;
      bytes_.push_back(escapes ? frame[i] ^ kLinkEscaped : frame[i]);
      if (escapes) bytes_.push_back(kLinkEscape);
    }
    // Room that a frame without a mistake takes; where it had none, there is more than there was.
    if (waiting_ < kLinkWaiting) taken_[waiting_++] = data;
  }

  std::vector<unsigned> bytes_;  ///< that are still to come, the last one first
  std::array<unsigned, kLinkWaiting> taken_{};
  unsigned waiting_ = 0;
};
DYNRT_COSIM(LinkReceive, LinkReceive, link_receive, ([](Bench<LinkReceive>& bench, const Run&) {
              bench.shape<LinkEvent>("event", [frames = Frames()](LinkEvent& e, Random& r) mutable {
                frames.next(e, r);
              });
            }))

/// Requests near the number that is expected, most of them possible.
DYNRT_COSIM(LinkOrder, LinkOrder<kBytes>, link_order,
            ([](Bench<LinkOrder<kBytes>>& bench, const Run&) {
              bench.shape<LinkRequest>(
                  "request", [number = 0u](LinkRequest& r, Random& random) mutable {
                    r.good = random.below(16) != 0;
                    r.whole = random.below(16) != 0;
                    r.command = uint<8>::from(random.below(7));
                    if (random.below(2) == 0) ++number;
                    r.sequence = uint<8>::from(number + random.below(3));
                    if (random.below(8) != 0) {
                      r.length = uint<16>::from(r.length.to_u64() % 600 & ~15ull);
                      r.address = uint<32>::from(r.address.to_u64() % (1u << 27) & ~15ull);
                    }
                  });
            }))

/// A job's steps follow each other.
DYNRT_COSIM(LinkExecute, LinkExecute<kBytes>, link_execute,
            ([](Bench<LinkExecute<kBytes>>& bench, const Run&) {
              bench.shape<NumberedLinkJob>(
                  "job", [now = NumberedLinkJob{.index = {}, .last = true, .job = {}}](
                             NumberedLinkJob& n, Random& random) mutable {
                    if (now.last) {
                      now.job = n.job;
                      now.job.action = any_of<LinkAction>(random, 6);
                      now.job.repeat = uint<9>::from(random.below(40));
                      now.index = uint<9>(0);
                    } else {
                      now.index = hls::next(now.index);
                    }
                    now.last = now.index == now.job.repeat;
                    n = now;
                  });
            }))

DYNRT_COSIM(LinkAnswer, LinkAnswer<kBytes>, link_answer,
            ([](Bench<LinkAnswer<kBytes>>& bench, const Run&) {
              bench.shape<NumberedLinkReply>("reply", [](NumberedLinkReply& n, Random& random) {
                n.job.size = uint<6>::from(4 * random.below(5));
              });
            }))

}  // namespace
}  // namespace dynrt::cosim
