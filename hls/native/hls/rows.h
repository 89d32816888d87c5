// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The rows of a RAM in the native model.
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>

namespace hls {

/// Rows that several ports and the outside share; a copy of this object is one more of them.
/// Without a number there are none, for a join that is only described.
template <class T>
class Rows {
 public:
  static_assert(std::is_trivially_destructible_v<T>, "a row is bits");
  Rows() = default;
  explicit Rows(std::size_t number)
      : memory_(::operator new(number * sizeof(T)), [](void* m) { ::operator delete(m); }),
        first_(static_cast<T*>(memory_.get())),
        number_(number) {
    for (T& row : *this) new (&row) T{};
  }
  std::size_t size() const { return number_; }
  T* begin() const { return first_; }
  T* end() const { return first_ + number_; }
  T& operator[](std::size_t row) const { return first_[row]; }
  /// The memory, which begins with the first row.
  const std::shared_ptr<void>& memory() const { return memory_; }

 private:
  std::shared_ptr<void> memory_;
  T* first_ = nullptr;
  std::size_t number_ = 0;
};

}  // namespace hls
