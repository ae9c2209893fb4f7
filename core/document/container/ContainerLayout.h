// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"
#include "document/container/UnpackLimits.h"

#include <new>
#include <stdexcept>

// What writing and reading a container agree upon; docs/format.md is the description.
namespace handwheel::layout {

// First in the archive, so that a file cut short still has it, and once more at the end.
inline const std::string kManifest = "manifest.json";
inline const std::string kManifestCopy = "manifest.copy.json";
// Bytes; a parsed manifest takes up to some thirty times as much memory.
inline constexpr std::size_t kLargestManifest = 16 << 20;
inline constexpr UnpackLimits kLimits{.largest = kLargestContainer, .allowance = std::uint64_t{1} << 30};

inline bool isManifestName(std::string_view name) {
  return name == kManifest || name == kManifestCopy;
}

// Printable ASCII, relative, with slashes, no part empty, "." or "..": whoever unpacks the archive writes below his own
// folder, on any system.
bool isBlobName(std::string_view name);

// CRC-32 as in ZIP, in eight hexadecimal digits.
std::string checksumText(std::string_view bytes);

inline Error tooLarge(const char* what, std::uint64_t count, std::uint64_t limit) {
  return {ErrorCode::FileTooLarge, {what, std::to_string(count), std::to_string(limit)}, {}, {}};
}

// Does work during which libraries may run out of memory.
template <class Work>
auto withinMemory(const Work& work) -> decltype(work()) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::OutOfMemory, {}, {}, {}};
  } catch (const std::length_error&) {
    return Error{ErrorCode::OutOfMemory, {}, {}, {}};
  }
}

}  // namespace handwheel::layout
