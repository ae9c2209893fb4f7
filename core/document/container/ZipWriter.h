// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"

#include <span>
#include <string>
#include <string_view>

namespace handwheel {

// Compression level of a ZIP archive.
enum class Compression { None, Fast };

// An entry to be written to a ZIP archive.
struct ZipEntry {
  std::string_view name;  // UTF-8, relative, with slashes
  std::string_view bytes;
};

// Creates a ZIP archive in memory with these entries in this order. Equal input gives equal bytes, because no time is
// stored. Errors: Cancelled, OutOfMemory, LibraryFailed.
Result<std::string> writeZip(std::span<const ZipEntry> entries, Compression compression, Progress progress = {});

}  // namespace handwheel
