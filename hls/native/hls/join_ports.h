// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The names of the ports of a join: a port is called "unit.port".
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "hls/join_record.h"
#include "hls/ports.h"

namespace hls {

struct PortOfUnit {
  std::string name;
  const void* address;
  PortInfo type;
};

namespace detail {
template <class Port, class Visit>
void visit_port(const std::string& name, Port& port, Visit& visit) {
  visit(name, port);
}
/// The configuration leaves this port out.
template <class Visit>
void visit_port(const std::string&, Absent&, Visit&) {}
template <class Port, std::size_t N, class Visit>
void visit_port(const std::string& name, Port (&ports)[N], Visit& visit) {
  for (std::size_t i = 0; i < N; ++i) {
    visit_port(name + "_" + std::to_string(i), ports[i], visit);
  }
}
}  // namespace detail

/// Calls visit(name, port) for every port of a unit, in the order of HLS_PORTS and with the names
/// that hlsc gives them: those of an array are name_0, name_1 and so on. The ports of its parts
/// follow its own.
template <class Unit, class Visit>
void for_each_port(Unit& unit, Visit&& visit) {
  const std::vector<std::string> names = split_names(Unit::hls_field_names());
  auto name = names.begin();
  unit.hls_visit([&](auto&... member) { (detail::visit_port(*name++, member, visit), ...); });
  if constexpr (requires { typename Unit::PortsOfParts; }) {
    [&]<class... Part>(Parts<Part...>) {
      (for_each_port(static_cast<Part&>(unit), visit), ...);
    }(typename Unit::PortsOfParts{});
  }
}

class JoinPorts {
 public:
  /// Makes a unit's ports known and adds them to its record.
  void add(UnitRecord& record, const std::vector<PortOfUnit>& ports);

  const std::string& name_of(const void* port) const;
  /// The unit that a port belongs to.
  std::string unit_of(const void* port) const;
  /// The port's name within its unit.
  std::string member_of(const void* port) const;
  /// How many Ins a unit has.
  unsigned inputs_of(const std::string& unit) const { return inputs_.at(unit); }

 private:
  std::map<const void*, std::string> names_;
  std::map<std::string, unsigned> inputs_;  ///< by unit
};

}  // namespace hls
