// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"

#include <span>

namespace handwheel {

// Long arrays lie in a container as chunks of so many elements: one damaged byte loses no more.
inline constexpr std::size_t kChunkElements = 65'536;

struct IndexRange {
  std::size_t begin = 0;
  std::size_t end = 0;
  bool operator==(const IndexRange&) const = default;
};

template <class T>
struct ReadArray {
  std::vector<T> values;         // up to the last element that is there; zeros where elements before it are lost
  std::vector<IndexRange> lost;  // elements, in order, neighbours joined
};

// Writes the blobs "name/0000", "name/0001", … An element is so many numbers (3 for a point); values holds whole
// elements. T as for toBlob().
template <class T>
void writeArray(Container& container, const std::string& name, std::span<const T> values, std::size_t numbers = 1);

// Reads so many elements. Never fails: a chunk that is missing or has the wrong size is lost. Memory is bounded by 64
// times what the container holds of the array, whatever count says.
template <class T>
ReadArray<T> readArray(const Container& container, const std::string& name, std::uint64_t count,
                       std::size_t numbers = 1);

}  // namespace handwheel
