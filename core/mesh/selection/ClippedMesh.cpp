// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/selection/ClippedMesh.h"

#include <map>
#include <utility>
#include <vector>

namespace handwheel {
namespace {

using ConvexPiece = std::vector<Vec3>;  // fewer than three corners: nothing

// The parts of a convex piece below and above a plane across an axis. Corners in the plane are of both.
std::pair<ConvexPiece, ConvexPiece> dividedAt(const ConvexPiece& piece, Eigen::Index axis, double at) {
  ConvexPiece below, above;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const Vec3 &a = piece[i], &b = piece[(i + 1) % piece.size()];
    const double da = a[axis] - at, db = b[axis] - at;
    if (da <= 0.0) below.push_back(a);
    if (da >= 0.0) above.push_back(a);
    if (!(da < 0.0 && db > 0.0) && !(da > 0.0 && db < 0.0)) continue;
    Vec3 between = a + da / (da - db) * (b - a);
    between[axis] = at;
    below.push_back(between);
    above.push_back(between);
  }
  return {below, above};
}

// Adds the parts of a piece outside a box. Returns false if the whole piece is outside and was added as it is.
bool addOutside(const ConvexPiece& piece, const Box& box, std::vector<ConvexPiece>& outside) {
  const std::size_t before = outside.size();
  ConvexPiece inside = piece;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    for (const bool isUpper : {false, true}) {
      auto [below, above] = dividedAt(inside, axis, isUpper ? box.max()[axis] : box.min()[axis]);
      ConvexPiece& out = isUpper ? above : below;
      if (out.size() >= 3) outside.push_back(std::move(out));
      inside = std::move(isUpper ? below : above);
      if (inside.size() >= 3) continue;
      outside.resize(before);
      outside.push_back(piece);
      return false;
    }
  return true;
}

}  // namespace

PreviewMesh clippedMesh(const FaceHierarchy& faces, std::span<const Box> boxes) {
  PreviewMesh clipped{faces.mesh(), {}};
  std::map<Face, std::vector<Box>> meeting;
  for (const Box& box : boxes)
    faces.forEachInBox(box, [&](Face f) {
      meeting[f].push_back(box);
      return true;
    });
  for (const auto& [face, own] : meeting) {
    const TrianglePoints corners = faces.mesh().points(face);
    std::vector<ConvexPiece> pieces{ConvexPiece(corners.begin(), corners.end())};
    bool isCut = false;
    for (const Box& box : own) {
      std::vector<ConvexPiece> left;
      for (const ConvexPiece& piece : pieces) isCut = addOutside(piece, box, left) || isCut;
      pieces = std::move(left);
    }
    if (!isCut) continue;
    clipped.mesh.removeFace(face);
    clipped.touched.add(face);
    for (const ConvexPiece& piece : pieces) {
      std::vector<Vertex> vertices;
      for (const Vec3& p : piece) vertices.push_back(clipped.mesh.addVertex(p));
      for (std::size_t i = 2; i < vertices.size(); ++i)
        clipped.touched.add(clipped.mesh.addFace({vertices[0], vertices[i - 1], vertices[i]}));
    }
  }
  return clipped;
}

}  // namespace handwheel
