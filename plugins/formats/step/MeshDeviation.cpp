// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/MeshDeviation.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <array>
#include <cmath>

namespace handwheel {

namespace {

double faceDeviation(const TopoDS_Face& face) {
  TopLoc_Location location;
  const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(face, location);
  if (mesh.IsNull() || !mesh->HasUVNodes()) return 0.0;
  const BRepAdaptor_Surface surface(face, false);
  const gp_Trsf placement = location.Transformation();
  double largest = 0.0;
  for (int i = 1; i <= mesh->NbTriangles(); ++i) {
    std::array<int, 3> nodes{};
    mesh->Triangle(i).Get(nodes[0], nodes[1], nodes[2]);
    std::array<gp_XYZ, 3> points;
    std::array<gp_XY, 3> at;
    for (std::size_t k = 0; k < 3; ++k) {
      points[k] = mesh->Node(nodes[k]).Transformed(placement).XYZ();
      at[k] = mesh->UVNode(nodes[k]).XY();
    }
    gp_XYZ normal = (points[1] - points[0]).Crossed(points[2] - points[0]);
    const double length = normal.Modulus();
    if (!(length > 0.0)) continue;
    normal /= length;
    for (const gp_XY& uv :
         {(at[0] + at[1] + at[2]) / 3.0, (at[0] + at[1]) / 2.0, (at[1] + at[2]) / 2.0, (at[2] + at[0]) / 2.0}) {
      const double distance = std::abs(normal.Dot(surface.Value(uv.X(), uv.Y()).XYZ() - points[0]));
      if (std::isfinite(distance)) largest = std::max(largest, distance);
    }
  }
  return largest;
}

}  // namespace

double meshDeviation(const TopoDS_Shape& shape) {
  double largest = 0.0;
  for (TopExp_Explorer each(shape, TopAbs_FACE); each.More(); each.Next())
    largest = std::max(largest, faceDeviation(TopoDS::Face(each.Current())));
  return largest;
}

}  // namespace handwheel
