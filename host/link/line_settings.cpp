// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/link/line_settings.h"

#include <sys/ioctl.h>

namespace dynrt::host {

LineSettings::LineSettings(int file)
    : file_(file),
      has_line_(::tcgetattr(file, &line_) == 0),
      has_serial_(::ioctl(file, TIOCGSERIAL, &serial_) == 0),
      interrupted_(put_back, this) {}

LineSettings::~LineSettings() { put_back(this); }

void LineSettings::put_back(const void* settings) {
  const auto& was = *static_cast<const LineSettings*>(settings);
  ::tcflush(was.file_, TCIOFLUSH);  // what is not sent yet would hold up the close
  if (was.has_serial_) ::ioctl(was.file_, TIOCSSERIAL, &was.serial_);
  ::ioctl(was.file_, TIOCNXCL);  // of serial_device.cpp, where the device outlives its files
  if (was.has_line_) ::tcsetattr(was.file_, TCSANOW, &was.line_);
}

}  // namespace dynrt::host
