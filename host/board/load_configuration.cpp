// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/board/load_configuration.h"

#include <dlfcn.h>
#include <elf.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "host/board/board_messages.h"
#include "host/error.h"
#include "host/format/configuration_json.h"
#include "host/program_part.h"

namespace dynrt::host {

namespace {

namespace fs = std::filesystem;

struct Loaded {
  std::string name;
  Configuration configuration;
};

/// The loader would map a library that was cut off and crash when it is used. The table of sections
/// stands at the end of a library, so if that is there, all of it is.
bool is_whole_library(const std::string& path) {
  Elf64_Ehdr header{};
  std::ifstream file(path, std::ios::binary);
  if (!file.read(reinterpret_cast<char*>(&header), sizeof header)) return false;
  if (std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0 || header.e_type != ET_DYN) return false;
  const std::uint64_t end = header.e_shoff + std::uint64_t{header.e_shentsize} * header.e_shnum;
  return header.e_shoff > 0 && end <= fs::file_size(path);
}

template <class Symbol>
Symbol symbol(void* library, const char* name) {
  return reinterpret_cast<Symbol>(dlsym(library, name));
}

/// A library that fits this program stays open; of any other there is a sentence.
struct Library {
  const Configuration* configuration = nullptr;
  std::string fault;
};

Library open(const std::string& path) {
  std::error_code error;
  if (!fs::exists(path, error)) return {nullptr, fmt::format(messages::kNoConfigurationFile, path)};
  if (!is_whole_library(path))
    return {nullptr, fmt::format("configuration {}: the shared library is cut off; make it again "
                                 "with scripts/configuration",
                                 path)};
  // An absolute path, as the loader looks for bare names elsewhere.
  void* library = dlopen(fs::absolute(path).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    return {nullptr,
            fmt::format("configuration {}: cannot load it: {}", path, std::string(dlerror()))};
  }
  const auto* fingerprint = symbol<const char*>(library, "dynrt_configuration_fingerprint");
  const auto configuration = symbol<const Configuration* (*)()>(library, "dynrt_configuration");
  if (fingerprint != nullptr && configuration != nullptr &&
      fingerprint == this_build().fingerprint) {
    return {configuration(), {}};
  }
  const bool foreign = fingerprint == nullptr || configuration == nullptr;
  dlclose(library);
  return {nullptr,
          foreign
              ? fmt::format("configuration {}: this shared library is not a configuration of "
                            "dynrt; make one with scripts/configuration",
                            path)
              : fmt::format("configuration {}: it was made from other sources or by another "
                            "compiler than this program; make it again with scripts/configuration",
                            path)};
}

Loaded loaded_from(const std::string& path, std::string name) {
  const Library library = open(path);
  if (library.configuration == nullptr) throw UserError(library.fault);
  return {std::move(name), *library.configuration};
}

/// The keys that a JSON file states, and its stem as their name; none if it cannot be read: its
/// mistakes are reported when its configuration is made.
std::optional<CoreConfiguration> stated_in(const std::string& path) {
  std::ifstream file(path);
  try {
    CoreConfiguration stated = configuration_of(Json::parse(file));
    stated.name = fs::path(path).stem().string();
    return stated;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

/// A configuration that is listed or that a JSON file states; none if it is neither.
std::optional<CoreConfiguration> configuration_called(const std::string& name) {
  if (name.ends_with(".json")) return stated_in(name);
  const CoreConfiguration* listed = listed_configuration(name);
  return listed == nullptr ? std::nullopt : std::optional(*listed);
}

/// Of the configurations that are listed and not built in.
fs::path listed_folder() {
  return program_part(fs::path(this_build().description).parent_path() / "configurations",
                      "lib/dynrt/configurations");
}

}  // namespace

bool is_configuration_file(std::string_view name) {
  return name.ends_with(".so") || name.ends_with(".json");
}

const Configuration& load_configuration(const std::string& path, bool rtl) {
  static std::map<std::pair<std::string, bool>, std::unique_ptr<Loaded>> loaded;
  const bool made = path.ends_with(".json");
  auto& slot = loaded[{path, made && rtl}];
  if (!slot) {
    const std::string library = made ? make_configuration(path, rtl) : path;
    slot = std::make_unique<Loaded>(loaded_from(library, fs::path(path).stem().string()));
    slot->configuration.name = slot->name;
  }
  return slot->configuration;
}

const Configuration& load_listed_configuration(const std::string& name, bool rtl) {
  const fs::path folder = listed_folder();
  const fs::path built = folder / (name + ".so");
  if (open(built).configuration != nullptr) return load_configuration(built);
  return load_configuration(folder / (name + ".json"), rtl);
}

void make_ready(std::span<const Configuration> table, const std::string& name, const Tell& tell) {
  if (name.ends_with(".so")) return;
  if (name.ends_with(".json")) {
    make_configuration(name, false, tell);
    return;
  }
  const auto found = std::ranges::find(table, name, &Configuration::name);
  if (found == table.end() || found->native != nullptr) return;
  if (open((listed_folder() / (name + ".so")).string()).configuration == nullptr) {
    make_configuration((listed_folder() / (name + ".json")).string(), false, tell);
  }
}

std::string make_schedules(const std::string& name, const Tell& tell, unsigned jobs) {
  if (name.ends_with(".so")) {
    refuse(
        "configuration {}: a shared library does not say what its units are made from; name the "
        "JSON file that it was made from, and its units can be lowered",
        name);
  }
  if (name.ends_with(".json")) return make_verilog(name, tell, jobs);
  return make_verilog((listed_folder() / (name + ".json")).string(), tell, jobs);
}

void add_general(CoreInfo& core) {
  if (const auto general = configuration_called(core.made_from)) {
    core.general = std::make_shared<CoreConfiguration>(*general);
  }
}

std::string general_of(const std::string& configuration) {
  std::optional<CoreConfiguration> special;
  if (configuration.ends_with(".json")) special = stated_in(configuration);
  if (configuration.ends_with(".so")) special = load_configuration(configuration).core();
  const bool made = special && special->made_from != CoreConfiguration{}.made_from;
  return made ? special->made_from : configuration;
}

}  // namespace dynrt::host
