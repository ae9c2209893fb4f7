// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/PartDuplicates.h"

#include "mesh/EdgeTable.h"
#include "mesh/Weld.h"
#include "proximity/TriangleHierarchy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <unordered_set>

namespace handwheel {
namespace {

// Steps tried, in units of the last place at the vertex; 2^14 of single precision is 1e-3 of the coordinate, too visible.
constexpr int kSmallestStep = 1;
constexpr int kLargestStep = 1 << 9;

double unitInTheLastPlace(const Vec3& p, NumberType numbers) {
  const double largest = p.cwiseAbs().maxCoeff();
  if (numbers == NumberType::Float64) return std::nextafter(largest, 1e300) - largest;
  const float f = static_cast<float>(largest);
  return static_cast<double>(std::nextafter(f, std::numeric_limits<float>::max())) - static_cast<double>(f);
}

struct PositionHash {
  std::size_t operator()(const std::array<double, 3>& p) const {
    std::size_t h = 0;
    for (double x : p) h = h * 0x9e3779b97f4a7c15ull + std::hash<double>()(x);
    return h;
  }
};

class Parter {
 public:
  Parter(HalfEdgeMesh& mesh, NumberType numbers) : m_mesh(mesh), m_numbers(numbers) {
    for (Face f = 0; f < mesh.faceSlots(); ++f) {
      if (!mesh.isLive(f)) continue;
      for (Vertex v : mesh.triangle(f)) m_positions.insert(key(mesh.position(v)));
      if (!isDegenerate(mesh.points(f))) m_faces.push_back(f);
    }
    std::vector<Vec3> points(mesh.vertexSlots());
    for (Vertex v = 0; v < points.size(); ++v) points[v] = mesh.position(v);
    std::vector<Triangle> triangles;
    for (Face f : m_faces) triangles.push_back(mesh.triangle(f));
    m_hierarchy = TriangleHierarchy(points, triangles);
  }

  // Moves the fan's vertex off its position; false when every step would harm.
  bool part(const std::vector<HalfEdge>& fan) {
    const Vertex v = m_mesh.from(fan.front());
    const Vec3 home = m_mesh.position(v);
    const double unit = unitInTheLastPlace(home, m_numbers);
    const std::size_t before = intersections(fan);
    const std::vector<Vec3> directions = waysOut(fan);
    for (int step = kSmallestStep; step <= kLargestStep; step *= 2) {
      for (const Vec3& d : directions) {
        const Vec3 p = rounded(Vec3(home + step * unit * d), m_numbers);
        if (p == home || m_positions.contains(key(p))) continue;
        m_mesh.setPosition(v, p);
        if (!hasFlatFace(fan) && intersections(fan) <= before) {
          m_positions.insert(key(p));
          m_reach = std::max(m_reach, (p - home).norm());
          return true;
        }
      }
    }
    m_mesh.setPosition(v, home);
    return false;
  }

 private:
  static std::array<double, 3> key(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

  // Into the solid, out of it, and towards and away from the middle of the fan; scaled so that the largest component is 1.
  std::vector<Vec3> waysOut(const std::vector<HalfEdge>& fan) const {
    const Vec3 home = m_mesh.position(m_mesh.from(fan.front()));
    Vec3 normal = Vec3::Zero(), middle = Vec3::Zero();
    for (HalfEdge h : fan) {
      const TrianglePoints p = m_mesh.points(HalfEdgeMesh::face(h));
      normal += (p[1] - p[0]).cross(p[2] - p[0]).stableNormalized();
      middle += ((p[0] + p[1] + p[2]) / 3.0 - home).stableNormalized();
    }
    std::vector<Vec3> ways;
    const Vec3 n = normal.stableNormalized(), m = middle.stableNormalized();
    for (const Vec3& d : {Vec3(-n), m, Vec3(m - n), n, Vec3(m + n), Vec3(-m), Vec3(-m - n), Vec3(n - m)}) {
      const double largest = d.cwiseAbs().maxCoeff();
      if (largest > 1e-6) ways.push_back(d / largest);
    }
    return ways;
  }

  bool hasFlatFace(const std::vector<HalfEdge>& fan) const {
    return std::any_of(fan.begin(), fan.end(),
                       [&](HalfEdge h) { return isDegenerate(m_mesh.points(HalfEdgeMesh::face(h))); });
  }

  // Pairs in which a face of the fan takes part.
  std::size_t intersections(const std::vector<HalfEdge>& fan) const {
    std::size_t n = 0;
    for (HalfEdge h : fan) {
      const Face f = HalfEdgeMesh::face(h);
      const TrianglePoints t = m_mesh.points(f);
      if (isDegenerate(t)) continue;
      Box box(t[0]);
      box.extend(t[1]).extend(t[2]);
      // The hierarchy holds the places before anything was moved.
      const Vec3 slack = Vec3::Constant(m_reach);
      m_hierarchy.forEachInBox(Box(box.min() - slack, box.max() + slack), [&](std::uint32_t i) {
        const Face other = m_faces[i];
        if (other == f) return true;
        const bool inFan = std::any_of(fan.begin(), fan.end(), [&](HalfEdge g) { return HalfEdgeMesh::face(g) == other; });
        if (inFan && other < f) return true;  // counted once
        const TrianglePoints o = m_mesh.points(other);
        if (!isDegenerate(o)) n += trianglesMeet(t, o);
        return true;
      });
    }
    return n;
  }

  HalfEdgeMesh& m_mesh;
  NumberType m_numbers;
  std::vector<Face> m_faces;  // of the hierarchy's triangles
  TriangleHierarchy m_hierarchy;
  std::unordered_set<std::array<double, 3>, PositionHash> m_positions;  // that the file will hold
  double m_reach = 0.0;  // how far a vertex was moved at most
};

// The classes at the ends of edges that have more than two faces in the file.
std::vector<bool> crowdedClasses(const HalfEdgeMesh& mesh, const PointClasses& classes) {
  std::vector<Triangle> triangles(mesh.faceSlots(), Triangle{0, 0, 0});
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f)) continue;
    for (int k = 0; k < 3; ++k) triangles[f][k] = classes.classOf[mesh.triangle(f)[k]];
  }
  std::vector<bool> crowded(classes.representative.size(), false);
  const EdgeTable edges(triangles, classes.representative.size());
  edges.forEachEdge([&](std::uint32_t low, std::uint32_t high, std::span<const EdgeTable::Entry> run) {
    if (run.size() > 2) crowded[low] = crowded[high] = true;
  });
  return crowded;
}

}  // namespace

std::vector<Vertex> partDuplicates(HalfEdgeMesh& mesh, NumberType numbers, Progress progress) {
  std::vector<Vec3> points(mesh.vertexSlots());
  for (Vertex v = 0; v < points.size(); ++v) points[v] = mesh.position(v);
  const PointClasses classes = classifyPoints(points);
  const std::vector<bool> crowded = crowdedClasses(mesh, classes);
  if (std::none_of(crowded.begin(), crowded.end(), [](bool c) { return c; })) return {};

  // The fans at each crowded position, largest first; that one stays.
  std::map<std::uint32_t, std::map<Vertex, std::vector<HalfEdge>>> fansAt;
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h) {
    if (!mesh.isProper(HalfEdgeMesh::face(h))) continue;
    const Vertex v = mesh.from(h);
    if (!crowded[classes.classOf[v]]) continue;
    std::vector<HalfEdge>& fan = fansAt[classes.classOf[v]][v];
    if (fan.empty()) fan = mesh.fan(h);
  }
  Parter parter(mesh, numbers);
  std::vector<Vertex> moved;
  for (auto& [c, fans] : fansAt) {
    if (progress.cancelled()) break;
    std::vector<std::vector<HalfEdge>*> order;
    for (auto& [v, fan] : fans) order.push_back(&fan);
    std::stable_sort(order.begin(), order.end(), [](const auto* a, const auto* b) { return a->size() > b->size(); });
    // One fan keeps the position: the largest, or the first that cannot move.
    bool kept = false;
    for (std::size_t i = order.size(); i-- > 0;) {
      if (i == 0 && !kept) break;
      const bool parted = parter.part(*order[i]);
      if (parted) moved.push_back(mesh.from(order[i]->front()));
      kept |= !parted;
    }
  }
  return moved;
}

}  // namespace handwheel
