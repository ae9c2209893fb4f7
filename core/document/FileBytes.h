// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"

#include <filesystem>
#include <string>

namespace handwheel {

// Reads all bytes of a regular file. Errors: FileMissing, FileUnreadable, Cancelled; they have no subject. May throw
// std::bad_alloc.
Result<std::string> readFileBytes(const std::filesystem::path& path, Progress progress = {});
// Number of bytes at the beginning of a file that suffice to recognise its format.
inline constexpr std::size_t kFileHead = 64 << 10;
// Reads at most the first `most` bytes of a file. Errors: FileMissing, FileUnreadable; they have no subject.
Result<std::string> readFileHead(const std::filesystem::path& path, std::size_t most = kFileHead);

}  // namespace handwheel
