// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Where the files are that the program reads at run time: in its build, or where
// `cmake --install` has put them beside the installed program (cmake/Package.cmake).
#pragma once

#include <filesystem>
#include <string_view>
#include <system_error>

namespace dynrt::host {

/// The path `installed` below the folder that holds the program's own, such as
/// PREFIX/share/dynrt/scenes of PREFIX/bin/dynrt; the path `built` where there is none.
inline std::filesystem::path program_part(const std::filesystem::path& built,
                                          std::string_view installed) {
  namespace fs = std::filesystem;
  std::error_code unknown;
  const fs::path prefix = fs::read_symlink("/proc/self/exe", unknown).parent_path().parent_path();
  return fs::exists(prefix / installed, unknown) ? prefix / installed : built;
}

}  // namespace dynrt::host
