// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/measure/Section.h"

#include <string>

namespace handwheel {

// Drawings of the curves of a section at 1 : 1 in mm. They use the axes of axesOfPlane(), seen from the side to which
// the normal points. Coordinates are measured along these axes from the origin of the mesh, with all digits.

// Writes a section as an SVG 1.1 drawing. All curves form one path, so hollows stay empty; the page has the size of the
// section.
std::string svgOf(const Section& section, const Vec3& normal);
// Writes a section as a DXF R12 drawing. This version is widely readable. Each curve is a polyline on layer 0;
// $INSUNITS holds the unit.
std::string dxfOf(const Section& section, const Vec3& normal);

}  // namespace handwheel
