// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A board at the end of a link, with the bus operations that RtlBoard uses. Accesses to registers
// go over the link. Words of the window go into the board's memory, at the addresses of the port
// (host/format/port_address.h). Words that the host writes are sent when a frame starts, and only
// those that differ from the board's.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "host/board/board.h"
#include "host/board/bus.h"
#include "host/board/clocked_board.h"
#include "host/link/link.h"
#include "host/link/upload_plan.h"

namespace dynrt::host {

/// Direct access to the memory of a simulated board, which saves the time of the link.
class BackDoor {
 public:
  virtual ~BackDoor() = default;
  virtual void write(std::uint32_t address, std::span<const std::uint8_t> bytes) = 0;
  virtual void read(std::uint32_t address, std::span<std::uint8_t> bytes) = 0;
};

class LinkedBoard final : public ClockedBoard {
 public:
  /// Called while the board works on a frame, before its state is asked for again.
  using Pause = std::function<void()>;

  /// With `door`, which outlives the board, transfers of the memory bypass the link.
  LinkedBoard(std::unique_ptr<BoardLink> link, BackDoor* door, Pause pause);

  void reset() override {}
  bool write(std::uint32_t address, std::span<const std::uint32_t> words) override;
  bool read(std::uint32_t address, std::span<std::uint32_t> words) override;
  bool run_until_interrupt(std::uint64_t limit) override;
  bool interrupt() const override { return interrupt_; }
  std::uint64_t clocks() const override { return clocks_; }
  void watch(VgaMonitor* /*monitor*/) override {}
  std::optional<std::uint64_t> frame_writes() const override { return std::nullopt; }

  /// Reports transfers of the memory.
  void report_transfers(TransferProgress progress) { progress_ = std::move(progress); }
  /// A progress function for the link, for a transfer of `total` bytes called `what`.
  LinkProgress progress_of(std::string_view what, std::uint64_t total) const;
  /// Counts bytes of the memory that did not come over the line as if they had.
  void count_read(std::uint64_t bytes);
  /// Sends the words written to the window that differ from the board's.
  void send_memory();
  /// Bytes of the memory that were sent.
  std::uint64_t uploaded() const { return uploaded_; }
  /// The traffic on the line, including transfers that bypassed it.
  BusTraffic traffic() const;
  double clock_hz() const { return link_->board().clock_hz; }
  unsigned pixel_mhz() const { return link_->board().pixel_mhz; }  ///< 0: it has no display
  const LinkCounts& counts() const { return link_->counts(); }

 private:
  void spare_line(const LineCost& cost);
  void write_window(unsigned bank, std::uint32_t word, std::span<const std::uint32_t> words);
  void read_window(unsigned bank, std::uint32_t word, std::span<std::uint32_t> words);
  /// Bytes of the board's memory, kept until the next frame starts.
  std::span<const std::uint8_t> memory(std::uint32_t address, std::size_t bytes);

  std::unique_ptr<BoardLink> link_;
  BackDoor* door_;
  Pause pause_;
  TransferProgress progress_;
  std::optional<std::uint32_t> counter_;            ///< the address of the one to be read
  std::map<std::uint32_t, std::uint32_t> written_;  ///< words to be sent, by the byte's address
  UploadPlan plan_;
  std::uint64_t uploaded_ = 0;
  std::uint64_t bytes_written_ = 0, bytes_read_ = 0;    ///< of memory and registers
  std::uint64_t frames_beside_ = 0, bytes_beside_ = 0;  ///< that a back door saved the line
  MemoryBytes kept_;
  bool interrupt_ = false;
  std::uint64_t clocks_ = 0;
};

}  // namespace dynrt::host
