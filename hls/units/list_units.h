// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The units of a configuration, one line for each module:
//   thesis|list|units/list.h|dynrt::List<dynrt::config::thesis>
// A unit may have a constant kRoom, which goes to hlsc's --room and is one more field then, and a
// constant kUncertaintyNs, which goes to its --uncertainty and is a further field, behind that of
// the room, unless it is 0.
#pragma once

#include <cstdio>
#include <memory>
#include <set>
#include <string>

#include "units/core.h"

namespace dynrt {

/// Collects the lines of configuration `config`.
class UnitLines {
 public:
  explicit UnitLines(std::string config) : config_(std::move(config)) {}
  void group(const std::string& /*name*/) {}
  void begin_names(const std::string& /*prefix*/) {}
  template <class U>
  void unit(const std::string& /*name*/, const std::string& module, U& /*unit*/) {
    if (!modules_.insert(module).second) return;
    // The path as an #include names it: its end, whatever path the compiler got.
    const std::string file(U::hls_file());
    text_ += config_ + "|" + module + "|" + file.substr(file.rfind("units/")) + "|" +
             hls::type_name<U>();
    std::string room;
    if constexpr (requires { U::kRoom; }) room = std::to_string(U::kRoom);
    std::string uncertainty;
    if constexpr (requires { U::kUncertaintyNs; }) uncertainty = number(U::kUncertaintyNs);
    if (!room.empty() || !uncertainty.empty()) text_ += "|" + room;
    if (!uncertainty.empty()) text_ += "|" + uncertainty;
    text_ += "\n";
  }
  const std::string& text() const { return text_; }

 private:
  /// As hlsc takes it; nothing if it is 0.
  static std::string number(double ns) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", ns);
    return ns > 0 ? text : "";
  }

  std::string config_;
  std::set<std::string> modules_;
  std::string text_;
};

template <class C>
void list_units(const char* config) {
  UnitLines lines(config);
  std::make_unique<Core<C>>()->name_units(lines);
  std::fputs(lines.text().c_str(), stdout);
}

}  // namespace dynrt
