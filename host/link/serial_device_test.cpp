// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The device is a pseudo-terminal, whose other end the test holds.
#include "host/link/serial_device.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <string>
#include <vector>

#include "host/error.h"

namespace dynrt::host {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;

/// The other end.
class OtherEnd {
 public:
  OtherEnd() : file_(::posix_openpt(O_RDWR | O_NOCTTY)) {
    EXPECT_GE(file_, 0);
    EXPECT_EQ(::grantpt(file_), 0);
    EXPECT_EQ(::unlockpt(file_), 0);
    path = ::ptsname(file_);
  }
  ~OtherEnd() { end(); }
  OtherEnd(const OtherEnd&) = delete;
  OtherEnd& operator=(const OtherEnd&) = delete;
  void end() {
    if (file_ >= 0) ::close(file_);
    file_ = -1;
  }
  void send(const Bytes& bytes) const {
    ASSERT_EQ(::write(file_, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
  }
  Bytes receive() const {
    Bytes bytes(4096);
    const ssize_t count = ::read(file_, bytes.data(), bytes.size());
    bytes.resize(count < 0 ? 0 : static_cast<std::size_t>(count));
    return bytes;
  }
  std::string path;

 private:
  int file_;
};

std::string refusal(const std::string& path, unsigned baud = kLinkBaud) {
  try {
    const SerialDevice device(path, baud);
    return "none";
  } catch (const UserError& error) {
    return error.what();
  }
}

Bytes all_bytes() {
  Bytes bytes;
  for (unsigned i = 0; i < 256; ++i) bytes.push_back(static_cast<std::uint8_t>(i));
  return bytes;
}

TEST(SerialDevice, CarriesEveryByteAsItIs) {
  const OtherEnd other;
  SerialDevice device(other.path);
  ASSERT_EQ(device.write(all_bytes()), 256u);
  EXPECT_EQ(other.receive(), all_bytes());
  other.send(all_bytes());
  Bytes received;
  while (received.size() < 256) {
    device.wait(false, device.now() + 10s);
    Bytes some(256);
    const std::size_t count = device.read(some);
    ASSERT_GT(count, 0u);
    received.insert(received.end(), some.begin(),
                    some.begin() + static_cast<std::ptrdiff_t>(count));
  }
  EXPECT_EQ(received, all_bytes());
}

TEST(SerialDevice, WaitsNoLongerThanAsked) {
  const OtherEnd other;
  SerialDevice device(other.path);
  const auto begin = device.now();
  device.wait(false, begin + 20ms);
  EXPECT_GE(device.now() - begin, 20ms);
  std::array<std::uint8_t, 10> bytes{};
  EXPECT_EQ(device.read(bytes), 0u);
  device.wait(true, begin + 100s);  // there is room to write
}

TEST(SerialDevice, RefusesWhatIsNoDevice) {
  EXPECT_THAT(refusal("/dev/no_such_device"),
              HasSubstr("/dev/no_such_device: there is no such device"));
  EXPECT_THAT(refusal("/dev/null/device"), HasSubstr("there is no such device"));
  EXPECT_THAT(refusal("/dev/null"), HasSubstr("this is no serial device"));
  EXPECT_THAT(refusal("/tmp"), HasSubstr("this is no serial device"));
  const OtherEnd other;
  EXPECT_THAT(refusal(other.path, 12'345), HasSubstr("no speed of 12345 bits"));
}

TEST(SerialDevice, RefusesOneThatIsInUseUntilItIsReleased) {
  const OtherEnd other;
  {
    const SerialDevice first(other.path);
    EXPECT_THAT(refusal(other.path), HasSubstr("another program uses the device"));
    EXPECT_THAT(refusal(other.path), HasSubstr("another program uses the device"))
        << "a refusal does not release it";
  }
  EXPECT_EQ(refusal(other.path), "none");
  const int by_another = ::open(other.path.c_str(), O_RDWR | O_NOCTTY);
  ASSERT_GE(by_another, 0) << "it is open to all again";
  ASSERT_EQ(::flock(by_another, LOCK_EX | LOCK_NB), 0);
  EXPECT_THAT(refusal(other.path), HasSubstr("another program uses the device"));
  ::close(by_another);
}

TEST(SerialDevice, LeavesTheDeviceAsItWas) {
  const OtherEnd other;
  const int look = ::open(other.path.c_str(), O_RDWR | O_NOCTTY);
  termios before{};
  ASSERT_EQ(::tcgetattr(look, &before), 0);
  {
    const SerialDevice device(other.path);
    termios raw{};
    ASSERT_EQ(::tcgetattr(look, &raw), 0);
    EXPECT_EQ(::cfgetospeed(&raw), static_cast<speed_t>(B3000000));
    EXPECT_EQ(raw.c_lflag & (ICANON | ECHO), 0u);
  }
  termios after{};
  ASSERT_EQ(::tcgetattr(look, &after), 0);
  EXPECT_EQ(after.c_lflag, before.c_lflag);
  EXPECT_EQ(::cfgetospeed(&after), ::cfgetospeed(&before));
  ::close(look);
}

TEST(SerialDevice, LeavesItAsItWasIfASignalEndsTheProgram) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const OtherEnd other;
    const int look = ::open(other.path.c_str(), O_RDWR | O_NOCTTY);
    termios before{};
    ASSERT_EQ(::tcgetattr(look, &before), 0);
    EXPECT_EXIT(
        {
          const SerialDevice device(other.path);
          termios raw{};
          if (::tcgetattr(look, &raw) != 0 || raw.c_lflag == before.c_lflag) std::exit(1);
          std::raise(signal);
        },
        testing::KilledBySignal(signal), "");
    termios after{};
    ASSERT_EQ(::tcgetattr(look, &after), 0);
    EXPECT_EQ(after.c_lflag, before.c_lflag);
    EXPECT_EQ(::cfgetospeed(&after), ::cfgetospeed(&before));
    EXPECT_EQ(refusal(other.path), "none") << "it is released";
    int exclusive = 1;
    ASSERT_EQ(::ioctl(look, TIOCGEXCL, &exclusive), 0);
    EXPECT_EQ(exclusive, 0);
    ::close(look);
  }
}

TEST(SerialDevice, SaysThatTheLineIsNoMore) {
  OtherEnd other;
  SerialDevice device(other.path);
  other.end();
  std::array<std::uint8_t, 10> bytes{};
  try {
    device.wait(false, device.now() + 10s);
    device.read(bytes);
    ADD_FAILURE() << "it reads on";
  } catch (const UserError& error) {
    EXPECT_THAT(error.what(), HasSubstr("was disconnected"));
  }
}

}  // namespace
}  // namespace dynrt::host
