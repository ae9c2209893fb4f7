// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/Section.h"

#include <string>

namespace handwheel {

// The curves of a section as a drawing at 1 : 1 in mm, with the axes of axesOfPlane(): seen from the side to which the
// normal points. Coordinates are those along these axes from the origin of the mesh, in full.

// SVG 1.1: one path, hollows as hollows; the page is as large as the section.
std::string svgOf(const Section& section, const Vec3& normal);
// DXF R12, which everything reads: a polyline for each curve on layer 0, the unit in $INSUNITS.
std::string dxfOf(const Section& section, const Vec3& normal);

}  // namespace handwheel
