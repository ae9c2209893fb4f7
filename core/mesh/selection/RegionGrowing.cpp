// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/selection/RegionGrowing.h"

#include "mesh/structure/FaceNormal.h"

#include <cmath>

namespace handwheel {
namespace {

// A face from which growing continues, with its representative normal.
struct Front {
  Face face;
  Vec3 normal;
};

// crosses(front, neighbour) returns the representative normal of the neighbour, or nothing if growing stops there.
template <class Crosses>
std::optional<FaceSelection> grow(const HalfEdgeMesh& mesh, std::vector<Front> fronts, const GrowthLimit& limit,
                                  Crosses crosses) {
  constexpr std::size_t kLook = 0xfff;  // mask for reading the cancel flag every 4096 faces
  FaceSelection result;
  std::erase_if(fronts, [&](const Front& front) { return !result.add(front.face); });
  for (std::size_t done = 0; !fronts.empty() && result.count() < limit.faces; ++done) {
    if ((done & kLook) == 0 && limit.progress.cancelled()) return std::nullopt;
    const Front front = fronts.back();
    fronts.pop_back();
    for (HalfEdge h = 3 * front.face; h < 3 * front.face + 3; ++h) {
      if (!mesh.hasOpposite(h)) continue;
      const Face neighbour = HalfEdgeMesh::face(mesh.opposite(h));
      if (result.contains(neighbour)) continue;
      const std::optional<Vec3> normal = crosses(front, neighbour);
      if (!normal) continue;
      result.add(neighbour);
      fronts.push_back({neighbour, *normal});
    }
  }
  return result;
}

std::vector<Front> frontsOf(const HalfEdgeMesh& mesh, std::span<const Face> seeds) {
  std::vector<Front> fronts;
  for (const Face f : seeds)
    if (f < mesh.faceSlots() && mesh.isLive(f)) fronts.push_back({f, unitNormal(mesh.points(f))});
  return fronts;
}

// Calls visit(face) for the faces around each vertex at which faces inside and outside of the selection meet. All faces
// around a vertex are connected over edges, so each such vertex is the end of an edge with faces on both sides of the
// outline.
template <class Visit>
void visitOutline(const HalfEdgeMesh& mesh, const FaceSelection& faces, Visit visit) {
  std::vector<bool> seen(mesh.vertexSlots(), false);
  const auto around = [&](HalfEdge h) {
    if (seen[mesh.from(h)]) return;
    seen[mesh.from(h)] = true;
    for (const HalfEdge g : mesh.fan(h)) visit(HalfEdgeMesh::face(g));
  };
  faces.forEach([&](Face f) {
    if (f >= mesh.faceSlots() || !mesh.isLive(f)) return;
    for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) {
      if (!mesh.hasOpposite(h) || faces.contains(HalfEdgeMesh::face(mesh.opposite(h)))) continue;
      around(h);
      around(HalfEdgeMesh::next(h));
    }
  });
}

}  // namespace

std::optional<FaceSelection> connectedFaces(const HalfEdgeMesh& mesh, std::span<const Face> seeds,
                                            const GrowthLimit& limit) {
  return grow(mesh, frontsOf(mesh, seeds), limit,
              [](const Front& front, Face) { return std::optional<Vec3>(front.normal); });
}

std::optional<FaceSelection> facesWithinAngle(const HalfEdgeMesh& mesh, std::span<const Face> seeds, double angle,
                                              const GrowthLimit& limit) {
  return grow(mesh, frontsOf(mesh, seeds), limit, [&](const Front& front, Face neighbour) -> std::optional<Vec3> {
    const Vec3 normal = unitNormal(mesh.points(neighbour));
    if (normal.isZero(0.0)) return front.normal;
    if (front.normal.isZero(0.0)) return normal;  // a seed without area leads anywhere
    // Exact where an arc cosine of nearly 1 is not.
    const double between = std::atan2(front.normal.cross(normal).norm(), front.normal.dot(normal));
    return between <= angle ? std::optional<Vec3>(normal) : std::nullopt;
  });
}

FaceSelection grownByRing(const HalfEdgeMesh& mesh, const FaceSelection& faces) {
  FaceSelection result = faces;
  visitOutline(mesh, faces, [&](Face f) { result.add(f); });
  return result;
}

FaceSelection shrunkByRing(const HalfEdgeMesh& mesh, const FaceSelection& faces) {
  FaceSelection result = faces;
  visitOutline(mesh, faces, [&](Face f) { result.remove(f); });
  return result;
}

}  // namespace handwheel
