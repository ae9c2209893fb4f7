// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/SheetRims.h"

#include "base/Tolerance.h"
#include "mesh/structure/CancelPolling.h"
#include "mesh/structure/FaceComponents.h"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace handwheel {
namespace {

struct Sheet {
  double area = 0.0;
  double volume = 0.0;  // between the part and the centre of its longest loop
  Vec3 firstMoment = Vec3::Zero();
  Eigen::Matrix3d secondMoment = Eigen::Matrix3d::Zero();
  BoundaryLoop* longest = nullptr;

  // Root mean square distances from the best plane and along its longer axis, with area for weight. What lies in a
  // plane has an outline of 4π at least (the isoperimetric inequality), a rough one somewhat less; one that is far
  // shorter is a hole in a plate.
  bool isFlat() const {
    if (outline() < M_PI) return false;
    const Vec3 mean = firstMoment / area;
    const Eigen::Matrix3d covariance = secondMoment / area - mean * mean.transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance, Eigen::EigenvaluesOnly);
    const double thickness = std::sqrt(std::max(0.0, solver.eigenvalues()[0]));
    const double extent = std::sqrt(std::max(0.0, solver.eigenvalues()[2]));
    return thickness < tolerance::kFlatSheet * extent;
  }

  // The longest loop's length, squared, in areas of the part: 4π for a flat disc, 2π for half a sphere.
  double outline() const { return longest->length * longest->length / area; }

  bool isRagged() const { return outline() > tolerance::kRaggedOutline; }

  // A flat disc with the outline's length would be larger than the part, and closed by a cone from the outline's centre
  // the part would hold little: a patch would be its second skin.
  bool isThin() const {
    return outline() > 4.0 * M_PI && std::abs(volume) < tolerance::kSheetVolume * std::pow(area, 1.5);
  }
};

}  // namespace

void markRims(const HalfEdgeMesh& mesh, const PositionTriangles& byPosition, std::vector<BoundaryLoop>& loops,
              Progress progress) {
  if (loops.empty()) return;
  const FaceComponents components(mesh, byPosition, progress.part(0.0, 0.5));
  if (progress.cancelled()) return;
  std::vector<Sheet> sheets(components.count());
  for (BoundaryLoop& loop : loops) {
    Sheet& sheet = sheets[components.of(HalfEdgeMesh::face(loop.halfEdges.front()))];
    if (!sheet.longest || loop.length > sheet.longest->length) sheet.longest = &loop;
  }
  const Vec3 origin = loops.front().centre;  // near the model, so that far-off ones keep their digits
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!pollProgress(f, mesh.faceSlots(), progress.part(0.5, 1.0))) return;
    if (!mesh.isProper(f)) continue;
    Sheet& sheet = sheets[components.of(f)];
    const TrianglePoints p = mesh.points(f);
    const double area = 0.5 * (p[1] - p[0]).cross(p[2] - p[0]).norm();
    sheet.area += area;
    if (!sheet.longest) continue;
    const Vec3& centre = sheet.longest->centre;
    sheet.volume += (p[0] - centre).dot((p[1] - centre).cross(p[2] - centre)) / 6.0;
    for (const Vec3& corner : p) {
      const Vec3 r = corner - origin;
      sheet.firstMoment += area / 3.0 * r;
      sheet.secondMoment += area / 3.0 * r * r.transpose();
    }
  }
  const Sheet* largest = nullptr;
  for (const Sheet& sheet : sheets) {
    if (!largest || sheet.area > largest->area) largest = &sheet;
    if (sheet.longest && sheet.area > 0.0) sheet.longest->rim = sheet.isFlat() || sheet.isThin() || sheet.isRagged();
  }
  if (!largest->longest || !largest->longest->rim) return;
  if (!largest->isRagged() && !(sheets.size() == 1 && largest->isFlat())) return;
  for (BoundaryLoop& loop : loops) loop.picture = loop.rim;
}

}  // namespace handwheel
