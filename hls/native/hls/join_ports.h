// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The names of the ports of a join: a port is called "unit.port".
#pragma once

#include <initializer_list>
#include <map>
#include <string>
#include <string_view>

#include "hls/join_record.h"
#include "hls/ports.h"

namespace hls {

struct PortOfUnit {
  const void* address;  ///< null: the configuration leaves this port out
  PortInfo type;
};
inline PortOfUnit port_of(const Absent&) { return {}; }
template <class P>
PortOfUnit port_of(const P& port) {
  return {&port, P::kPort};
}

class JoinPorts {
 public:
  /// Makes a unit's ports, which `names` lists in their order, known and adds them to its record.
  void add(UnitRecord& record, std::string_view names, std::initializer_list<PortOfUnit> ports);

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
