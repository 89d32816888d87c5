// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The settings that a serial line had, which are put back when this object dies, and when a signal
// ends the program meanwhile.
#pragma once

#include <linux/serial.h>
#include <termios.h>

#include "host/at_interrupt.h"

namespace dynrt::host {

class LineSettings {
 public:
  /// Of an open device, which outlives this object.
  explicit LineSettings(int file);
  ~LineSettings();
  LineSettings(const LineSettings&) = delete;
  LineSettings& operator=(const LineSettings&) = delete;

 private:
  static void put_back(const void* settings);

  int file_;
  termios line_{};
  bool has_line_;
  serial_struct serial_{};
  bool has_serial_;  ///< a pseudo-terminal has none
  AtInterrupt interrupted_;
};

}  // namespace dynrt::host
