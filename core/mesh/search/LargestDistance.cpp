// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/search/LargestDistance.h"

#include "mesh/structure/FaceNormal.h"
#include "proximity/ClosestPoint.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>
#include <tbb/partitioner.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <limits>
#include <mutex>
#include <numeric>
#include <utility>
#include <vector>

namespace handwheel {
namespace {

constexpr std::size_t kFacesPerRange = 64;
constexpr std::size_t kPartsPerPoll = 256;
constexpr double kPartBudget = 4e6;        // shared by the faces according to their areas; or, if that is more:
constexpr double kPartsOfTriangle = 16.0;  // parts for each triangle of the other surface
constexpr double kPartBudgetOfFace = 256;  // beside that share
constexpr double kFineEnough = 1e-12;      // share of the coordinates below which a distance is not resolved
constexpr double kCoordinateRounding = 8.0 * std::numeric_limits<double>::epsilon();
constexpr double kUnknown = std::numeric_limits<double>::infinity();
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

// Returns the largest distance of a part from a triangle: that of a corner, as the distance is a convex function.
double farthestOf(const Part& part, const TrianglePoints& t) {
  double farthest = 0.0;
  for (const Vec3& p : part) farthest = std::max(farthest, (closestOnTriangle(p, t[0], t[1], t[2]) - p).norm());
  return farthest;
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

// The constants of the bounds of all faces of a surface.
struct Search {
  const SurfaceDistance& of;
  double found;      // distance of a point of either surface
  double limit;      // distance beyond which a face needs no bound
  double tolerance;  // mm
};

// The bound for one face after another. Each thread has its own.
class FaceBound {
 public:
  FaceBound(const Search& search, const Progress& progress)
      : m_of(search.of.hierarchy()),
        m_found(search.found),
        m_limit(search.limit),
        m_tolerance(search.tolerance),
        m_progress(progress) {}

  // Points beyond the limit, at most one of each face.
  const std::vector<Vec3>& beyond() const { return m_beyond; }

  // Returns the bound of the distances of a face. It is infinite if a point is beyond the limit, or may be. If it takes
  // too many parts, it starts again with more slack.
  double boundOf(const TrianglePoints& face, double mostParts) {
    double found = m_found, slack = kLargestDistanceSlack;
    std::optional<double> tried;
    while (!(tried = tryBound(face, mostParts, slack, found))) slack *= 4.0;
    const double bound = *tried;
    if (bound <= (1.0 + kLargestDistanceSlack) * m_limit) return bound;
    if (bound != kUnknown) m_beyond.push_back((face[0] + face[1] + face[2]) / 3.0);
    return kUnknown;
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
      const auto nearEnough = [&] {
        return std::max((1.0 + slack) * found, slack / kLargestDistanceSlack * m_tolerance);
      };
      // Successive parts are often near the same triangle.
      if (const auto known = m_last ? farthestOf(part, m_of.corners(*m_last)) : kUnknown; known <= nearEnough()) {
        bound = std::max(bound, known);
        continue;
      }
      const Vec3 middle = middleOf(part);
      const auto nearest = m_of.nearest(middle);
      if (!nearest) continue;
      m_last = nearest->triangle;
      const auto corners = m_of.corners(nearest->triangle);
      const double distance = (nearest->point - middle).norm();
      if (distance > m_limit) {
        m_beyond.push_back(middle);
        return kUnknown;
      }
      double reach = 0.0;
      for (const Vec3& p : part) reach = std::max(reach, (p - middle).norm());
      found = std::max(found, distance);
      const double least = std::min(farthestOf(part, corners), distance + reach);
      if (least <= nearEnough()) {
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
  double m_found, m_limit, m_tolerance;
  const Progress& m_progress;
  std::vector<Part> m_stack;
  std::vector<Vec3> m_beyond;
  std::optional<std::uint32_t> m_last;  // triangle that was nearest to the last part for which it was searched
  std::size_t m_looked = 0;
};

using Range = tbb::blocked_range<std::size_t>;

// Calls work(range) on all threads, and returns the largest result. The ranges do not depend on the threads.
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
      [](double a, double b) { return std::max(a, b); }, tbb::simple_partitioner());
}

// Returns the largest distance of the corners and the middles of faces.
double largestFound(const SurfaceDistance& surface, const std::vector<std::uint32_t>& faces, const SurfaceDistance& of,
                    const Progress& progress) {
  return largestOf(faces.size(), progress, [&](const Range& range) {
    double largest = 0.0;
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const TrianglePoints t = surface.mesh().points(surface.faces()[faces[i]]);
      for (const Vec3& p : {t[0], t[1], t[2], Vec3((t[0] + t[1] + t[2]) / 3.0)}) {
        // A nearer point changes nothing, and most are nearer.
        if (largest > 0.0 && of.hierarchy().isWithin(p, largest)) continue;
        if (const auto nearest = of.hierarchy().nearest(p)) largest = std::max(largest, (nearest->point - p).norm());
      }
    }
    return largest;
  });
}

// Returns the numbers of the faces to be tested (proveWithin()).
std::vector<std::uint32_t> facesIn(const SurfaceDistance& surface, std::span<const Box> regions) {
  std::vector<std::uint32_t> faces(regions.empty() ? surface.faces().size() : 0);
  std::iota(faces.begin(), faces.end(), 0u);
  for (const Box& region : regions) {
    surface.hierarchy().forEachInBox(region, [&](std::uint32_t face) {
      faces.push_back(face);
      return true;
    });
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

// Returns the proof for some faces of a surface.
DistanceProof proofOf(const SurfaceDistance& surface, const std::vector<std::uint32_t>& faces, const Search& search,
                      const Progress& progress) {
  const auto pointsOf = [&](std::size_t i) { return surface.mesh().points(surface.faces()[faces[i]]); };
  double area = 0.0;
  for (std::size_t i = 0; i < faces.size(); ++i) area += handwheel::areaOf(pointsOf(i));
  const auto triangles = static_cast<double>(search.of.faces().size());
  const double budget = std::max(kPartBudget, kPartsOfTriangle * triangles);
  DistanceProof proof;
  std::mutex mutex;
  proof.bound = largestOf(faces.size(), progress, [&](const Range& range) {
    FaceBound face(search, progress);
    double largest = 0.0;
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const TrianglePoints t = pointsOf(i);
      const double share = area > 0.0 ? handwheel::areaOf(t) / area : 0.0;
      const double bound = face.boundOf(t, kPartBudgetOfFace + budget * share);
      if (bound != kUnknown) largest = std::max(largest, bound);
    }
    const std::scoped_lock lock(mutex);
    proof.beyond.insert(proof.beyond.end(), face.beyond().begin(), face.beyond().end());
    return largest;
  });
  return proof;
}

}  // namespace

std::optional<double> largestDistance(const SurfaceDistance& a, const SurfaceDistance& b, Progress progress) {
  const auto proof = proveWithin(a, b, std::numeric_limits<double>::infinity(), progress);
  return proof ? std::optional(proof->bound) : std::nullopt;
}

std::optional<double> largestDistance(const HalfEdgeMesh& a, const HalfEdgeMesh& b, Progress progress) {
  const SurfaceDistance first(a, progress.part(0.0, 0.1)), second(b, progress.part(0.1, 0.2));
  return largestDistance(first, second, progress.part(0.2, 1.0));
}

std::optional<DistanceProof> proveWithin(const SurfaceDistance& a, const SurfaceDistance& b, double limit,
                                         Progress progress, std::span<const Box> regions) {
  if (a.empty() || b.empty() || progress.cancelled()) return std::nullopt;
  const std::vector<std::uint32_t> ofA = facesIn(a, regions), ofB = facesIn(b, regions);
  const double coordinate = std::max(largestCoordinate(a), largestCoordinate(b));
  const double rounding = kCoordinateRounding * coordinate, tolerance = kFineEnough * coordinate;
  const double least = (limit - rounding) / (1.0 + kLargestDistanceSlack);
  const double found = std::min(least, std::max(largestFound(a, ofA, b, progress.part(0.0, 0.1)),
                                                largestFound(b, ofB, a, progress.part(0.1, 0.2))));
  DistanceProof proof = proofOf(a, ofA, {b, found, least, tolerance}, progress.part(0.2, 0.6));
  const DistanceProof other = proofOf(b, ofB, {a, found, least, tolerance}, progress.part(0.6, 1.0));
  if (progress.cancelled()) return std::nullopt;
  proof.bound = std::max(proof.bound, other.bound);
  if (proof.bound > 0.0) proof.bound += rounding;
  proof.beyond.insert(proof.beyond.end(), other.beyond.begin(), other.beyond.end());
  std::sort(proof.beyond.begin(), proof.beyond.end(), [](const Vec3& p, const Vec3& q) {
    return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end());
  });
  return proof;
}

}  // namespace handwheel
