// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/zip_library.h"

#include <filesystem>

#include "host/error.h"
#include "host/scene/memory_files.h"
#include "host/scene/scene_messages.h"

namespace dynrt::host {

namespace {

constexpr zip_uint64_t kLargest = 1u << 30;  // a model beyond a gigabyte is none of ours

// Assimp asks for files of the folder "a/b" as "a/b/c" or "a/b/./c".
std::string normal(const std::string& name) {
  return std::filesystem::path(name).lexically_normal().generic_string();
}

}  // namespace

ZipLibrary::ZipLibrary(const std::string& path, std::string remedy)
    : path_(path), remedy_(std::move(remedy)) {
  int code = 0;
  archive_.reset(zip_open(path.c_str(), ZIP_RDONLY, &code));
  if (archive_) return;
  zip_error_t error;
  zip_error_init_with_code(&error, code);
  const std::string reason = zip_error_strerror(&error);
  zip_error_fini(&error);
  refuse(messages::kBadLibrary, path, reason, remedy_);
}

std::vector<std::string> ZipLibrary::names() const {
  std::vector<std::string> names;
  const zip_int64_t count = zip_get_num_entries(archive_.get(), 0);
  for (zip_int64_t i = 0; i < count; ++i) {
    const char* name = zip_get_name(archive_.get(), static_cast<zip_uint64_t>(i), 0);
    if (name != nullptr) names.emplace_back(name);
  }
  return names;
}

std::optional<std::string> ZipLibrary::read(const std::string& name) const {
  zip_stat_t stat;
  if (zip_stat(archive_.get(), normal(name).c_str(), 0, &stat) != 0) return std::nullopt;
  if (stat.size > kLargest) refuse(messages::kBadLibrary, path_, name + " is too large", remedy_);
  const auto close = [](zip_file_t* file) { zip_fclose(file); };
  const std::unique_ptr<zip_file_t, decltype(close)> file(
      zip_fopen_index(archive_.get(), stat.index, 0), close);
  std::string text(stat.size, '\0');
  if (!file ||
      zip_fread(file.get(), text.data(), stat.size) != static_cast<zip_int64_t>(stat.size)) {
    refuse(messages::kBadLibrary, path_, name + " cannot be unpacked", remedy_);
  }
  return text;
}

bool ZipLibrary::Exists(const char* name) const {
  return zip_name_locate(archive_.get(), normal(name).c_str(), 0) >= 0;
}

Assimp::IOStream* ZipLibrary::Open(const char* name, const char* /*mode*/) {
  std::optional<std::string> text = read(name);
  return text ? new OwnedStream(std::move(*text)) : nullptr;
}

void ZipLibrary::Close(Assimp::IOStream* stream) { delete stream; }

}  // namespace dynrt::host
