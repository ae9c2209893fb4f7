// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "machining/target/files/Drawing.h"

#include <string_view>

namespace handwheel {

bool looksLikeSvg(std::string_view head);

// Reads the outlines of an SVG file from untrusted bytes. Fill, stroke and style sheets do not matter.
//
// Paths, lines, polylines, polygons, rectangles, circles and ellipses are read, in groups and under transformations;
// elements that are not displayed, definitions and texts are not. Other curves than lines and circular arcs become arcs
// within Drawing::kCurveTolerance. y is flipped to point up. The unit is that of width or height; else a user unit is a
// pixel of 1/96 in. A horizontal line whose id, class or label is "axis" marks the axis; without one, it is the lowest
// straight line. O(bytes). Source: W3C SVG 1.1, sections 7 to 9. Errors: those of readXml(); ElementMalformed,
// FileTooLarge {segments}, TargetError::NoProfile, AxisUnknown, Cancelled.
Result<Drawing> readSvg(std::string_view bytes, Progress progress = {});

}  // namespace handwheel
