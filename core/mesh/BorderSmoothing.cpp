// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/BorderSmoothing.h"

#include "mesh/PeriodicSpline.h"
#include "mesh/VertexPull.h"

#include <algorithm>
#include <map>

namespace handwheel {
namespace {

constexpr double kWavesKept = 3.0;         // a loop keeps this many around it, and fewer
constexpr std::size_t kStepsPerKnot = 16;  // in which the length of the curve is measured
constexpr int kHalvings = 6;               // of a way that turns a face over, before it is given up

// A curve by its length from its first knot.
class MeasuredCurve {
 public:
  explicit MeasuredCurve(const PeriodicSpline& spline) : m_spline(spline), m_along{0.0} {
    Vec3 last = spline.at(0, 0.0);
    for (std::size_t i = 1; i <= spline.size() * kStepsPerKnot; ++i) {
      const Vec3 p = step(i);
      m_along.push_back(m_along.back() + (p - last).stableNorm());
      last = p;
    }
  }

  double length() const { return m_along.back(); }
  double atKnot(std::size_t i) const { return m_along[i * kStepsPerKnot]; }

  Vec3 at(double way) const {
    way -= length() * std::floor(way / length());
    const auto above = std::upper_bound(m_along.begin(), m_along.end() - 1, way);
    const auto i = static_cast<std::size_t>(above - m_along.begin()) - 1;
    const double span = m_along[i + 1] - m_along[i];
    const double u = (static_cast<double>(i % kStepsPerKnot) + (span > 0.0 ? (way - m_along[i]) / span : 0.0));
    return m_spline.at(i / kStepsPerKnot, u / kStepsPerKnot);
  }

 private:
  Vec3 step(std::size_t i) const {
    if (i == m_spline.size() * kStepsPerKnot) return m_spline.at(m_spline.size() - 1, 1.0);
    return m_spline.at(i / kStepsPerKnot, static_cast<double>(i % kStepsPerKnot) / kStepsPerKnot);
  }

  const PeriodicSpline& m_spline;
  std::vector<double> m_along;
};

std::vector<Vec3> targets(const std::vector<Vec3>& points, const SmoothingOptions& options) {
  const auto n = static_cast<double>(points.size());
  const PeriodicSpline spline(points, lambdaForWavelength(std::min(options.wavelength, n / kWavesKept)));
  std::vector<Vec3> result;
  if (!options.evenly) {
    for (std::size_t i = 0; i < points.size(); ++i) result.push_back(spline.knot(i));
    return result;
  }
  const MeasuredCurve curve(spline);
  const double step = curve.length() / n;
  double start = 0.0;  // so that the points go the least way in the mean
  for (std::size_t i = 0; i < points.size(); ++i) start += (curve.atKnot(i) - static_cast<double>(i) * step) / n;
  for (std::size_t i = 0; i < points.size(); ++i) result.push_back(curve.at(start + static_cast<double>(i) * step));
  return result;
}

// The way of each vertex, cut short until no face turns over.
class HeldWays {
 public:
  HeldWays(const NearFaces& near, std::vector<VertexMove> moves) : m_near(near), m_moves(std::move(moves)) {
    for (std::size_t i = 0; i < m_moves.size(); ++i) m_index[m_moves[i].vertex] = i;
    m_share.assign(m_moves.size(), 1.0);
    for (std::size_t i = 0; i < m_moves.size(); ++i) {
      for (const HalfEdge h : near.leaving(m_moves[i].from)) {
        // Whatever else lies there would be torn off.
        const HalfEdge before = HalfEdgeMesh::previous(h);
        if (near.mesh().from(h) != m_moves[i].vertex || near.mesh().isSeam(h) || near.mesh().isSeam(before))
          m_share[i] = 0.0;
        m_faces.push_back(HalfEdgeMesh::face(h));
      }
    }
    std::sort(m_faces.begin(), m_faces.end());
    m_faces.erase(std::unique(m_faces.begin(), m_faces.end()), m_faces.end());
  }

  SmoothedBorder run() {
    for (int round = 0; shorten(round); ++round) {
    }
    SmoothedBorder result;
    for (std::size_t i = 0; i < m_moves.size(); ++i) {
      result.held += m_share[i] < 1.0;
      const Vec3 to = place(i);
      if (to != m_moves[i].from) result.moves.push_back({m_moves[i].vertex, m_moves[i].from, to});
    }
    return result;
  }

 private:
  Vec3 place(std::size_t i) const { return m_moves[i].from + m_share[i] * (m_moves[i].to - m_moves[i].from); }

  // A face none of whose corners goes anywhere is never in the way, so this ends.
  bool shorten(int round) {
    std::vector<bool> isShort(m_moves.size(), false);
    bool any = false;
    for (const Face f : m_faces) {
      TrianglePoints after = m_near.mesh().points(f);
      std::vector<std::size_t> moved;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto at = m_index.find(m_near.mesh().triangle(f)[k]);
        if (at == m_index.end() || m_share[at->second] == 0.0) continue;
        moved.push_back(at->second);
        after[k] = place(at->second);
      }
      if (moved.empty() || mayBecome(m_near.mesh().points(f), after)) continue;
      for (const std::size_t i : moved) isShort[i] = any = true;
    }
    for (std::size_t i = 0; i < m_moves.size(); ++i)
      if (isShort[i]) m_share[i] = round < kHalvings ? 0.5 * m_share[i] : 0.0;
    return any;
  }

  const NearFaces& m_near;
  std::vector<VertexMove> m_moves;
  std::map<Vertex, std::size_t> m_index;
  std::vector<double> m_share;
  std::vector<Face> m_faces;
};

}  // namespace

SmoothedBorder smoothBorder(const NearFaces& near, const BoundaryLoop& loop, const SmoothingOptions& options) {
  const std::vector<Vec3> points = loopPoints(near.mesh(), loop);
  if (points.size() < 3) return {};
  const std::vector<Vec3> to = targets(points, options);
  std::vector<VertexMove> moves;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (to[i].allFinite()) moves.push_back({near.mesh().from(loop.halfEdges[i]), points[i], to[i]});
  return HeldWays(near, std::move(moves)).run();
}

bool moveVertices(HalfEdgeMesh& mesh, const std::vector<VertexMove>& moves) {
  for (const VertexMove& m : moves)
    if (m.vertex >= mesh.vertexSlots() || mesh.position(m.vertex) != m.from) return false;
  for (const VertexMove& m : moves) mesh.setPosition(m.vertex, m.to);
  return true;
}

}  // namespace handwheel
