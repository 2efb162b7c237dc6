// SPDX-License-Identifier: GPL-3.0-or-later
// Many lists of numbers, one after the other in one piece of memory.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace impinge {

class Lists {
 public:
  /// A list, and a number that goes into it.
  using Pair = std::array<std::uint32_t, 2>;

  Lists() : first_(1, 0) {}
  /// Makes `count` lists, each with its numbers in the order of the pairs, a range of Pair. A counting sort,
  /// in linear time.
  template <class Pairs>
  Lists(std::size_t count, const Pairs& pairs) : first_(count + 2, 0), numbers_(pairs.size()) {
    for (const auto& [list, number] : pairs) ++first_[list + 2];
    for (std::size_t k = 2; k < first_.size(); ++k) first_[k] += first_[k - 1];
    for (const auto& [list, number] : pairs) numbers_[first_[list + 1]++] = number;
    first_.pop_back();
  }

  /// The numbers of list k.
  std::span<const std::uint32_t> operator[](std::size_t k) const {
    return std::span(numbers_).subspan(first_[k], first_[k + 1] - first_[k]);
  }
  /// Place of the first number of list k among all; k may be the number of lists.
  std::uint32_t first(std::size_t k) const { return first_[k]; }
  /// The numbers of all lists.
  const std::vector<std::uint32_t>& numbers() const { return numbers_; }
  std::size_t size() const { return first_.size() - 1; }  // how many lists
  bool empty() const { return numbers_.empty(); }         // are all lists empty?
  std::size_t bytes() const {                             // of memory
    return (first_.capacity() + numbers_.capacity()) * sizeof(std::uint32_t);
  }

 private:
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> numbers_;
};

}  // namespace impinge
