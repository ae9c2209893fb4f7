// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/structure/Transforming.h"

#include "base/NumberText.h"
#include "mesh/structure/CancelPolling.h"
#include "mesh/structure/FaceNormal.h"
#include "mesh/structure/Orientation.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

namespace handwheel {
namespace {

constexpr double kLargestCoordinate = 1e60;  // fourth powers of lengths stay finite
constexpr std::size_t kMostRegions = 64;

Error outOfRange(const char* what, double value, double least, double largest) {
  return {ErrorCode::ValueOutOfRange, {what, shortestText(value), shortestText(least), shortestText(largest)}, {}, {}};
}

std::vector<bool> usedVertices(const HalfEdgeMesh& mesh) {
  std::vector<bool> used(mesh.vertexSlots(), false);
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f)) continue;
    for (const Vertex v : mesh.triangle(f)) used[v] = true;
  }
  return used;
}

Box boxOf(const HalfEdgeMesh& mesh) {
  Box box;
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f)) continue;
    for (const Vec3& p : mesh.points(f)) box.extend(p);
  }
  return box;
}

bool isUsable(const Box& box) {
  return !box.isEmpty() && box.min().minCoeff() >= -kLargestCoordinate && box.max().maxCoeff() <= kLargestCoordinate;
}

// Moments of the surface, as those of a thin shell.
struct Moments {
  double area = 0.0;
  Vec3 centre = Vec3::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();  // about the centre, over the area
};

// The middles of a triangle's edges, each with a third of its area, have its moments up to the second.
template <class Visit>
void forEachEdgeMiddle(const HalfEdgeMesh& mesh, Visit visit) {
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f)) continue;
    const TrianglePoints t = mesh.points(f);
    for (std::size_t k = 0; k < 3; ++k) visit(Vec3(0.5 * (t[k] + t[(k + 1) % 3])), areaOf(t) / 3.0);
  }
}

Moments momentsOf(const HalfEdgeMesh& mesh, const Vec3& near) {
  Moments m;
  Vec3 sum = Vec3::Zero();
  forEachEdgeMiddle(mesh, [&](const Vec3& p, double weight) {
    m.area += weight;
    sum += weight * (p - near);
  });
  if (!(m.area > 0.0)) return m;
  m.centre = near + sum / m.area;
  forEachEdgeMiddle(mesh, [&](const Vec3& p, double weight) {
    const Vec3 d = p - m.centre;
    m.second += weight / m.area * d * d.transpose();
  });
  return m;
}

// Computes unitNormal() from the corner opposite the longest side: between the long sides of a sliver few digits are
// left.
Vec3 sureNormal(const TrianglePoints& t) {
  std::size_t first = 0;
  double longest = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double side = (t[(k + 2) % 3] - t[(k + 1) % 3]).stableNorm();
    if (side > longest) {
      longest = side;
      first = k;
    }
  }
  return unitNormal({t[first], t[(first + 1) % 3], t[(first + 2) % 3]});
}

// A possible base: its plane n · p = offset, with the body on the negative side.
struct FlatFace {
  Vec3 normal = Vec3::Zero();
  double offset = 0.0;
  double area = 0.0;
};

// Connected faces in one plane, the largest first.
std::vector<FlatFace> flatRegions(const HalfEdgeMesh& mesh, const Progress& progress) {
  std::vector<bool> seen(mesh.faceSlots(), false);
  std::vector<FlatFace> regions;
  std::vector<Face> open;
  for (Face seed = 0; seed < mesh.faceSlots(); ++seed) {
    if (!pollProgress(seed, mesh.faceSlots(), progress)) return {};
    if (!mesh.isLive(seed) || seen[seed]) continue;
    const Vec3 normal = unitNormal(mesh.points(seed));
    if (normal.isZero()) continue;
    FlatFace region;
    double largest = 0.0;
    seen[seed] = true;
    open.assign(1, seed);
    while (!open.empty()) {
      const Face f = open.back();
      open.pop_back();
      const TrianglePoints points = mesh.points(f);
      const double area = areaOf(points);
      region.area += area;
      // The plane of a sliver would be far from the other faces.
      if (area > largest) {
        largest = area;
        region.normal = sureNormal(points);
        region.offset = region.normal.dot(points[0]);
      }
      for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) {
        if (!mesh.hasOpposite(h)) continue;
        const Face other = HalfEdgeMesh::face(mesh.opposite(h));
        if (seen[other] || unitNormal(mesh.points(other)).dot(normal) < tolerance::kFlatCosine) continue;
        seen[other] = true;
        open.push_back(other);
      }
    }
    if (largest > 0.0) regions.push_back(region);
  }
  const std::size_t n = std::min(regions.size(), kMostRegions);
  std::partial_sort(regions.begin(), regions.begin() + static_cast<std::ptrdiff_t>(n), regions.end(),
                    [](const FlatFace& a, const FlatFace& b) { return a.area > b.area; });
  regions.resize(n);
  return regions;
}

// Returns the area of all faces in the plane; 0 if the body extends beyond it.
double standingArea(const HalfEdgeMesh& mesh, const FlatFace& plane, double flatness) {
  double area = 0.0;
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f)) continue;
    const TrianglePoints t = mesh.points(f);
    double low = std::numeric_limits<double>::infinity();
    for (const Vec3& p : t) {
      const double height = plane.normal.dot(p) - plane.offset;
      if (height > flatness) return 0.0;
      low = std::min(low, height);
    }
    if (low >= -flatness && unitNormal(t).dot(plane.normal) > 0.0) area += areaOf(t);
  }
  return area;
}

}  // namespace

Status transform(HalfEdgeMesh& mesh, const Eigen::Affine3d& by) {
  const double determinant = by.linear().determinant();
  const double largest = std::numeric_limits<double>::max();
  if (!by.matrix().allFinite() || !std::isnormal(determinant)) {
    return outOfRange("determinant", determinant, -largest, largest);
  }
  const std::vector<bool> used = usedVertices(mesh);
  for (Vertex v = 0; v < used.size(); ++v) {
    const Vec3 p = by * mesh.position(v);
    if (used[v] && !p.allFinite()) return outOfRange("coordinate", p.cwiseAbs().maxCoeff(), -largest, largest);
  }
  for (Vertex v = 0; v < used.size(); ++v) {
    if (used[v]) mesh.setPosition(v, by * mesh.position(v));
  }
  if (determinant < 0.0) reverseOrientation(mesh);
  return Done{};
}

void reverseOrientation(HalfEdgeMesh& mesh) {
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f)) continue;
    std::array<HalfEdge, 3> behind{};
    for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) {
      behind[reversedHalfEdge(h) % 3] = mesh.hasOpposite(h) ? reversedHalfEdge(mesh.opposite(h)) : mesh.opposite(h);
    }
    mesh.setTriangle(f, reversed(mesh.triangle(f)));
    for (HalfEdge k = 0; k < 3; ++k) mesh.setOpposite(3 * f + k, behind[k]);
  }
}

std::optional<Pose> ontoPrincipalAxes(const HalfEdgeMesh& mesh) {
  const Box box = boxOf(mesh);
  if (!isUsable(box)) return std::nullopt;
  const Moments m = momentsOf(mesh, box.center());
  if (!(m.area > 0.0)) return std::nullopt;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(m.second);
  Eigen::Matrix3d axes;  // one axis per row, the longest first
  for (Eigen::Index k = 0; k < 3; ++k) axes.row(k) = solver.eigenvectors().col(2 - k).transpose();
  Vec3 third = Vec3::Zero();
  forEachEdgeMiddle(mesh, [&](const Vec3& p, double weight) {
    const Vec3 along = axes * (p - m.centre);
    third += weight * along.cwiseProduct(along).cwiseProduct(along);
  });
  for (Eigen::Index k = 0; k < 2; ++k) {
    if (third[k] < 0.0) axes.row(k) = -axes.row(k);
  }
  axes.row(2) = axes.row(0).cross(axes.row(1));
  Pose pose = Pose::Identity();
  pose.linear() = axes;
  pose.translation() = -axes * m.centre;
  return pose;
}

std::optional<Pose> ontoLargestFlatFace(const HalfEdgeMesh& mesh, const FlatBaseOptions& resting, Progress progress) {
  const Box box = boxOf(mesh);
  if (!isUsable(box)) return std::nullopt;
  double whole = 0.0;
  forEachEdgeMiddle(mesh, [&](const Vec3&, double weight) { whole += weight; });
  const std::vector<FlatFace> regions = flatRegions(mesh, progress.part(0.0, 0.3));
  const double flatness = resting.flatness * box.diagonal().stableNorm();
  std::optional<FlatFace> best;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    if (!pollProgress(i, regions.size(), progress.part(0.3, 1.0), 1)) return std::nullopt;
    FlatFace plane = regions[i];
    plane.area = standingArea(mesh, plane, flatness);
    if (plane.area > 0.0 && plane.area >= resting.leastShare * whole && (!best || plane.area > best->area)) {
      best = plane;
    }
  }
  if (!best) return std::nullopt;
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::Quaterniond::FromTwoVectors(best->normal, -Vec3::UnitZ()).toRotationMatrix();
  Box turned;
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f)) continue;
    for (const Vec3& p : mesh.points(f)) turned.extend(Vec3(pose * p));
  }
  pose.translation() = Vec3(-turned.center().x(), -turned.center().y(), best->offset);
  return pose;
}

std::optional<Pose> boxToOrigin(const HalfEdgeMesh& mesh, const Vec3& anchor) {
  const Box box = boxOf(mesh);
  if (!isUsable(box)) return std::nullopt;
  Pose pose = Pose::Identity();
  pose.translation() = -(box.min() + anchor.cwiseProduct(box.sizes()));
  return pose;
}

}  // namespace handwheel
