// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/OutlineChecks.h"

#include "base/NumberText.h"
#include "machining/target/TargetErrors.h"
#include "machining/target/TargetProfile.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace handwheel {

namespace {

using Segments = std::vector<ProfileSegment>;

constexpr double kJoin = TargetProfile::kJoin;

Error errorAt(const ErrorDescription& code, const ProfilePoint& p) {
  return {code, {shownText(p.x()), shownText(p.y())}, {}, {}};
}

Error errorAtHeight(const ErrorDescription& code, double z) {
  return {code, {shownText(z)}, {}, {}};
}

bool isOnAxis(const ProfilePoint& p) {
  return p.x() == 0.0;
}

Status checkNumbers(const Segments& segments) {
  if (segments.size() > TargetProfile::kMostSegments) {
    return Error{ErrorCode::FileTooLarge,
                 {"segments", std::to_string(segments.size()), std::to_string(TargetProfile::kMostSegments)},
                 {},
                 {}};
  }
  const double most = TargetProfile::kLargestCoordinate;
  for (const ProfileSegment& s : segments) {
    for (const double value : {s.from.x(), s.from.y(), s.to.x(), s.to.y(), s.bulge}) {
      if (!(std::abs(value) <= most))
        return Error{ErrorCode::ValueOutOfRange,
                     {"coordinate", shortestText(value), shortestText(-most), shortestText(most)},
                     {},
                     {}};
    }
  }
  return Done{};
}

// Removes segments without length; ends that are on the axis to rounding become exact, and neighbours share their ends.
Status join(Segments& segments) {
  for (ProfileSegment& s : segments) {
    for (ProfilePoint* p : {&s.from, &s.to})
      if (std::abs(p->x()) <= kJoin) p->x() = 0.0;
  }
  std::erase_if(segments, [](const ProfileSegment& s) { return (s.to - s.from).norm() <= kJoin; });
  for (std::size_t i = 0; i + 1 < segments.size(); ++i) {
    ProfilePoint& end = segments[i].to;
    const double gap = (segments[i + 1].from - end).norm();
    if (gap > kJoin)
      return Error{TargetError::NotJoined, {shownText(gap), shownText(end.x()), shownText(end.y())}, {}, {}};
    segments[i + 1].from = end;
  }
  if (!segments.empty() && (segments.back().to - segments.front().from).norm() <= kJoin)
    segments.back().to = segments.front().from;
  return Done{};
}

Status checkSides(const Segments& segments) {
  for (const ProfileSegment& s : segments) {
    const ProfileBox box = s.box();
    if (box.min().x() < -kJoin) return errorAtHeight(TargetError::CrossesAxis, 0.5 * (box.min().y() + box.max().y()));
  }
  return Done{};
}

// Removes the pieces on the axis, and begins behind them.
void openAtAxis(Segments& segments) {
  const auto isAlongAxis = [](const ProfileSegment& s) { return isOnAxis(s.from) && isOnAxis(s.to) && !s.isArc(); };
  const bool isRing = !segments.empty() && segments.front().from == segments.back().to;
  if (isRing) {
    // A ring that touches the axis begins there.
    const auto along = std::find_if(segments.begin(), segments.end(), isAlongAxis);
    const auto start = along != segments.end() ? along + 1
                                               : std::find_if(segments.begin(), segments.end(),
                                                              [](const ProfileSegment& s) { return isOnAxis(s.from); });
    if (start != segments.end()) std::rotate(segments.begin(), start, segments.end());
  }
  while (!segments.empty() && isAlongAxis(segments.back())) segments.pop_back();
  while (!segments.empty() && isAlongAxis(segments.front())) segments.erase(segments.begin());
}

// Joins ends off the axis to it, or to each other.
void closeEnds(Segments& segments) {
  const ProfilePoint first = segments.front().from, last = segments.back().to;
  if (first == last) return;
  if (!isOnAxis(first) && !isOnAxis(last) && std::abs(first.y() - last.y()) <= kJoin) {
    segments.push_back({last, first, 0.0});
    return;
  }
  if (!isOnAxis(first)) segments.insert(segments.begin(), {ProfilePoint(0.0, first.y()), first, 0.0});
  if (!isOnAxis(last)) segments.push_back({last, ProfilePoint(0.0, last.y()), 0.0});
}

Status checkAxis(const Segments& segments) {
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const ProfileSegment& s = segments[i];
    if (i > 0 && isOnAxis(s.from)) return errorAtHeight(TargetError::TouchesAxis, s.from.y());
    // An arc may dip to the axis between its ends.
    const bool hasEndThere = isOnAxis(s.from) || isOnAxis(s.to);
    if (!hasEndThere && s.box().min().x() <= kJoin)
      return errorAtHeight(TargetError::TouchesAxis, 0.5 * (s.box().min().y() + s.box().max().y()));
    if (hasEndThere && s.box().min().x() < -kJoin) return errorAtHeight(TargetError::CrossesAxis, s.from.y());
  }
  return Done{};
}

// Returns twice the area that segments and axis enclose; above zero if it is on the left.
double signedArea(const Segments& segments) {
  double sum = 0.0;
  for (const ProfileSegment& s : segments) {
    sum += s.from.x() * s.to.y() - s.from.y() * s.to.x();
    if (!s.isArc()) continue;
    const double chord = (s.to - s.from).squaredNorm(), angle = s.angle(), r = s.radius();
    // Area of the circular segment: r² (angle - sin angle); by the chord if that would cancel.
    sum += std::abs(angle) < 1e-3 ? chord * angle / 6.0 : r * r * (angle - std::sin(angle));
  }
  const ProfilePoint a = segments.back().to, b = segments.front().from;
  return sum + a.x() * b.y() - a.y() * b.x();
}

void turnLeft(Segments& segments, bool isClockwise) {
  if (!isClockwise) return;
  std::reverse(segments.begin(), segments.end());
  for (ProfileSegment& s : segments) s = s.reversed();
}

// Returns a point at which it crosses itself. Errors: TooIntricate, Cancelled.
Result<std::optional<ProfilePoint>> ownCrossing(const Segments& segments, bool isClosed, Progress progress) {
  constexpr std::size_t kPairsPerPoll = 4096;
  constexpr std::size_t kPairsOfEach = 100,
                        kLeastPairs = 1'000'000;  // pairs of intersecting boxes; takes a second or two
  const std::size_t most = std::max(kLeastPairs, kPairsOfEach * segments.size());
  std::size_t pairs = 0;
  const ProfileHierarchy tree(segments);
  const std::size_t n = segments.size();
  const ProfilePoint slack(kJoin, kJoin);
  std::optional<ProfilePoint> found;
  bool isCancelled = progress.cancelled();
  for (std::size_t i = 0; i < n && !found && pairs <= most && !isCancelled; ++i) {
    if (i % kPairsPerPoll == 0) progress.set(static_cast<double>(i) / static_cast<double>(n));
    ProfileBox box = segments[i].box();
    box = ProfileBox(box.min() - slack, box.max() + slack);
    tree.meeting(box, [&](std::size_t k) {
      if (++pairs > most || isCancelled) return false;
      if (pairs % kPairsPerPoll == 0) isCancelled = progress.cancelled();
      if (k <= i) return true;
      const bool isNext = k == i + 1, isBefore = isClosed && i == 0 && k + 1 == n;
      if (isNext && isBefore) return true;  // two arcs that form a whole ring
      found = isNext     ? meetingBeside(segments[i], segments[k], kJoin)
              : isBefore ? meetingBeside(segments[k], segments[i], kJoin)
                         : meeting(segments[i], segments[k], kJoin);
      return !found;
    });
  }
  if (isCancelled) return Error{ErrorCode::Cancelled, {}, {}, {}};
  if (!found && pairs > most) return Error{TargetError::TooIntricate, {}, {}, {}};
  return found;
}

}  // namespace

Result<CheckedOutline> checkedOutline(std::vector<ProfileSegment> segments, Progress progress) {
  if (const Status sound = checkNumbers(segments); !sound) return sound.error();
  if (const Status joined = join(segments); !joined) return joined.error();
  if (const Status onOneSide = checkSides(segments); !onOneSide) return onOneSide.error();
  openAtAxis(segments);
  if (segments.empty()) return Error{TargetError::NoArea, {}, {}, {}};
  closeEnds(segments);
  CheckedOutline outline;
  outline.isClosed = segments.front().from == segments.back().to && !isOnAxis(segments.front().from);
  if (const Status atAxis = checkAxis(segments); !atAxis) return atAxis.error();
  const double area = signedArea(segments);
  if (!(std::abs(area) > kJoin * kJoin)) return Error{TargetError::NoArea, {}, {}, {}};
  turnLeft(segments, area < 0.0);
  const auto crossing = ownCrossing(segments, outline.isClosed, progress);
  if (!crossing) return crossing.error();
  if (*crossing) return errorAt(TargetError::CrossesItself, **crossing);
  outline.segments = std::move(segments);
  return outline;
}

}  // namespace handwheel
