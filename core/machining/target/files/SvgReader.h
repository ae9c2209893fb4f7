// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "machining/target/files/Drawing.h"

#include <string_view>

namespace handwheel {

// Returns true if the first bytes of a file look like SVG.
bool looksLikeSvg(std::string_view head);

// Reads the outlines of an SVG file from untrusted bytes. Fill, stroke and style sheets are ignored.
//
// Paths, lines, polylines, polygons, rectangles, circles and ellipses are read, also in groups and under
// transformations. Elements that are not displayed, definitions and texts are ignored. Curves other than lines and
// circular arcs become arcs within Drawing::kCurveTolerance. y is flipped to point up. The unit of length is that of
// the attributes width and height; if they have none, a user unit is a pixel of 1/96 in. A horizontal line whose id,
// class or label is "axis" marks the axis; if there is no such line, the axis is the lowest line of the drawing, which
// must be horizontal. O(bytes). Source: W3C SVG 1.1, sections 7 to 9. Errors: the errors of readXml();
// ElementMalformed, FileTooLarge {segments}, TargetError::NoProfile, AxisUnknown, Cancelled.
Result<Drawing> readSvg(std::string_view bytes, Progress progress = {});

}  // namespace handwheel
