// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/section/SectionOutline.h"

#include "machining/refit/ArcNurbs.h"
#include "machining/section/PlaneVectors.h"
#include "machining/target/CurveFit.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kLongestMark = 0.5;  // mm; longer segments are never joined
constexpr std::size_t kLeastRun = 4;  // a shorter run of short segments is a detail, not the marks of a hand
constexpr double kOnTheAxis = 1e-9;   // mm

using Chain = std::vector<ProfileSegment>;

bool isOnAxis(const SectionSegment& segment) {
  return !segment.carrier.isCircle() && std::abs(segment.from.x()) <= kOnTheAxis &&
         std::abs(segment.to.x()) <= kOnTheAxis;
}

// Returns the points of a run of segments, a few on each arc.
std::vector<ProfilePoint> pointsOf(std::span<const ProfileSegment> run) {
  constexpr int kOnArc = 4;
  std::vector<ProfilePoint> points{run.front().from};
  for (const ProfileSegment& segment : run) {
    for (int i = 1; segment.isArc() && i < kOnArc; ++i) points.push_back(segment.at(static_cast<double>(i) / kOnArc));
    points.push_back(segment.to);
  }
  return points;
}

// Leaves out segments that are shorter than a slack (mm). The longer neighbour keeps its ends.
Chain withoutSpecks(const Chain& chain, double slack) {
  Chain all;
  for (const ProfileSegment& segment : chain) {
    ProfileSegment next = segment;
    if (!all.empty() && all.back().to != next.from) {
      if (all.back().length() < next.length())
        all.back().to = next.from;
      else
        next.from = all.back().to;
    }
    if (next.length() >= slack)
      all.push_back(next);
    else if (!all.empty() && &segment == &chain.back())
      all.back().to = segment.to;
  }
  return all.size() > 1 ? all : chain;
}

// Returns true if the ends of lines are within a slack of the line from the first to the last.
bool isStraight(std::span<const ProfileSegment> lines, double slack) {
  const ProfileSegment whole{lines.front().from, lines.back().to, 0.0};
  return std::all_of(lines.begin(), lines.end(), [&](const ProfileSegment& line) {
    return !line.isArc() && (line.to - line.from).dot(whole.to - whole.from) > 0.0 &&
           (whole.nearest(line.from) - line.from).norm() <= slack && (whole.nearest(line.to) - line.to).norm() <= slack;
  });
}

// Joins lines that are nearly one, such as those of a tool that a hand or a bending bar leads. Corners that were
// programmed stay.
Chain straightened(const Chain& chain, double slack) {
  constexpr double kMostTurn = 1e-3;  // sine of the largest angle between neighbours
  const auto goesOn = [&](const ProfileSegment& a, const ProfileSegment& b) {
    return !a.isArc() && !b.isArc() && std::abs(crossProduct(a.direction(0.5), b.direction(0.5))) <= kMostTurn;
  };
  Chain all;
  for (std::size_t i = 0; i < chain.size();) {
    std::size_t end = i + 1;
    while (end < chain.size() && goesOn(chain[end - 1], chain[end]) &&
           isStraight(std::span(chain).subspan(i, end + 1 - i), slack))
      ++end;
    all.push_back(end == i + 1 ? chain[i] : ProfileSegment{chain[i].from, chain[end - 1].to, 0.0});
    i = end;
  }
  return all;
}

// Joins the runs of short segments.
Chain joined(const Chain& chain, double tolerance) {
  Chain all;
  for (std::size_t i = 0; i < chain.size();) {
    std::size_t end = i;
    while (end < chain.size() && chain[end].length() < kLongestMark) ++end;
    if (end - i < kLeastRun) {
      end = std::max(end, i + 1);
      all.insert(all.end(), chain.begin() + static_cast<std::ptrdiff_t>(i),
                 chain.begin() + static_cast<std::ptrdiff_t>(end));
    } else {
      const Chain fitted = fitSegments(pointsOf(std::span(chain).subspan(i, end - i)), tolerance);
      all.insert(all.end(), fitted.begin(), fitted.end());
    }
    i = end;
  }
  return all;
}

// Returns the curves of a loop without those on the axis, which part it into chains. The outside, or what is closed, is
// the first chain; hollows on the axis follow.
std::vector<Chain> chainsOf(const SharedLoop& boundary, double tolerance, double base) {
  SectionLoop loop = boundary.segments();
  for (SectionSegment& segment : loop) {
    segment.pass = SectionSegment::kBar;
    segment.isOfTrailingEdge = false;
  }
  loop = SharedLoop::of(loop).segments();
  const auto axis = std::find_if(loop.begin(), loop.end(), isOnAxis);
  if (axis != loop.end()) {
    std::rotate(loop.begin(), axis + 1, loop.end());
  } else {
    // A loop begins with a long segment, which is not joined to the last ones.
    const auto longer = [](const SectionSegment& a, const SectionSegment& b) { return a.length() < b.length(); };
    std::rotate(loop.begin(), std::max_element(loop.begin(), loop.end(), longer), loop.end());
  }
  std::vector<Chain> chains(1);
  for (const SectionSegment& segment : loop) {
    if (isOnAxis(segment)) {
      if (!chains.back().empty()) chains.emplace_back();
      continue;
    }
    ProfileSegment curve = segment.curve();
    curve.from.y() += base;
    curve.to.y() += base;
    chains.back().push_back(curve);
  }
  std::erase_if(chains, [](const Chain& chain) { return chain.empty(); });
  constexpr double kShare = 0.2;  // share of the tolerance for other than runs of short segments
  for (Chain& chain : chains)
    chain = joined(straightened(withoutSpecks(chain, kShare * tolerance), kShare * tolerance), tolerance);
  // The outside is the one that runs upwards.
  const auto outside = std::find_if(chains.begin(), chains.end(),
                                    [](const Chain& chain) { return chain.back().to.y() > chain.front().from.y(); });
  if (outside != chains.end()) std::iter_swap(chains.begin(), outside);
  return chains;
}

// Returns a chain traversed in reverse: hollows run upwards from axis to axis.
Chain reversedChain(Chain chain) {
  std::reverse(chain.begin(), chain.end());
  for (ProfileSegment& segment : chain) segment = segment.reversed();
  return chain;
}

}  // namespace

Result<TargetProfile> outlineOf(const TurnedSection& piece, double tolerance, double base) {
  Chain all;
  for (const SharedLoop& loop : piece.loops()) {
    for (const Chain& chain : chainsOf(loop, tolerance, base)) all.insert(all.end(), chain.begin(), chain.end());
  }
  return TargetProfile::make(std::move(all));
}

Result<TurnedCurves> curvesOf(const TurnedSection& piece, double tolerance, double base) {
  std::optional<ProfileCurve> outside;
  std::vector<ProfileCurve> cavities;
  for (const SharedLoop& loop : piece.loops()) {
    const bool isHollow = loop.area() < 0.0;
    for (Chain& chain : chainsOf(loop, tolerance, base)) {
      const bool isOutside = !isHollow && !outside;
      Result<ProfileCurve> curve = ProfileCurve::make(nurbsOf(isOutside ? chain : reversedChain(std::move(chain))));
      if (!curve) return curve.error();
      if (isOutside)
        outside = std::move(*curve);
      else
        cavities.push_back(std::move(*curve));
    }
  }
  if (!outside) return Error{ErrorCode::ElementMalformed, {"profile", "nothing is left of the part"}, {}, {}};
  return TurnedCurves{std::move(*outside), std::move(cavities)};
}

}  // namespace handwheel
