// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "proximity/ClosestPoint.h"

#include <algorithm>

namespace handwheel {

Vec3 closestOnSegment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double length2 = along.squaredNorm();
  if (!(length2 > 0.0)) return a;
  const double t = (p - a).dot(along) / length2;
  // From the nearer end, so that an end is hit exactly.
  if (t <= 0.0) return a;
  if (t >= 1.0) return b;
  return t < 0.5 ? Vec3(a + t * along) : Vec3(b - (1.0 - t) * along);
}

Vec3 closestOnTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  Vec3 best = closestOnSegment(p, a, b);
  double bestDistance = (best - p).squaredNorm();
  const auto offer = [&](const Vec3& q) {
    const double distance = (q - p).squaredNorm();
    if (distance < bestDistance) {
      best = q;
      bestDistance = distance;
    }
  };
  offer(closestOnSegment(p, b, c));
  offer(closestOnSegment(p, c, a));

  // Barycentric weights of p's foot on the plane. Used only as a convex combination: in a needle they may be noise, but
  // what comes out lies on the triangle, and the edges have been offered already.
  const Vec3 normal = (b - a).cross(c - a);
  const double wa = normal.dot((c - b).cross(p - b));
  const double wb = normal.dot((a - c).cross(p - c));
  const double wc = normal.dot((b - a).cross(p - a));
  if (const double sum = wa + wb + wc; wa > 0.0 && wb > 0.0 && wc > 0.0 && sum > 0.0)
    offer(a + (wb / sum) * (b - a) + (wc / sum) * (c - a));
  return best;
}

}  // namespace handwheel
