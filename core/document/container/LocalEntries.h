// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// An entry of a ZIP archive as described by its local header (APPNOTE.TXT 4.3.7). The archive's directory is not used.
struct LocalEntry {
  std::string name;
  std::size_t data = 0;          // offset of its first byte
  std::uint32_t compressed = 0;  // bytes; 0 if they are given only after the data
  std::uint32_t size = 0;
  std::uint32_t checksum = 0;
  bool isDeflated = false;
  bool isStreamed = false;  // sizes and checksum follow the data
};

// Finds the entries of a ZIP archive by their local headers. Skips the data of those whose end is followed by another
// header. Entries that are encrypted, or compressed by other methods than deflate, are left out. O(bytes).
std::vector<LocalEntry> findLocalEntries(std::string_view archive, std::size_t most);

// Result of unpacking an entry.
struct UnpackedEntry {
  std::string bytes;     // the bytes that can be unpacked
  bool isWhole = false;  // size and checksum are right
};

// Unpacks at most `most` bytes of an entry. `work` is reduced by the bytes read and written, and unpacking stops when
// it is used up: headers may overlap, so that their number does not bound the work.
UnpackedEntry unpackLocalEntry(std::string_view archive, const LocalEntry& entry, std::uint64_t most,
                               std::uint64_t& work, const Progress& progress);

}  // namespace handwheel
