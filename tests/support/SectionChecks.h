// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/section/TurnedSection.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

// A validator of the boundary loops of turned sections.
namespace handwheel::test {

inline constexpr double kLoopGap = 5e-8;      // mm, between a segment and the next one
inline constexpr double kCarrierGap = 1e-7;   // mm, between a carrier and the ends of its segment
inline constexpr double kCrossing = 5e-7;     // mm; segments that cross nearer to an end than this only touch
inline constexpr double kBelowAxis = -1e-9;   // mm, the least radius of an end
inline constexpr double kArcBelow = -5e-8;    // mm, the least radius of an arc that touches the axis
inline constexpr double kLeastPiece = 1e-10;  // mm², the least area of a loop

inline std::string textOf(const SectionSegment& s) {
  char text[200];
  std::snprintf(text, sizeof text, "(%.9f, %.9f) to (%.9f, %.9f), radius %.9f", s.from.x(), s.from.y(), s.to.x(),
                s.to.y(), s.carrier.radius);
  return text;
}

// Returns true if two segments cross, both well inside of their ends.
inline bool isCrossing(const SectionSegment& a, const SectionSegment& b) {
  const auto isWithin = [](const SectionSegment& s, const ProfilePoint& p) {
    return (p - s.from).norm() > kCrossing && (p - s.to).norm() > kCrossing && s.isOn(p, 1e-9);
  };
  const CarrierMeetings found = meetings(a.carrier, b.carrier, 0.0);
  for (std::size_t i = 0; i < found.count; ++i) {
    const ProfilePoint& p = found.points[i];
    if (!isWithin(a, p) || !isWithin(b, p)) continue;
    const ProfilePoint u = a.carrier.direction(p), v = b.carrier.direction(p);
    constexpr double kTouching = 1e-3;  // sine of the least angle of a crossing
    if (std::abs(u.x() * v.y() - u.y() * v.x()) > kTouching) return true;
  }
  return false;
}

// Returns the first fault of boundary loops, or an empty text if they are sound: each segment begins where the one
// before ends, its carrier passes through both ends, no two segments cross, nothing lies below the axis, and each
// segment that is not beside another has the material on its left and none on its right. O(segments²).
inline std::string faultOf(const TurnedSection& section) {
  std::vector<SectionLoop> loops;
  for (const SharedLoop& loop : section.loops()) loops.push_back(loop.segments());
  std::vector<const SectionSegment*> all;
  for (const SectionLoop& loop : loops) {
    if (loop.size() < 2) return "a loop of one segment";
    if (std::abs(areaOf(loop)) < kLeastPiece) return "a loop without area";
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const SectionSegment &s = loop[i], &next = loop[(i + 1) % loop.size()];
      if (!s.from.allFinite() || !s.to.allFinite()) return "not finite: " + textOf(s);
      if ((s.to - next.from).norm() > kLoopGap) return "a gap after " + textOf(s);
      if (s.carrier.distance(s.from) > kCarrierGap || s.carrier.distance(s.to) > kCarrierGap)
        return "ends beside the carrier: " + textOf(s);
      if (s.from.x() < kBelowAxis || s.box().min().x() < kArcBelow) return "below the axis: " + textOf(s);
      all.push_back(&s);
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t k = i + 1; k < all.size(); ++k)
      if (isCrossing(*all[i], *all[k])) return "crossing: " + textOf(*all[i]) + " and " + textOf(*all[k]);
  for (const SectionSegment* s : all) {
    constexpr double kBeside = 1e-6, kNear = 4e-6;  // mm
    if (s->length() < 4.0 * kNear) continue;
    const ProfilePoint middle = s->at(0.5 * s->length()), along = s->carrier.direction(middle);
    const bool isFree = std::all_of(all.begin(), all.end(), [&](const SectionSegment* other) {
      return other == s || (other->nearest(middle) - middle).norm() > kNear;
    });
    if (!isFree) continue;
    const ProfilePoint left(-along.y(), along.x());
    if (!section.contains(middle + kBeside * left)) return "no material on the left of " + textOf(*s);
    if (section.contains(middle - kBeside * left)) return "material on the right of " + textOf(*s);
  }
  return {};
}

}  // namespace handwheel::test
