// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/TriangleSoup.h"

namespace handwheel {

// Thickens triangles to prisms, half of the thickness (mm) to either side. volumeOfSurface() takes such a surface also
// where the triangles enclose nothing, as open sheets and triangles that share no edges. Prisms overlap where triangles
// meet, and leave a notch of half the thickness on the outside of a bend. Triangles without area are left out.
TriangleSoup wallsOf(const TriangleSoup& surface, double thickness);

}  // namespace handwheel
