// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/intersections/SharedPlanes.h"

#include "mesh/boundary/CoordinateRounding.h"
#include "mesh/structure/DisjointSets.h"
#include "mesh/structure/EdgeTable.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace handwheel {
namespace {

// Distance of corners from their plane in ulps: rounding moves each coordinate by half a unit, and a plane through
// three such points is off by several beyond them.
constexpr double kUnits = 16.0;
// The same in steps of the decimals of a file.
constexpr double kSteps = 2.0;
// Least sine of the angle between two planes, and least volume spanned by three normals, for a well-defined
// intersection: otherwise rounding would move it by more than a thousand units.
constexpr double kParallelPlanes = 1e-3;
constexpr double kSpanned = 1e-3;
// Limits that keep a mesh with very many small walls from taking long. Excess walls are ignored.
constexpr std::size_t kMostPlanes = 200;
constexpr std::size_t kMostInPlanes = 6'000;

struct PlaneGroup {
  std::vector<std::uint32_t> faces;
  SharedPlanes::Plane plane;
};

class PlaneFinder {
 public:
  PlaneFinder(const TriangleSoup& soup, std::span<const TrianglePair> pairs, Progress progress)
      : m_soup(soup), m_pairs(pairs), m_progress(progress), m_reach(reachOf()) {}

  SharedPlanes find() {
    collect(acrossSurfaces());
    if (m_groups.empty()) return {};
    collect(alongSurfaces());
    for (PlaneGroup& group : m_groups) {
      if (m_progress.cancelled()) return {};
      complete(group);
      if (!isPlane(group)) continue;
      m_found.planes.push_back(group.plane);
      addPairs(group.faces);
    }
    m_found.reach = m_reach;
    return std::move(m_found);
  }

 private:
  double reachOf() const {
    TriangleSoup paired;
    for (const TrianglePair& pair : m_pairs) {
      for (const std::uint32_t t : {pair.first, pair.second})
        for (const std::uint32_t v : m_soup.triangles[t]) paired.points.push_back(m_soup.points[v]);
    }
    return planarReach(paired);
  }

  Vec3 corner(std::uint32_t t, int k) const { return m_soup.points[m_soup.triangles[t][k]]; }
  Vec3 doubleArea(std::uint32_t t) const { return (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0)); }
  SharedPlanes::Plane planeOf(std::uint32_t t) const {
    const Vec3 normal = doubleArea(t).stableNormalized();
    return {normal, normal.dot(corner(t, 0))};
  }
  bool isIn(const SharedPlanes::Plane& plane, std::uint32_t t) const {
    for (int k = 0; k < 3; ++k)
      if (!(std::abs(plane.normal.dot(corner(t, k)) - plane.offset) <= m_reach)) return false;
    return true;
  }
  Box boxOf(std::uint32_t t) const {
    Box box;
    for (int k = 0; k < 3; ++k) box.extend(corner(t, k));
    return Box(box.min().array() - m_reach, box.max().array() + m_reach);
  }
  // The larger of two triangles determines a plane best.
  bool areInOne(std::uint32_t f, std::uint32_t g) const {
    const bool isFirst = doubleArea(f).norm() > doubleArea(g).norm();
    return isIn(planeOf(isFirst ? f : g), isFirst ? g : f);
  }

  // Coplanar pairs of surfaces that coincide.
  std::vector<TrianglePair> acrossSurfaces() const {
    std::vector<TrianglePair> found = besideEachOther();
    for (const auto& [f, g] : m_pairs)
      if (areInOne(f, g)) found.emplace_back(f, g);
    return found;
  }

  // Coplanar neighbours. If others cut their plane, it must be unique, or three planes meet in more than one point.
  std::vector<TrianglePair> alongSurfaces() const {
    std::vector<Triangle> near;
    std::vector<std::uint32_t> faces;
    for (const auto& [box, f] : trianglesAtPairs()) {
      near.push_back(m_soup.triangles[f]);
      faces.push_back(f);
    }
    std::vector<TrianglePair> found;
    const EdgeTable edges(near, m_soup.points.size());
    edges.forEachEdge([&](std::uint32_t, std::uint32_t, std::span<const EdgeTable::Entry> entries) {
      if (entries.size() != 2) return;
      const std::uint32_t f = faces[entries[0].halfEdge / 3], g = faces[entries[1].halfEdge / 3];
      if (areInOne(f, g)) found.emplace_back(f, g);
    });
    return found;
  }

  // Groups the triangles that such pairs connect, the largest triangle first; those in an existing plane join it.
  void collect(const std::vector<TrianglePair>& same) {
    std::map<std::uint32_t, std::uint32_t> numbers;
    std::vector<std::uint32_t> faces;
    for (const auto& [f, g] : same) {
      for (const std::uint32_t t : {f, g})
        if (numbers.emplace(t, static_cast<std::uint32_t>(faces.size())).second) faces.push_back(t);
    }
    if (faces.size() > kMostInPlanes) return;
    DisjointSets sets(faces.size());
    for (const auto& [f, g] : same) sets.join(numbers[f], numbers[g]);
    std::map<std::uint32_t, PlaneGroup> groups;
    for (std::uint32_t i = 0; i < faces.size(); ++i) groups[sets.root(i)].faces.push_back(faces[i]);
    if (groups.size() > kMostPlanes) return;
    std::vector<PlaneGroup> sorted;
    for (auto& [root, group] : groups) {
      settle(group);
      sorted.push_back(std::move(group));
    }
    std::stable_sort(sorted.begin(), sorted.end(),
                     [this](const PlaneGroup& a, const PlaneGroup& b) { return sizeOf(a) > sizeOf(b); });
    for (PlaneGroup& group : sorted) merge(group);
  }

  // Returns the triangles of pairs that are coplanar and near each other, crossing or not: the last digit decides that.
  // Neighbours are excluded.
  std::vector<TrianglePair> besideEachOther() const {
    std::vector<TrianglePair> found;
    std::vector<std::pair<Box, std::uint32_t>> near = trianglesAtPairs();
    if (near.size() > kMostInPlanes) return found;
    std::sort(near.begin(), near.end(),
              [](const auto& a, const auto& b) { return a.first.min().x() < b.first.min().x(); });
    for (std::size_t i = 0; i < near.size(); ++i) {
      const auto& [box, f] = near[i];
      for (std::size_t j = i + 1; j < near.size() && near[j].first.min().x() <= box.max().x(); ++j) {
        const std::uint32_t g = near[j].second;
        if (box.intersects(near[j].first) && !areNeighbours(f, g) && areInOne(f, g)) found.emplace_back(f, g);
      }
    }
    return found;
  }

  std::vector<std::pair<Box, std::uint32_t>> trianglesAtPairs() const {
    std::vector<bool> isAt(m_soup.points.size(), false);
    for (const TrianglePair& pair : m_pairs)
      for (const std::uint32_t t : {pair.first, pair.second})
        for (const std::uint32_t v : m_soup.triangles[t]) isAt[v] = true;
    std::vector<std::pair<Box, std::uint32_t>> found;
    for (std::uint32_t t = 0; t < m_soup.triangles.size(); ++t) {
      const Triangle& c = m_soup.triangles[t];
      if (!hasRepeatedVertex(c) && (isAt[c[0]] || isAt[c[1]] || isAt[c[2]])) found.emplace_back(boxOf(t), t);
    }
    return found;
  }

  bool areNeighbours(std::uint32_t f, std::uint32_t g) const {
    const Triangle &a = m_soup.triangles[f], &b = m_soup.triangles[g];
    return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
  }

  double sizeOf(const PlaneGroup& group) const { return doubleArea(group.faces.front()).norm(); }

  // Returns the plane of the largest triangle, which comes first.
  void settle(PlaneGroup& group) {
    std::stable_sort(group.faces.begin(), group.faces.end(),
                     [this](std::uint32_t a, std::uint32_t b) { return doubleArea(a).norm() > doubleArea(b).norm(); });
    group.plane = planeOf(group.faces.front());
  }

  void merge(PlaneGroup& group) {
    const auto same = std::find_if(m_groups.begin(), m_groups.end(), [&](const PlaneGroup& other) {
      return std::all_of(group.faces.begin(), group.faces.end(), [&](std::uint32_t f) { return isIn(other.plane, f); });
    });
    if (same == m_groups.end())
      m_groups.push_back(std::move(group));
    else
      same->faces.insert(same->faces.end(), group.faces.begin(), group.faces.end());
  }

  // Adds triangles that lie in a plane too, but cross none there, because they differ in the last digit.
  void complete(PlaneGroup& group) {
    Box box;
    for (const std::uint32_t f : group.faces) box.extend(boxOf(f));
    std::set<std::uint32_t> faces(group.faces.begin(), group.faces.end());
    for (std::uint32_t t = 0; t < m_soup.triangles.size(); ++t) {
      if (hasRepeatedVertex(m_soup.triangles[t])) continue;
      if (isIn(group.plane, t) && box.intersects(boxOf(t))) faces.insert(t);
    }
    group.faces.assign(faces.begin(), faces.end());
    m_progress.spend(m_soup.triangles.size() / 100 + 1);
  }

  // Assigns its plane to the points of a group. Returns false, without a change, if the position of one would be
  // undefined.
  bool isPlane(const PlaneGroup& group) {
    const auto number = static_cast<std::uint32_t>(m_found.planes.size());
    m_found.planes.push_back(group.plane);
    std::map<std::uint32_t, std::vector<std::uint32_t>> planesOf;
    bool isGood = true;
    for (const std::uint32_t f : group.faces) {
      isGood = isGood && isIn(group.plane, f);  // otherwise the group is a chain that leaves the plane
      for (const std::uint32_t v : m_soup.triangles[f]) {
        if (!isGood || planesOf.contains(v)) continue;
        const auto known = m_found.planesOf.find(v);
        std::vector<std::uint32_t>& planes = planesOf[v];
        if (known != m_found.planesOf.end()) planes = known->second;
        planes.push_back(number);
        isGood = isWellDefined(planes);
      }
    }
    m_found.planes.pop_back();
    if (isGood)
      for (auto& [v, planes] : planesOf) m_found.planesOf[v] = std::move(planes);
    return isGood;
  }

  bool isWellDefined(const std::vector<std::uint32_t>& planes) const {
    const auto normal = [&](std::size_t i) { return m_found.planes[planes[i]].normal; };
    for (std::size_t i = 0; i < planes.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (normal(i).cross(normal(j)).norm() < kParallelPlanes) return false;
    return planes.size() < 3 || (planes.size() == 3 && std::abs(normal(0).dot(normal(1).cross(normal(2)))) >= kSpanned);
  }

  void addPairs(const std::vector<std::uint32_t>& faces) {
    if (faces.size() > kMostInPlanes) return;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const Box box = boxOf(faces[i]);
      for (std::size_t j = 0; j < i; ++j)
        if (box.intersects(boxOf(faces[j]))) m_found.pairs.push_back(std::minmax(faces[i], faces[j]));
    }
  }

  const TriangleSoup& m_soup;
  const std::span<const TrianglePair> m_pairs;
  const Progress m_progress;
  const double m_reach;  // mm
  std::vector<PlaneGroup> m_groups;
  SharedPlanes m_found;
};

}  // namespace

double planarReach(const TriangleSoup& soup) {
  double largest = 0.0;
  bool isSingle = true;
  for (const Vec3& p : soup.points) {
    largest = std::max(largest, p.cwiseAbs().maxCoeff());
    isSingle = isSingle && rounded(p, NumberType::Float32) == p;
  }
  const double unit =
      isSingle ? static_cast<double>(std::numeric_limits<float>::epsilon()) : std::numeric_limits<double>::epsilon();
  return std::max(kUnits * unit * largest, kSteps * coordinateSteps(soup.points).reach());
}

SharedPlanes findSharedPlanes(const TriangleSoup& soup, std::span<const TrianglePair> pairs, Progress progress,
                              std::size_t mostPairs) {
  if (pairs.size() > mostPairs) return {};
  return PlaneFinder(soup, pairs, progress).find();
}

}  // namespace handwheel
