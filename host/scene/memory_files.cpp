// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/memory_files.h"

#include <cstdint>
#include <memory>
#include <utility>

namespace dynrt::host {

namespace {

Assimp::MemoryIOStream* view_of(std::string_view bytes) {
  return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(bytes.data()),
                                    bytes.size());
}

}  // namespace

OwnedStream::OwnedStream(std::string bytes)
    : OwnedStream(std::make_unique<std::string>(std::move(bytes))) {}

OwnedStream::OwnedStream(std::unique_ptr<std::string> bytes)
    : MemoryIOStream(reinterpret_cast<const std::uint8_t*>(bytes->data()), bytes->size()),
      bytes_(std::move(bytes)) {}

bool OneFileReplaced::Exists(const char* name) const {
  return name == path_ || others_.Exists(name);
}

Assimp::IOStream* OneFileReplaced::Open(const char* name, const char* mode) {
  return name == path_ ? view_of(content_) : others_.Open(name, mode);
}

}  // namespace dynrt::host
