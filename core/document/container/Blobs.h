// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"

#include <span>

namespace handwheel {

// Elements per chunk of a long array in a container. One damaged byte loses at most one chunk.
inline constexpr std::size_t kChunkElements = 65'536;

// A half-open range of indices.
struct IndexRange {
  std::size_t begin = 0;
  std::size_t end = 0;
  bool operator==(const IndexRange&) const = default;
};

// Result of reading an array, with the ranges that are lost.
template <class T>
struct ReadArray {
  std::vector<T> values;         // up to the last element that was read; zeros for lost elements before it
  std::vector<IndexRange> lost;  // elements, in order, neighbours joined
};

// Writes an array as the blobs "name/0000", "name/0001" and so on. numbers: per element (3 for a point); values has
// whole elements. T: see toBlob().
template <class T>
void writeArray(Container& container, const std::string& name, std::span<const T> values, std::size_t numbers = 1);

// Reads an array of `count` elements. Never fails: a chunk that is missing or has the wrong size is lost. Memory is
// bounded by 64 times the size of the array in the container, for any count.
template <class T>
ReadArray<T> readArray(const Container& container, const std::string& name, std::uint64_t count,
                       std::size_t numbers = 1);

}  // namespace handwheel
