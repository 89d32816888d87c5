// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Tokens as words and as text, for co-simulation, memory images and comparisons. A token's bits lie
// in 32-bit words, lowest first, which is also how Verilator holds a wide port; bits beyond the
// token's width are zero.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hls/fields.h"

namespace hls {

template <class T>
inline constexpr unsigned words_of = (bit_width_of<T>() + 31) / 32;
template <class T>
using Words = std::array<std::uint32_t, words_of<T>>;

namespace detail {
template <class T>
concept FloatLike = requires(const T& t) { t.to_double(); };

/// The decimal value of a leaf, with its bits in hexadecimal.
template <class L>
std::string leaf_text(const L& leaf) {
  const std::uint64_t bits = leaf_to_bits(leaf).to_u64();
  if constexpr (FloatLike<L>) {
    return fmt::format("{:.9g} (0x{:0{}x})", leaf.to_double(), bits, (bit_width_of<L>() + 3) / 4);
  } else if constexpr (is_sint<L>::value) {
    return fmt::format("{} (0x{:x})", leaf.to_s64(), bits);
  } else if constexpr (std::is_same_v<L, bool>) {
    return leaf ? "true" : "false";
  } else {
    return fmt::format("{} (0x{:x})", bits, bits);
  }
}

/// Cuts the first name off a list like "a, b, c".
inline std::string_view next_name(std::string_view& names) {
  const std::size_t comma = names.find(',');
  std::string_view name = names.substr(0, comma);
  names = comma == names.npos ? std::string_view{} : names.substr(comma + 1);
  const std::size_t first = name.find_first_not_of(" \t\n");
  const std::size_t last = name.find_last_not_of(" \t\n");
  return first == name.npos ? std::string_view{} : name.substr(first, last - first + 1);
}

/// Calls visit(leaf, path) for every leaf, path being like "ray[2].origin.x".
template <class T, class Visit>
void for_each_named_leaf(const T& token, Visit&& visit, const std::string& path) {
  if constexpr (is_array<T>::value) {
    for (std::size_t i = 0; i < token.size(); ++i) {
      for_each_named_leaf(token[i], visit, fmt::format("{}[{}]", path, i));
    }
  } else if constexpr (Struct<T>) {
    std::string_view names = T::hls_field_names();
    token.hls_visit([&](const auto&... field) {
      const auto visit_field = [&](const auto& f) {
        const std::string_view name = next_name(names);
        for_each_named_leaf(f, visit,
                            path.empty() ? std::string(name) : fmt::format("{}.{}", path, name));
      };
      (visit_field(field), ...);
    });
  } else {
    visit(token, path);
  }
}
}  // namespace detail

/// The bits [offset +: width] of some words, width at most 64.
inline std::uint64_t get_bits(const std::uint32_t* words, unsigned offset, unsigned width) {
  std::uint64_t bits = 0;
  for (unsigned done = 0; done < width;) {
    const unsigned shift = (offset + done) % 32;
    bits |= std::uint64_t{words[(offset + done) / 32] >> shift} << done;
    done += 32 - shift;
  }
  return width < 64 ? bits & ((std::uint64_t{1} << width) - 1) : bits;
}
/// Sets bits that were zero.
inline void put_bits(std::uint32_t* words, unsigned offset, unsigned width, std::uint64_t bits) {
  for (unsigned done = 0; done < width;) {
    const unsigned shift = (offset + done) % 32;
    words[(offset + done) / 32] |= static_cast<std::uint32_t>((bits >> done) << shift);
    done += 32 - shift;
  }
}

template <class T>
Words<T> pack(const T& token) {
  Words<T> words{};
  for_each_leaf(token, [&words]<class L>(const L& leaf, unsigned offset) {
    put_bits(words.data(), offset, bit_width_of<L>(), leaf_to_bits(leaf).to_u64());
  });
  return words;
}
template <class T>
T unpack(const std::uint32_t* words) {
  T token{};
  for_each_leaf(token, [words]<class L>(L& leaf, unsigned offset) {
    constexpr unsigned kWidth = bit_width_of<L>();
    leaf = leaf_from_bits<L>(uint<kWidth>::from(get_bits(words, offset, kWidth)));
  });
  return token;
}
template <class T>
T unpack(const Words<T>& words) {
  return unpack<T>(words.data());
}

/// "packet = 3 (0x3), origin.x = 1.5 (0x3f8000)": every leaf with its path.
template <class T>
std::string describe(const T& token) {
  std::string text;
  detail::for_each_named_leaf(token,
                              [&text](const auto& leaf, const std::string& path) {
                                if (!text.empty()) text += ", ";
                                if (!path.empty()) text += path + " = ";
                                text += detail::leaf_text(leaf);
                              },
                              {});
  return text;
}

/// A leaf in which two tokens differ; a token that is itself a leaf has the path "value".
struct Difference {
  std::string field, left, right;
  std::string text() const { return fmt::format("{}: {} against {}", field, left, right); }
};

template <class T>
std::optional<Difference> first_difference(const T& left, const T& right) {
  struct Leaf {
    std::string path, text;
    std::uint64_t bits;
  };
  const auto leaves = [](const T& token) {
    std::vector<Leaf> result;
    detail::for_each_named_leaf(
        token,
        [&result](const auto& leaf, const std::string& path) {
          result.push_back({path, detail::leaf_text(leaf), leaf_to_bits(leaf).to_u64()});
        },
        {});
    return result;
  };
  if (pack(left) == pack(right)) return std::nullopt;
  const std::vector<Leaf> l = leaves(left);
  const std::vector<Leaf> r = leaves(right);
  std::size_t i = 0;
  while (l[i].bits == r[i].bits) ++i;
  return Difference{l[i].path.empty() ? "value" : l[i].path, l[i].text, r[i].text};
}

}  // namespace hls
