// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/measure/Section.h"

#include "base/Tolerance.h"
#include "mesh/measure/CoveredArea.h"
#include "mesh/structure/CancelPolling.h"

#include <array>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace handwheel {

namespace {

// A cut face, given by the half-edges at which the curve enters and leaves.
struct CutFace {
  HalfEdge in;   // from above to below
  HalfEdge out;  // from below to above
  bool isTaken = false;
};

class Cut {
 public:
  Cut(const HalfEdgeMesh& mesh, const Vec3& normal, double offset) : m_mesh(mesh), m_normal(normal), m_offset(offset) {}

  Section build(const Progress& progress) {
    for (Face f = 0; f < m_mesh.faceSlots(); ++f) {
      if (!pollProgress(f, m_mesh.faceSlots(), progress.part(0.0, 0.5))) return {};
      addFace(f);
    }
    // Open curves start where the surface ends; the remaining ones are closed.
    for (const bool isOpen : {true, false}) {
      for (std::size_t i = 0; i < m_cut.size(); ++i) {
        if (!m_cut[i].isTaken && (!isOpen || !isCut(m_cut[i].in))) follow(i);
      }
    }
    m_section.area = coveredArea(m_closed, progress.part(0.5, 1.0));
    return std::move(m_section);
  }

 private:
  double height(Vertex v) const { return m_normal.dot(m_mesh.position(v)) - m_offset; }

  void addFace(Face f) {
    if (!m_mesh.isLive(f)) return;
    std::array<double, 3> heights{};
    for (std::uint32_t k = 0; k < 3; ++k) heights[k] = height(m_mesh.triangle(f)[k]);
    if (!std::isfinite(heights[0] + heights[1] + heights[2]) || !m_mesh.isProper(f)) return;
    CutFace cut{kNone, kNone};
    for (std::uint32_t k = 0; k < 3; ++k) {
      const bool isAbove = heights[k] > 0.0, isNextAbove = heights[(k + 1) % 3] > 0.0;
      if (isAbove && !isNextAbove) cut.in = 3 * f + k;
      if (!isAbove && isNextAbove) cut.out = 3 * f + k;
    }
    if (cut.in == kNone) return;
    m_index.emplace(f, m_cut.size());
    m_cut.push_back(cut);
  }

  // Returns true if the curve continues beyond a half-edge of a cut face.
  bool isCut(HalfEdge h) const {
    return m_mesh.hasOpposite(h) && m_index.contains(HalfEdgeMesh::face(m_mesh.opposite(h)));
  }

  // The same from both faces of the edge, as it always goes from below to above.
  Vec3 crossing(Vertex below, Vertex above) const {
    const double low = height(below), high = height(above);
    return m_mesh.position(below) + low / (low - high) * (m_mesh.position(above) - m_mesh.position(below));
  }

  void follow(std::size_t first) {
    SectionCurve curve;
    const auto add = [&curve](const Vec3& p) {
      if (curve.points.empty() || curve.points.back() != p) curve.points.push_back(p);
    };
    add(crossing(m_mesh.to(m_cut[first].in), m_mesh.from(m_cut[first].in)));
    for (std::size_t i = first;;) {
      m_cut[i].isTaken = true;
      const HalfEdge out = m_cut[i].out;
      add(crossing(m_mesh.from(out), m_mesh.to(out)));
      curve.closed = isCut(out);
      if (!curve.closed) break;
      i = m_index.at(HalfEdgeMesh::face(m_mesh.opposite(out)));
      if (m_cut[i].isTaken) break;
    }
    if (curve.closed && curve.points.size() > 1 && curve.points.back() == curve.points.front()) curve.points.pop_back();
    // Touched in a point or along an edge.
    if (curve.points.size() >= (curve.closed ? 3u : 2u)) measure(std::move(curve));
  }

  void measure(SectionCurve curve) {
    const std::vector<Vec3>& p = curve.points;
    if (m_section.curves.empty()) m_origin = p[0];  // keeps the precision of curves far away
    for (std::size_t i = 0; i < p.size(); ++i) {
      if (i + 1 == p.size() && !curve.closed) break;
      m_section.length += (p[(i + 1) % p.size()] - p[i]).stableNorm();  // squares may overflow
    }
    if (curve.closed) {
      auto& flat = m_closed.emplace_back();
      for (const Vec3& q : p) flat.emplace_back((q - m_origin).dot(m_axes.u), (q - m_origin).dot(m_axes.v));
    }
    m_section.isClosed = m_section.isClosed && curve.closed;
    m_section.curves.push_back(std::move(curve));
  }

  const HalfEdgeMesh& m_mesh;
  const Vec3 m_normal;
  const double m_offset;
  const PlaneAxes m_axes = axesOfPlane(m_normal);
  std::vector<CutFace> m_cut;
  std::unordered_map<Face, std::size_t> m_index;  // index of each cut face
  Section m_section;
  Vec3 m_origin = Vec3::Zero();
  std::vector<std::vector<Eigen::Vector2d>> m_closed;  // in the plane
};

}  // namespace

PlaneAxes axesOfPlane(const Vec3& normal) {
  const Vec3 across = Vec3::UnitZ().cross(normal);
  // Along Z within a rounding; there the cross product has no digits left.
  const Vec3 u = across.norm() > tolerance::kAlongAxis ? Vec3(across.normalized())
                                                       : Vec3((Vec3::UnitX() - normal.x() * normal).normalized());
  return {u, normal.cross(u)};
}

Section sectionOf(const HalfEdgeMesh& mesh, const Vec3& normal, double offset, Progress progress) {
  return Cut(mesh, normal, offset).build(progress);
}

}  // namespace handwheel
