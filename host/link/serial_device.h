// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A serial device, or the end of a pseudo-terminal, as a line to a board: raw, eight data bits, no
// parity, one stop bit. No other program can use it meanwhile; it is released as it was, whatever
// ends the program.
#pragma once

#include <string>

#include "host/link/byte_stream.h"
#include "host/link/line_settings.h"
#include "units/link_format.h"

namespace dynrt::host {

class SerialDevice final : public ByteStream {
 public:
  /// Throws UserError if there is no such device, it is in use, or it has not that speed.
  explicit SerialDevice(const std::string& path, unsigned baud = kLinkBaud);
  ~SerialDevice() override;
  SerialDevice(const SerialDevice&) = delete;
  SerialDevice& operator=(const SerialDevice&) = delete;

  std::size_t write(std::span<const std::uint8_t> bytes) override;
  std::size_t read(std::span<std::uint8_t> bytes) override;
  void wait(bool to_write, Time deadline) override;
  Time now() const override;

 private:
  /// A file that is closed in any case.
  class File {
   public:
    explicit File(int number) : number_(number) {}
    ~File();
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    int number() const { return number_; }

   private:
    int number_;
  };

  /// No other program opens the device until it ends.
  class Lock {
   public:
    Lock(int file, const std::string& path);
    ~Lock();
    Lock(const Lock&) = delete;
    Lock& operator=(const Lock&) = delete;

   private:
    int file_;
  };

  void set_up(const std::string& path, unsigned baud);

  File file_;
  Lock lock_;
  LineSettings settings_;  ///< put back before the device is closed
  bool hung_up_ = false;
};

}  // namespace dynrt::host
