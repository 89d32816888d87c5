// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A zip file as Assimp's file system, so that a model inside finds the material file next to it.
#pragma once

#include <zip.h>

#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dynrt::host {

class ZipLibrary : public Assimp::IOSystem {
 public:
  /// Throws UserError if the zip file cannot be read; `remedy` ends its sentence.
  ZipLibrary(const std::string& path, std::string remedy);

  std::vector<std::string> names() const;  ///< of all files

  /// Nothing if there is no such file inside; throws UserError if it cannot be unpacked.
  std::optional<std::string> read(const std::string& name) const;

  bool Exists(const char* name) const override;
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* name, const char* mode) override;
  void Close(Assimp::IOStream* stream) override;

 private:
  struct Discard {
    void operator()(zip_t* archive) const { zip_discard(archive); }
  };

  std::string path_, remedy_;
  std::unique_ptr<zip_t, Discard> archive_;
};

}  // namespace dynrt::host
