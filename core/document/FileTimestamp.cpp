// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/FileTimestamp.h"

#include <sys/stat.h>

namespace handwheel {

std::optional<FileTimestamp> timestampOf(const std::filesystem::path& path) {
  struct stat is {};
  if (::stat(path.c_str(), &is) != 0 || !S_ISREG(is.st_mode)) return std::nullopt;
  return FileTimestamp{static_cast<std::uintmax_t>(is.st_size),
                       static_cast<std::int64_t>(is.st_mtim.tv_sec) * 1'000'000'000 + is.st_mtim.tv_nsec};
}

}  // namespace handwheel
