// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/holes/EvenRemeshing.h"

#include "base/Tolerance.h"
#include "mesh/openmesh/OpenMeshCopy.h"
#include "mesh/structure/DisjointSets.h"
#include "mesh/structure/EdgeTable.h"
#include "proximity/TriangleHierarchy.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace handwheel {
namespace {

using Surface = OpenMeshSurface;
using VertexHandle = Surface::VertexHandle;
using EdgeHandle = Surface::EdgeHandle;
using HalfedgeHandle = Surface::HalfedgeHandle;
using FaceHandle = Surface::FaceHandle;

// Edges longer than kLong times the wanted length are split, edges shorter than kShort times it are collapsed (Botsch
// and Kobbelt 2004).
constexpr double kLong = 4.0 / 3.0;
constexpr double kShort = 4.0 / 5.0;
constexpr int kRemeshingRounds = 6;  // rounds of splitting, collapsing, flipping and moving
constexpr int kSplitPasses = 30;     // halvings of an edge in a round; no patch has edges 2^30 times too long
constexpr int kFlipPasses = 20;

// Returns true if each edge has one face, or two that agree in orientation, and each point one fan of faces. Other
// faces stop OpenMesh with an assertion.
bool isManifold(const TriangleSoup& patch) {
  bool isManifold = std::none_of(patch.triangles.begin(), patch.triangles.end(), hasRepeatedVertex);
  const auto next = [](std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; };
  DisjointSets fans(3 * patch.triangles.size());  // sets of corners, which are numbered like half-edges
  const EdgeTable edges(patch.triangles, patch.points.size());
  edges.forEachEdge([&](std::uint32_t, std::uint32_t, std::span<const EdgeTable::Entry> uses) {
    if (uses.size() == 1) return;
    const std::uint32_t h = uses[0].halfEdge, g = uses[1].halfEdge;
    isManifold = isManifold && uses.size() == 2 && patch.triangles[h / 3][h % 3] != patch.triangles[g / 3][g % 3];
    fans.join(h, next(g));
    fans.join(next(h), g);
  });
  std::vector<std::uint32_t> fanOf(patch.points.size(), kNone);
  for (std::uint32_t h = 0; h < 3 * patch.triangles.size(); ++h) {
    std::uint32_t& fan = fanOf[patch.triangles[h / 3][h % 3]];
    if (fan == kNone) fan = fans.root(h);
    isManifold = isManifold && fan == fans.root(h);
  }
  return isManifold;
}

class EvenRemesher {
 public:
  EvenRemesher(const TriangleSoup& patch, const EvenRemeshing& wanted, const Progress& progress)
      : m_given(patch.points, patch.triangles), m_wanted(wanted), m_progress(progress) {}

  // Returns false if the patch is not manifold, or has a vertex with so many faces that OpenMesh would take minutes.
  bool take(const TriangleSoup& patch) {
    if (hasHub(patch) || !isManifold(patch)) return false;
    m_surface.poll(m_progress);
    for (const Vec3& p : patch.points) addPoint(p);
    m_inside = patch.points.size() - m_wanted.lengths.size();
    for (const Triangle& t : patch.triangles) {
      const auto corner = [&](int k) { return VertexHandle(static_cast<int>(t[k])); };
      if (!m_surface.add_face(corner(0), corner(1), corner(2)).is_valid()) return false;
    }
    for (const auto v : m_surface.vertices()) {
      if (isFixed(v) != m_surface.is_boundary(v)) return false;
    }
    initialiseLengths();
    return true;
  }

  TriangleSoup remesh() {
    for (int round = 0; round < kRemeshingRounds; ++round) {
      updateDistances();
      splitLongEdges();
      if (round > 0) collapseShortEdges();
      flipEdges();
      spreadLengths();
      movePoints();
      m_progress.set((round + 1.0) / kRemeshingRounds);
    }
    splitJoinedEdges();
    flipEdges();
    return result();
  }

 private:
  static bool hasHub(const TriangleSoup& patch) {
    std::vector<int> faces(patch.points.size(), 0);
    for (const Triangle& t : patch.triangles) {
      for (const std::uint32_t v : t) {
        if (++faces[v] > tolerance::kLibraryFanFaces) return true;
      }
    }
    return false;
  }

  bool isFixed(VertexHandle v) const { return indexOf(v) < m_wanted.lengths.size(); }
  static std::size_t indexOf(VertexHandle v) { return static_cast<std::size_t>(v.idx()); }
  const Vec3& at(VertexHandle v) const { return m_points[indexOf(v)]; }

  VertexHandle addPoint(const Vec3& p, double length = 0.0, double distance = 0.0) {
    m_points.push_back(p);
    m_lengths.push_back(length);
    m_distances.push_back(distance);
    return m_surface.add_vertex({});
  }

  double wantedAt(VertexHandle v) const { return m_lengths[indexOf(v)] + m_wanted.growth * m_distances[indexOf(v)]; }
  double wantedBetween(VertexHandle a, VertexHandle b) const { return 0.5 * (wantedAt(a) + wantedAt(b)); }

  // Returns true if an edge outside of the patch joins the two vertices.
  bool isJoined(VertexHandle a, VertexHandle b) const {
    if (!isFixed(a) || !isFixed(b)) return false;
    const std::pair<std::uint32_t, std::uint32_t> edge =
        std::minmax(static_cast<std::uint32_t>(a.idx()), static_cast<std::uint32_t>(b.idx()));
    return std::binary_search(m_wanted.joined.begin(), m_wanted.joined.end(), edge);
  }

  // Points that the given patch has inside get the mean of the border.
  void initialiseLengths() {
    double sum = 0.0;
    for (const double length : m_wanted.lengths) sum += length;
    const double mean = sum / static_cast<double>(std::max<std::size_t>(1, m_wanted.lengths.size()));
    std::fill(m_lengths.begin(), m_lengths.end(), mean);
    std::copy(m_wanted.lengths.begin(), m_wanted.lengths.end(), m_lengths.begin());
  }

  // Interpolates the wanted lengths of the border by a few steps towards the harmonic function.
  void spreadLengths() {
    constexpr int kSweeps = 4;
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      for (const auto v : m_surface.vertices()) {
        if (isFixed(v)) continue;
        double sum = 0.0;
        int count = 0;
        for (const auto w : m_surface.vv_range(v)) {
          sum += m_lengths[indexOf(w)];
          ++count;
        }
        if (count > 0) m_lengths[indexOf(v)] = sum / count;
      }
    }
  }

  // Sets the distances from the border along edges (Dijkstra).
  void updateDistances() {
    if (m_wanted.growth <= 0.0) return;
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    for (const auto v : m_surface.vertices()) {
      m_distances[indexOf(v)] = isFixed(v) ? 0.0 : std::numeric_limits<double>::infinity();
      if (isFixed(v)) open.push({0.0, v.idx()});
    }
    while (!open.empty()) {
      const auto [distance, index] = open.top();
      open.pop();
      const VertexHandle v(index);
      if (distance > m_distances[indexOf(v)]) continue;
      for (const auto w : m_surface.vv_range(v)) {
        const double next = distance + (at(w) - at(v)).norm();
        if (next >= m_distances[indexOf(w)]) continue;
        m_distances[indexOf(w)] = next;
        open.push({next, w.idx()});
      }
    }
  }

  void split(EdgeHandle e) {
    const HalfedgeHandle h = m_surface.halfedge_handle(e, 0);
    const VertexHandle a = m_surface.from_vertex_handle(h), b = m_surface.to_vertex_handle(h);
    const std::size_t i = indexOf(a), j = indexOf(b);
    const VertexHandle middle = addPoint(0.5 * (at(a) + at(b)), 0.5 * (m_lengths[i] + m_lengths[j]),
                                         0.5 * (m_distances[i] + m_distances[j] + (at(b) - at(a)).norm()));
    m_surface.split(e, middle);
    ++m_inside;
  }

  // Splits the longest edges first, relative to their wanted length, so that triangles stay as even as possible.
  void splitLongEdges() {
    for (int pass = 0; pass < kSplitPasses; ++pass) {
      std::vector<std::pair<double, int>> edges;
      for (const auto e : m_surface.edges()) {
        if (m_surface.is_boundary(e)) continue;
        const HalfedgeHandle h = m_surface.halfedge_handle(e, 0);
        const VertexHandle a = m_surface.from_vertex_handle(h), b = m_surface.to_vertex_handle(h);
        const double ratio = (at(b) - at(a)).norm() / wantedBetween(a, b);
        if (ratio > kLong) edges.emplace_back(-ratio, e.idx());
      }
      if (edges.empty()) return;
      std::sort(edges.begin(), edges.end());
      for (const auto& [ratio, index] : edges) {
        if (m_inside >= m_wanted.mostPoints) return;
        split(EdgeHandle(index));
      }
      flipEdges();
    }
  }

  void splitJoinedEdges() {
    std::vector<EdgeHandle> edges;
    for (const auto e : m_surface.edges()) {
      const HalfedgeHandle h = m_surface.halfedge_handle(e, 0);
      if (!m_surface.is_boundary(e) && isJoined(m_surface.from_vertex_handle(h), m_surface.to_vertex_handle(h)))
        edges.push_back(e);
    }
    for (const EdgeHandle e : edges) split(e);
  }

  Vec3 normalOf(const Vec3& a, const Vec3& b, const Vec3& c) const { return (b - a).cross(c - a); }

  // Returns true if the faces at a vertex keep their sides when it moves. without: a vertex whose faces vanish.
  bool keepsSides(VertexHandle v, const Vec3& target, VertexHandle without = VertexHandle()) const {
    for (const auto h : m_surface.voh_range(v)) {
      if (m_surface.is_boundary(h)) continue;
      const VertexHandle b = m_surface.to_vertex_handle(h);
      const VertexHandle c = m_surface.to_vertex_handle(m_surface.next_halfedge_handle(h));
      if (b == without || c == without) continue;
      const Vec3 before = normalOf(at(v), at(b), at(c)), after = normalOf(target, at(b), at(c));
      if (!(before.dot(after) > kLeastCosine * before.norm() * after.norm())) return false;
    }
    return true;
  }

  bool canCollapse(HalfedgeHandle h) const {
    const VertexHandle from = m_surface.from_vertex_handle(h), to = m_surface.to_vertex_handle(h);
    if (isFixed(from)) return false;
    for (const auto w : m_surface.vv_range(from)) {
      if (w == to) continue;
      if (isJoined(w, to) || (at(w) - at(to)).norm() > kLong * wantedBetween(w, to)) return false;
    }
    return keepsSides(from, at(to), to);
  }

  void collapseShortEdges() {
    for (const auto e : m_surface.edges()) {
      if (m_surface.status(e).deleted() || m_surface.is_boundary(e)) continue;
      for (unsigned int side = 0; side < 2; ++side) {
        const HalfedgeHandle h = m_surface.halfedge_handle(e, side);
        const VertexHandle a = m_surface.from_vertex_handle(h), b = m_surface.to_vertex_handle(h);
        if ((at(b) - at(a)).norm() >= kShort * wantedBetween(a, b)) break;
        if (!canCollapse(h) || !m_surface.is_collapse_ok(h)) continue;
        m_surface.collapse(h);
        --m_inside;
        break;
      }
    }
  }

  // The cosine and sine of the angle at b, both multiplied by the same factor.
  Eigen::Vector2d directionAt(VertexHandle a, VertexHandle b, VertexHandle c) const {
    const Vec3 u = at(a) - at(b), v = at(c) - at(b);
    return {u.dot(v), u.cross(v).norm()};
  }

  // Returns true if the other diagonal of the two faces makes larger angles, as in a Delaunay triangulation, and the
  // surface does not fold by it.
  bool wantsFlip(EdgeHandle e) const {
    const HalfedgeHandle h = m_surface.halfedge_handle(e, 0), g = m_surface.halfedge_handle(e, 1);
    const VertexHandle a = m_surface.from_vertex_handle(h), b = m_surface.to_vertex_handle(h);
    const VertexHandle c = m_surface.to_vertex_handle(m_surface.next_halfedge_handle(h));
    const VertexHandle d = m_surface.to_vertex_handle(m_surface.next_halfedge_handle(g));
    const Eigen::Vector2d left = directionAt(a, c, b), right = directionAt(a, d, b);
    const double sineOfSum = left.x() * right.y() + left.y() * right.x();  // negative if the sum is more than 180°
    if (sineOfSum >= -kAngleMargin * left.norm() * right.norm() || isJoined(c, d)) return false;
    const Vec3 before = normalOf(at(a), at(b), at(c)) + normalOf(at(b), at(a), at(d));
    const Vec3 first = normalOf(at(c), at(d), at(b)), second = normalOf(at(d), at(c), at(a));
    return first.dot(before) > kLeastCosine * first.norm() * before.norm() &&
           second.dot(before) > kLeastCosine * second.norm() * before.norm();
  }

  void flipEdges() {
    for (int pass = 0; pass < kFlipPasses; ++pass) {
      bool isAnyFlipped = false;
      for (const auto e : m_surface.edges()) {
        if (m_surface.is_boundary(e) || !wantsFlip(e) || !m_surface.is_flip_ok(e)) continue;
        m_surface.flip(e);
        isAnyFlipped = true;
      }
      if (!isAnyFlipped) return;
    }
  }

  void movePoints() {
    for (const auto v : m_surface.vertices()) {
      if (isFixed(v)) continue;
      Vec3 sum = Vec3::Zero();
      int count = 0;
      for (const auto w : m_surface.vv_range(v)) {
        sum += at(w);
        ++count;
      }
      if (count == 0) continue;
      const auto nearest = m_given.nearest(sum / count);
      if (nearest && keepsSides(v, nearest->point)) m_points[indexOf(v)] = nearest->point;
    }
  }

  TriangleSoup result() const {
    TriangleSoup soup;
    std::vector<std::uint32_t> number(m_points.size(), kNone);
    for (const auto v : m_surface.vertices()) {
      number[indexOf(v)] = static_cast<std::uint32_t>(soup.points.size());
      soup.points.push_back(at(v));
    }
    for (const auto f : m_surface.faces()) {
      Triangle t{};
      std::size_t k = 0;
      for (const auto v : m_surface.fv_range(f)) t[k++] = number[indexOf(v)];
      soup.triangles.push_back(t);
    }
    return soup;
  }

  static constexpr double kLeastCosine = 0.2;   // a face may not turn farther from its side
  static constexpr double kAngleMargin = 1e-9;  // radian; keeps two equal diagonals from being exchanged for ever

  Surface m_surface;
  TriangleHierarchy m_given;
  const EvenRemeshing& m_wanted;
  const Progress& m_progress;
  // Indexed by the numbers of vertices, deleted ones included; faster than properties of OpenMesh.
  std::vector<Vec3> m_points;
  std::vector<double> m_lengths;    // wanted lengths without growth, mm
  std::vector<double> m_distances;  // from the border, mm
  std::size_t m_inside = 0;         // points inside
};

}  // namespace

double expectedTriangles(const TriangleSoup& patch, const std::vector<double>& lengths) {
  double n = 0.0;
  for (const Triangle& t : patch.triangles) {
    const Vec3 u = patch.points[t[1]] - patch.points[t[0]];
    const Vec3 v = patch.points[t[2]] - patch.points[t[0]];
    double length = 0.0;
    for (std::uint32_t corner : t) length += lengths[std::min<std::size_t>(corner, lengths.size() - 1)] / 3.0;
    n += 0.5 * u.cross(v).norm() / (kEquilateralArea * length * length);
  }
  return n;
}

std::optional<TriangleSoup> remeshEvenly(const TriangleSoup& patch, const EvenRemeshing& wanted, Progress progress) {
  try {
    EvenRemesher remesher(patch, wanted, progress);
    if (!remesher.take(patch)) return std::nullopt;
    return remesher.remesh();
  } catch (const OpenMeshSurface::Cancelled&) {
    return std::nullopt;
  }
}

}  // namespace handwheel
