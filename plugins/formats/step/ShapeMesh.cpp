// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/ShapeMesh.h"

#include "step/LibraryProgress.h"
#include "step/MeshDeviation.h"

#include <BRepBndLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace handwheel {

namespace {

constexpr double kAngle = 0.35;  // rad, between neighbouring chords: small roundings stay round
constexpr std::size_t kMostTriangles = 20'000'000;

Error notMeshed(std::string reason) {
  return {ErrorCode::LibraryFailed, {std::move(reason)}, {}, {}};
}

using Corners = std::array<std::uint32_t, 3>;

// All faces so far.
struct Triangles {
  std::vector<gp_Pnt> points;
  std::vector<Corners> corners;
};

// At poles and seams the library makes triangles of two points.
bool isTriangle(const Triangles& all, const Corners& c) {
  const auto isSame = [&](std::uint32_t a, std::uint32_t b) {
    return all.points[a].XYZ().IsEqual(all.points[b].XYZ(), 0.0);
  };
  return !isSame(c[0], c[1]) && !isSame(c[1], c[2]) && !isSame(c[2], c[0]);
}

// Adds the triangles of a face; false where it has none.
bool addFace(const TopoDS_Face& face, Triangles& all) {
  TopLoc_Location location;
  const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(face, location);
  if (mesh.IsNull()) return false;
  const gp_Trsf placement = location.Transformation();
  const bool isTurned = (face.Orientation() == TopAbs_REVERSED) != placement.IsNegative();
  const std::size_t first = all.points.size(), before = all.corners.size();
  for (int i = 1; i <= mesh->NbNodes(); ++i) all.points.push_back(mesh->Node(i).Transformed(placement));
  for (int i = 1; i <= mesh->NbTriangles(); ++i) {
    std::array<int, 3> nodes{};
    mesh->Triangle(i).Get(nodes[0], nodes[1], nodes[2]);
    if (isTurned) std::swap(nodes[1], nodes[2]);
    Corners corners{};
    for (std::size_t k = 0; k < 3; ++k) corners[k] = static_cast<std::uint32_t>(first + nodes[k] - 1);
    if (isTriangle(all, corners)) all.corners.push_back(corners);
  }
  return all.corners.size() > before;
}

// Numbers of a binary PLY file, one after the other.
template <class Number>
void append(std::string& bytes, Number value) {
  const auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(value);
  bytes.append(raw.data(), raw.size());
}

std::string header(std::size_t points, std::size_t triangles) {
  const char* const order = std::endian::native == std::endian::little ? "little" : "big";
  return std::string("ply\nformat binary_") + order + "_endian 1.0\nelement vertex " + std::to_string(points) +
         "\nproperty double x\nproperty double y\nproperty double z\nelement face " + std::to_string(triangles) +
         "\nproperty list uchar uint vertex_indices\nend_header\n";
}

std::string plyOf(const Triangles& all) {
  std::string bytes = header(all.points.size(), all.corners.size());
  bytes.reserve(bytes.size() + 24 * all.points.size() + 13 * all.corners.size());
  for (const gp_Pnt& p : all.points)
    for (double coordinate : {p.X(), p.Y(), p.Z()}) append(bytes, coordinate);
  for (const Corners& corners : all.corners) {
    append(bytes, std::uint8_t{3});
    for (std::uint32_t corner : corners) append(bytes, corner);
  }
  return bytes;
}

// mm; not a number where the box is not one.
double diagonalOf(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box, false);
  return box.IsVoid() || box.IsOpen() ? std::nan("") : std::sqrt(box.SquareExtent());
}

}  // namespace

Result<ShapeMesh> meshOf(const TopoDS_Shape& shape, double chordShare, Progress progress) {
  ShapeMesh mesh;
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) ++mesh.faces;
  if (mesh.faces == 0) return notMeshed("the file contains no surface");
  IMeshTools_Parameters parameters;
  parameters.Deflection = chordShare * diagonalOf(shape);
  parameters.Angle = kAngle;
  if (!(parameters.Deflection > 0.0 && std::isfinite(parameters.Deflection)))
    return notMeshed("its surfaces have zero size");
  const Handle(LibraryProgress) indicator = new LibraryProgress(progress.part(0.0, 0.9));
  const BRepMesh_IncrementalMesh mesher(shape, parameters, indicator->Start());
  mesh.chord = std::max(parameters.Deflection, meshDeviation(shape));

  Triangles all;
  for (TopExp_Explorer each(shape, TopAbs_FACE); each.More(); each.Next()) {
    if (!addFace(TopoDS::Face(each.Current()), all)) ++mesh.facesLost;
    if (all.corners.size() > kMostTriangles)
      return notMeshed("it takes more than " + std::to_string(kMostTriangles) + " triangles");
  }
  if (all.corners.empty()) return notMeshed("none of its surfaces can be triangulated");
  mesh.ply = plyOf(all);
  progress.set(1.0);
  return mesh;
}

}  // namespace handwheel
