// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "volume/vdb/VdbVolume.h"

namespace handwheel {

inline constexpr const char* kVdbLibrary = "OpenVDB";

// Reads a volume of a VDB file, in a process of its own (IsolatedReader.h). It is the first level set of floats, or
// else the first fog volume, thresholded at a density of one half. Lengths are taken as millimetres. Errors:
// LibraryFailed with the reason (no such grid; voxels that are not axis-aligned cubes; too large), OutOfMemory,
// Cancelled.
Result<VdbVolume> readVdb(std::string_view file, Progress progress);

// Returns a volume as a VDB file of one level set, "surface", three voxels deep on both sides. It is written by the
// same process. Errors: LibraryFailed, OutOfMemory, Cancelled.
Result<std::string> vdbOf(const SparseVolume& volume, Progress progress);

// Returns true if the first bytes are those of a VDB file.
bool looksLikeVdb(std::string_view bytes);

}  // namespace handwheel
