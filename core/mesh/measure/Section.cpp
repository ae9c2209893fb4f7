// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/measure/Section.h"

#include "base/Tolerance.h"
#include "mesh/measure/CoveredArea.h"
#include "mesh/structure/CancelPolling.h"
#include "mesh/structure/Shells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace handwheel {

namespace {

// Shares of the largest coordinate up to which a vertex lies in the plane: what rounding moves it, and the height by. A
// wall that is slanted is flat only as far as the precision of its file allows.
constexpr double kRoundingOfDoubles = 64.0 * std::numeric_limits<double>::epsilon();
constexpr double kRoundingOfSingles = 2.0 * static_cast<double>(std::numeric_limits<float>::epsilon());

// The heights of vertices above a plane, and the height up to which they lie in it.
class Heights {
 public:
  Heights(const HalfEdgeMesh& mesh, const Vec3& normal, double offset)
      : m_mesh(mesh), m_normal(normal), m_offset(offset) {
    double largest = std::abs(offset);
    bool isSingle = true;
    for (Face f = 0; f < mesh.faceSlots(); ++f) {
      if (!mesh.isLive(f)) continue;
      for (const Vertex v : mesh.triangle(f)) {
        const Vec3& p = mesh.position(v);
        if (!p.allFinite()) continue;
        largest = std::max(largest, p.cwiseAbs().maxCoeff());
        isSingle = isSingle && p == p.cast<float>().cast<double>();
      }
    }
    const bool isAlongAxis = (normal.array() != 0.0).count() == 1;
    m_tolerance = largest * (isSingle && !isAlongAxis ? kRoundingOfSingles : kRoundingOfDoubles);
  }

  double of(Vertex v) const { return m_normal.dot(m_mesh.position(v)) - m_offset; }
  double tolerance() const { return m_tolerance; }
  bool isInPlane(Vertex v) const { return std::abs(of(v)) <= m_tolerance; }

 private:
  const HalfEdgeMesh& m_mesh;
  const Vec3 m_normal;
  const double m_offset;
  double m_tolerance = 0.0;
};

// The side that vertices in the plane count to.
enum class InPlane { Below, Above };

// A cut face, given by the half-edges at which the curve enters and leaves.
struct CutFace {
  HalfEdge in;   // from above to below
  HalfEdge out;  // from below to above
  bool isTaken = false;
};

struct CutCurve {
  SectionCurve curve;
  Face face;  // one of the cut faces
};

class Cut {
 public:
  Cut(const HalfEdgeMesh& mesh, const Heights& heights, InPlane inPlane)
      : m_mesh(mesh),
        m_heights(heights),
        m_from(inPlane == InPlane::Below ? heights.tolerance() : -heights.tolerance()),
        m_inPlane(inPlane) {}

  std::vector<CutCurve> build(const Progress& progress) {
    for (Face f = 0; f < m_mesh.faceSlots(); ++f) {
      if (!pollProgress(f, m_mesh.faceSlots(), progress)) return {};
      addFace(f);
    }
    // Open curves start where the surface ends; the remaining ones are closed.
    for (const bool isOpen : {true, false}) {
      for (std::size_t i = 0; i < m_cut.size(); ++i) {
        if (!m_cut[i].isTaken && (!isOpen || !isCut(m_cut[i].in))) follow(i);
      }
    }
    return std::move(m_curves);
  }

 private:
  bool isAbove(double height) const { return m_inPlane == InPlane::Below ? height > m_from : height >= m_from; }

  void addFace(Face f) {
    if (!m_mesh.isLive(f)) return;
    std::array<double, 3> heights{};
    for (std::uint32_t k = 0; k < 3; ++k) heights[k] = m_heights.of(m_mesh.triangle(f)[k]);
    if (!std::isfinite(heights[0] + heights[1] + heights[2]) || !m_mesh.isProper(f)) return;
    CutFace cut{kNone, kNone};
    for (std::uint32_t k = 0; k < 3; ++k) {
      const bool isHere = isAbove(heights[k]), isNext = isAbove(heights[(k + 1) % 3]);
      if (isHere && !isNext) cut.in = 3 * f + k;
      if (!isHere && isNext) cut.out = 3 * f + k;
    }
    if (cut.in == kNone) return;
    m_index.emplace(f, m_cut.size());
    m_cut.push_back(cut);
  }

  // Returns true if the curve continues beyond a half-edge of a cut face.
  bool isCut(HalfEdge h) const {
    return m_mesh.hasOpposite(h) && m_index.contains(HalfEdgeMesh::face(m_mesh.opposite(h)));
  }

  // The same from both faces of the edge, as it always goes from below to above. A vertex in the plane may be on the
  // wrong side of it by a rounding.
  Vec3 crossing(Vertex below, Vertex above) const {
    const double low = std::min(m_heights.of(below), 0.0), high = std::max(m_heights.of(above), 0.0);
    const double share = high > low ? low / (low - high) : 0.5;
    return m_mesh.position(below) + share * (m_mesh.position(above) - m_mesh.position(below));
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
    if (curve.points.size() < (curve.closed ? 3u : 2u)) return;
    m_curves.push_back({std::move(curve), HalfEdgeMesh::face(m_cut[first].in)});
  }

  const HalfEdgeMesh& m_mesh;
  const Heights& m_heights;
  const double m_from;  // mm
  const InPlane m_inPlane;
  std::vector<CutFace> m_cut;
  std::unordered_map<Face, std::size_t> m_index;  // index of each cut face
  std::vector<CutCurve> m_curves;
};

// The curves that make up a section, with their figures.
class Figures {
 public:
  explicit Figures(const Vec3& normal) : m_axes(axesOfPlane(normal)) {}

  void add(SectionCurve curve) {
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

  Section take(const Progress& progress) {
    m_section.area = coveredArea(m_closed, progress);
    return std::move(m_section);
  }

 private:
  const PlaneAxes m_axes;
  Section m_section;
  Vec3 m_origin = Vec3::Zero();
  std::vector<std::vector<Eigen::Vector2d>> m_closed;  // in the plane
};

// Twice the area that a curve encloses: positive if it is counter-clockwise.
double turnOf(const SectionCurve& curve, const Vec3& normal) {
  double sum = 0.0;
  for (std::size_t i = 2; curve.closed && i < curve.points.size(); ++i)
    sum += normal.dot((curve.points[i - 1] - curve.points[0]).cross(curve.points[i] - curve.points[0]));
  return sum;
}

// Returns the shell of each face.
std::vector<std::uint32_t> shellNumbers(const HalfEdgeMesh& mesh, const Progress& progress) {
  std::vector<std::uint32_t> numbers(mesh.faceSlots(), 0);
  std::uint32_t number = 0;
  for (const std::vector<Face>& shell : findShells(mesh, progress)) {
    for (const Face f : shell) numbers[f] = number;
    ++number;
  }
  return numbers;
}

// Returns the curves just below the plane; of shells that have none, those just above, if they bound material there.
std::vector<CutCurve> curvesOfBoth(const HalfEdgeMesh& mesh, const Heights& heights, const Vec3& normal,
                                   const Progress& progress) {
  std::vector<CutCurve> below = Cut(mesh, heights, InPlane::Above).build(progress.part(0.0, 0.4));
  std::vector<CutCurve> above = Cut(mesh, heights, InPlane::Below).build(progress.part(0.4, 0.8));
  const std::vector<std::uint32_t> shellOf = shellNumbers(mesh, progress.part(0.8, 1.0));
  std::unordered_set<std::uint32_t> isBelow;
  std::unordered_map<std::uint32_t, double> turns;
  for (const CutCurve& c : below) isBelow.insert(shellOf[c.face]);
  for (const CutCurve& c : above) turns[shellOf[c.face]] += turnOf(c.curve, normal);
  for (CutCurve& c : above) {
    const std::uint32_t shell = shellOf[c.face];
    if (!isBelow.contains(shell) && (turns[shell] >= 0.0 || isBelow.empty())) below.push_back(std::move(c));
  }
  return below;
}

}  // namespace

PlaneAxes axesOfPlane(const Vec3& normal) {
  const Vec3 across = Vec3::UnitZ().cross(normal);
  // Along Z within a rounding; there the cross product has no digits left.
  const Vec3 u = across.norm() > tolerance::kAlongAxis ? Vec3(across.normalized())
                                                       : Vec3((Vec3::UnitX() - normal.x() * normal).normalized());
  return {u, normal.cross(u)};
}

Section sectionOf(const HalfEdgeMesh& mesh, const Vec3& normal, double offset, Progress progress) {
  const Heights heights(mesh, normal, offset);
  std::size_t inPlane = 0;
  bool isTouched = false;
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!pollProgress(f, mesh.faceSlots(), progress.part(0.0, 0.1))) return {};
    if (!mesh.isLive(f) || !mesh.isProper(f)) continue;
    const Triangle t = mesh.triangle(f);
    const auto corners = std::count_if(t.begin(), t.end(), [&](Vertex v) { return heights.isInPlane(v); });
    isTouched |= corners > 0;
    inPlane += corners == 3;
  }
  std::vector<CutCurve> curves = inPlane > 0 ? curvesOfBoth(mesh, heights, normal, progress.part(0.1, 0.5))
                                             : Cut(mesh, heights, InPlane::Below).build(progress.part(0.1, 0.5));
  if (progress.cancelled()) return {};
  Figures figures(normal);
  for (CutCurve& c : curves) figures.add(std::move(c.curve));
  Section section = figures.take(progress.part(0.5, 1.0));
  section.facesInPlane = inPlane;
  section.isTouched = isTouched;
  return section;
}

}  // namespace handwheel
