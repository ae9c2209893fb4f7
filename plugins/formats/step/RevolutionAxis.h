// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <BRepAdaptor_Surface.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Ax1.hxx>
#include <optional>
#include <vector>

namespace handwheel {

// A face of a shape, with data for detecting surfaces of revolution.
struct ExaminedFace {
  TopoDS_Face face;
  BRepAdaptor_Surface surface;
  double u[2], v[2];  // bounds of the parameters
  double area = 0.0;  // approximate area
  struct Sample {
    gp_Pnt point;
    gp_Dir normal;
  };
  std::vector<Sample> samples;
};

std::vector<ExaminedFace> examine(const TopoDS_Shape& shape);

// Returns true if a face is a surface of revolution about an axis. All its normals then intersect the axis (H.
// Pottmann, J. Wallner, "Computational Line Geometry", 3.3.1).
bool isOfRevolution(const ExaminedFace& face, const gp_Ax1& axis);

// Returns the axis for which the faces of revolution have the largest total area. It points in the positive direction
// of the nearest coordinate axis, and its location is its point nearest to the origin.
std::optional<gp_Ax1> axisOf(const std::vector<ExaminedFace>& faces);

}  // namespace handwheel
