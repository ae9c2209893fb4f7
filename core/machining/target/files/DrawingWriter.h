// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/target/files/Drawing.h"

#include <string>

namespace handwheel {

// Writes the half section of a target as DXF in text. AutoCAD R12 with $INSUNITS, mm: LINE and ARC on the layer
// "PROFILE", the axis on the layer "AXIS". z is x. Numbers have all their digits.
std::string dxfOf(const TargetProfile& target);

// Writes the half section as SVG in mm: one path, and the axis as a line of the id "axis". z runs to the right.
std::string svgOf(const TargetProfile& target);

// Returns the largest distance (mm) of points on either outline from the other: of corners and of points between them.
// It checks a written file. O(n log n).
double distanceBetween(const TargetProfile& a, const TargetProfile& b);

}  // namespace handwheel
