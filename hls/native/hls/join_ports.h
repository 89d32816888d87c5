// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The names of the ports of a join: a port is called "unit.port".
#pragma once

#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "hls/join_record.h"
#include "hls/ports.h"

namespace hls {

class JoinPorts {
 public:
  /// Makes a unit's ports known and adds them to its record.
  template <class U>
  void add(UnitRecord& record, U& unit) {
    const std::vector<std::string> names = split_names(U::hls_field_names());
    std::size_t index = 0;
    std::apply([&](auto&... port) { (add_port(record, names[index++], port), ...); },
               unit.hls_fields());
  }

  const std::string& name_of(const void* port) const {
    const auto found = names_.find(port);
    if (found == names_.end()) {
      throw std::logic_error(
          "the join connects a port whose unit it does not have, or which the unit does not name "
          "in HLS_PORTS");
    }
    return found->second;
  }
  /// The unit that a port belongs to.
  std::string unit_of(const void* port) const {
    const std::string& name = name_of(port);
    return name.substr(0, name.find('.'));
  }
  /// The port's name within its unit.
  std::string member_of(const void* port) const {
    const std::string& name = name_of(port);
    return name.substr(name.find('.') + 1);
  }
  /// How many Ins a unit has.
  unsigned inputs_of(const std::string& unit) const { return inputs_.at(unit); }

 private:
  void add_port(UnitRecord&, const std::string&, Absent&) {}
  template <class P>
  void add_port(UnitRecord& record, const std::string& name, P& port) {
    names_[&port] = record.name + "." + name;
    record.ports.push_back({name, P::kPort});
    if (P::kPort.kind == PortKind::kIn) ++inputs_[record.name];
  }

  std::map<const void*, std::string> names_;
  std::map<std::string, unsigned> inputs_;  ///< by unit
};

}  // namespace hls
