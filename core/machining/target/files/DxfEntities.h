// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/target/ProfileSegment.h"
#include "machining/target/files/DxfPairs.h"

#include <array>
#include <string>
#include <vector>

namespace handwheel {

// An entity of a DXF file: the groups that describe lines and arcs. Lengths are in the unit of the file.
struct DxfEntity {
  std::string type;                      // "LINE"
  std::uint64_t line = 0;                // line at which it begins
  std::string layer, lineType;           // in lower case
  bool isShown = true;                   // visible, and in the model space
  int flags = 0;                         // the value of group 70
  ProfilePoint first{0, 0};              // the values of groups 10 and 20
  ProfilePoint second{0, 0};             // the values of groups 11 and 21
  double size = 0.0;                     // group 40: the radius, or the ratio of the axes of an ellipse
  std::array<double, 2> span{0.0, 0.0};  // groups 50 and 51 in rad; for an ellipse groups 41 and 42 in rad
  ProfilePoint tilt{0, 0};               // x and y of the normal
  double normalZ = 1.0;

  struct Vertex {
    ProfilePoint at{0, 0};
    double bulge = 0.0;
    bool isFrame = false;  // control point of a spline, not on the curve
  };
  std::vector<Vertex> vertices;  // points of a polyline

  // Adds a group. Errors: those of DxfPair::number().
  Status take(const DxfPair& pair);
  bool isAxis() const;  // true for a line that marks the axis
  bool isRead() const;  // true for a type that curvesOf() knows
};

// Returns the lines and arcs of an entity. tolerance: largest distance of an ellipse from the arcs that replace it, in
// the unit of the file. Errors: ElementMalformed with the line.
Result<std::vector<ProfileSegment>> curvesOf(const DxfEntity& entity, double tolerance);

}  // namespace handwheel
