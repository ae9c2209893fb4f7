// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/formats/MeshFormat.h"

namespace handwheel {

// Text and binary of either byte order. Faces are polygons or triangle strips; elements and properties that describe
// neither vertices nor faces are skipped, and listed as lost where they say something about the surface.
Result<MeshFile> readPly(std::string_view bytes, const ReadOptions& options, Progress progress);

}  // namespace handwheel
