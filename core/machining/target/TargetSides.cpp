// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/TargetSides.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace handwheel {

namespace {

using SegmentList = std::vector<ProfileSegment>;

// Returns the segments with arcs split at their highest and lowest points, so that every extreme of z is the end of a
// segment.
SegmentList partedAtExtremes(std::span<const ProfileSegment> segments) {
  SegmentList all;
  for (const ProfileSegment& s : segments) {
    std::vector<double> cuts{0.0};
    if (s.isArc()) {
      const ProfilePoint c = s.centre(), start = s.from - c;
      for (const double side : {1.0, -1.0}) {
        const double turned = std::atan2(side * start.x(), side * start.y());  // from the start to straight up or down
        for (const double angle : {turned, turned + 2.0 * M_PI, turned - 2.0 * M_PI}) {
          const double share = angle / s.angle();
          if (share > 1e-9 && share < 1.0 - 1e-9) cuts.push_back(share);
        }
      }
      std::sort(cuts.begin(), cuts.end());
    }
    cuts.push_back(1.0);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) all.push_back(s.piece(cuts[i], cuts[i + 1]));
  }
  return all;
}

// Returns the segment that begins at the highest, or lowest, point; of several the one nearest to the axis. The end of
// an open outline comes after the last one.
std::size_t furthest(const SegmentList& all, bool isClosed, double up) {
  std::size_t best = 0;
  const auto pointAt = [&](std::size_t i) -> const ProfilePoint& {
    return i < all.size() ? all[i].from : all.back().to;
  };
  for (std::size_t i = 1; i < all.size() + (isClosed ? 0 : 1); ++i) {
    const double rise = up * (pointAt(i).y() - pointAt(best).y());
    const bool isSame = std::abs(rise) <= TargetProfile::kJoin;
    if (isSame ? pointAt(i).x() < pointAt(best).x() : rise > 0.0) best = i;
  }
  return best;
}

// Returns the segments from one point of the outline to another, round the end if it is closed.
SegmentList between(const SegmentList& all, std::size_t from, std::size_t to) {
  SegmentList some;
  for (std::size_t i = from; i != to; i = i + 1 == all.size() && to < from ? 0 : i + 1) {
    if (i < all.size()) some.push_back(all[i]);
    if (i >= all.size()) break;
  }
  return some;
}

}  // namespace

Result<TargetSides> sidesOf(const TargetProfile& part) {
  const SegmentList all = partedAtExtremes(part.segments());
  const std::size_t low = furthest(all, part.isClosed(), -1.0), high = furthest(all, part.isClosed(), 1.0);
  Result<TargetProfile> outside = TargetProfile::make(between(all, low, high));
  if (!outside) return outside.error();
  TargetSides sides{std::move(outside).value(), {}};
  const double beyond = 2.0 * (part.length() + part.largestRadius());
  const auto goOn = [&](const ProfilePoint& p, double up) { return ProfilePoint(p.x(), p.y() + up * beyond); };
  const auto addBore = [&](SegmentList wall) -> Status {
    const bool isWall = std::any_of(wall.begin(), wall.end(),
                                    [](const ProfileSegment& s) { return std::max(s.from.x(), s.to.x()) > 0.0; });
    if (!isWall) return Done{};
    const ProfilePoint first = wall.front().from, last = wall.back().to;
    if (first.x() > 0.0) wall.insert(wall.begin(), {goOn(first, 1.0), first, 0.0});
    if (last.x() > 0.0) wall.push_back({last, goOn(last, -1.0), 0.0});
    Result<TargetProfile> bore = TargetProfile::make(std::move(wall));
    if (!bore) return bore.error();
    sides.bores.push_back(std::move(bore).value());
    return Done{};
  };
  // Down the bore: through the part, or from the highest point to the axis and from the axis to the lowest one.
  std::vector<SegmentList> walls{between(all, high, part.isClosed() ? low : all.size())};
  if (!part.isClosed()) walls.push_back(between(all, 0, low));
  for (SegmentList& wall : walls) {
    if (wall.empty()) continue;
    const Status added = addBore(std::move(wall));
    if (!added) return added.error();
  }
  return sides;
}

}  // namespace handwheel
