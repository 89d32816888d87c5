// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/cache.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <openssl/evp.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <stdexcept>

#include "host/app/progress.h"

namespace dynrt::host {

namespace fs = std::filesystem;

fs::path cache_folder() {
  const auto named = [](const char* variable) {
    const char* value = std::getenv(variable);
    return value == nullptr || *value == 0 ? fs::path() : fs::absolute(value);
  };
  if (const fs::path cache = named("DYNRT_CACHE"); !cache.empty()) return cache;
  if (const fs::path cache = named("XDG_CACHE_HOME"); !cache.empty()) return cache / "dynrt";
  const fs::path home = named("HOME");
  return home.empty() ? fs::path() : home / ".cache" / "dynrt";
}

std::string digest(const std::string& text) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> bytes;
  unsigned size = 0;
  if (EVP_Digest(text.data(), text.size(), bytes.data(), &size, EVP_sha256(), nullptr) != 1) {
    throw std::logic_error("OpenSSL has no SHA-256");
  }
  std::string hex;
  for (unsigned i = 0; i < size; ++i) hex += fmt::format("{:02x}", bytes[i]);
  return hex;
}

FileLock::FileLock(const fs::path& path)
    : file_(open(path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0666)) {
  if (file_ < 0 || flock(file_, LOCK_EX | LOCK_NB) == 0) return;
  const Progress progress("another program makes it; waiting");
  flock(file_, LOCK_EX);
}

FileLock::~FileLock() {
  if (file_ >= 0) close(file_);
}

}  // namespace dynrt::host
