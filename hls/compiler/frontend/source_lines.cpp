// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "frontend/source_lines.h"

#include <filesystem>

namespace hlsc {

namespace fs = std::filesystem;

SourceLines::SourceLines(const std::vector<std::string>& include_folders) {
  for (const std::string& folder : include_folders) {
    folders_.push_back((fs::absolute(folder) / "").lexically_normal().string());
  }
}

const SourceLines::File& SourceLines::file(const llvm::DIFile* file) const {
  const auto known = files_.find(file);
  if (known != files_.end()) return known->second;
  fs::path path = file->getFilename().str();
  if (path.is_relative()) path = fs::path(file->getDirectory().str()) / path;
  const std::string full = path.lexically_normal().string();

  std::string name = file->getFilename().str();
  std::size_t longest = 0;
  for (const std::string& folder : folders_) {
    if (folder.size() > longest && full.compare(0, folder.size(), folder) == 0) {
      longest = folder.size();
      name = full.substr(longest);
    }
  }
  const bool language = longest > 0 && name.rfind("hls/", 0) == 0;
  const bool system = full.rfind("/usr/", 0) == 0;
  const bool wrapper = fs::path(name).filename() == "hlsc_unit.cpp";
  return files_.emplace(file, File{name, language || system || wrapper}).first->second;
}

bool SourceLines::is_library(const llvm::DIFile* f) const { return !f || file(f).library; }

SourceLine SourceLines::at(const llvm::DIFile* f, unsigned line) const {
  if (!f) return {};
  return {file(f).name, line};
}

SourceLine SourceLines::of(const llvm::DILocation* location) const {
  for (const llvm::DILocation* l = location; l; l = l->getInlinedAt()) {
    if (l->getLine() != 0 && !is_library(l->getFile())) return at(l->getFile(), l->getLine());
  }
  return {};
}

SourceLine SourceLines::of(const llvm::Instruction& instruction) const {
  return of(instruction.getDebugLoc().get());
}

}  // namespace hlsc
