// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// An entry of a ZIP archive as its local header tells, without the archive's directory (APPNOTE.TXT 4.3.7).
struct LocalEntry {
  std::string name;
  std::size_t data = 0;          // where its bytes begin
  std::uint32_t compressed = 0;  // bytes; 0 where they are announced only behind the data
  std::uint32_t size = 0;
  std::uint32_t checksum = 0;
  bool isDeflated = false;
  bool isStreamed = false;  // sizes and checksum follow the data
};

// Looks for local headers, jumping over the data of those whose end is followed by another header. Entries that are
// encrypted, or packed by other means than deflate, are left out. O(bytes).
std::vector<LocalEntry> findLocalEntries(std::string_view archive, std::size_t most);

struct UnpackedEntry {
  std::string bytes;     // as far as they can be unpacked
  bool isWhole = false;  // size and checksum are right
};

// Unpacks at most `most` bytes; work counts bytes read and written down, and unpacking stops when it is spent: headers
// may overlap, so that their number does not bound the work.
UnpackedEntry unpackLocalEntry(std::string_view archive, const LocalEntry& entry, std::uint64_t most,
                               std::uint64_t& work, const Progress& progress);

}  // namespace handwheel
