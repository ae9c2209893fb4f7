// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"

#include <span>

namespace handwheel {

// Elements per chunk of a long array in a container. A damaged byte affects at most one chunk.
inline constexpr std::size_t kChunkElements = 65'536;

// A half-open range of indices.
struct IndexRange {
  std::size_t begin = 0;
  std::size_t end = 0;
  bool operator==(const IndexRange&) const = default;
};

// Result of reading an array: its values and the ranges that are lost.
template <class T>
struct ReadArray {
  std::vector<T> values;         // up to the last element that was read; lost elements in between are zero
  std::vector<IndexRange> lost;  // ranges of elements, sorted; adjacent ranges are joined
};

// Writes an array as the blobs "name/0000", "name/0001" and so on. values: the numbers of whole elements. numbers:
// count of numbers per element (3 for a point). T: see toBlob().
template <class T>
void writeArray(Container& container, const std::string& name, std::span<const T> values, std::size_t numbers = 1);

// Reads an array of `count` elements. It cannot fail: the elements of a chunk that is missing or has the wrong size are
// listed as lost. For any count, memory is bounded by 64 times the size of the array in the container.
template <class T>
ReadArray<T> readArray(const Container& container, const std::string& name, std::uint64_t count,
                       std::size_t numbers = 1);

}  // namespace handwheel
