// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "hls/join_ports.h"

#include <stdexcept>

namespace hls {

void JoinPorts::add(UnitRecord& record, const std::vector<PortOfUnit>& ports) {
  for (const PortOfUnit& port : ports) {
    names_[port.address] = record.name + "." + port.name;
    record.ports.push_back({port.name, port.type});
    if (port.type.kind == PortKind::kIn) ++inputs_[record.name];
  }
}

const std::string& JoinPorts::name_of(const void* port) const {
  const auto found = names_.find(port);
  if (found == names_.end()) {
    throw std::logic_error(
        "the join connects a port whose unit it does not have, or which the unit does not name in "
        "HLS_PORTS");
  }
  return found->second;
}
std::string JoinPorts::unit_of(const void* port) const {
  const std::string& name = name_of(port);
  return name.substr(0, name.find('.'));
}
std::string JoinPorts::member_of(const void* port) const {
  const std::string& name = name_of(port);
  return name.substr(name.find('.') + 1);
}

}  // namespace hls
