// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "machining/target/files/Drawing.h"

#include <string_view>

namespace handwheel {

bool looksLikeDxf(std::string_view head);

// Reads the curves in the model space of a text DXF file. The bytes are untrusted.
//
// The entities LINE, ARC, CIRCLE, ELLIPSE, LWPOLYLINE and POLYLINE are read, unless they are invisible, in paper space
// or not in a plane parallel to x and y. Lines on a layer "axis" or "center", or with such a line type, mark the axis.
// The variable $INSUNITS gives the unit; without it, the unit is mm. O(bytes). Source: AutoCAD's DXF reference, group
// codes. Errors: FileTooLarge {bytes, segments}, ElementMalformed with the line, NumberMalformed, NumberNotFinite,
// TargetError::BinaryDrawing, NoProfile, Cancelled.
Result<Drawing> readDxf(std::string_view bytes, Progress progress = {});

}  // namespace handwheel
