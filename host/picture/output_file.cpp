// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/picture/output_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <regex>

#include "host/error.h"
#include "host/picture/picture_messages.h"

namespace dynrt::host {

namespace {

namespace fs = std::filesystem;

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// The same for all names of a file, whether it is there or not.
fs::path place_of(const fs::path& path) { return fs::weakly_canonical(fs::absolute(path)); }

/// A hidden name of this process in the folder of `path`, with the same extension.
std::string temporary_for(const fs::path& path) {
  return folder_of(path) /
         fmt::format(".{}.{}{}", path.stem().string(), getpid(), path.extension().string());
}

/// The half-written files that killed processes have left of this file.
void remove_abandoned(const fs::path& path) {
  std::error_code error;
  fs::directory_iterator at(folder_of(path), error);
  for (; !error && at != fs::directory_iterator(); at.increment(error)) {
    if (abandoned(at->path()) != path.filename()) continue;
    std::error_code gone;
    fs::remove(at->path(), gone);
  }
}

}  // namespace

std::string abandoned(const fs::path& file) {
  static const std::regex pattern(R"(\.(.+)\.(\d+)(\.[^.]*)?)");
  std::smatch match;
  const std::string name = file.filename().string();
  if (!std::regex_match(name, match, pattern)) return {};
  const bool gone = kill(std::atoi(match[2].str().c_str()), 0) != 0 && errno == ESRCH;
  return gone ? match[1].str() + match[3].str() : std::string();
}

UnfinishedFile::UnfinishedFile(std::string path)
    : path_(std::move(path)), interrupted_(std::in_place, remove, path_.c_str()) {}

UnfinishedFile::~UnfinishedFile() {
  if (interrupted_) unlink(path_.c_str());
}

void UnfinishedFile::keep() { interrupted_.reset(); }

void UnfinishedFile::remove(const void* path) { unlink(static_cast<const char*>(path)); }

void cannot_write(const std::string& path, const std::string& reason) {
  refuse(messages::kCannotWrite, path, reason);
}

bool ends_with(const std::string& path, std::string_view end) {
  std::ifstream file(path, std::ios::binary);
  std::string found(end.size(), '\0');
  file.seekg(-static_cast<std::streamoff>(end.size()), std::ios::end);
  return file.read(found.data(), static_cast<std::streamsize>(found.size())) && found == end;
}

void check_end(const std::string& file, std::string_view end, const std::string& path) {
  if (!ends_with(file, end)) cannot_write(path, "it is cut off; is the disk full?");
}

void check_outputs(std::span<const Output> outputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (outputs[i].path.empty()) continue;
    const std::string extension = fs::path(outputs[i].path).extension().string();
    if (outputs[i].is_picture && extension != ".png" && extension != ".exr") {
      refuse("{}: dynrt does not write the image format '{}'; the name must end in .png or .exr",
             outputs[i].path, extension);
    }
    for (const Output& other : outputs.first(i)) {
      if (!other.path.empty() && place_of(outputs[i].path) == place_of(other.path)) {
        refuse("{} {}: {} writes the same file; name another file", outputs[i].flag,
               outputs[i].path, other.flag);
      }
    }
    check_output_path(outputs[i].path);
    remove_abandoned(outputs[i].path);
  }
}

void check_output_path(const std::string& path) {
  const fs::path folder = folder_of(path);
  std::error_code unreachable;
  if (!fs::is_directory(folder, unreachable)) {
    refuse("{}: there is no folder '{}'; create it or name a file elsewhere", path,
           folder.string());
  }
  if (fs::is_directory(path, unreachable)) cannot_write(path, std::strerror(EISDIR));
  // Only trying tells: a folder may be read-only for reasons that its permissions do not show.
  const UnfinishedFile probe(temporary_for(path));
  errno = 0;
  if (std::ofstream(probe.path())) return;
  // The folder is there: this is how one that holds no files of ours, such as /proc, says so.
  cannot_write(path, errno == ENOENT ? "its folder cannot be written" : std::strerror(errno));
}

void write_whole(const std::string& path,
                 const std::function<void(const std::string& temporary)>& write) {
  UnfinishedFile file(temporary_for(path));
  write(file.path());
  std::error_code error;
  fs::rename(file.path(), path, error);
  if (error) cannot_write(path, error.message());
  file.keep();
}

void write_bytes(const std::string& path, std::string_view bytes) {
  write_whole(path, [&](const std::string& temporary) {
    std::ofstream file(temporary, std::ios::binary);
    file << bytes;
    file.close();
    if (!file) cannot_write(path, std::strerror(errno));
  });
}

void write_text(const std::string& path, const std::string& text) { write_bytes(path, text); }

}  // namespace dynrt::host
