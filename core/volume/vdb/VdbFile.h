// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "volume/vdb/VdbVolume.h"

namespace handwheel {

inline constexpr const char* kVdbLibrary = "OpenVDB";

// Reads a volume from a VDB file, in a separate process (IsolatedReader.h). The volume is the first level set of
// floats. If there is none, it is the first fog volume, thresholded at a density of one half. Lengths are taken as
// millimetres. Errors: LibraryFailed with the reason (no suitable grid; voxels that are not axis-aligned cubes; too
// large), OutOfMemory, Cancelled.
Result<VdbVolume> readVdb(std::string_view file, Progress progress);

// Returns a volume as a VDB file with one level set, "surface", three voxels deep on both sides. The file is written by
// the process that also reads VDB files. Errors: LibraryFailed, OutOfMemory, Cancelled.
Result<std::string> vdbOf(const SparseVolume& volume, Progress progress);

// Returns true if the bytes begin like a VDB file.
bool looksLikeVdb(std::string_view bytes);

}  // namespace handwheel
