// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "proximity/TriangleIntersection.h"

#include "proximity/ExactOrientation.h"

#include <algorithm>

namespace handwheel {
namespace {

// A coordinate plane onto which a triangle's plane maps one to one: what coincides there coincides in space.
class Projection {
 public:
  explicit Projection(const TrianglePoints& t) {
    (t[1] - t[0]).cross(t[2] - t[0]).cwiseAbs().maxCoeff(&m_dropped);
    m_turn = turn(t[0], t[1], t[2]);
    // The rounded normal of a needle may mislead; of a triangle with area, one of the three has some too.
    for (int tries = 0; tries < 2 && m_turn == 0; ++tries) {
      m_dropped = (m_dropped + 1) % 3;
      m_turn = turn(t[0], t[1], t[2]);
    }
  }

  // Returns 1 if p, q, r turn left in the projection, -1 if they turn right, 0 on a line.
  int turn(const Vec3& p, const Vec3& q, const Vec3& r) const { return sideOfLine(flat(p), flat(q), flat(r)); }
  // Returns the turn of the triangle itself.
  int turn() const { return m_turn; }

 private:
  Vec2 flat(const Vec3& p) const { return {p[(m_dropped + 1) % 3], p[(m_dropped + 2) % 3]}; }

  int m_dropped = 0;
  int m_turn = 0;
};

bool sameSide(int a, int b, int c) {
  return a != 0 && a == b && b == c;
}

// Two triangles in one plane are apart exactly when the line along an edge of one of them has the other strictly on its
// outer side.
bool meetInPlane(const TrianglePoints& a, const TrianglePoints& b) {
  const Projection flat(a);
  const auto anEdgeParts = [&](const TrianglePoints& t, const TrianglePoints& other) {
    const int outside = -flat.turn(t[0], t[1], t[2]);
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 &from = t[i], &to = t[(i + 1) % 3];
      if (std::all_of(other.begin(), other.end(), [&](const Vec3& p) { return flat.turn(from, to, p) == outside; }))
        return true;
    }
    return false;
  };
  return !anEdgeParts(a, b) && !anEdgeParts(b, a);
}

// The same for triangles with a common first corner: do their angles there overlap?
bool meetInPlaneBesideCorner(const TrianglePoints& a, const TrianglePoints& b) {
  const Projection flat(a);
  const auto isInAngle = [&](const Vec3& p, const TrianglePoints& t, int turn) {
    return flat.turn(t[0], t[1], p) != -turn && flat.turn(t[0], p, t[2]) != -turn;
  };
  return isInAngle(b[1], a, flat.turn()) || isInAngle(b[2], a, flat.turn()) ||
         isInAngle(a[1], b, flat.turn(b[0], b[1], b[2]));
}

bool boxesApart(const TrianglePoints& a, const TrianglePoints& b) {
  for (int k = 0; k < 3; ++k) {
    const auto [lowA, highA] = std::minmax({a[0][k], a[1][k], a[2][k]});
    const auto [lowB, highB] = std::minmax({b[0][k], b[1][k], b[2][k]});
    if (highA < lowB || highB < lowA) return true;
  }
  return false;
}

TrianglePoints startingAt(const TrianglePoints& t, std::size_t corner) {
  return {t[corner], t[(corner + 1) % 3], t[(corner + 2) % 3]};
}

// A triangle that crosses or touches another one's plane, turned so that its first corner is on the one side of it and
// the others are not: the edges from the first corner lead to the plane and on or up to it, never along it.
struct Crossing {
  TrianglePoints corners;
  int firstSide = 0;

  Crossing(const TrianglePoints& t, const std::array<int, 3>& sides) {
    for (std::size_t i = 0; i < 3; ++i) {
      const int next = sides[(i + 1) % 3], last = sides[(i + 2) % 3];
      const int side = sides[i] != 0 ? sides[i] : -next;
      if (side * next > 0 || side * last > 0 || (sides[i] == 0 && (next == 0 || last == 0))) continue;
      corners = startingAt(t, i);
      firstSide = side;
      return;
    }
  }

  void reverse() { std::swap(corners[1], corners[2]); }
};

std::array<int, 3> sidesOf(const TrianglePoints& t, const TrianglePoints& of) {
  const ExactPlane plane(t[0], t[1], t[2]);
  return {plane.side(of[0]), plane.side(of[1]), plane.side(of[2])};
}

// No corner is shared. Guigue and Devillers, "Fast and robust triangle-triangle overlap test using orientation
// predicates" (2003): the line in which the planes meet cuts an interval out of each triangle; two signs tell whether
// these overlap.
bool meetApart(const TrianglePoints& a, const TrianglePoints& b) {
  if (boxesApart(a, b)) return false;
  const auto sidesB = sidesOf(a, b);
  if (sameSide(sidesB[0], sidesB[1], sidesB[2])) return false;
  if (sidesB == std::array<int, 3>{0, 0, 0}) return meetInPlane(a, b);
  const auto sidesA = sidesOf(b, a);
  if (sameSide(sidesA[0], sidesA[1], sidesA[2])) return false;
  Crossing p(a, sidesA), q(b, sidesB);
  if (p.firstSide < 0) q.reverse();
  if (q.firstSide < 0) p.reverse();
  // Now each first corner sees the other triangle counter-clockwise.
  return ExactPlane(p.corners[0], p.corners[1], q.corners[0]).side(q.corners[1]) <= 0 &&
         ExactPlane(p.corners[0], p.corners[2], q.corners[0]).side(q.corners[2]) >= 0;
}

// The corners a[0] and b[0] are shared.
bool meetBesideCorner(const TrianglePoints& a, const TrianglePoints& b) {
  const ExactPlane planeA(a[0], a[1], a[2]);
  const int first = planeA.side(b[1]), second = planeA.side(b[2]);
  if (first * second > 0) return false;
  if (first == 0 && second == 0) return meetInPlaneBesideCorner(a, b);
  // b leaves the common corner within a's plane, in the direction in which that plane cuts the edge opposite to the
  // corner. The planes and lines through that edge and the corners of a tell whether this direction lies in a's angle.
  const ExactPlane planeB(b[0], b[1], b[2]);
  const int downwards = first != 0 ? first : -second;
  return planeB.side(a[1]) * downwards <= 0 && planeB.side(a[2]) * downwards >= 0;
}

// The triangles share the edge pq: they meet beside it only when the one lies flat on the other.
bool foldedFlat(const Vec3& p, const Vec3& q, const Vec3& apexA, const Vec3& apexB) {
  if (ExactPlane(p, q, apexA).side(apexB) != 0) return false;
  const Projection flat({p, q, apexA});
  return flat.turn() == flat.turn(p, q, apexB);
}

}  // namespace

bool trianglesMeet(const TrianglePoints& a, const TrianglePoints& b) {
  std::array<std::size_t, 3> inA{}, inB{};
  std::size_t shared = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (a[i] == b[j]) {
        inA[shared] = i;
        inB[shared++] = j;
        break;
      }
  if (shared == 0) return meetApart(a, b);
  if (shared == 1) return meetBesideCorner(startingAt(a, inA[0]), startingAt(b, inB[0]));
  if (shared == 2) return foldedFlat(a[inA[0]], a[inA[1]], a[3 - inA[0] - inA[1]], b[3 - inB[0] - inB[1]]);
  return true;
}

bool isDegenerate(const TrianglePoints& t) {
  return Projection(t).turn() == 0;
}

}  // namespace handwheel
