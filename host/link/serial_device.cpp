// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/link/serial_device.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/serial.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "host/error.h"

namespace dynrt::host {

namespace {

constexpr char kDeviceGone[] =
    "board {}: the serial device was disconnected; leave the board connected and switched on";

constexpr char kNoSpeed[] =
    "board serial:{}: the device has no speed of {} bits a second; take an adapter that has";

constexpr char kNotSerial[] =
    "board serial:{}: this is no serial device; name one, such as /dev/ttyUSB0";

/// The name that termios has for a speed.
speed_t speed_of(const std::string& path, unsigned baud) {
  constexpr std::pair<unsigned, speed_t> kSpeeds[] = {
      {115'200, B115200},    {230'400, B230400},    {460'800, B460800},
      {921'600, B921600},    {1'000'000, B1000000}, {1'500'000, B1500000},
      {2'000'000, B2000000}, {3'000'000, B3000000}, {4'000'000, B4000000}};
  const auto* found = std::ranges::find(kSpeeds, baud, &std::pair<unsigned, speed_t>::first);
  if (found == std::end(kSpeeds)) refuse(kNoSpeed, path, baud);
  return found->second;
}

[[noreturn]] void refuse_failure(const std::string& path) {
  const int error = errno;
  switch (error) {
    case ENOENT:
    case ENODEV:
    case ENXIO:
    case ENOTDIR:
      refuse("board serial:{}: there is no such device; connect the board, or name its device",
             path);
    case EBUSY:
    case EWOULDBLOCK:
      refuse("board serial:{}: another program uses the device; end that program first", path);
    case EACCES:
    case EPERM:
      refuse(
          "board serial:{}: you may not open the device; join the group that owns it, often "
          "dialout",
          path);
    case EISDIR:
    case ENOTTY:
      refuse(kNotSerial, path);
    default:
      refuse("board serial:{}: the device fails: {}", path, std::strerror(error));
  }
}

int open_device(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) refuse_failure(path);
  return file;
}

}  // namespace

SerialDevice::File::~File() { ::close(number_); }

SerialDevice::Lock::Lock(int file, const std::string& path) : file_(file) {
  if (::isatty(file) == 0) refuse(kNotSerial, path);
  // The first keeps out programs that ask for this lock, even root's; the second all others.
  if (::flock(file, LOCK_EX | LOCK_NB) != 0 || ::ioctl(file, TIOCEXCL) != 0) refuse_failure(path);
}
SerialDevice::Lock::~Lock() { ::ioctl(file_, TIOCNXCL); }

SerialDevice::SerialDevice(const std::string& path, unsigned baud)
    : ByteStream("serial:" + path),
      file_(open_device(path)),
      lock_(file_.number(), path),
      settings_(file_.number()) {
  set_up(path, baud);
}

SerialDevice::~SerialDevice() = default;

void SerialDevice::set_up(const std::string& path, unsigned baud) {
  const speed_t speed = speed_of(path, baud);
  termios raw{};
  if (::tcgetattr(file_.number(), &raw) != 0) refuse_failure(path);
  ::cfmakeraw(&raw);
  raw.c_cflag |= CLOCAL | CREAD;
  raw.c_cflag &= ~static_cast<tcflag_t>(CSTOPB | CRTSCTS | HUPCL);
  raw.c_cc[VMIN] = 0;
  raw.c_cc[VTIME] = 0;
  termios now{};
  if (::cfsetspeed(&raw, speed) != 0 || ::tcsetattr(file_.number(), TCSANOW, &raw) != 0 ||
      ::tcgetattr(file_.number(), &now) != 0 || ::cfgetospeed(&now) != speed) {
    refuse(kNoSpeed, path, baud);
  }
  // A USB adapter hands over a few bytes at once, not after 16 ms; other devices know no such
  // thing.
  serial_struct serial{};
  if (::ioctl(file_.number(), TIOCGSERIAL, &serial) == 0) {
    serial.flags |= ASYNC_LOW_LATENCY;
    ::ioctl(file_.number(), TIOCSSERIAL, &serial);
  }
  ::tcflush(file_.number(), TCIOFLUSH);
}

std::size_t SerialDevice::write(std::span<const std::uint8_t> bytes) {
  const ssize_t written = ::write(file_.number(), bytes.data(), bytes.size());
  if (written >= 0) return static_cast<std::size_t>(written);
  if (errno == EAGAIN || errno == EINTR) return 0;
  refuse(kDeviceGone, name());
}

std::size_t SerialDevice::read(std::span<std::uint8_t> bytes) {
  const ssize_t read = ::read(file_.number(), bytes.data(), bytes.size());
  if (read > 0 || (read == 0 && !hung_up_)) return static_cast<std::size_t>(read);
  if (read == 0) refuse(kDeviceGone, name());
  if (errno == EAGAIN || errno == EINTR) return 0;
  refuse(kDeviceGone, name());
}

void SerialDevice::wait(bool to_write, Time deadline) {
  using std::chrono::milliseconds;
  pollfd poll{.fd = file_.number(), .events = POLLIN, .revents = 0};
  if (to_write) poll.events |= POLLOUT;
  const Time left = std::max(deadline - now(), Time(0));
  const auto timeout = std::chrono::ceil<milliseconds>(left).count();
  const int ready = ::poll(&poll, 1, static_cast<int>(timeout));
  if (ready < 0 && errno != EINTR) refuse(kDeviceGone, name());
  hung_up_ = ready > 0 && (poll.revents & (POLLHUP | POLLERR | POLLNVAL)) != 0;
}

ByteStream::Time SerialDevice::now() const {
  return std::chrono::steady_clock::now().time_since_epoch();
}

}  // namespace dynrt::host
