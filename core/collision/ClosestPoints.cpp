// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "collision/ClosestPoints.h"

#include "collision/PairTraversal.h"
#include "collision/Penetration.h"

#include <algorithm>

namespace handwheel {

namespace {

constexpr std::size_t kMostMeeting = 64;  // leaves that are separated
constexpr double kTouching = 1e-9;        // mm: includes shapes that touch in a search for those that meet

// Returns the closest points with both pieces exchanged.
ClosestPoints exchanged(const ClosestPoints& points) {
  return {points.distance, points.second, points.first, -points.normal};
}

// Returns the closest points of a sphere and a solid, by a formula.
ClosestPoints ballToSolid(const CollisionPiece& ball, const Vec3& centre, const CollisionPiece& solid,
                          const Pose& pose) {
  const SolidNearest nearest = nearestOfSolid(solid.kind, solid.half, pose.inverse(Eigen::Isometry) * centre);
  const Vec3 normal = pose.linear() * nearest.normal;
  const double radius = ball.half.x();
  return {nearest.distance - radius, centre - radius * normal, pose * nearest.point, normal};
}

// Returns none if there is no formula for the two pieces.
std::optional<ClosestPoints> byFormula(const CollisionPiece& a, const Pose& poseA, const CollisionPiece& b,
                                       const Pose& poseB) {
  using enum CollisionPiece::Kind;
  if (a.kind == Ball && b.kind != Mesh) return ballToSolid(a, poseA.translation(), b, poseB);
  if (b.kind == Ball && a.kind != Mesh) return exchanged(ballToSolid(b, poseB.translation(), a, poseA));
  return std::nullopt;
}

bool isClosedMesh(const CollisionPiece& piece) {
  return piece.kind == CollisionPiece::Kind::Mesh && piece.mesh->isClosed();
}

// Two pieces, at least one of which is a mesh, or neither of which is a sphere.
class PiecePair {
 public:
  PiecePair(const CollisionPiece& a, const Pose& poseA, const CollisionPiece& b, const Pose& poseB, QueryCounts& counts)
      : m_first(a),
        m_second(b),
        m_pose(poseA.inverse(Eigen::Isometry) * poseB),
        m_world(poseA),
        m_a(a),
        m_b(b),
        m_walk(m_a, m_b, m_pose, counts) {}

  bool isEmpty() const { return m_a.isEmpty() || m_b.isEmpty(); }

  std::optional<ClosestPoints> closest(double enough, double tolerance, PairHint& hint) {
    // Box tests find meeting pieces much faster than distances, which are zero for very many bounds then.
    if (m_walk.mayMeet()) {
      const auto meeting = m_walk.meeting(kMostMeeting, {});
      if (!meeting.empty()) return apart(meeting, hint);
    }
    auto found = m_walk.nearest(std::max(enough, kTouching), {hint.first, hint.second},
                                -std::numeric_limits<double>::infinity(), tolerance);
    if (found && found->isMeeting) return apart({found->leaves}, hint);
    const bool isFirstWithin = isWithin(m_a, Pose::Identity(), m_second, m_pose);
    const bool isSecondWithin = !isFirstWithin && isWithin(m_b, m_pose, m_first, Pose::Identity());
    if (isFirstWithin || isSecondWithin) {
      if (!found) found = m_walk.nearest(std::numeric_limits<double>::infinity(), {});
      if (found) return outOf(*found, isFirstWithin);
    }
    if (!found) return std::nullopt;
    hint = {found->leaves.first, found->leaves.second, hint.normal};
    const ClosestPoints points = pointsOf(*found);
    if (found->distance > 0.0) hint.normal = points.normal;
    return points;
  }

  double bound(double than, double upTo, PairHint& hint) {
    const auto found = m_walk.nearest(upTo, {hint.first, hint.second}, than);
    if (found) hint = {found->leaves.first, found->leaves.second, hint.normal};
    if (found && found->distance < than) return found->distance;
    if (isAnyWithin()) return 0.0;
    return found ? found->distance : upTo;
  }

  bool isMeeting(PairHint& hint) {
    if (m_a.margin() + m_b.margin() > 0.0) return bound(kTouching, kTouching, hint) < kTouching;
    const auto found = m_walk.meeting(1, {hint.first, hint.second});
    if (!found.empty()) hint = {found.front().first, found.front().second, hint.normal};
    return !found.empty() || isAnyWithin();
  }

  void addContacts(double margin, std::size_t most, std::vector<PieceContact>& contacts) {
    for (const PairTraversal::Nearest& found : m_walk.within(margin, most)) {
      contacts.push_back({m_a.triangleOf(found.leaves.first), m_b.triangleOf(found.leaves.second),
                          found.isMeeting ? lastTouch(found.leaves) : pointsOf(found)});
    }
  }

 private:
  // Returns true if one, or a shell of it, is inside the other. A mesh has a surface only, so a piece in it may meet
  // none of its triangles.
  static bool isWithin(const PieceTree& inner, const Pose& poseInner, const CollisionPiece& outer,
                       const Pose& poseOuter) {
    if (!isClosedMesh(outer)) return false;
    const Pose toOuter = poseOuter.inverse(Eigen::Isometry) * poseInner;
    const auto isIn = [&](const Vec3& p) { return outer.mesh->contains(toOuter * p); };
    if (!inner.isMesh()) return isIn(Vec3::Zero());
    const std::span<const Vec3> points = inner.shellPoints();
    return std::any_of(points.begin(), points.end(), isIn);
  }

  bool isAnyWithin() const {
    return isWithin(m_a, Pose::Identity(), m_second, m_pose) || isWithin(m_b, m_pose, m_first, Pose::Identity());
  }

  // Returns the closest points of shapes that do not meet within the margins.
  ClosestPoints pointsOf(const PairTraversal::Nearest& found) const {
    const Vec3 normal = (found.first - found.second).stableNormalized();
    return inWorld(found.distance, found.first - m_a.margin() * normal, found.second + m_b.margin() * normal, normal);
  }

  IntersectingShapes shapesOf(const PairTraversal::Leaves& leaves) const {
    return {m_a.shape(leaves.first, Pose::Identity()), m_b.shape(leaves.second, m_pose)};
  }

  // Returns the last touch of two leaves that meet. Moved slightly beyond the penetration, they are closest where they
  // touch last; that point, unlike the deepest corner, is on both of them.
  ClosestPoints lastTouch(const PairTraversal::Leaves& leaves) const {
    const IntersectingShapes shapes = shapesOf(leaves);
    const Penetration found = minimumPenetration({shapes}, Vec3::Zero(), isClosedMesh(m_first), isClosedMesh(m_second));
    const double depth = std::max(0.0, found.depth), whole = depth + m_a.margin() + m_b.margin();
    constexpr double kShare = 0.01, kLeast = 1e-3;  // mm
    const Vec3 moved = (depth + std::max(kShare * depth, kLeast)) * found.normal;
    ConvexShape first = shapes.first;
    for (Vec3& corner : first.corners) corner += moved;
    first.pose.pretranslate(moved);
    const ConvexNearest touch = nearestOf(first, shapes.second, std::numeric_limits<double>::infinity());
    const bool isKnown = touch.distance > 0.0;  // else lost in rounding
    const Vec3 deepest = isKnown ? Vec3(touch.first - moved) : found.deepest;
    const Vec3 other = isKnown ? touch.second : Vec3(found.deepest + depth * found.normal);
    return inWorld(-whole, deepest - m_a.margin() * found.normal, other + m_b.margin() * found.normal, found.normal);
  }

  // Returns the separation of leaves that meet.
  ClosestPoints apart(const std::vector<PairTraversal::Leaves>& meeting, const PairHint& hint) {
    std::vector<IntersectingShapes> shapes;
    shapes.reserve(meeting.size());
    for (const PairTraversal::Leaves& leaves : meeting) shapes.push_back(shapesOf(leaves));
    const Vec3 last = m_world.linear().transpose() * hint.normal;
    const Penetration found = minimumPenetration(shapes, last, isClosedMesh(m_first), isClosedMesh(m_second));
    const double depth = std::max(0.0, found.depth) + m_a.margin() + m_b.margin();
    const Vec3 deepest = found.deepest - m_a.margin() * found.normal;
    return inWorld(-depth, deepest, deepest + depth * found.normal, found.normal);
  }

  // Moves a piece that is inside the other without meeting its surface out by the closest point, with all of it.
  ClosestPoints outOf(const PairTraversal::Nearest& found, bool isFirstWithin) const {
    Vec3 normal = (found.second - found.first).stableNormalized();
    if (normal.isZero(0.0)) normal = Vec3::UnitZ();
    if (isFirstWithin) {
      const Vec3 deepest = farthest(m_a, Pose::Identity(), -normal);
      const double depth = normal.dot(found.second - deepest);
      return inWorld(-depth, deepest, deepest + depth * normal, normal);
    }
    const Vec3 deepest = farthest(m_b, m_pose, normal);
    const double depth = normal.dot(deepest - found.first);
    return inWorld(-depth, deepest - depth * normal, deepest, normal);
  }

  static Vec3 farthest(const PieceTree& tree, const Pose& pose, const Vec3& direction) {
    if (!tree.isMesh()) return tree.shape(0, pose).support(direction) + tree.margin() * direction;
    const Vec3 own = pose.linear().transpose() * direction;
    const Vec3* best = tree.model()->vertices;
    for (int i = 1; i < tree.model()->num_vertices; ++i) {
      if (tree.model()->vertices[i].dot(own) > best->dot(own)) best = &tree.model()->vertices[i];
    }
    return pose * *best;
  }

  ClosestPoints inWorld(double distance, const Vec3& first, const Vec3& second, const Vec3& normal) const {
    return {distance, m_world * first, m_world * second, m_world.linear() * normal};
  }

  const CollisionPiece &m_first, &m_second;
  const Pose m_pose;   // pose of the second piece in the frame of the first
  const Pose m_world;  // pose of the first piece
  const PieceTree m_a, m_b;
  PairTraversal m_walk;
};

}  // namespace

std::optional<ClosestPoints> closestPoints(const CollisionPiece& a, const Pose& poseA, const CollisionPiece& b,
                                           const Pose& poseB, double enough, PairHint& hint, QueryCounts& counts,
                                           double tolerance) {
  ++counts.exact;
  std::optional<ClosestPoints> found = byFormula(a, poseA, b, poseB);
  if (found) {
    ++counts.pairs;
  } else {
    PiecePair pair(a, poseA, b, poseB, counts);
    if (!pair.isEmpty()) found = pair.closest(enough, tolerance, hint);
  }
  return found && found->distance < enough ? found : std::nullopt;
}

double distanceBound(const CollisionPiece& a, const Pose& poseA, const CollisionPiece& b, const Pose& poseB,
                     double than, double upTo, PairHint& hint, QueryCounts& counts) {
  ++counts.exact;
  if (const auto found = byFormula(a, poseA, b, poseB)) {
    ++counts.pairs;
    return found->distance;
  }
  PiecePair pair(a, poseA, b, poseB, counts);
  return pair.isEmpty() ? upTo : pair.bound(than, upTo, hint);
}

bool areMeeting(const CollisionPiece& a, const Pose& poseA, const CollisionPiece& b, const Pose& poseB, PairHint& hint,
                QueryCounts& counts) {
  ++counts.exact;
  if (const auto found = byFormula(a, poseA, b, poseB)) {
    ++counts.pairs;
    return found->distance <= 0.0;
  }
  PiecePair pair(a, poseA, b, poseB, counts);
  return !pair.isEmpty() && pair.isMeeting(hint);
}

void addContacts(const CollisionPiece& a, const Pose& poseA, const CollisionPiece& b, const Pose& poseB, double margin,
                 std::size_t most, std::vector<PieceContact>& contacts, QueryCounts& counts) {
  ++counts.exact;
  if (const auto found = byFormula(a, poseA, b, poseB)) {
    ++counts.pairs;
    const bool isContact = found->distance < margin || found->distance <= 0.0;
    if (isContact && most > 0) contacts.push_back({kNone, kNone, *found});
    return;
  }
  PiecePair pair(a, poseA, b, poseB, counts);
  if (!pair.isEmpty()) pair.addContacts(margin, most, contacts);
}

}  // namespace handwheel
