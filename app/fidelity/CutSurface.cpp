// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fidelity/CutSurface.h"

#include "fidelity/SeededInput.h"
#include "mesh/structure/MeshBuilder.h"
#include "proximity/TriangleHierarchy.h"

#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

constexpr std::size_t kAttempts = 50;  // for each hole

// The faces that hang together with the first one inside a ball around it.
std::vector<Face> facesInBall(const HalfEdgeMesh& mesh, Face first, double radius) {
  const TrianglePoints p = mesh.points(first);
  const Vec3 centre = (p[0] + p[1] + p[2]) / 3.0;
  std::vector<bool> seen(mesh.faceSlots(), false);
  std::vector<Face> faces{first};
  seen[first] = true;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (HalfEdge h = 3 * faces[i]; h < 3 * faces[i] + 3; ++h) {
      if (!mesh.hasOpposite(h)) continue;
      const Face f = HalfEdgeMesh::face(mesh.opposite(h));
      if (seen[f] || (mesh.position(mesh.to(HalfEdgeMesh::next(mesh.opposite(h)))) - centre).norm() > radius) continue;
      seen[f] = true;
      faces.push_back(f);
    }
  }
  return faces;
}

// The distance to the faces of a mesh that are cut out.
DistanceToTruth distanceTo(const HalfEdgeMesh& mesh, const std::vector<Face>& faces) {
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  for (Face f : faces) {
    const auto n = static_cast<std::uint32_t>(points.size());
    for (const Vec3& p : mesh.points(f)) points.push_back(p);
    triangles.push_back({n, n + 1, n + 2});
  }
  const auto hierarchy = std::make_shared<TriangleHierarchy>(points, triangles);
  return [hierarchy](const Vec3& p) { return std::sqrt(hierarchy->nearest(p)->squaredDistance); };
}

}  // namespace

CutSurface cutHoles(const TriangleSoup& soup, std::uint64_t seed, const DistanceToTruth& truth,
                    const CutOptions& options) {
  Random random(seed);
  HalfEdgeMesh mesh = buildMesh(soup).mesh;
  Box box;
  for (const Vec3& p : soup.points) box.extend(p);
  const double radius = options.radius * box.diagonal().norm();
  std::vector<std::pair<Vec3, DistanceToTruth>> cuts;
  const std::size_t attempts = mesh.faceSlots() > 0 ? kAttempts * options.holes : 0;
  for (std::size_t attempt = 0; attempt < attempts && cuts.size() < options.holes; ++attempt) {
    const auto first = static_cast<Face>(random.below(mesh.faceSlots()));
    if (!mesh.isLive(first) || !mesh.isProper(first)) continue;
    const Vec3 centre = mesh.points(first)[0];
    const bool isAtCrease = options.distanceToCrease && cuts.size() % 2 == 0;
    if (isAtCrease && options.distanceToCrease(centre) > 0.5 * radius) continue;
    const auto isNear = [&](const auto& c) { return (c.first - centre).norm() < 3.0 * radius; };
    if (std::any_of(cuts.begin(), cuts.end(), isNear)) continue;
    const std::vector<Face> faces = facesInBall(mesh, first, radius);
    cuts.emplace_back(centre, truth ? truth : distanceTo(mesh, faces));
    for (Face f : faces) mesh.removeFace(f);
  }
  relink(mesh);

  CutSurface result;
  const std::vector<BoundaryLoop> loops = findBoundaryLoops(mesh);
  for (const auto& [centre, distance] : cuts) {
    // The hole is the longest loop around the cut.
    const BoundaryLoop* hole = nullptr;
    for (const BoundaryLoop& loop : loops) {
      const bool isHere = (loop.centre - centre).norm() < radius;
      if (isHere && (!hole || loop.length > hole->length)) hole = &loop;
    }
    if (hole) result.holes.push_back({*hole, distance});
  }
  result.filler = std::make_unique<HoleFiller>(mesh);
  return result;
}

}  // namespace handwheel
