// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/section/SectionCut.h"

#include "machining/section/PlaneVectors.h"
#include "machining/section/ToolSweep.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kTiny = 1e-6;  // mm

// A nose without a body, and the directions of its edges.
class BareNose {
 public:
  BareNose(const TurningPass& how, const ProfileSegment& move, const ProfileSegment& whole)
      : m_move(move),
        m_travel(whole.to - whole.from),
        m_radius(how.noseRadius),
        m_outward(how.side == TurningSide::Outside ? 1.0 : -1.0),
        m_trailing(-how.edges.y()),
        m_hasEdges(how.edges.x() * m_outward < 0.0 && how.edges.y() != 0.0) {}

  // Returns true if the nose moves beside the material: around the part with a boring tool, or in a bore with an
  // outside tool, whose shank then does not reach through the wall.
  bool isBeside(const TurnedSection& section) const {
    bool isAny = false;
    for (const ProfilePoint& p : {m_move.from, m_move.at(0.5), m_move.to}) {
      const auto radii = section.radiiAt(p.y());
      if (!radii) continue;
      const bool isHere = m_outward > 0.0 ? radii->inner > 0.0 && p.x() + m_radius <= radii->inner + kTiny
                                          : p.x() - m_radius >= radii->outer - kTiny;
      if (!isHere) return false;
      isAny = true;
    }
    return isAny;
  }

  // Returns the extensions of the nose to the side of its shank and, when it faces, along its trailing edge.
  std::vector<ProfilePoint> shadows(const TurnedSection& section, std::uint32_t pass) const {
    const ProfileBox box = section.box();
    const double reach = 2.0 * (box.max().x() + std::abs(m_move.from.x()) + std::abs(m_move.to.x()) + m_radius) + 1.0;
    const ProfilePoint outward(m_outward * reach, 0.0);
    const double facing = facingLength(section, pass);
    if (!(facing > 0.0)) return {outward};
    const ProfilePoint along(0.0, m_trailing * facing);
    return {outward, along, outward + along};
  }

 private:
  bool isFacing() const {
    const ProfilePoint by = m_move.to - m_move.from;
    return m_hasEdges && -m_outward * by.x() > 0.0 && std::abs(by.x()) >= std::abs(by.y());
  }

  // Returns the length from the path to the first plane without material on the trailing side; 0 if the trailing edge
  // does not cut.
  double facingLength(const TurnedSection& section, std::uint32_t pass) const {
    if (!isFacing()) return 0.0;
    const double edge = m_outward * m_move.to.x() - m_radius;  // outward coordinate of the tip
    const double behind = std::max(m_trailing * m_move.from.y(), m_trailing * m_move.to.y());
    const double beside = m_radius, longest = std::min(kTrailingEdge, std::abs(m_travel.x()));
    const double farthest = behind + beside + longest;
    std::vector<double> ends{behind + beside};
    for (const SectionLoop& loop : section.loops()) {
      for (const SectionSegment& segment : loop) {
        const ProfileBox box = segment.box();
        const double low = std::min(m_trailing * box.min().y(), m_trailing * box.max().y());
        const double high = std::max(m_trailing * box.min().y(), m_trailing * box.max().y());
        const double outer = std::max(m_outward * box.min().x(), m_outward * box.max().x());
        if (high < ends.front() || low > farthest || !(outer > edge + kTiny)) continue;
        for (const double end : {low, high})
          if (end > ends.front() && end <= farthest) ends.push_back(end);
      }
    }
    std::sort(ends.begin(), ends.end());
    // The nose itself reaches as far as the first of them.
    constexpr double kPastFace = 1e-4;  // mm
    const auto free = std::find_if(ends.begin(), ends.end(),
                                   [&](double end) { return isFree(section, m_trailing * (end + kPastFace), edge); });
    const bool isFacing =
        free != ends.end() && free != ends.begin() && !hasOwnSurface(section, pass, ends.front(), *free, edge);
    return isFacing ? *free + kPastFace - ends.front() : 0.0;
  }

  // Returns true if there is no material outward of a coordinate at a height.
  bool isFree(const TurnedSection& section, double z, double edge) const {
    const auto radii = section.radiiAt(z);
    if (!radii) return true;
    return m_outward > 0.0 ? radii->outer <= edge + kTiny
                           : -radii->inner <= edge + kTiny || radii->inner >= -edge - kTiny;
  }

  // Returns true if the pass has left a surface between two heights, on the trailing side.
  bool hasOwnSurface(const TurnedSection& section, std::uint32_t pass, double from, double to, double edge) const {
    for (const SectionLoop& loop : section.loops()) {
      for (const SectionSegment& segment : loop) {
        if (segment.pass != pass || segment.isOfTrailingEdge) continue;
        const ProfileBox box = segment.box();
        const double low = std::min(m_trailing * box.min().y(), m_trailing * box.max().y());
        const double high = std::max(m_trailing * box.min().y(), m_trailing * box.max().y());
        const double outer = std::max(m_outward * box.min().x(), m_outward * box.max().x());
        if (outer > edge + kTiny && high > from + kTiny && low < to - kTiny) return true;
      }
    }
    return false;
  }

  ProfileSegment m_move;
  ProfilePoint m_travel;  // mm, of the whole move
  double m_radius, m_outward, m_trailing;
  bool m_hasEdges;
};

bool subtractAll(TurnedSection& section, const SweptShape& shape, const ProfileSegment& move,
                 std::span<const ProfilePoint> shadows, std::uint32_t pass, SectionRemoval& removal) {
  const bool isFacing = shadows.size() > 1;
  for (const SectionCutter& cutter : cuttersOf(shape, move, shadows)) {
    const std::optional<SectionRemoval> cut = section.subtract(cutter, pass, isFacing);
    if (!cut) return false;
    removal.add(*cut);
  }
  return true;
}

ProfileSegment mirrored(const ProfileSegment& move) {
  return {{-move.from.x(), move.from.y()}, {-move.to.x(), move.to.y()}, -move.bulge};
}

// Returns the least radius that a shape reaches on a move.
double leastRadius(const SweptShape& shape, const ProfileSegment& move) {
  double least = std::numeric_limits<double>::infinity();
  for (const ProfilePoint& p : shape.corners) least = std::min(least, p.x() - shape.radius);
  return least + move.box().min().x();
}

// The directions in which a line from a point may go to pass within a tolerance of all points since.
class Sleeve {
 public:
  explicit Sleeve(const ProfilePoint& start) : m_start(start) {}
  // Adds a point. Returns false if no line to it passes the earlier points, or if the path turns back.
  bool add(const ProfilePoint& p, double tolerance) {
    const ProfilePoint v = p - m_start;
    const double distance = v.norm();
    if (!(distance > tolerance)) return m_reach == 0.0;
    const double half = std::asin(std::min(1.0, tolerance / distance));
    if (m_reach == 0.0) {
      m_axis = v / distance;
      m_low = -half;
      m_high = half;
      m_reach = distance;
      return true;
    }
    const double angle = std::atan2(m_axis.x() * v.y() - m_axis.y() * v.x(), m_axis.dot(v));
    if (distance < m_reach || angle < m_low || angle > m_high) return false;
    m_low = std::max(m_low, angle - half);
    m_high = std::min(m_high, angle + half);
    m_reach = distance;
    return true;
  }

 private:
  ProfilePoint m_start, m_axis{0, 0};
  double m_low = 0.0, m_high = 0.0, m_reach = 0.0;
};

}  // namespace

bool mayCut(const TurnedSection& section, const TurningPass& how, const ProfileSegment& move) {
  if (section.empty() || how.thread) return false;
  ProfileBox tool(ProfilePoint(-how.noseRadius, -how.noseRadius), ProfilePoint(how.noseRadius, how.noseRadius));
  for (const RoundedPolygon& polygon : how.tool ? how.tool->cutting : std::vector<RoundedPolygon>()) {
    const ProfilePoint out(polygon.radius(), polygon.radius());
    for (const ProfilePoint& p : polygon.corners()) {
      tool.extend(ProfilePoint(p - out));
      tool.extend(ProfilePoint(p + out));
    }
  }
  const ProfileBox path = move.box(), &part = section.box();
  const ProfilePoint low = path.min() + tool.min(), high = path.max() + tool.max();
  const bool isBesideEnds = low.y() > part.max().y() || high.y() < part.min().y();
  const bool isOutside = how.side == TurningSide::Outside && low.x() > part.max().x();
  return !isBesideEnds && !isOutside;
}

std::optional<SectionRemoval> cutMove(TurnedSection& section, const TurningPass& how, const ProfileSegment& move,
                                      const ProfileSegment& whole, std::uint32_t pass) {
  SectionRemoval removal;
  const bool isSound = move.from.allFinite() && move.to.allFinite() && std::isfinite(move.bulge);
  if (!isSound || how.method == TurningMethod::Poles || !mayCut(section, how, move)) return removal;
  if (!how.tool) {
    const BareNose nose(how, move, whole);
    if (nose.isBeside(section)) return removal;
    const SweptShape shape{{ProfilePoint(0, 0)}, how.noseRadius};
    return subtractAll(section, shape, move, nose.shadows(section, pass), pass, removal) ? std::optional(removal)
                                                                                         : std::nullopt;
  }
  for (const RoundedPolygon& polygon : how.tool->cutting) {
    if (polygon.empty()) continue;
    const SweptShape shape = SweptShape::of(polygon);
    if (!subtractAll(section, shape, move, {}, pass, removal)) return std::nullopt;
    // The part turns: an edge beyond the axis cuts on the other side.
    if (leastRadius(shape, move) < -kTiny && !subtractAll(section, shape.mirrored(), mirrored(move), {}, pass, removal))
      return std::nullopt;
  }
  return removal;
}

ProfileSegment straightRun(const TurningPass& pass, std::size_t i) {
  constexpr double kStraightRun = 1e-6;  // sine of the largest angle between two moves of a run
  if (i == 0) return {pass.path[0], pass.path[0], 0.0};
  std::size_t first = i - 1, last = i;
  const ProfilePoint along = (pass.path[i] - pass.path[i - 1]).normalized();
  const auto goesOn = [&](const ProfilePoint& a, const ProfilePoint& b) {
    const ProfilePoint move = b - a;
    return move.dot(along) > 0.0 && std::abs(crossProduct(move, along)) <= kStraightRun * move.norm();
  };
  while (first > 0 && goesOn(pass.path[first - 1], pass.path[first])) --first;
  while (last + 1 < pass.path.size() && goesOn(pass.path[last], pass.path[last + 1])) ++last;
  return {pass.path[first], pass.path[last], 0.0};
}

std::vector<ProfileSegment> movesOf(const TurningPass& pass, double tolerance) {
  std::vector<ProfileSegment> moves;
  if (pass.path.empty()) return moves;
  moves.push_back({pass.path[0], pass.path[0], 0.0});
  auto arc = pass.arcs.begin();
  std::size_t at = 0;
  while (at + 1 < pass.path.size()) {
    while (arc != pass.arcs.end() && arc->first < at) ++arc;
    std::size_t end = at + 1;
    double bulge = 0.0;
    if (arc != pass.arcs.end() && arc->first == at && arc->last > at && arc->last < pass.path.size()) {
      end = arc->last;
      bulge = arc->bulge;
    } else {
      const std::size_t last =
          arc != pass.arcs.end() ? std::min<std::size_t>(arc->first, pass.path.size() - 1) : pass.path.size() - 1;
      Sleeve sleeve(pass.path[at]);
      sleeve.add(pass.path[end], tolerance);
      while (end < last && sleeve.add(pass.path[end + 1], tolerance)) ++end;
    }
    if (pass.path[end] != pass.path[at]) moves.push_back({pass.path[at], pass.path[end], bulge});
    at = end;
  }
  return moves;
}

std::optional<SectionRemoval> cutPass(TurnedSection& section, const TurningPass& pass, std::uint32_t number,
                                      Progress progress) {
  constexpr std::uint64_t kMostWork = 5'000'000;  // segments that all moves visit; less than a second
  constexpr double kLeastTolerance = 3e-7, kLargestTolerance = 1e-3;  // mm
  SectionRemoval removal;
  std::uint64_t work = 0;
  std::vector<ProfileSegment> moves = movesOf(pass, kLeastTolerance);
  for (double tolerance = 1e-6; moves.size() > kManyMoves && tolerance <= kLargestTolerance; tolerance *= 10.0)
    moves = movesOf(pass, tolerance);
  for (const ProfileSegment& move : moves) {
    // An arc may begin along the axis and end across it.
    constexpr double kFacedAngle = 0.1;  // rad
    const int pieces =
        pass.edges.isZero() ? 1 : std::max(1, static_cast<int>(std::ceil(std::abs(move.angle()) / kFacedAngle)));
    for (int k = 0; k < pieces; ++k) {
      if (progress.cancelled()) return std::nullopt;
      work += section.size();
      if (work > kMostWork) return std::nullopt;
      const ProfileSegment piece =
          pieces == 1 ? move : move.piece(static_cast<double>(k) / pieces, static_cast<double>(k + 1) / pieces);
      const std::optional<SectionRemoval> cut = cutMove(section, pass, piece, move, number);
      if (!cut) return std::nullopt;
      removal.add(*cut);
    }
  }
  return removal;
}

}  // namespace handwheel
