// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/solid/CrackStitching.h"

#include "base/Tolerance.h"
#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/structure/MeshBuilder.h"
#include "proximity/TriangleHierarchy.h"

#include <algorithm>

namespace handwheel {
namespace {

constexpr double kOppositeCosine = -0.5;  // largest cosine between the directions of the two sides
constexpr double kOwnStretch = 4.0;    // a side is not its own other side within this multiple of the distance along it
constexpr double kMostInward = 0.5;    // the other side is not behind the faces at this one (cosine)
constexpr double kLeastLength = 10.0;  // least length of a crack, in multiples of its mean width
constexpr std::size_t kMostMisses = 3;    // vertices in a row without another side that do not end a crack
constexpr int kTangentSteps = 2;          // edges to either side that determine the direction of a boundary
constexpr int kStitchPasses = 4;          // a pass stitches the vertices that are nearest to each other
constexpr std::uint32_t kMeanWindow = 8;  // points to either side over which a displacement is averaged
constexpr std::uint32_t kNoPoint = ~std::uint32_t{0};

// The points of all boundaries, one after the other.
struct BoundaryPoints {
  struct Point {
    HalfEdge start;  // half-edge that starts here
    std::uint32_t loop;
    double along;                    // distance from the first point of the loop, mm
    Vec3 direction;                  // direction of the boundary
    Vec3 inward;                     // unit vector from the boundary towards its face
    std::uint32_t other = kNoPoint;  // nearest point on the other side
    double width = 0.0;              // distance to it, mm
    bool isInCrack = false;
  };

  BoundaryPoints(const HalfEdgeMesh& m, const std::vector<BoundaryLoop>& loops) : mesh(m) {
    for (std::uint32_t i = 0; i < loops.size(); ++i) {
      firstOf.push_back(static_cast<std::uint32_t>(points.size()));
      lengthOf.push_back(loops[i].length);
      addLoop(loops[i], i);
    }
    firstOf.push_back(static_cast<std::uint32_t>(points.size()));
  }

  const Vec3& position(std::uint32_t i) const { return mesh.position(mesh.from(points[i].start)); }

  // Returns the distance of two points along their loop; infinite if they are on different ones.
  double apart(std::uint32_t i, std::uint32_t k) const {
    const Point &a = points[i], &b = points[k];
    if (a.loop != b.loop) return std::numeric_limits<double>::infinity();
    const double d = std::abs(a.along - b.along);
    return std::min(d, lengthOf[a.loop] - d);
  }

  const HalfEdgeMesh& mesh;
  std::vector<Point> points;
  std::vector<std::uint32_t> firstOf;  // index of the first point of each loop, then the number of points
  std::vector<double> lengthOf;        // mm

 private:
  void addLoop(const BoundaryLoop& loop, std::uint32_t number) {
    const auto n = static_cast<int>(loop.halfEdges.size());
    const auto at = [&](int i) -> const Vec3& {
      return mesh.position(mesh.from(loop.halfEdges[static_cast<std::size_t>((i + n) % n)]));
    };
    double along = 0.0;
    const int steps = std::min(kTangentSteps, n - 1);
    for (int i = 0; i < n; ++i) {
      const Vec3 direction = (at(i + steps) - at(i - steps)).stableNormalized();
      const HalfEdge h = loop.halfEdges[static_cast<std::size_t>(i)];
      const Vec3 edge = (at(i + 1) - at(i)).stableNormalized();
      Vec3 inward = mesh.position(mesh.to(mesh.next(h))) - at(i);
      inward -= inward.dot(edge) * edge;
      points.push_back({h, number, along, direction, inward.stableNormalized()});
      along += (at(i + 1) - at(i)).norm();
    }
  }
};

// Finds the point on another stretch of boundary, which runs in the opposite direction, that is nearest to each point
// when this is shifted.
void findOthers(BoundaryPoints& boundary, const std::vector<Vec3>& shifts, double reach, const Progress& progress) {
  std::vector<Vec3> positions;
  std::vector<Triangle> each;
  for (std::uint32_t i = 0; i < boundary.points.size(); ++i) {
    positions.push_back(boundary.position(i));
    each.push_back({i, i, i});
  }
  const TriangleHierarchy tree(positions, each, progress.part(0.0, 0.3));
  for (std::uint32_t i = 0; i < boundary.points.size() && !progress.cancelled(); ++i) {
    BoundaryPoints::Point& point = boundary.points[i];
    const Vec3& p = positions[i];
    const Box box((p.array() - reach).matrix(), (p.array() + reach).matrix());
    point.other = kNoPoint;
    double least = reach;
    tree.forEachInBox(box, [&](std::uint32_t k) {
      const double distance = (positions[k] - p).norm(), remaining = (positions[k] - p - shifts[i]).norm();
      if (distance > reach || remaining > least ||
          boundary.apart(i, k) <= kOwnStretch * std::max(distance, 1e-3 * reach))
        return true;
      if (point.direction.dot(boundary.points[k].direction) > kOppositeCosine) return true;
      if ((positions[k] - p).dot(point.inward) > kMostInward * distance) return true;
      least = remaining;
      point.other = k;
      point.width = distance;
      return true;
    });
  }
}

// Returns how far the other side is at each point: the mean of the displacements there, over some points to either
// side.
std::vector<Vec3> meanDisplacements(const BoundaryPoints& boundary) {
  std::vector<Vec3> displacements(boundary.points.size(), Vec3::Zero());
  for (std::size_t loop = 0; loop + 1 < boundary.firstOf.size(); ++loop) {
    const std::uint32_t first = boundary.firstOf[loop], n = boundary.firstOf[loop + 1] - first;
    const std::uint32_t window = std::min(kMeanWindow, (n - 1) / 2);
    for (std::uint32_t i = 0; i < n; ++i) {
      double count = 0.0;
      for (std::uint32_t k = 0; k <= 2 * window; ++k) {
        const std::uint32_t at = first + (i + n - window + k) % n, other = boundary.points[at].other;
        if (other == kNoPoint) continue;
        displacements[first + i] += boundary.position(other) - boundary.position(at);
        count += 1.0;
      }
      if (count > 0.0) displacements[first + i] /= count;
    }
  }
  return displacements;
}

// Marks the stretches of a loop along which there is another side, and which are long in comparison to the distance.
void markCracks(BoundaryPoints& boundary, std::uint32_t loop) {
  const std::uint32_t first = boundary.firstOf[loop], n = boundary.firstOf[loop + 1] - first;
  auto& points = boundary.points;
  const auto isAlong = [&](std::uint32_t i) { return points[first + i % n].other != kNoPoint; };
  std::uint32_t begin = 0;  // behind a gap between two stretches, or anywhere if there is none
  for (std::uint32_t i = 0, misses = 0; i < n; ++i) {
    misses = isAlong(i) ? 0 : misses + 1;
    if (misses <= kMostMisses) continue;
    begin = i + 1;
    break;
  }
  std::vector<std::uint32_t> stretch;
  double length = 0.0, width = 0.0;
  const auto finish = [&] {
    const double mean = width / std::max<double>(1.0, static_cast<double>(stretch.size()));
    if (stretch.size() > 2 && length >= kLeastLength * mean) {
      for (const std::uint32_t i : stretch) points[i].isInCrack = true;
    }
    stretch.clear();
    length = width = 0.0;
  };
  for (std::uint32_t i = begin, misses = 0; i < begin + n; ++i) {
    const std::uint32_t at = first + i % n, before = first + (i + n - 1) % n;
    misses = isAlong(i) ? 0 : misses + 1;
    if (misses > kMostMisses) finish();
    if (!isAlong(i)) continue;
    if (!stretch.empty()) length += boundary.apart(at, before);
    stretch.push_back(at);
    width += points[at].width;
  }
  finish();
}

std::size_t openEdges(const HalfEdgeMesh& mesh) {
  std::size_t n = 0;
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h) n += mesh.isBorder(h) || mesh.isSeam(h);
  return n;
}

// Merges the sides of cracks once. Returns the vertices that were moved.
std::vector<Vertex> stitchOnce(HalfEdgeMesh& mesh, double reach, const Progress& progress) {
  std::vector<Vertex> moved;
  const std::vector<BoundaryLoop> loops = findBoundaryLoops(mesh, progress.part(0.0, 0.3));
  if (progress.cancelled() || loops.empty()) return moved;
  BoundaryPoints boundary(mesh, loops);
  findOthers(boundary, std::vector<Vec3>(boundary.points.size(), Vec3::Zero()), reach, progress.part(0.3, 0.45));
  findOthers(boundary, meanDisplacements(boundary), reach, progress.part(0.45, 0.6));
  for (std::uint32_t i = 0; i < loops.size(); ++i) markCracks(boundary, i);
  HalfEdgeMesh trial = mesh;
  for (std::uint32_t i = 0; i < boundary.points.size(); ++i) {
    const BoundaryPoints::Point& point = boundary.points[i];
    if (!point.isInCrack || point.other < i || boundary.points[point.other].other != i) continue;
    const Vertex a = mesh.from(point.start), b = mesh.from(boundary.points[point.other].start);
    const Vec3 middle = 0.5 * (mesh.position(a) + mesh.position(b));
    for (const Vertex v : {a, b}) {
      trial.setPosition(v, middle);
      moved.push_back(v);
    }
  }
  if (progress.cancelled() || moved.empty()) return {};
  relink(trial, progress.part(0.7, 1.0));
  if (progress.cancelled() || openEdges(trial) >= openEdges(mesh)) return {};
  mesh = std::move(trial);
  return moved;
}

}  // namespace

std::vector<Vertex> stitchCracks(HalfEdgeMesh& mesh, double reach, Progress progress) {
  std::vector<Vertex> moved;
  if (!(reach > 0.0)) return moved;
  HalfEdgeMesh work = mesh;
  for (int pass = 0; pass < kStitchPasses; ++pass) {
    const std::vector<Vertex> now =
        stitchOnce(work, reach, progress.part(double(pass) / kStitchPasses, (pass + 1.0) / kStitchPasses));
    if (progress.cancelled()) return {};
    if (now.empty()) break;
    moved.insert(moved.end(), now.begin(), now.end());
  }
  std::sort(moved.begin(), moved.end());
  moved.erase(std::unique(moved.begin(), moved.end()), moved.end());
  if (!moved.empty()) mesh = std::move(work);
  return moved;
}

}  // namespace handwheel
