// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/search/LargestDistance.h"

#include "mesh/structure/FaceNormal.h"
#include "proximity/ClosestPoint.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace handwheel {
namespace {

constexpr std::size_t kFacesPerRange = 64;
constexpr std::size_t kPartsPerPoll = 256;
constexpr double kPartBudget = 4e6;        // shared by the faces according to their areas
constexpr double kPartBudgetOfFace = 256;  // beside that share
constexpr double kFineEnough = 1e-12;      // share of the coordinates below which a distance is not resolved
constexpr double kCoordinateRounding = 8.0 * std::numeric_limits<double>::epsilon();
constexpr double kWidest = 2.0;  // extent of a part beyond which it is halved, in longest edges of its nearest triangle

double largestCoordinate(const SurfaceDistance& surface) {
  const Box& box = surface.hierarchy().bounds();
  return std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
}

// A convex part of a face.
using Part = std::vector<Vec3>;

Vec3 middleOf(const Part& part) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& p : part) sum += p - part[0];
  return part[0] + sum / static_cast<double>(part.size());
}

// Cuts a part by the plane through a point. Returns false, and cuts nothing, if all corners are on one side of it.
bool cut(const Part& part, const Vec3& point, const Vec3& normal, double tolerance, Part& behind, Part& before) {
  behind.clear();
  before.clear();
  bool isBehind = false, isBefore = false;
  for (std::size_t i = 0; i < part.size(); ++i) {
    const Vec3 &p = part[i], &q = part[(i + 1) % part.size()];
    const double here = normal.dot(p - point), next = normal.dot(q - point);
    isBehind |= here < -tolerance;
    isBefore |= here > tolerance;
    if (here <= 0.0) behind.push_back(p);
    if (here >= 0.0) before.push_back(p);
    if ((here < 0.0 && next > 0.0) || (here > 0.0 && next < 0.0)) {
      const Vec3 between = p + here / (here - next) * (q - p);
      behind.push_back(between);
      before.push_back(between);
    }
  }
  return isBehind && isBefore;
}

// The bound for one face after another. Each thread has its own.
class FaceBound {
 public:
  FaceBound(const TriangleHierarchy& of, double found, double tolerance, const Progress& progress)
      : m_of(of), m_found(found), m_tolerance(tolerance), m_progress(progress) {}

  // Returns the bound of the distances of a face. If it takes too many parts, it starts again with more slack.
  double boundOf(const TrianglePoints& face, double mostParts) {
    double found = m_found;
    for (double slack = kLargestDistanceSlack;; slack *= 4.0) {
      if (const auto bound = tryBound(face, mostParts, slack, found)) return *bound;
    }
  }

 private:
  std::optional<double> tryBound(const TrianglePoints& face, double mostParts, double slack, double& found) {
    double bound = 0.0, parts = 0.0;
    m_stack.assign(1, Part(face.begin(), face.end()));
    while (!m_stack.empty()) {
      if (++m_looked % kPartsPerPoll == 0 && m_progress.cancelled()) return bound;
      if (++parts > mostParts) return std::nullopt;
      const Part part = std::move(m_stack.back());
      m_stack.pop_back();
      const Vec3 middle = middleOf(part);
      const auto nearest = m_of.nearest(middle);
      if (!nearest) continue;
      const auto corners = m_of.corners(nearest->triangle);
      const double distance = (nearest->point - middle).norm();
      double reach = 0.0, farthest = 0.0;
      for (const Vec3& p : part) {
        reach = std::max(reach, (p - middle).norm());
        farthest = std::max(farthest, (closestOnTriangle(p, corners[0], corners[1], corners[2]) - p).norm());
      }
      found = std::max(found, distance);
      const double least = std::min(farthest, distance + reach);
      if (least <= std::max((1.0 + slack) * found, slack / kLargestDistanceSlack * m_tolerance)) {
        bound = std::max(bound, least);
      } else if (!cutAlong(part, corners, reach)) {
        halve(part, middle);
      }
    }
    return bound;
  }

  // Cuts a part along the planes through the edges of a triangle that are perpendicular to it.
  bool cutAlong(const Part& part, const TrianglePoints& t, double reach) {
    const Vec3 normal = unitNormal(t);
    double longest = 0.0;
    for (std::size_t k = 0; k < 3; ++k) longest = std::max(longest, (t[(k + 1) % 3] - t[k]).norm());
    if (normal.isZero() || reach > kWidest * longest) return false;
    bool isCut = false;
    Part inner = part, behind, before;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 outwards = (t[(k + 1) % 3] - t[k]).cross(normal).normalized();
      if (!cut(inner, t[k], outwards, m_tolerance, behind, before)) continue;
      isCut = true;
      m_stack.push_back(before);
      inner.swap(behind);
    }
    if (isCut) m_stack.push_back(std::move(inner));
    return isCut;
  }

  // Halves a part across its longest extent.
  void halve(const Part& part, const Vec3& middle) {
    const auto isNearer = [&](const Vec3& p, const Vec3& q) {
      return (p - middle).squaredNorm() < (q - middle).squaredNorm();
    };
    const Vec3 along = *std::max_element(part.begin(), part.end(), isNearer) - middle;
    Part behind, before;
    cut(part, middle, along, 0.0, behind, before);
    if (behind.size() >= 3) m_stack.push_back(std::move(behind));
    if (before.size() >= 3) m_stack.push_back(std::move(before));
  }

  const TriangleHierarchy& m_of;
  double m_found;      // distance of a point of either surface
  double m_tolerance;  // mm
  const Progress& m_progress;
  std::vector<Part> m_stack;
  std::size_t m_looked = 0;
};

using Range = tbb::blocked_range<std::size_t>;

// Calls work(range) on all threads, and returns the largest result.
double largestOf(std::size_t n, const Progress& progress, const std::function<double(const Range&)>& work) {
  std::atomic<std::size_t> done{0};
  return tbb::parallel_reduce(
      Range(0, n, kFacesPerRange), 0.0,
      [&](const Range& range, double largest) {
        if (progress.cancelled()) return largest;
        largest = std::max(largest, work(range));
        progress.set(static_cast<double>(done += range.size()) / static_cast<double>(n));
        return largest;
      },
      [](double a, double b) { return std::max(a, b); });
}

// Returns the largest distance of the corners and the middles of faces.
double largestFound(const SurfaceDistance& surface, const SurfaceDistance& of, const Progress& progress) {
  return largestOf(surface.faces().size(), progress, [&](const Range& range) {
    double largest = 0.0;
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const TrianglePoints t = surface.mesh().points(surface.faces()[i]);
      for (const Vec3& p : {t[0], t[1], t[2], Vec3((t[0] + t[1] + t[2]) / 3.0)}) {
        // A nearer point changes nothing, and most are nearer.
        if (largest > 0.0 && of.hierarchy().isWithin(p, largest)) continue;
        if (const auto nearest = of.hierarchy().nearest(p)) largest = std::max(largest, (nearest->point - p).norm());
      }
    }
    return largest;
  });
}

double boundFrom(const SurfaceDistance& surface, const SurfaceDistance& of, double found, const Progress& progress) {
  const std::vector<Face>& faces = surface.faces();
  double area = 0.0;
  for (const Face f : faces) area += handwheel::areaOf(surface.mesh().points(f));
  const double tolerance = kFineEnough * std::max(largestCoordinate(surface), largestCoordinate(of));
  return largestOf(faces.size(), progress, [&](const Range& range) {
    FaceBound bound(of.hierarchy(), found, tolerance, progress);
    double largest = 0.0;
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const TrianglePoints t = surface.mesh().points(faces[i]);
      const double share = area > 0.0 ? handwheel::areaOf(t) / area : 0.0;
      largest = std::max(largest, bound.boundOf(t, kPartBudgetOfFace + kPartBudget * share));
    }
    return largest;
  });
}

}  // namespace

std::optional<double> largestDistance(const SurfaceDistance& a, const SurfaceDistance& b, Progress progress) {
  if (a.empty() || b.empty() || progress.cancelled()) return std::nullopt;
  const double found =
      std::max(largestFound(a, b, progress.part(0.0, 0.1)), largestFound(b, a, progress.part(0.1, 0.2)));
  const double bound =
      std::max(boundFrom(a, b, found, progress.part(0.2, 0.6)), boundFrom(b, a, found, progress.part(0.6, 1.0)));
  if (progress.cancelled()) return std::nullopt;
  const double rounding = kCoordinateRounding * std::max(largestCoordinate(a), largestCoordinate(b));
  return bound > 0.0 ? bound + rounding : 0.0;
}

std::optional<double> largestDistance(const HalfEdgeMesh& a, const HalfEdgeMesh& b, Progress progress) {
  const SurfaceDistance first(a, progress.part(0.0, 0.1)), second(b, progress.part(0.1, 0.2));
  return largestDistance(first, second, progress.part(0.2, 1.0));
}

}  // namespace handwheel
