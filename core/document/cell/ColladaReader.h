// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "mesh/structure/TriangleSoup.h"

#include <string_view>

namespace handwheel {

// Mesh read from a COLLADA document.
struct ColladaMesh {
  TriangleSoup soup;          // In metres; vertices not welded
  std::vector<Error> damage;  // Parts that could not be understood and were left out
};

// Reads the triangles and polygons of a COLLADA 1.4 or 1.5 document. Instances are placed as in its scene. Its unit is
// applied; its up axis is ignored, as is usual for robot descriptions. Materials, skins and animations are left out.
// O(bytes + triangles); both numbers are limited. Errors: those of readXml(), NoTriangles.
Result<ColladaMesh> readCollada(std::string_view bytes, Progress progress = {});

// Returns true if the first bytes of a file look like COLLADA.
bool looksLikeCollada(std::string_view head);

}  // namespace handwheel
