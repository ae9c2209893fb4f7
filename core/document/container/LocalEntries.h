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
  std::size_t data = 0;          // offset of the first byte of the data
  std::uint32_t compressed = 0;  // size in the archive, bytes; 0 if it is given only after the data
  std::uint32_t size = 0;
  std::uint32_t checksum = 0;
  bool isDeflated = false;
  bool isStreamed = false;  // sizes and checksum follow the data
};

// Finds the entries of a ZIP archive by their local headers. The data of an entry are skipped if another header follows
// them, and searched for headers otherwise. Entries that are encrypted, or compressed with other methods than deflate,
// are omitted. most: the limit of the number of entries. O(bytes).
std::vector<LocalEntry> findLocalEntries(std::string_view archive, std::size_t most);

// Result of unpacking an entry.
struct UnpackedEntry {
  std::string bytes;     // the part that can be unpacked
  bool isWhole = false;  // size and checksum are right
};

// Unpacks at most `most` bytes of an entry. `work` is the number of bytes that may still be read and written for all
// entries; it is reduced, and unpacking stops at 0. This limit is needed because entries may overlap.
UnpackedEntry unpackLocalEntry(std::string_view archive, const LocalEntry& entry, std::uint64_t most,
                               std::uint64_t& work, const Progress& progress);

}  // namespace handwheel
