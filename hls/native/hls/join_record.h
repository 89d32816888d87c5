// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The connections of a join, as data: names, widths and ends. A port is named "unit.port".
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "hls/counter_name.h"
#include "hls/ports.h"

namespace hls {

struct PortRecord {
  std::string name;
  PortInfo type;
};
struct UnitRecord {
  std::string name;
  std::string module;
  std::vector<PortRecord> ports;
  std::string group = {};        ///< under which a block diagram shows it
  bool order_dependent = false;  ///< its counts depend on the order of service
};
enum class ChannelKind : std::uint8_t { kChannel, kRepeat, kInput, kOutput, kSink };
struct ChannelRecord {
  std::string name;
  std::vector<std::string> from;
  std::vector<std::string> to;
  unsigned width;
  unsigned depth;  ///< the most tokens there can be; 0 if there is no such bound
  ChannelKind kind;
  std::vector<std::string> short_fifos = {};  ///< the writers that have one all the same
  unsigned repeat_width = 0;                  ///< of a repeated job's count
  bool order_dependent = false;               ///< its token count depends on the order of service

  /// Whether the FIFO of a writer never refuses a token.
  bool holds_all(const std::string& writer) const {
    return depth != 0 && std::ranges::find(short_fifos, writer) == short_fifos.end();
  }
};
struct RamRecord {
  std::string name;
  std::string writer;
  std::vector<std::string> readers;
  unsigned width;  ///< of a row as it is written
  unsigned rows;
  Hazard hazard;
  unsigned words = 1;  ///< that a row is made of; readers read one of them
};
struct BankRecord {
  std::string name;
  std::string port;
  unsigned width;
  unsigned rows;
  bool write;
};
struct FieldRecord {
  std::string name;
  unsigned offset;  ///< of the lowest bit
  unsigned width;
};
struct ConfigRecord {
  std::string name;
  std::vector<std::string> to;
  unsigned width;
  bool constant;
  std::uint64_t value;
  std::vector<FieldRecord> fields = {};  ///< of a struct
};
struct JoinRecord {
  std::vector<UnitRecord> units;
  std::vector<ChannelRecord> channels;
  std::vector<RamRecord> rams;
  std::vector<BankRecord> banks;
  std::vector<ConfigRecord> configs;
  bool counts = true;  ///< its top counts tokens, transactions and stalls
};

struct CounterRecord {
  std::string of;  ///< a channel or a unit
  Counted what;
  bool order_independent;  ///< the same for every order of the packets
  std::string name() const { return counter_name(of, what); }
};
/// The counters of a top, in the order of their addresses: tokens of every channel inside, then
/// transactions and stalls of every unit; none, if the top has no counters. The stalls of a unit
/// always depend on the order.
inline std::vector<CounterRecord> counters_of(const JoinRecord& join) {
  std::vector<CounterRecord> counters;
  if (!join.counts) return counters;
  for (const ChannelRecord& c : join.channels) {
    if (c.kind != ChannelKind::kInput && c.kind != ChannelKind::kOutput) {
      counters.push_back({c.name, Counted::kTokens, !c.order_dependent});
    }
  }
  for (const UnitRecord& unit : join.units) {
    counters.push_back({unit.name, Counted::kTransactions, !unit.order_dependent});
  }
  for (const UnitRecord& unit : join.units) {
    counters.push_back({unit.name, Counted::kStalls, false});
  }
  return counters;
}

/// A type with its namespaces: "dynrt::List<dynrt::config::thesis>".
template <class T>
std::string type_name() {
  const std::string_view name = __PRETTY_FUNCTION__;  // ... type_name() [T = dynrt::List<...>]
  const std::size_t begin = name.find("T = ") + 4;
  return std::string(name.substr(begin, name.size() - 1 - begin));
}

/// "entry, slot" as {"entry", "slot"}.
inline std::vector<std::string> split_names(std::string_view list) {
  std::vector<std::string> names(1);
  for (const char c : list) {
    if (c == ',') {
      names.emplace_back();
    } else if (c != ' ' && c != '\n') {
      names.back() += c;
    }
  }
  return names;
}

}  // namespace hls
