// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Files in memory for Assimp: a file repaired before Assimp reads it, or a file from a zip library.
#pragma once

#include <assimp/MemoryIOWrapper.h>

#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <memory>
#include <string>
#include <string_view>

namespace dynrt::host {

/// A stream of bytes that it owns.
class OwnedStream : public Assimp::MemoryIOStream {
 public:
  explicit OwnedStream(std::string bytes);

 private:
  explicit OwnedStream(std::unique_ptr<std::string> bytes);

  std::unique_ptr<std::string> bytes_;
};

/// Another file system, in which one file has other content. Both must outlive this.
class OneFileReplaced : public Assimp::IOSystem {
 public:
  OneFileReplaced(Assimp::IOSystem& others, std::string path, std::string_view content)
      : others_(others), path_(std::move(path)), content_(content) {}

  bool Exists(const char* name) const override;
  char getOsSeparator() const override { return others_.getOsSeparator(); }
  Assimp::IOStream* Open(const char* name, const char* mode) override;
  void Close(Assimp::IOStream* stream) override { delete stream; }

 private:
  Assimp::IOSystem& others_;
  const std::string path_;
  const std::string_view content_;
};

}  // namespace dynrt::host
