// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A simulated ULX3S: the whole of ulx3s_board in Verilator, with what stands at its pins: the
// SDRAM chip, the host's end of the serial line, and a DVI monitor. Its time runs only while
// somebody waits for bytes or lets it run.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "host/board/frame_meter.h"
#include "host/link/byte_stream.h"
#include "host/ulx3s/linked_board.h"
#include "sdram/sdram_chip.h"

namespace dynrt::host {

class SimulatedUlx3s : public ByteStream, public BackDoor {
 public:
  virtual void run(Time time) = 0;
  /// The frames that the monitor has seen whole since the last call.
  virtual std::vector<DisplayFrame> take_frames() = 0;
  /// Of the memory's chip. What it forbids and has seen is in its faults.
  virtual const verif::SdramChip& chip() const = 0;

 protected:
  using ByteStream::ByteStream;
};

/// Resets the board and waits until its memory is set up.
std::unique_ptr<SimulatedUlx3s> make_simulated_ulx3s();

}  // namespace dynrt::host
