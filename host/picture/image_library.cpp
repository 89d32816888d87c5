// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/picture/image_library.h"

#include <dlfcn.h>

#include <filesystem>
#include <system_error>

#include "host/error.h"
#include "host/program_part.h"

namespace dynrt::host {

namespace {

constexpr char kNoImageLibrary[] =
    "pictures need dynrt's library {}, which cannot be loaded ({}); build it again or put it into "
    "the program's folder";

namespace fs = std::filesystem;

fs::path find_library() {
  const fs::path built = DYNRT_IMAGES_LIBRARY;
  std::error_code unknown;
  const fs::path program = fs::read_symlink("/proc/self/exe", unknown).parent_path();
  if (fs::exists(program / built.filename(), unknown)) return program / built.filename();
  return program_part(built, "lib/dynrt/" + built.filename().string());
}

}  // namespace

const ImageLibrary& load_image_library(const std::string& path) {
  const std::string name = fs::path(path).filename().string();
  void* library = dlopen(path.c_str(), RTLD_LAZY | RTLD_LOCAL);  // never closed
  if (library == nullptr) refuse(kNoImageLibrary, name, std::string(dlerror()));
  using Function = const ImageLibrary* (*)();
  const auto function = reinterpret_cast<Function>(dlsym(library, kImageLibraryFunction));
  if (function == nullptr) refuse(kNoImageLibrary, name, std::string(dlerror()));
  return *function();
}

const ImageLibrary& image_library() {
  static const ImageLibrary& library = load_image_library(find_library());
  return library;
}

}  // namespace dynrt::host
