// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A simulated ULX3S: the whole of ulx3s_board in Verilator, with models of the parts at its pins:
// the SDRAM chip, the host's end of the serial line, and a DVI monitor. Its time runs only while a
// caller waits for bytes or calls run().
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "host/board/frame_meter.h"
#include "host/link/byte_stream.h"
#include "host/ulx3s/linked_board.h"

namespace dynrt::host {

/// The traffic at the pins of the SDRAM since the board was set up.
struct SdramUse {
  std::uint64_t clocks = 0;
  std::uint64_t words_read = 0;  ///< of 16 bits, each a clock of the data pins
  std::uint64_t words_written = 0;
  std::uint64_t activations = 0;
  std::uint64_t refreshes = 0;
};

class SimulatedUlx3s : public ByteStream, public BackDoor {
 public:
  using BackDoor::read;
  using BackDoor::write;
  using ByteStream::read;
  using ByteStream::write;

  virtual void run(Time time) = 0;
  /// The frames that the monitor has seen whole since the last call.
  virtual std::vector<DisplayFrame> take_frames() = 0;
  virtual SdramUse memory_use() const = 0;

 protected:
  using ByteStream::ByteStream;
};

/// Resets the board and waits until its memory is set up. Throws UserError if this build has not
/// its Verilog (verif/ulx3s has the simulation).
std::unique_ptr<SimulatedUlx3s> make_simulated_ulx3s();

}  // namespace dynrt::host
