// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Loaded before a program, makes its monotonic clock that of a simulated board: nanoseconds in the
// file that DYNRT_BOARD_CLOCK names. So a program waits for a board, whose second takes minutes, as
// long as it would for a real one.
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <atomic>
#include <cstdint>
#include <cstdlib>

namespace {

using Clock = std::atomic<std::uint64_t>;
static_assert(Clock::is_always_lock_free && sizeof(Clock) == sizeof(std::uint64_t));

const Clock* board_clock() {
  const char* const path = std::getenv("DYNRT_BOARD_CLOCK");
  const int file = path == nullptr ? -1 : ::open(path, O_RDONLY | O_CLOEXEC);
  if (file < 0) ::abort();
  void* const mapped = ::mmap(nullptr, sizeof(Clock), PROT_READ, MAP_SHARED, file, 0);
  ::close(file);
  if (mapped == MAP_FAILED) ::abort();
  return static_cast<const Clock*>(mapped);
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): it takes the place of the library's
extern "C" int clock_gettime(clockid_t id, timespec* time) noexcept {
  if (id != CLOCK_MONOTONIC) return static_cast<int>(::syscall(SYS_clock_gettime, id, time));
  static const Clock* const clock = board_clock();
  constexpr std::uint64_t kSecond = 1'000'000'000;
  const std::uint64_t now = clock->load();
  *time = {.tv_sec = static_cast<time_t>(now / kSecond),
           .tv_nsec = static_cast<long>(now % kSecond)};
  return 0;
}
