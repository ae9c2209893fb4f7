// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/RoundedTarget.h"

#include "base/NumberText.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace handwheel {

namespace {

double crossOf(const ProfilePoint& a, const ProfilePoint& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// Returns the intersection of the lines of two segments; nothing if they are parallel to within a thousandth of a
// radian.
std::optional<ProfilePoint> lineMeeting(const ProfileSegment& a, const ProfileSegment& b) {
  constexpr double kParallel = 1e-3;
  const ProfilePoint u = a.direction(0.0), v = b.direction(0.0);
  const double sine = crossOf(u, v);
  if (std::abs(sine) < kParallel) return std::nullopt;
  return ProfilePoint(a.from + u * (crossOf(b.from - a.from, v) / sine));
}

// A corner of an outline, and the shape of the next segment.
struct Corner {
  ProfilePoint at;
  double fillet = 0.0;  // mm, radius of the arc that rounds it; 0: sharp
  double bulge = 0.0;   // bulge of the segment to the next corner
};

// An arc between two lines that it touches is the fillet of the corner in which the lines meet: a round arc, shorter
// along the lines than those are long.
std::optional<Corner> filletedCorner(const ProfileSegment& before, const ProfileSegment& arc,
                                     const ProfileSegment& after) {
  constexpr double kTangent = 0.02;  // rad, error of fitted arcs
  if (!arc.isArc() || before.isArc() || after.isArc() || std::abs(arc.angle()) > 0.9 * M_PI) return std::nullopt;
  const auto touches = [](const ProfilePoint& a, const ProfilePoint& b) {
    return a.dot(b) > 0.0 && std::abs(crossOf(a, b)) < kTangent;
  };
  if (!touches(before.direction(1.0), arc.direction(0.0)) || !touches(arc.direction(1.0), after.direction(0.0)))
    return std::nullopt;
  const auto meeting = lineMeeting(before, after);
  if (!meeting) return std::nullopt;
  return Corner{*meeting, arc.radius(), 0.0};
}

std::vector<Corner> cornersOf(const TargetProfile& target, double largestFillet) {
  constexpr double kFitted = 1e-3;  // mm, error of fitted radii
  const auto segments = target.segments();
  const std::size_t count = segments.size();
  std::vector<Corner> corners;
  bool isAfterFillet = false;
  for (std::size_t i = 0; i < count; ++i) {
    const bool isBetween = target.isClosed() || (i > 0 && i + 1 < count);
    const auto fillet = isBetween
                            ? filletedCorner(segments[(i + count - 1) % count], segments[i], segments[(i + 1) % count])
                            : std::nullopt;
    if (fillet) {
      corners.push_back(*fillet);
      // The material is on the left: a right turn is concave.
      const bool isOfNose = largestFillet > 0.0 && fillet->fillet <= largestFillet + kFitted;
      if (segments[i].bulge < 0.0 && isOfNose) corners.back().fillet = 0.0;
    } else if (!isAfterFillet) {
      corners.push_back({segments[i].from, 0.0, segments[i].bulge});
    }
    isAfterFillet = fillet.has_value();
  }
  if (isAfterFillet && target.isClosed()) corners.erase(corners.begin());  // the line after it begins there
  if (!target.isClosed()) corners.push_back({segments.back().to, 0.0, 0.0});
  return corners;
}

double multiple(double value, double step) {
  return std::round(value / step) * step;
}

// Returns the arc that rounds a corner between two others, or nothing if there is no room, or no corner.
std::optional<ProfileSegment> filletAt(const ProfilePoint& before, const Corner& corner, const ProfilePoint& after) {
  const ProfilePoint in = (corner.at - before).normalized(), out = (after - corner.at).normalized();
  const double turn = std::atan2(crossOf(in, out), in.dot(out));
  const double reach = corner.fillet * std::tan(0.5 * std::abs(turn));
  const double room = std::min((corner.at - before).norm(), (after - corner.at).norm());
  if (!(corner.fillet > 0.0 && reach > 0.0 && reach <= room)) return std::nullopt;
  return ProfileSegment{corner.at - in * reach, corner.at + out * reach, std::tan(0.25 * turn)};
}

// Appends a segment, unless it has no length.
void append(std::vector<ProfileSegment>& outline, const ProfileSegment& segment) {
  if ((segment.to - segment.from).norm() > TargetProfile::kJoin) outline.push_back(segment);
}

std::vector<ProfileSegment> outlineOf(const std::vector<Corner>& corners, bool isClosed) {
  const std::size_t count = corners.size();
  std::vector<std::optional<ProfileSegment>> fillets(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (!isClosed && (i == 0 || i + 1 == count)) continue;
    fillets[i] = filletAt(corners[(i + count - 1) % count].at, corners[i], corners[(i + 1) % count].at);
  }
  std::vector<ProfileSegment> outline;
  for (std::size_t i = 0; i + 1 < count || (isClosed && i < count); ++i) {
    const std::size_t next = (i + 1) % count;
    if (fillets[i]) append(outline, *fillets[i]);
    append(outline, {fillets[i] ? fillets[i]->to : corners[i].at,
                     fillets[next] ? fillets[next]->from : corners[next].at, corners[i].bulge});
  }
  return outline;
}

}  // namespace

Result<TargetProfile> rounded(const TargetProfile& target, const TargetRounding& how) {
  if (!(how.step >= TargetRounding::kLeastStep && how.step <= TargetRounding::kLargestStep))
    return Error{
        ErrorCode::ValueOutOfRange,
        {"step", shownText(how.step), shownText(TargetRounding::kLeastStep), shownText(TargetRounding::kLargestStep)},
        {},
        {}};
  std::vector<Corner> corners = cornersOf(target, how.largestFillet);
  for (Corner& corner : corners) {
    corner.at = {multiple(corner.at.x(), 0.5 * how.step), multiple(corner.at.y(), how.step)};
    corner.fillet = multiple(corner.fillet, how.step);
  }
  return TargetProfile::make(outlineOf(corners, target.isClosed()));
}

double largestDistance(const TargetProfile& a, const TargetProfile& b) {
  double largest = 0.0;
  const auto measure = [&largest](const TargetProfile& from, const TargetProfile& to) {
    for (const ProfileSegment& s : from.segments()) {
      for (const double t : {0.0, 0.5}) largest = std::max(largest, std::abs(to.distance(s.at(t))));
    }
  };
  measure(a, b);
  measure(b, a);
  return largest;
}

}  // namespace handwheel
