// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/BoundarySmoothing.h"

#include "mesh/boundary/PeriodicSpline.h"
#include "mesh/search/MovedFaces.h"

#include <algorithm>
#include <map>

namespace handwheel {
namespace {

constexpr double kWavesKept = 3.0;         // at most this many waves around a loop are kept
constexpr std::size_t kStepsPerKnot = 16;  // steps to measure the length of the curve
constexpr int kHalvings = 6;               // halvings of a move that flips a face, before the vertex stays
constexpr int kPasses = 4;                 // further passes for vertices that were held back

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

  Vec3 at(double distance) const {
    distance -= length() * std::floor(distance / length());
    const auto above = std::upper_bound(m_along.begin(), m_along.end() - 1, distance);
    const auto i = static_cast<std::size_t>(above - m_along.begin()) - 1;
    const double span = m_along[i + 1] - m_along[i];
    const double u = (static_cast<double>(i % kStepsPerKnot) + (span > 0.0 ? (distance - m_along[i]) / span : 0.0));
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
  double start = 0.0;  // chosen for the least mean displacement of the points
  for (std::size_t i = 0; i < points.size(); ++i) start += (curve.atKnot(i) - static_cast<double>(i) * step) / n;
  for (std::size_t i = 0; i < points.size(); ++i) result.push_back(curve.at(start + static_cast<double>(i) * step));
  return result;
}

// Moves the points of a loop, each less far if a face would flip.
class LoopMover {
 public:
  LoopMover(const FaceLocator& near, const BoundaryLoop& loop, NumberType numbers)
      : m_near(near), m_numbers(numbers), m_positions(loopPoints(near.mesh(), loop)) {
    for (const HalfEdge h : loop.halfEdges) {
      const Vertex v = near.mesh().from(h);
      m_index[v] = m_vertices.size();
      m_vertices.push_back(v);
      m_isStuck.push_back(false);
      for (const HalfEdge g : near.leaving(near.mesh().position(v))) {
        // Other fans and seams at this position would be torn off.
        const bool isSeam = near.mesh().isSeam(g) || near.mesh().isSeam(HalfEdgeMesh::previous(g));
        if (near.mesh().from(g) != v || isSeam) m_isStuck.back() = true;
        m_faces.push_back(HalfEdgeMesh::face(g));
      }
    }
    std::sort(m_faces.begin(), m_faces.end());
    m_faces.erase(std::unique(m_faces.begin(), m_faces.end()), m_faces.end());
  }

  const std::vector<Vec3>& positions() const { return m_positions; }

  // Returns the number of points that were held back.
  std::size_t draw(const std::vector<Vec3>& to) {
    m_to = to;
    m_share.clear();
    for (std::size_t i = 0; i < to.size(); ++i) m_share.push_back(m_isStuck[i] || !to[i].allFinite() ? 0.0 : 1.0);
    for (int round = 0; shorten(round); ++round) {
    }
    for (std::size_t i = 0; i < to.size(); ++i) m_positions[i] = position(i);
    return static_cast<std::size_t>(
        std::count_if(m_share.begin(), m_share.end(), [](double share) { return share < 1.0; }));
  }

  std::vector<VertexMove> moves() const {
    std::vector<VertexMove> result;
    for (std::size_t i = 0; i < m_vertices.size(); ++i) {
      const Vec3& from = m_near.mesh().position(m_vertices[i]);
      if (m_positions[i] != from) result.push_back({m_vertices[i], from, m_positions[i]});
    }
    return result;
  }

 private:
  Vec3 position(std::size_t i) const {
    if (m_share[i] == 0.0) return m_positions[i];
    const Vec3 position = rounded(m_positions[i] + m_share[i] * (m_to[i] - m_positions[i]), m_numbers);
    return position == rounded(m_positions[i], m_numbers) ? m_positions[i] : position;  // rounding alone is no move
  }

  // Without any displacement all faces are valid, so this terminates.
  bool shorten(int round) {
    MovedFaces moved{m_faces, {}};
    std::vector<bool> isWrong;
    for (const Face f : m_faces) {
      TrianglePoints after = m_near.mesh().points(f);
      for (std::size_t k = 0; k < 3; ++k) {
        const auto at = m_index.find(m_near.mesh().triangle(f)[k]);
        if (at != m_index.end()) after[k] = position(at->second);
      }
      isWrong.push_back(!mayBecome(m_near.mesh().points(f), after));
      moved.shapes.push_back(after);
    }
    forEachNewCrossing(m_near, moved, [&](std::size_t i) { return isWrong[i] = true; });
    std::vector<bool> isShort(m_share.size(), false);
    for (std::size_t i = 0; i < m_faces.size(); ++i) {
      for (const Vertex v : m_near.mesh().triangle(m_faces[i])) {
        const auto at = m_index.find(v);
        if (isWrong[i] && at != m_index.end() && m_share[at->second] > 0.0) isShort[at->second] = true;
      }
    }
    for (std::size_t i = 0; i < m_share.size(); ++i)
      if (isShort[i]) m_share[i] = round < kHalvings ? 0.5 * m_share[i] : 0.0;
    return std::find(isShort.begin(), isShort.end(), true) != isShort.end();
  }

  const FaceLocator& m_near;
  NumberType m_numbers;
  std::vector<Vertex> m_vertices;
  std::map<Vertex, std::size_t> m_index;
  std::vector<Face> m_faces;
  std::vector<bool> m_isStuck;
  std::vector<Vec3> m_positions;
  std::vector<Vec3> m_to;
  std::vector<double> m_share;  // share of the displacement per vertex
};

}  // namespace

SmoothedBoundary smoothBoundary(const FaceLocator& near, const BoundaryLoop& loop, const SmoothingOptions& options) {
  if (loop.halfEdges.size() < 3) return {};
  LoopMover mover(near, loop, options.numbers);
  std::size_t held = mover.draw(targets(mover.positions(), options));
  // Even spacing needs the longest displacements. Points that were held back move onto the curve directly.
  const SmoothingOptions here{options.wavelength, false, options.numbers};
  for (int pass = 0; pass < kPasses && held > 0; ++pass) held = mover.draw(targets(mover.positions(), here));
  return {mover.moves(), held};
}

bool moveVertices(HalfEdgeMesh& mesh, const std::vector<VertexMove>& moves) {
  for (const VertexMove& m : moves)
    if (m.vertex >= mesh.vertexSlots() || mesh.position(m.vertex) != m.from) return false;
  for (const VertexMove& m : moves) mesh.setPosition(m.vertex, m.to);
  return true;
}

}  // namespace handwheel
