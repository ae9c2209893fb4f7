// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace handwheel {

// The size and modification time of a file, for detecting changes.
struct FileTimestamp {
  std::uintmax_t bytes = 0;
  std::int64_t modifiedNs = 0;  // ns since 1970
  bool operator==(const FileTimestamp&) const = default;
};

// Returns the present stamp of a file, or nothing if there is no regular file at the path.
std::optional<FileTimestamp> timestampOf(const std::filesystem::path& path);

}  // namespace handwheel
