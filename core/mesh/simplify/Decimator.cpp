// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/simplify/Decimator.h"

#include "mesh/search/IncrementalHierarchy.h"
#include "mesh/simplify/CollapsePlacement.h"
#include "mesh/simplify/CollapseShape.h"
#include "mesh/structure/CancelPolling.h"
#include "mesh/structure/EdgeCollapse.h"
#include "mesh/structure/EdgeOperations.h"
#include "proximity/ClosestPoint.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace handwheel {
namespace {

constexpr std::size_t kEdgesPerReport = 256;

}  // namespace

bool Decimator::prepare(const Progress& progress) {
  m_stamp.assign(m_mesh.vertexSlots(), 0);
  m_inStar.assign(m_mesh.faceSlots(), 0);
  for (Face f = 0; m_options.avoidIntersections && f < m_mesh.faceSlots(); ++f) {
    if (!pollProgress(f, m_mesh.faceSlots(), progress)) return false;
    if (m_mesh.isLive(f)) m_octree.add(f, boxOf(m_mesh.points(f)));
  }
  return !progress.cancelled();
}

std::uint32_t Decimator::rankOf(double cost) {
  constexpr int kMantissaBits = 52, kKeptBits = 1;
  return static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(cost) >> (kMantissaBits - kKeptBits));
}

void Decimator::offer(HalfEdge h) {
  if (m_mesh.hasOpposite(h)) h = std::min(h, m_mesh.opposite(h));
  const auto placing = collapsePlacement(m_mesh, m_holds, h);
  if (placing) m_queue.push({rankOf(placing->cost), h, m_stamp[m_mesh.from(h)], m_stamp[m_mesh.to(h)]});
}

bool Decimator::seed(const Progress& progress) {
  for (HalfEdge h = 0; h < m_mesh.halfEdgeSlots(); ++h) {
    if (!pollProgress(h, m_mesh.halfEdgeSlots(), progress, kSearchesPerPoll)) return false;
    if (!m_mesh.isProper(HalfEdgeMesh::face(h))) continue;
    if (!m_mesh.hasOpposite(h) || h < m_mesh.opposite(h)) offer(h);
  }
  return true;
}

void Decimator::takeStar(HalfEdge h, const Vec3& p) {
  m_star = {};
  const Face f = HalfEdgeMesh::face(h), o = m_mesh.hasOpposite(h) ? HalfEdgeMesh::face(m_mesh.opposite(h)) : kNone;
  for (const HalfEdge end : {h, HalfEdgeMesh::next(h)}) {
    forEachInFan(m_mesh, end, [&](HalfEdge g) {
      if (HalfEdgeMesh::face(g) == f || HalfEdgeMesh::face(g) == o) return true;
      const Vec3 &to = m_mesh.position(m_mesh.to(g)), &last = m_mesh.position(m_mesh.to(HalfEdgeMesh::next(g)));
      m_star.faces.push_back(HalfEdgeMesh::face(g));
      m_star.before.push_back({m_mesh.position(m_mesh.from(g)), to, last});
      m_star.after.push_back({p, to, last});
      return true;
    });
  }
  m_star.faces.push_back(f);
  if (o != kNone) m_star.faces.push_back(o);
}

bool Decimator::meetsNothing() {
  ++m_stars;
  for (const Face f : m_star.faces) m_inStar[f] = m_stars;
  Box whole;
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < m_star.after.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (trianglesMeet(m_star.after[i], m_star.after[j])) return false;
    }
    boxes.push_back(boxOf(m_star.after[i]));
    whole.extend(boxes.back());
  }
  return m_octree.forEachNear(whole, [&](Face other) {
    if (m_inStar[other] == m_stars) return true;
    const TrianglePoints points = m_mesh.points(other);
    const Box box = boxOf(points);
    if (!box.intersects(whole)) return true;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (box.intersects(boxes[i]) && trianglesMeet(m_star.after[i], points) && !isDegenerate(points)) return false;
    }
    return true;
  });
}

bool Decimator::isStarAllowed() {
  if (!keepsShape(m_star.before, m_star.after)) return false;
  if (m_options.avoidIntersections && !meetsNothing()) return false;
  return !m_error || m_error->allows(m_star.faces, m_star.after);
}

bool Decimator::isAllowed(HalfEdge h, const Vec3& p) {
  if (m_holds.mergesCreases(m_mesh, h) || !canCollapse(m_mesh, h)) return false;
  takeStar(h, p);
  return isStarAllowed();
}

void Decimator::removeFromOctree(std::span<const Face> faces) {
  if (!m_options.avoidIntersections) return;
  for (const Face f : faces) m_octree.remove(f, boxOf(m_mesh.points(f)));
}

void Decimator::addToOctree(std::span<const Face> faces) {
  if (!m_options.avoidIntersections) return;
  for (const Face f : faces) m_octree.add(f, boxOf(m_mesh.points(f)));
}

void Decimator::collapse(HalfEdge h, const Vec3& p) {
  const Vertex a = m_mesh.from(h);
  const bool isInner = m_mesh.hasOpposite(h);
  m_holds.beforeCollapse(m_mesh, h);
  removeFromOctree(m_star.faces);
  const HalfEdge leaving = collapseEdge(m_mesh, h, p);
  const std::span<const Face> stay = std::span<const Face>(m_star.faces).first(m_star.after.size());
  addToOctree(stay);
  if (m_error) m_error->replace(m_star.faces, stay);
  m_faces -= isInner ? 2 : 1;
  ++m_stamp[a];
  forEachInFan(m_mesh, leaving, [&](HalfEdge g) {
    offer(g);
    const HalfEdge back = HalfEdgeMesh::previous(g);
    if (!m_mesh.hasOpposite(back)) offer(back);
    return true;
  });
}

std::optional<Box> Decimator::insert(Face f, const Vec3& on, const Vec3& position) {
  const TrianglePoints t = m_mesh.points(f);
  HalfEdge h = kNone;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t k = 0; k < 3; ++k) {
    const double distance = (closestOnSegment(on, t[k], t[(k + 1) % 3]) - on).squaredNorm();
    if (distance >= least) continue;
    least = distance;
    h = 3 * f + k;
  }
  if (h == kNone || !m_mesh.hasOpposite(h)) return std::nullopt;
  const HalfEdge o = m_mesh.opposite(h);
  const Face g = HalfEdgeMesh::face(o);
  const auto end = [&](HalfEdge of) { return m_mesh.position(m_mesh.to(of)); };
  const Vec3 a = end(o), b = end(h), c = end(HalfEdgeMesh::next(h)), d = end(HalfEdgeMesh::next(o));
  m_star = {{f, g}, {t, t, m_mesh.points(g), m_mesh.points(g)}, {}};
  m_star.after = {{position, c, a}, {position, b, c}, {position, d, b}, {position, a, d}};
  if (!isStarAllowed()) return std::nullopt;
  Box changed;
  for (const TrianglePoints& each : {t, m_mesh.points(g)}) changed.extend(boxOf(each));
  changed.extend(position);
  removeFromOctree(m_star.faces);
  (void)splitEdge(m_mesh, h, position);
  const auto last = static_cast<Face>(m_mesh.faceSlots() - 1);
  const std::array<Face, 4> made{f, last - 1, g, last};
  m_inStar.resize(m_mesh.faceSlots(), 0);
  addToOctree(made);
  if (m_error) m_error->replace(m_star.faces, made);
  return changed;
}

bool Decimator::drain(const Progress& progress) {
  const double toGo = static_cast<double>(m_faces - std::min(m_faces, m_options.faces)), start = double(m_faces);
  double reported = 0.0;
  // Largest size of the queue: with an error limit, most of the time goes into refused collapses.
  std::size_t longest = 1;
  for (std::size_t i = 0; !m_queue.empty() && m_faces > m_options.faces; ++i) {
    if (progress.cancelled()) return false;  // polled each time, because one check may take milliseconds
    if (i % kEdgesPerReport == 0) {
      longest = std::max(longest, m_queue.size());
      const double gone = (start - static_cast<double>(m_faces)) / toGo;
      const double looked = 1.0 - static_cast<double>(m_queue.size()) / static_cast<double>(longest);
      reported = std::max({reported, gone, looked});
      progress.set(reported);
    }
    const Candidate c = m_queue.top();
    m_queue.pop();
    if (!m_mesh.isLive(HalfEdgeMesh::face(c.edge))) continue;
    if (m_stamp[m_mesh.from(c.edge)] != c.fromStamp || m_stamp[m_mesh.to(c.edge)] != c.toStamp) continue;
    // If the faces around its ends have changed since, the edge is queued again.
    const auto placing = collapsePlacement(m_mesh, m_holds, c.edge);
    if (placing && rankOf(placing->cost) > c.rank) {
      m_queue.push({rankOf(placing->cost), c.edge, c.fromStamp, c.toStamp});
    } else if (placing && isAllowed(c.edge, placing->position)) {
      collapse(c.edge, placing->position);
    }
  }
  return true;
}

bool Decimator::run(const Progress& progress) {
  if (!prepare(progress.part(0.0, 0.05))) return false;
  // Refused edges are tried again after their surroundings have changed, as long as that succeeds.
  double from = 0.05;
  std::size_t before = 0;
  do {
    before = m_faces;
    const Progress round = progress.part(from, 0.5 * (from + 1.0));
    from = 0.5 * (from + 1.0);
    m_queue = {};
    if (!seed(round.part(0.0, 0.3)) || !drain(round.part(0.3, 1.0))) return false;
  } while (m_faces > m_options.faces && before - m_faces > before / 100);
  return true;
}

}  // namespace handwheel
