// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace handwheel {

// Unpacks a gzip or zlib stream (RFC 1952, RFC 1950) up to a size limit. The first bytes determine the format; output
// beyond the limit is not unpacked. Memory grows with the output, which deflate limits to 1032 times the input. Errors:
// FileTooLarge if the limit is more than a quarter of systemMemory(); LibraryFailed {zlib, reason} if the stream is
// damaged or truncated.
Result<std::string> inflated(std::string_view packed, std::size_t most);

// Returns true if the bytes begin like a gzip stream.
bool looksLikeGzip(std::string_view bytes);

}  // namespace handwheel
