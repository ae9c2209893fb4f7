// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/cycles/ContourCuts.h"

#include "base/NumberText.h"
#include "machining/program/NoseCompensation.h"
#include "machining/program/ProgramSetup.h"
#include "machining/program/cycles/CyclePath.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kEscape = 0.5;        // mm, away from the wall at the end of a level
constexpr double kRoughChord = 0.01;   // mm, chord tolerance of the contour at which levels end
constexpr double kBesideLevel = 0.3;   // mm above a level at which feeding begins in a pocket
constexpr double kBesideChuck = 0.01;  // mm, between the tip and the chuck
constexpr int kMostRoughLevels = 10'000;

ToolMove moveAlong(const ProfileSegment& segment) {
  ToolMove move;
  move.kind = ToolMove::Kind::Feed;
  move.from = segment.from;
  move.to = segment.to;
  if (segment.isArc()) {
    // Counter-clockwise from r towards z is clockwise from z towards r.
    move.turn = segment.bulge > 0.0 ? -1 : 1;
    move.centre = segment.centre();
  }
  return move;
}

// Returns true if a contour extends to the surface of the bar at its lower end. The part of it as thick as the bar
// there is removed from the contour.
bool isOpenBelow(CutContour& contour, double barRadius) {
  const auto isOfBar = [barRadius](const ProfilePoint& p) { return p.x() > barRadius - 1e-6; };
  while (contour.size() > 1 && isOfBar(contour.back().from) && isOfBar(contour.back().to)) contour.pop_back();
  return isOfBar(contour.back().to) && contour.back().direction(1.0).x() > 0.01;
}

// Returns the path of the centre of a nose along the outside of a contour, with the approach. At the end it continues
// straight by the tail (mm) out of the bar or down.
std::vector<ToolMove> offsetPath(const CutContour& contour, double nose, double clearance, const ProfilePoint& tail) {
  std::vector<ToolMove> path;
  const ProfilePoint first = contour.front().from, last = contour.back().to;
  const ProfilePoint start = first - (nose + clearance) * contour.front().direction(0.0);
  ProfilePoint at = start;
  NoseCompensation compensation(ProgramDialect::LinuxCnc, [&](const NoseCompensation::Step& step) {
    ToolMove move = step.modal;
    move.from = at;
    move.to = at = profilePoint(step.to);
    move.centre = profilePoint(step.centre);
    if (move.from != move.to) path.push_back(move);
  });
  compensation.begin(-1, nose, {0, 0}, planePoint(start));
  const auto add = [&](const ToolMove& move) {
    compensation.move({move, planePoint(move.to), planePoint(move.centre), {}});
  };
  add(moveAlong({start, first, 0.0}));
  for (const ProfileSegment& segment : contour) add(moveAlong(segment));
  if (!tail.isZero()) add(moveAlong({last, last + tail, 0.0}));
  compensation.end();
  // Compensation enters from the contour; here the nose is beside it from the start.
  if (!path.empty()) path.front().from = path.front().to - (nose + clearance) * contour.front().direction(0.0);
  return path;
}

// Returns the same as straight pieces, from the upper end to the lower.
std::vector<ProfilePoint> pointsOf(const std::vector<ToolMove>& path) {
  std::vector<ProfilePoint> points{path.front().from};
  for (const ToolMove& move : path) {
    const double radius = (move.from - move.centre).norm();
    const double step =
        move.turn == 0 ? 10.0 : 2.0 * std::acos(std::max(0.0, 1.0 - kRoughChord / std::max(radius, kRoughChord)));
    const int pieces =
        move.turn == 0 ? 1 : std::clamp(static_cast<int>(std::ceil(std::abs(sweepOf(move)) / step)), 1, 1000);
    for (int i = 1; i <= pieces; ++i) points.push_back(pointOn(move, static_cast<double>(i) / pieces));
  }
  return points;
}

struct Interval {
  double from, to;  // z, from > to
};

// Returns the intervals in which the contour lies below a level.
std::vector<Interval> intervalsAt(const std::vector<ProfilePoint>& contour, double level, double start) {
  std::vector<Interval> found;
  bool isOpen = contour.front().x() <= level;
  double from = start;
  for (std::size_t i = 1; i < contour.size(); ++i) {
    const ProfilePoint &a = contour[i - 1], &b = contour[i];
    if ((a.x() <= level) == (b.x() <= level)) continue;
    const double z = a.y() + (level - a.x()) / (b.x() - a.x()) * (b.y() - a.y());
    if (isOpen)
      found.push_back({from, z});
    else
      from = z;
    isOpen = !isOpen;
  }
  if (isOpen) found.push_back({from, contour.back().y()});
  return found;
}

void roughLevels(CyclePath& path, const std::vector<ProfilePoint>& contour, double barRadius, const CycleSettings& s) {
  const double above = barRadius + s.nose + s.clearance;
  const double start = s.nose + s.clearance;
  double lowest = contour.front().x();
  for (const ProfilePoint& p : contour)
    if (p.y() <= s.nose) lowest = std::min(lowest, p.x());
  int count = 0;
  for (double level = barRadius + s.nose - s.depth; level > lowest; level -= s.depth) {
    if (++count > kMostRoughLevels) refuse({}, "depth", "there are too many levels", "Use a larger depth of cut.");
    for (const Interval& cut : intervalsAt(contour, level, start)) {
      if (cut.to > 0.0 || cut.from - cut.to < kEscape) continue;
      const bool isPocket = cut.from < start;
      path.rapid({above, path.at().y()});
      path.rapid({above, cut.from});
      path.rapid({std::min(above, isPocket ? level + s.depth + kBesideLevel : level), cut.from});
      path.feed({level, cut.from});
      path.feed({level, cut.to});
      path.feed({level + kEscape, cut.to + kEscape});
    }
  }
}

void alongContour(CyclePath& path, const std::vector<ToolMove>& contour, double barRadius, const CycleSettings& s) {
  const double above = barRadius + s.nose + s.clearance;
  path.rapid({above, path.at().y()});
  path.rapid({above, std::max(contour.front().from.y(), s.nose + s.clearance)});
  path.rapid({contour.front().from.x(), path.at().y()});
  path.feed(contour.front().from);
  for (const ToolMove& move : contour) path.along(move);
  // The move goes outward only: a taper that ends in the bar has already gone further.
  path.feed({std::max(above, path.at().x()), path.at().y()});
}

// Returns the overrun beyond the lower end of the target, mm. The centre of the nose goes that far, and its radius is
// below it.
double overrunOf(const CycleSettings& s) {
  const double overrun = std::min(s.overrun, s.room - 2.0 * s.nose - s.allowance - kBesideChuck);
  if (overrun < 0.0)
    refuse({}, "bar", "the tool would run into the chuck at the lower end of the target",
           "Take a bar that is at least " + roundedText(-overrun, 2) + " mm longer.");
  return overrun;
}

}  // namespace

std::vector<ToolMove> contourCuts(CutContour contour, double barRadius, const CycleSettings& s) {
  const bool isOpen = isOpenBelow(contour, barRadius);
  const auto pathBeside = [&](double nose) {
    ProfilePoint tail(0.0, 0.0);  // none on the axis
    if (isOpen)
      tail = (nose + s.clearance) * contour.back().direction(1.0);
    else if (contour.back().to.x() > nose)
      tail.y() = -nose - overrunOf(s);
    return offsetPath(contour, nose, s.clearance, tail);
  };
  const std::vector<ToolMove> rough = pathBeside(s.nose + s.allowance), finish = pathBeside(s.nose);
  const double above = barRadius + s.nose + s.clearance, away = s.nose + 10.0 * s.clearance;
  CyclePath path(s);
  path.tool(s.roughTool, s.roughFeed);
  path.rapid({above, away});
  roughLevels(path, pointsOf(rough), barRadius, s);
  alongContour(path, rough, barRadius, s);
  path.rapid({above, away});
  path.tool(s.finishTool, s.finishFeed);
  alongContour(path, finish, barRadius, s);
  path.rapid({above, away});
  return path.take();
}

}  // namespace handwheel
