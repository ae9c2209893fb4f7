// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"
#include "document/container/UnpackLimits.h"

#include <new>
#include <stdexcept>

// Constants and functions for both writing and reading containers; docs/format.md describes the format.
namespace handwheel::layout {

// Names of the manifest and of its copy. The manifest is the first entry of the archive, so that a truncated file still
// contains it; the copy is the last entry.
inline const std::string kManifest = "manifest.json";
inline const std::string kManifestCopy = "manifest.copy.json";
// Limit of the size of a manifest, bytes. A parsed manifest takes up to about thirty times this amount of memory.
inline constexpr std::size_t kLargestManifest = 16 << 20;
inline constexpr UnpackLimits kLimits{.largest = kLargestContainer, .allowance = std::uint64_t{1} << 30};

inline bool isManifestName(std::string_view name) {
  return name == kManifest || name == kManifestCopy;
}

// Returns true if a name is valid for a blob. Valid names are relative, in printable ASCII, with slashes, and no part
// is empty, "." or "..". Unpacking the archive therefore writes only below the target folder, on any system.
bool isBlobName(std::string_view name);

// Returns the CRC-32 of bytes (the one of ZIP) as eight hexadecimal digits.
std::string checksumText(std::string_view bytes);

// Creates the error FileTooLarge.
inline Error tooLarge(const char* what, std::uint64_t count, std::uint64_t limit) {
  return {ErrorCode::FileTooLarge, {what, std::to_string(count), std::to_string(limit)}, {}, {}};
}

// Runs work and returns its result, or the error OutOfMemory if the work runs out of memory.
template <class Work>
auto catchOutOfMemory(const Work& work) -> decltype(work()) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::OutOfMemory, {}, {}, {}};
  } catch (const std::length_error&) {
    return Error{ErrorCode::OutOfMemory, {}, {}, {}};
  }
}

}  // namespace handwheel::layout
