// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "collision/PairTraversal.h"

#include <fcl/narrowphase/detail/primitive_shape_algorithm/triangle_distance.h>
#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

// mm⁴: below this, FCL's distance of triangles takes one for a line.
constexpr double kSmallestTriangle = 1e-12;

double squaredArea(const std::array<const Vec3*, 3>& t) {
  return (*t[1] - *t[0]).cross(*t[2] - *t[0]).squaredNorm();
}

}  // namespace

PairTraversal::PairTraversal(const PieceTree& a, const PieceTree& b, const Pose& pose, QueryCounts& counts)
    : m_a(a),
      m_b(b),
      m_pose(pose),
      m_turn(pose.linear()),
      m_shift(pose.translation()),
      m_counts(counts),
      m_margin(a.margin() + b.margin()) {}

bool PairTraversal::isValid(const Leaves& leaves) const {
  return leaves.first < m_a.leafCount() && leaves.second < m_b.leafCount();
}

// Returns a lower bound of a distance. Bounding spheres reject most distant pairs, and boxes along their axes most of
// the rest; the distance of swept rectangles, the tightest bound, takes several times as long as both.
double PairTraversal::boundOf(int a, int b) {
  ++m_counts.volumes;
  const fcl::OBBRSSd &first = m_a.bound(a), &second = m_b.bound(b);
  const Vec3 between = m_turn.lazyProduct(second.obb.To) + m_shift - first.obb.To;
  const double apart = m_least + m_a.radius(a) + m_b.radius(b);
  if (between.squaredNorm() > apart * apart) return m_least;
  const Eigen::Matrix3d turn = first.obb.axis.transpose().lazyProduct(m_turn.lazyProduct(second.obb.axis).eval());
  const Vec3 toSecond = first.obb.axis.transpose().lazyProduct(between);
  const Eigen::Matrix3d size = turn.cwiseAbs();
  const Vec3 beyondFirst = toSecond.cwiseAbs() - first.obb.extent - size.lazyProduct(second.obb.extent);
  const Vec3 beyondSecond = turn.transpose().lazyProduct(toSecond).cwiseAbs() - second.obb.extent -
                            size.transpose().lazyProduct(first.obb.extent);
  const double square = std::max(beyondFirst.cwiseMax(0.0).squaredNorm(), beyondSecond.cwiseMax(0.0).squaredNorm());
  if (square > m_least * m_least) return m_least;  // the square of a very small limit is 0
  return fcl::distance(m_turn, m_shift, first.rss, second.rss);
}

bool PairTraversal::isSplitFirst(int a, int b) const {
  return m_b.isLeaf(b) || (!m_a.isLeaf(a) && m_a.radius(a) > m_b.radius(b));
}

void PairTraversal::descend(int a, int b, double bound) {
  if (bound >= m_least - (m_found ? m_tolerance : 0.0) || m_least <= m_stop) return;
  if (m_a.isLeaf(a) && m_b.isLeaf(b)) return look(m_a.leafOf(a), m_b.leafOf(b));
  const bool isFirst = isSplitFirst(a, b);
  const int a1 = isFirst ? m_a.left(a) : a, a2 = isFirst ? m_a.right(a) : a;
  const int b1 = isFirst ? b : m_b.left(b), b2 = isFirst ? b : m_b.right(b);
  const double one = boundOf(a1, b1), other = boundOf(a2, b2);
  if (one <= other) {
    descend(a1, b1, one);
    descend(a2, b2, other);
  } else {
    descend(a2, b2, other);
    descend(a1, b1, one);
  }
}

void PairTraversal::look(std::uint32_t a, std::uint32_t b) {
  ++m_counts.pairs;
  ConvexNearest nearest;
  if (m_a.isMesh() && m_b.isMesh()) {
    const auto s = m_a.corners(a), t = m_b.corners(b);
    if (squaredArea(s) > kSmallestTriangle && squaredArea(t) > kSmallestTriangle) {
      nearest.distance = fcl::detail::TriangleDistanced::triDistance(*s[0], *s[1], *s[2], *t[0], *t[1], *t[2], m_turn,
                                                                     m_shift, nearest.first, nearest.second);
    } else {
      nearest = nearestOf(m_a.shape(a, Pose::Identity()), m_b.shape(b, m_pose), m_least);
    }
  } else {
    nearest = nearestOf(m_a.shape(a, Pose::Identity()), m_b.shape(b, m_pose), m_least);
  }
  if (!(nearest.distance < m_least)) return;
  m_least = nearest.distance;
  m_found = {nearest.distance - m_margin, !(nearest.distance > 0.0), {a, b}, nearest.first, nearest.second};
}

std::optional<PairTraversal::Nearest> PairTraversal::nearest(double enough, const Leaves& hint, double stop,
                                                             double tolerance) {
  m_least = enough + m_margin;
  m_stop = std::max(0.0, std::nextafter(stop + m_margin, 0.0));  // converted to a distance of the shapes, inclusive
  m_tolerance = tolerance;
  m_found.reset();
  if (!(m_least > 0.0)) return std::nullopt;
  const double bound = boundOf(0, 0);
  if (bound >= m_least) return std::nullopt;
  if (isValid(hint)) look(hint.first, hint.second);
  descend(0, 0, bound);
  return m_found;
}

// For pieces that meet box tests tell as much as distances, and are faster.
bool PairTraversal::mayBeWithin(int a, int b) {
  if (m_reach > 0.0) {
    m_least = m_reach;
    return boundOf(a, b) < m_reach;
  }
  ++m_counts.volumes;
  return fcl::overlap(m_turn, m_shift, m_a.bound(a).obb, m_b.bound(b).obb);
}

void PairTraversal::collect(int a, int b) {
  if (m_within.size() >= m_most || !mayBeWithin(a, b)) return;
  if (m_a.isLeaf(a) && m_b.isLeaf(b)) {
    // Each pair by itself: the distance of earlier pairs is no bound for it.
    m_least = m_reach > 0.0 ? m_reach : std::numeric_limits<double>::infinity();
    m_found.reset();
    look(m_a.leafOf(a), m_b.leafOf(b));
    if (m_found && (m_reach > 0.0 || m_found->isMeeting)) m_within.push_back(*m_found);
    return;
  }
  const bool isFirst = isSplitFirst(a, b);
  collect(isFirst ? m_a.left(a) : a, isFirst ? b : m_b.left(b));
  collect(isFirst ? m_a.right(a) : a, isFirst ? b : m_b.right(b));
}

void PairTraversal::collectAll(double reach, std::size_t most) {
  m_within.clear();
  m_reach = reach;
  m_most = most;
  collect(0, 0);
}

std::vector<PairTraversal::Leaves> PairTraversal::meeting(std::size_t most, const Leaves& hint) {
  m_least = std::numeric_limits<double>::infinity();
  m_found.reset();
  if (most == 1 && isValid(hint) && fcl::overlap(m_turn, m_shift, m_a.bound(0).obb, m_b.bound(0).obb)) {
    look(hint.first, hint.second);
    if (m_found && m_found->isMeeting) return {hint};
  }
  collectAll(0.0, most);
  std::vector<Leaves> leaves;
  leaves.reserve(m_within.size());
  for (const Nearest& each : m_within) leaves.push_back(each.leaves);
  return leaves;
}

const std::vector<PairTraversal::Nearest>& PairTraversal::within(double enough, std::size_t most) {
  // Shapes that touch are listed, too: with a margin around them, these are the shapes that are no further apart than
  // it.
  const double least = std::nextafter(m_margin, std::numeric_limits<double>::infinity());
  collectAll(enough > 0.0 ? std::max(enough + m_margin, least) : m_margin > 0.0 ? least : 0.0, most);
  return m_within;
}

bool PairTraversal::mayMeet() {
  m_least = std::numeric_limits<double>::infinity();
  return !(boundOf(0, 0) > 0.0);
}

}  // namespace handwheel
