// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/TriangleSoup.h"

#include <string>

namespace handwheel {

// A 3MF file with one object in millimetres, built once; deflated. Coordinates are rounded to the number type first and
// written with the shortest digits that read back to the same double; they must be finite. The archive is empty once
// cancelled, and should the library fail. O(points + triangles).
std::string writeThreeMf(const TriangleSoup& soup, NumberType numbers, Progress progress = {});

}  // namespace handwheel
