// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/FanSeparator.h"

#include "mesh/search/IncrementalHierarchy.h"
#include "mesh/structure/CancelPolling.h"
#include "mesh/structure/EdgeOperations.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handwheel {
namespace {

// Tried steps, in ulps at the vertex; 2^14 of single precision is 1e-3 of the coordinate, too visible.
constexpr int kSmallestStep = 1;
constexpr int kLargestStep = 1 << 9;

double unitInTheLastPlace(const Vec3& p, NumberType numbers) {
  const double largest = p.cwiseAbs().maxCoeff();
  if (numbers == NumberType::Float64) return std::nextafter(largest, 1e300) - largest;
  const float f = static_cast<float>(largest);
  return static_cast<double>(std::nextafter(f, std::numeric_limits<float>::max())) - static_cast<double>(f);
}

// Numbers of operations that take as long as one step of WorkBudget.
constexpr std::size_t kBoxesPerStep = 256;
constexpr std::size_t kTestsPerStep = 8;  // tests of two triangles

std::vector<Face> facesOf(const std::vector<HalfEdge>& fan) {
  std::vector<Face> faces;
  faces.reserve(fan.size());
  for (HalfEdge h : fan) faces.push_back(HalfEdgeMesh::face(h));
  return faces;
}

}  // namespace

std::size_t FanSeparator::PositionHash::operator()(const PointKey& p) const {
  std::size_t h = 0;
  for (double x : p) h = h * 0x9e3779b97f4a7c15ull + std::hash<double>()(x);
  return h;
}

FanSeparator::FanSeparator(HalfEdgeMesh& mesh, NumberType numbers, Progress progress, Progress watched)
    : m_mesh(mesh), m_numbers(numbers), m_watched(watched) {
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!pollProgress(f, mesh.faceSlots(), progress, kSearchesPerPoll)) return;
    if (!mesh.isLive(f)) continue;
    for (Vertex v : mesh.triangle(f)) m_positions.insert(positionKey(mesh.position(v)));
    if (!isDegenerate(mesh.points(f))) m_faces.push_back(f);
  }
  std::vector<Vec3> points(mesh.vertexSlots());
  for (Vertex v = 0; v < points.size(); ++v) points[v] = mesh.position(v);
  std::vector<Triangle> triangles;
  for (Face f : m_faces) triangles.push_back(mesh.triangle(f));
  m_hierarchy = TriangleHierarchy(points, triangles);
}

bool FanSeparator::separate(const std::vector<HalfEdge>& fan) {
  const Surroundings around = surroundings(facesOf(fan), longestMove(fan));
  return separate(fan, around, intersections(around));
}

Vertex FanSeparator::separateEdge(HalfEdge h) {
  const HalfEdgeMesh before = m_mesh;
  const Face f = HalfEdgeMesh::face(h), g = HalfEdgeMesh::face(m_mesh.opposite(h));
  const std::size_t allowed = intersections(surroundings({f, g}, 0.0));
  const Vec3 middle = rounded(Vec3(0.5 * (m_mesh.position(m_mesh.from(h)) + m_mesh.position(m_mesh.to(h)))), m_numbers);
  const auto firstNew = static_cast<Face>(m_mesh.faceSlots());
  const HalfEdge spoke = splitEdge(m_mesh, h, middle);
  addHalf(f, firstNew);
  addHalf(g, firstNew + 1);
  const std::vector<HalfEdge> fan = m_mesh.fan(spoke);
  if (separate(fan, surroundings(facesOf(fan), longestMove(fan)), allowed)) return m_mesh.from(spoke);
  m_halves[m_whole.at(firstNew)].pop_back();
  m_halves[m_whole.at(firstNew + 1)].pop_back();
  m_mesh = before;
  return kNone;
}

// Finds the faces that may meet these while a corner moves by the given distance, mm, along each axis. Incomplete once
// cancelled.
FanSeparator::Surroundings FanSeparator::surroundings(std::vector<Face> faces, double move) {
  Surroundings around{std::move(faces), {}};
  m_seenIn.resize(m_mesh.faceSlots(), 0);
  ++m_search;
  for (const Face f : around.faces) m_seenIn[f] = m_search;
  for (const Face f : around.faces) {
    if (m_watched.cancelled()) break;
    const std::size_t before = around.near.size();
    std::size_t seen = 0;
    const auto add = [&](Face other) {
      ++seen;
      if (m_seenIn[other] == m_search) return;
      m_seenIn[other] = m_search;
      const TrianglePoints points = m_mesh.points(other);
      if (!isDegenerate(points)) around.near.push_back({other, boxOf(points)});
    };
    // The hierarchy has the original positions, and split faces as a whole.
    const Box box = boxOf(m_mesh.points(f));
    const Vec3 slack = Vec3::Constant(m_reach + move);
    m_hierarchy.forEachInBox(Box(box.min() - slack, box.max() + slack), [&](std::uint32_t i) {
      add(m_faces[i]);
      const auto halves = m_halves.find(m_faces[i]);
      if (halves != m_halves.end()) std::for_each(halves->second.begin(), halves->second.end(), add);
      return true;
    });
    spend(around.near.size() - before, seen);
  }
  return around;
}

void FanSeparator::spend(std::size_t tests, std::size_t boxes) {
  m_uncounted += boxes + tests * (kBoxesPerStep / kTestsPerStep);
  m_watched.spend(m_uncounted / kBoxesPerStep);
  m_uncounted %= kBoxesPerStep;
}

// Returns an upper bound of the move along each axis.
double FanSeparator::longestMove(const std::vector<HalfEdge>& fan) const {
  return 2.0 * kLargestStep * unitInTheLastPlace(m_mesh.position(m_mesh.from(fan.front())), m_numbers);
}

void FanSeparator::addHalf(Face of, Face half) {
  const auto at = m_whole.find(of);
  const Face whole = at == m_whole.end() ? of : at->second;
  m_whole[half] = whole;
  m_halves[whole].push_back(half);
}

bool FanSeparator::separate(const std::vector<HalfEdge>& fan, const Surroundings& around, std::size_t allowed) {
  const Vertex v = m_mesh.from(fan.front());
  const Vec3 home = m_mesh.position(v);
  const double unit = unitInTheLastPlace(home, m_numbers);
  const std::vector<Vec3> directions = separatingDirections(fan);
  std::size_t fewest = allowed + m_spare + 1;
  Vec3 best = home;
  for (int step = kSmallestStep; step <= kLargestStep && fewest > allowed; step *= 2) {
    for (const Vec3& d : directions) {
      if (m_watched.cancelled()) break;
      const Vec3 p = rounded(Vec3(home + step * unit * d), m_numbers);
      if (p == home || m_positions.contains(positionKey(p))) continue;
      m_mesh.setPosition(v, p);
      m_reach = std::max(m_reach, (p - home).norm());
      if (hasFlatFace(around.faces)) continue;
      const std::size_t n = intersections(around, fewest);
      if (n >= fewest || m_watched.cancelled()) continue;
      fewest = n;
      best = p;
      if (n <= allowed) break;
    }
  }
  m_mesh.setPosition(v, best);
  if (best == home) return false;
  m_positions.insert(positionKey(best));
  m_spare -= fewest > allowed ? fewest - allowed : 0;
  return true;
}

// Returns directions into the solid, out of it, and towards and away from the middle of the fan, scaled so that the
// largest component is 1.
std::vector<Vec3> FanSeparator::separatingDirections(const std::vector<HalfEdge>& fan) const {
  const Vec3 home = m_mesh.position(m_mesh.from(fan.front()));
  Vec3 normal = Vec3::Zero(), middle = Vec3::Zero();
  for (HalfEdge h : fan) {
    const TrianglePoints p = m_mesh.points(HalfEdgeMesh::face(h));
    normal += (p[1] - p[0]).cross(p[2] - p[0]).stableNormalized();
    middle += ((p[0] + p[1] + p[2]) / 3.0 - home).stableNormalized();
  }
  std::vector<Vec3> result;
  const Vec3 n = normal.stableNormalized(), m = middle.stableNormalized();
  for (const Vec3& d : {Vec3(-n), m, Vec3(m - n), n, Vec3(m + n), Vec3(-m), Vec3(-m - n), Vec3(n - m)}) {
    const double largest = d.cwiseAbs().maxCoeff();
    if (largest > 1e-6) result.push_back(d / largest);
  }
  return result;
}

bool FanSeparator::hasFlatFace(const std::vector<Face>& faces) const {
  return std::any_of(faces.begin(), faces.end(), [&](Face f) { return isDegenerate(m_mesh.points(f)); });
}

// Counts the intersecting pairs with one of the faces, up to a limit. Too few once cancelled.
std::size_t FanSeparator::intersections(const Surroundings& around, std::size_t most) {
  std::vector<std::pair<Box, TrianglePoints>> ours;
  for (const Face f : around.faces) {
    const TrianglePoints points = m_mesh.points(f);
    if (!isDegenerate(points)) ours.emplace_back(boxOf(points), points);
  }
  std::size_t n = 0;
  for (std::size_t i = 0; i < ours.size() && n < most && !m_watched.cancelled(); ++i) {
    const auto& [box, t] = ours[i];
    std::size_t tests = 0;
    for (std::size_t k = i + 1; k < ours.size() && n < most; ++k) {
      if (!ours[k].first.intersects(box)) continue;
      ++tests;
      n += trianglesMeet(t, ours[k].second);
    }
    for (std::size_t k = 0; k < around.near.size() && n < most; ++k) {
      if (!around.near[k].box.intersects(box)) continue;
      ++tests;
      n += trianglesMeet(t, m_mesh.points(around.near[k].face));
    }
    spend(tests, ours.size() - i - 1 + around.near.size());
  }
  return std::min(n, most);
}

}  // namespace handwheel
