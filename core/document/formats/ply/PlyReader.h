// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/formats/MeshFormat.h"

namespace handwheel {

// Returns true if bytes begin with the signature of PLY files.
bool looksLikePly(std::string_view bytes);

// Reads a PLY file, text or binary of either byte order. Faces are polygons or triangle strips; elements and properties
// that describe neither vertices nor faces are skipped, and listed as lost if they describe the surface.
Result<MeshFile> readPly(std::string_view bytes, const ReadOptions& options, Progress progress);

}  // namespace handwheel
