// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/Cleaning.h"

#include "mesh/Defects.h"
#include "mesh/EdgeTable.h"
#include "mesh/MeshBuilder.h"
#include "mesh/Weld.h"

#include <algorithm>
#include <map>

namespace handwheel {
namespace {

// The half-edge opposite the middle vertex of a needle: its longest edge.
HalfEdge longestEdge(const HalfEdgeMesh& mesh, Face f) {
  const auto length = [&](HalfEdge h) { return (mesh.position(mesh.to(h)) - mesh.position(mesh.from(h))).squaredNorm(); };
  HalfEdge longest = 3 * f;
  for (HalfEdge h = 3 * f + 1; h < 3 * f + 3; ++h) {
    if (length(h) > length(longest)) longest = h;
  }
  return longest;
}

bool areJoined(const HalfEdgeMesh& mesh, HalfEdge fromA, Vertex b) {
  const std::vector<HalfEdge> fan = mesh.fan(fromA);
  return std::any_of(fan.begin(), fan.end(), [&](HalfEdge g) {
    return mesh.to(g) == b || mesh.from(HalfEdgeMesh::previous(g)) == b;
  });
}

// Replaces edge h and its two faces by the other diagonal. False, and nothing changed, when a new face would have no area
// or the diagonal exists.
bool flipEdge(HalfEdgeMesh& mesh, HalfEdge h) {
  if (!mesh.hasOpposite(h)) return false;
  const HalfEdge o = mesh.opposite(h);
  const HalfEdge hn = HalfEdgeMesh::next(h), hp = HalfEdgeMesh::previous(h);
  const HalfEdge on = HalfEdgeMesh::next(o), op = HalfEdgeMesh::previous(o);
  const Vertex a = mesh.from(h), c = mesh.to(h), b = mesh.from(hp), d = mesh.from(op);
  const auto pos = [&](Vertex v) { return mesh.position(v); };
  if (b == d || areJoined(mesh, hp, d)) return false;
  if (isDegenerate({pos(b), pos(d), pos(c)}) || isDegenerate({pos(d), pos(b), pos(a)})) return false;

  // h: (a c b) and o: (c a d) become (b d c) and (d b a).
  const HalfEdge behind[4] = {mesh.opposite(hn), mesh.opposite(hp), mesh.opposite(on), mesh.opposite(op)};
  const Face f = HalfEdgeMesh::face(h), g = HalfEdgeMesh::face(o);
  mesh.setTriangle(f, {b, d, c});
  mesh.setTriangle(g, {d, b, a});
  mesh.pair(3 * f, 3 * g);
  const auto attach = [&](HalfEdge e, HalfEdge other) {
    mesh.setOpposite(e, other);
    if (other < static_cast<HalfEdge>(Open::Seam)) mesh.setOpposite(other, e);
  };
  attach(3 * f + 1, behind[3]);  // d→c was op
  attach(3 * f + 2, behind[0]);  // c→b was hn
  attach(3 * g + 1, behind[1]);  // b→a was hp
  attach(3 * g + 2, behind[2]);  // a→d was on
  return true;
}

}  // namespace

std::size_t removeDegenerateFaces(HalfEdgeMesh& mesh) {
  std::size_t removed = 0;
  std::vector<Face> needles;
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f)) continue;
    if (!mesh.isProper(f)) {
      mesh.removeFace(f);
      ++removed;
    } else if (isDegenerate(mesh.points(f))) {
      needles.push_back(f);
    }
  }
  // Needles may lie side by side; flipping one can free the next.
  for (bool progress = true; progress && !needles.empty();) {
    progress = false;
    std::vector<Face> left;
    for (Face f : needles) {
      const bool flipped = flipEdge(mesh, longestEdge(mesh, f));
      removed += flipped;
      progress |= flipped;
      if (!flipped) left.push_back(f);
    }
    needles.swap(left);
  }
  for (Face f : needles) mesh.removeFace(f);
  removed += needles.size();
  if (removed > 0) relink(mesh);
  return removed;
}

std::size_t removeDuplicateFaces(HalfEdgeMesh& mesh) {
  std::vector<Vec3> points(mesh.vertexSlots());
  for (Vertex v = 0; v < points.size(); ++v) points[v] = mesh.position(v);
  const PointClasses classes = classifyPoints(points);

  std::map<Triangle, std::vector<Face>> groups;
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> facesAt;  // per edge by position
  const auto edge = [](const Triangle& t, int k) { return std::minmax(t[k], t[(k + 1) % 3]); };
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isProper(f)) continue;
    Triangle t = mesh.triangle(f);
    for (std::uint32_t& v : t) v = classes.classOf[v];
    for (int k = 0; k < 3; ++k) ++facesAt[edge(t, k)];
    std::sort(t.begin(), t.end());
    groups[t].push_back(f);
  }
  std::size_t removed = 0;
  for (const auto& [t, faces] : groups) {
    if (faces.size() < 2) continue;
    const int count = static_cast<int>(faces.size());
    int others = 0;
    for (int k = 0; k < 3; ++k) others += facesAt[edge(t, k)] - count;
    if (others == 0 && count == 2) continue;  // a pillow
    const int keep = others <= 4 ? 1 : 0;     // two other faces at each edge close the surface without this one
    for (int i = keep; i < count; ++i) {
      mesh.removeFace(faces[static_cast<std::size_t>(i)]);
      for (int k = 0; k < 3; ++k) --facesAt[edge(t, k)];
      ++removed;
    }
  }
  if (removed > 0) relink(mesh);
  return removed;
}

std::size_t removeDebris(HalfEdgeMesh& mesh) {
  std::size_t removed = 0;
  for (const Component& part : findComponents(mesh)) {
    if (!part.debris) continue;
    for (Face f : part.faces) mesh.removeFace(f);
    removed += part.faces.size();
  }
  return removed;
}

}  // namespace handwheel
