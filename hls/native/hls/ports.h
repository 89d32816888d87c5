// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The members that a unit is made of, as the native model has them: channels are queues, RAMs are
// arrays. hls/lowered/hls/ports.h has the same names for hlsc; only the include path decides which
// of the two a translation unit sees. A unit lists its ports once with HLS_PORTS.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "hls/fields.h"
#include "hls/fifo.h"
#include "hls/port_kind.h"
#include "hls/rows.h"

/// Names all ports of a unit (channels, RAM ports, configuration, arrays of one kind), and gives
/// hlsc the file that the unit is in.
#define HLS_PORTS(...)    \
  HLS_FIELDS(__VA_ARGS__) \
  static constexpr std::string_view hls_file() { return __FILE__; }

/// Says that a part of a unit has no ports.
#define HLS_NO_PORTS                                  \
  template <class Visit>                              \
  constexpr decltype(auto) hls_visit(Visit&& visit) { \
    return visit();                                   \
  }                                                   \
  static constexpr std::string_view hls_field_names() { return {}; }

namespace hls {

/// A channel's reading end. A transaction reads one token from every In of its unit.
template <class T>
class In : public InEnd {
 public:
  using Data = T;
  static constexpr PortInfo kPort{PortKind::kIn, bit_width_of<T>()};
  T read() { return fifo().pop(); }
  /// Tokens that wait to be read.
  std::size_t ready() const { return bound() ? fifo().size() : 0; }
  void bind(const std::shared_ptr<Fifo<T>>& queue) { bind_tokens(queue); }
  std::shared_ptr<Fifo<T>> queue() const { return std::static_pointer_cast<Fifo<T>>(tokens()); }

 private:
  Fifo<T>& fifo() const { return static_cast<Fifo<T>&>(*tokens()); }
};

/// A channel's writing end; bound to several queues it is a fork, and an arbiter merges several
/// Outs that share a queue. A transaction writes at most one token, under any condition.
template <class T>
class Out : public OutEnd {
 public:
  using Data = T;
  static constexpr PortInfo kPort{PortKind::kOut, bit_width_of<T>()};
  void write(const T& token) {
    for (const auto& queue : tokens()) static_cast<Fifo<T>&>(*queue).push(token);
  }
  void bind(const std::shared_ptr<Fifo<T>>& queue) { bind_tokens(queue); }
};

/// A synchronous RAM of N rows with one read and one write port: a read and a write per
/// transaction.
template <class T, unsigned N>
class Ram1R1W {
 public:
  using Address = uint<index_width(N)>;
  T read(Address address) const { return rows_[address.to_u64()]; }
  void write(Address address, const T& row) { rows_[address.to_u64()] = row; }
  void clear() { rows_ = Rows<T>(N); }
  Ram1R1W() = default;
  Ram1R1W(const Ram1R1W&) = delete;  // a copy would share the rows
  Ram1R1W& operator=(const Ram1R1W&) = delete;

 private:
  Rows<T> rows_{N};
};

/// A RAM small enough for LUTs, read and written in one stage, so that consecutive transactions on
/// one row see each other. Its rows start as zeros; those of other RAMs as whatever lies there.
template <class T, unsigned N>
class RegisterFile : public Ram1R1W<T, N> {};

/// The two ends of a RAM that one unit writes and others read. The join gives every reader its own
/// copy. Latency is the clocks from address to data: 1 for a RAM on the chip, more for a bank off
/// it.
template <class T, unsigned N>
class RamWrite {
 public:
  using Data = T;
  static constexpr PortInfo kPort{PortKind::kRamWrite, bit_width_of<T>(), N};
  using Address = uint<index_width(N)>;
  using Take = void (*)(void* taker, std::uint64_t row, const T&);
  void write(Address address, const T& row) {
    if (rows_.size() != 0) rows_[address.to_u64()] = row;
    if (take_) take_(taker_.get(), address.to_u64(), row);
  }
  void bind(Rows<T> rows) { rows_ = std::move(rows); }
  /// Gives every row with its number to `take`, too.
  void bind_taker(Take take, std::shared_ptr<void> taker) {
    take_ = take;
    taker_ = std::move(taker);
  }

 private:
  Rows<T> rows_;
  Take take_ = nullptr;
  std::shared_ptr<void> taker_;
};
template <class T, unsigned N, unsigned Latency = 1>
class RamRead {
 public:
  using Data = T;
  static constexpr PortInfo kPort{PortKind::kRamRead, bit_width_of<T>(), N, Latency};
  using Address = uint<index_width(N)>;
  T read(Address address) const { return rows_[address.to_u64()]; }
  void bind(Rows<T> rows) { rows_ = std::move(rows); }

 private:
  Rows<T> rows_;
};

/// Writes that wait until readers may see them: a row's number and the row.
template <class T>
using WriteLog = std::vector<std::pair<std::uint64_t, T>>;
template <class T>
void log_write(void* log, std::uint64_t row, const T& written) {
  static_cast<WriteLog<T>*>(log)->emplace_back(row, written);
}

/// A value that the host sets between frames and that does not change during a frame.
template <class T>
class Config {
 public:
  using Data = T;
  static constexpr PortInfo kPort{PortKind::kConfig, bit_width_of<T>()};
  T get() const { return *value_; }
  void bind(std::shared_ptr<T> value) { value_ = std::move(value); }

 private:
  std::shared_ptr<T> value_;
};

/// Replaces a port that a configuration leaves out.
struct Absent {};
template <bool Present, class Port>
using OptionalPort = std::conditional_t<Present, Port, Absent>;

/// Base classes of a unit that have ports of their own, such as the variants of one of its sides:
///     using PortsOfParts = hls::Parts<WayOut<C>>;
/// Each of them lists its ports with HLS_PORTS or, if it has none, with HLS_NO_PORTS.
template <class... Part>
struct Parts {};

}  // namespace hls
