// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/SheetBoundaries.h"

#include "base/Tolerance.h"
#include "mesh/structure/PositionKey.h"
#include "mesh/structure/Shells.h"

#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <tuple>

namespace handwheel {
namespace {

// Figures of a shell, in lengths of about its longest loop: squares of areas vanish or overflow at extreme sizes.
struct Sheet {
  double unit = 1.0;  // the power of two that makes these of mm
  double area = 0.0;
  double volume = 0.0;             // between the shell and the centre of its longest loop
  Vec3 areaVector = Vec3::Zero();  // sum of area times normal, which equals that of any patches of the loops
  std::size_t faces = 0;
  std::size_t loops = 0;
  BoundaryLoop* longest = nullptr;

  // Squared length of the longest loop over the area of the shell: 4π for a flat disc, 2π for a hemisphere.
  double outline() const { return unit * longest->length * (unit * longest->length) / area; }

  bool facesOneDirection() const { return areaVector.norm() > tolerance::kSheetAreaVector * area; }

  bool isRagged() const { return outline() > tolerance::kRaggedOutline; }

  // Returns true for a disc with all vertices on the edge, such as a flake of one or two triangles. It has nothing that
  // a patch could enclose.
  bool isAllEdge() const { return loops == 1 && faces + 2 == longest->halfEdges.size(); }

  // Returns true if a flat disc with the outline's length would be larger than the shell, and a cone from the outline's
  // centre would enclose little volume: a patch would be a second layer.
  bool isThin() const {
    return outline() > 4.0 * std::numbers::pi && std::abs(volume) < tolerance::kSheetVolume * std::pow(area, 1.5);
  }
};

void measure(const HalfEdgeMesh& mesh, const std::vector<Face>& shell, Sheet& sheet) {
  if (const double length = sheet.longest->length; length > 0.0 && std::isfinite(length))
    sheet.unit = std::ldexp(1.0, -std::ilogb(length));
  const Vec3 centre = sheet.unit * sheet.longest->centre;
  for (const Face f : shell) {
    TrianglePoints p = mesh.points(f);
    for (Vec3& corner : p) corner *= sheet.unit;
    const Vec3 doubled = (p[1] - p[0]).cross(p[2] - p[0]);
    sheet.area += 0.5 * doubled.norm();
    sheet.areaVector += 0.5 * doubled;
    sheet.volume += (p[0] - centre).dot((p[1] - centre).cross(p[2] - centre)) / 6.0;
  }
}

// Marks the loops that have a seam at which the faces of one shell disagree: both run along it in the same direction.
// They must be most of the boundary of their shell. Otherwise the shell is a scan with a one-sided defect.
void markOneSided(const HalfEdgeMesh& mesh, std::vector<BoundaryLoop>& loops, const std::vector<std::size_t>& shellOf) {
  using Key = std::tuple<PointKey, PointKey, std::size_t>;
  const auto shellAt = [&](const BoundaryLoop& loop) { return shellOf[HalfEdgeMesh::face(loop.halfEdges.front())]; };
  std::map<std::size_t, double> whole, disagreeing;  // lengths of boundaries by shell, mm
  std::map<Key, BoundaryLoop*> first;
  std::set<BoundaryLoop*> found;
  for (BoundaryLoop& loop : loops) {
    whole[shellAt(loop)] += loop.length;
    if (loop.halfEdges.size() == loop.borderEdges) continue;
    for (const HalfEdge h : loop.halfEdges) {
      const Key key(positionKey(mesh.position(mesh.from(h))), positionKey(mesh.position(mesh.to(h))),
                    shellOf[HalfEdgeMesh::face(h)]);
      const auto [at, isNew] = first.emplace(key, &loop);
      if (!isNew) found.insert({&loop, at->second});
    }
  }
  for (const BoundaryLoop* loop : found) disagreeing[shellAt(*loop)] += loop->length;
  for (BoundaryLoop* loop : found) loop->isSheetBoundary = disagreeing[shellAt(*loop)] > 0.5 * whole[shellAt(*loop)];
}

}  // namespace

void markSheetBoundaries(const HalfEdgeMesh& mesh, std::vector<BoundaryLoop>& loops, Progress progress) {
  if (loops.empty()) return;
  const std::vector<std::vector<Face>> shells = findShells(mesh, progress);
  if (progress.cancelled()) return;
  std::vector<std::size_t> shellOf(mesh.faceSlots());
  for (std::size_t i = 0; i < shells.size(); ++i) {
    for (const Face f : shells[i]) shellOf[f] = i;
  }
  std::vector<Sheet> sheets(shells.size());
  for (BoundaryLoop& loop : loops) {
    Sheet& sheet = sheets[shellOf[HalfEdgeMesh::face(loop.halfEdges.front())]];
    ++sheet.loops;
    if (!sheet.longest || loop.length > sheet.longest->length) sheet.longest = &loop;
  }
  markOneSided(mesh, loops, shellOf);
  for (std::size_t i = 0; i < shells.size(); ++i) {
    Sheet& sheet = sheets[i];
    if (!sheet.longest) continue;
    sheet.faces = shells[i].size();
    measure(mesh, shells[i], sheet);
    if (sheet.area > 0.0)
      sheet.longest->isSheetBoundary |=
          sheet.facesOneDirection() || sheet.isThin() || sheet.isRagged() || sheet.isAllEdge();
  }
}

}  // namespace handwheel
