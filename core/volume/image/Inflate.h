// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace handwheel {

// Unpacks a gzip or zlib stream (RFC 1952, RFC 1950) up to a size limit. The format is found by its first bytes; what
// follows so many bytes is not unpacked. Memory grows with what comes out, which deflate limits to 1032 times what went
// in. Errors: FileTooLarge where the limit is more than a quarter of systemMemory(); LibraryFailed {zlib, reason} where
// it is damaged or ends early before that.
Result<std::string> inflated(std::string_view packed, std::size_t most);

// Whether the bytes begin as a gzip stream does.
bool looksLikeGzip(std::string_view bytes);

}  // namespace handwheel
