// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/target/files/Drawing.h"

#include <string>

namespace handwheel {

// Writes the half section of a target as a DXF text file. The format is AutoCAD R12 with $INSUNITS in mm. The outline
// consists of LINE and ARC entities on the layer "PROFILE", and the axis is on the layer "AXIS". x of the file is z of
// the target. Numbers are written with all their digits.
std::string dxfOf(const TargetProfile& target);

// Writes the half section of a target as SVG in mm. The outline is one path, and the axis is a line with the id "axis".
// z points to the right.
std::string svgOf(const TargetProfile& target);

// Returns the largest distance (mm) of points on either outline from the other outline. The points are corners and
// points between corners. The function serves to check a written file. O(n log n).
double distanceBetween(const TargetProfile& a, const TargetProfile& b);

}  // namespace handwheel
