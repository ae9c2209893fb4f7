// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/SheetBoundaries.h"

#include "base/Tolerance.h"
#include "mesh/structure/Shells.h"

#include <cmath>
#include <numbers>

namespace handwheel {
namespace {

struct Sheet {
  double area = 0.0;
  double volume = 0.0;             // between the shell and the centre of its longest loop
  Vec3 areaVector = Vec3::Zero();  // the sum of area times normal: that of the loops' patches, whatever they are
  std::size_t faces = 0;
  std::size_t loops = 0;
  BoundaryLoop* longest = nullptr;

  // The longest loop's length, squared, in areas of the shell: 4π for a flat disc, 2π for half a sphere.
  double outline() const { return longest->length * longest->length / area; }

  bool looksOneWay() const { return areaVector.norm() > tolerance::kOneWaySheet * area; }

  bool isRagged() const { return outline() > tolerance::kRaggedOutline; }

  // A disc of which every vertex is on the edge, as a flake of one or two triangles: it has nothing that a patch could
  // enclose.
  bool isAllEdge() const { return loops == 1 && faces + 2 == longest->halfEdges.size(); }

  // A flat disc with the outline's length would be larger than the shell, and closed by a cone from the outline's
  // centre the shell would hold little: a patch would be its second skin.
  bool isThin() const {
    return outline() > 4.0 * std::numbers::pi && std::abs(volume) < tolerance::kSheetVolume * std::pow(area, 1.5);
  }
};

void measure(const HalfEdgeMesh& mesh, const std::vector<Face>& shell, Sheet& sheet) {
  const Vec3& centre = sheet.longest->centre;
  for (const Face f : shell) {
    const TrianglePoints p = mesh.points(f);
    const Vec3 doubled = (p[1] - p[0]).cross(p[2] - p[0]);
    sheet.area += 0.5 * doubled.norm();
    sheet.areaVector += 0.5 * doubled;
    sheet.volume += (p[0] - centre).dot((p[1] - centre).cross(p[2] - centre)) / 6.0;
  }
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
  for (std::size_t i = 0; i < shells.size(); ++i) {
    Sheet& sheet = sheets[i];
    if (!sheet.longest) continue;
    sheet.faces = shells[i].size();
    measure(mesh, shells[i], sheet);
    if (sheet.area > 0.0)
      sheet.longest->isSheetBoundary = sheet.looksOneWay() || sheet.isThin() || sheet.isRagged() || sheet.isAllEdge();
  }
}

}  // namespace handwheel
