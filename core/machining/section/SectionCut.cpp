// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/section/SectionCut.h"

#include "machining/section/BareNose.h"
#include "machining/section/PlaneVectors.h"
#include "machining/section/ToolSweep.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace handwheel {

namespace {

constexpr double kMirrored = 1e-6;  // mm; an edge that goes farther beyond the axis cuts there

bool subtractAll(TurnedSection& section, const std::vector<SectionCutter>& cutters, std::uint32_t pass,
                 bool isOfTrailingEdge, double toolHeight, SectionRemoval& removal) {
  for (const SectionCutter& cutter : cutters) {
    const std::optional<SectionRemoval> cut = section.subtract(cutter, pass, isOfTrailingEdge, toolHeight);
    if (!cut) return false;
    removal.add(*cut);
  }
  return true;
}

double heightOf(const SweptShape& shape) {
  ProfileBox box;
  for (const ProfilePoint& corner : shape.corners) box.extend(corner);
  return box.sizes().y() + 2.0 * shape.radius;
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

// Returns the fractions of a move at which its direction passes a diagonal, then 1: an arc may begin along the axis and
// end across it.
std::vector<double> diagonalsOf(const ProfileSegment& move) {
  std::vector<double> fractions;
  const double angle = move.angle();
  if (angle != 0.0) {
    const ProfilePoint along = move.direction(0.0);
    const double start = std::atan2(along.y(), along.x()), turn = std::copysign(1.0, angle);
    // The direction turns to odd multiples of 45°.
    for (double k = std::ceil(turn * start / (0.5 * M_PI) - 0.5);; k += 1.0) {
      const double at = (turn * (k + 0.5) * 0.5 * M_PI - start) / angle;
      if (at >= 1.0) break;
      if (at > 0.0) fractions.push_back(at);
    }
  }
  fractions.push_back(1.0);
  return fractions;
}

// Returns where the tool ends to go inward after a point of a move.
ProfilePoint endAfter(const WholeMove& move, const ProfilePoint& p) {
  const ProfileSegment& whole = move.path;
  if (!whole.isArc()) return move.end;
  const ProfilePoint centre = whole.centre(), a = whole.from - centre, b = p - centre;
  double at = std::atan2(crossProduct(a, b), a.dot(b)) / whole.angle();
  if (at < 0.0) at += 2.0 * M_PI / std::abs(whole.angle());
  const std::vector<double> ends = diagonalsOf(whole);
  const auto end = std::find_if(ends.begin(), ends.end(), [&](double each) { return each > at; });
  return end == ends.end() || *end >= 1.0 ? move.end : whole.at(*end);
}

bool cutByNose(TurnedSection& section, const TurningPass& how, const ProfileSegment& move, const WholeMove& whole,
               std::uint32_t pass, SectionRemoval& removal) {
  double from = 0.0;
  for (const double to : how.edges.isZero() ? std::vector<double>{1.0} : diagonalsOf(move)) {
    const ProfileSegment piece = move.piece(std::exchange(from, to), to);
    const BareNose nose(how, piece, endAfter(whole, piece.at(0.5)));
    const std::optional<double> face = nose.faceBehind(section, pass);
    if (!subtractAll(section, nose.nose(section), pass, face.has_value(), 2.0 * how.noseRadius, removal)) return false;
    if (!face) continue;
    constexpr double kAnyHeight = std::numeric_limits<double>::infinity();
    if (!subtractAll(section, nose.trailingEdge(section, *face), pass, true, kAnyHeight, removal)) return false;
  }
  return true;
}

// Returns the bounds of what the edges of a tool reach on a move.
ProfileBox reachOf(const TurningPass& how, const ProfileSegment& move) {
  ProfileBox tool(ProfilePoint(-how.noseRadius, -how.noseRadius), ProfilePoint(how.noseRadius, how.noseRadius));
  for (const RoundedPolygon& polygon : how.tool ? how.tool->cutting : std::vector<RoundedPolygon>()) {
    const ProfilePoint out(polygon.radius(), polygon.radius());
    for (const ProfilePoint& p : polygon.corners()) {
      tool.extend(ProfilePoint(p - out));
      tool.extend(ProfilePoint(p + out));
    }
  }
  const ProfileBox path = move.box();
  return {ProfilePoint(path.min() + tool.min()), ProfilePoint(path.max() + tool.max())};
}

}  // namespace

bool goesInward(const TurningPass& how, const ProfilePoint& direction) {
  const double outward = how.side == TurningSide::Outside ? 1.0 : -1.0;
  const bool hasEdges = how.edges.x() * outward < 0.0 && how.edges.y() != 0.0;
  return hasEdges && -outward * direction.x() > 0.0 && std::abs(direction.x()) >= std::abs(direction.y());
}

std::optional<ProfilePoint> inwardEnd(const TurningPass& how, const ProfileSegment& move) {
  if (!goesInward(how, move.direction(0.0))) return std::nullopt;
  const double first = diagonalsOf(move).front();
  return first >= 1.0 ? move.to : move.at(first);
}

std::vector<ProfilePoint> inwardEnds(const TurningPass& how, std::span<const ProfileSegment> moves) {
  std::vector<ProfilePoint> ends(moves.size());
  std::optional<ProfilePoint> next;  // the point at which the next move ends to go inward, if it does
  for (std::size_t i = moves.size(); i-- > 0;) {
    const ProfileSegment& move = moves[i];
    ends[i] = next && goesInward(how, move.direction(1.0)) ? *next : move.to;
    if (move.from == move.to && !move.isArc()) continue;
    const std::optional<ProfilePoint> own = inwardEnd(how, move);
    next = own && *own == move.to ? ends[i] : own;
  }
  return ends;
}

bool mayCut(const TurnedSection& section, const TurningPass& how, const ProfileSegment& move) {
  if (section.empty() || how.thread) return false;
  const ProfileBox tool = reachOf(how, move), &part = section.box();
  const bool isBesideEnds = tool.min().y() > part.max().y() || tool.max().y() < part.min().y();
  const bool isOutside = how.side == TurningSide::Outside && tool.min().x() > part.max().x();
  return !isBesideEnds && !isOutside;
}

std::optional<SectionRemoval> cutMove(TurnedSection& section, const TurningPass& how, const ProfileSegment& move,
                                      const WholeMove& whole, std::uint32_t pass) {
  SectionRemoval removal;
  const bool isSound = move.from.allFinite() && move.to.allFinite() && std::isfinite(move.bulge);
  if (!isSound || how.method == TurningMethod::Poles || !mayCut(section, how, move)) return removal;
  if (!how.tool) return cutByNose(section, how, move, whole, pass, removal) ? std::optional(removal) : std::nullopt;
  for (const RoundedPolygon& polygon : how.tool->cutting) {
    if (polygon.empty()) continue;
    const SweptShape shape = SweptShape::of(polygon);
    if (!subtractAll(section, cuttersOf(shape, move), pass, false, heightOf(shape), removal)) return std::nullopt;
    // The part turns: an edge beyond the axis cuts on the other side.
    if (leastRadius(shape, move) < -kMirrored &&
        !subtractAll(section, cuttersOf(shape.mirrored(), mirrored(move)), pass, false, heightOf(shape), removal))
      return std::nullopt;
  }
  return removal;
}

bool isBesideMaterial(const TurnedSection& section, const TurningPass& how, const ProfileSegment& move) {
  if (how.tool || section.empty()) return false;
  constexpr double kSlack = 1e-6;  // mm
  const double nose = how.noseRadius;
  bool isAny = false;
  for (const ProfilePoint& p : {move.from, move.at(0.5), move.to}) {
    for (const double height : {p.y() - nose, p.y(), p.y() + nose}) {
      const auto radii = section.radiiAt(height);
      if (!radii) continue;
      const bool isHere = how.side == TurningSide::Outside ? radii->inner > 0.0 && p.x() + nose <= radii->inner + kSlack
                                                           : p.x() - nose >= radii->outer - kSlack;
      if (!isHere) return false;
      isAny = true;
    }
  }
  return isAny;
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
                                      std::uint64_t& work, Progress progress) {
  constexpr double kLeastTolerance = 3e-7, kLargestTolerance = 1e-3;  // mm
  SectionRemoval removal;
  std::vector<ProfileSegment> moves = movesOf(pass, kLeastTolerance);
  for (double tolerance = 1e-6; moves.size() > kManyMoves && tolerance <= kLargestTolerance; tolerance *= 10.0)
    moves = movesOf(pass, tolerance);
  const std::vector<ProfilePoint> ends = inwardEnds(pass, moves);
  // A move sweeps its start, too.
  for (std::size_t i = moves.size() > 1 ? 1 : 0; i < moves.size(); ++i) {
    const ProfileSegment& move = moves[i];
    if (progress.cancelled()) return std::nullopt;
    std::uint64_t visited = 0;
    section.eachSegment(reachOf(pass, move), [&](const SectionSegment&) { ++visited; });
    if (visited >= work) return std::nullopt;
    work -= visited;
    if (!pass.isOfProgram && isBesideMaterial(section, pass, move)) continue;
    const std::optional<SectionRemoval> cut = cutMove(section, pass, move, WholeMove(move, ends[i]), number);
    if (!cut) return std::nullopt;
    removal.add(*cut);
  }
  return removal;
}

}  // namespace handwheel
