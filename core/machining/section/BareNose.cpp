// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/section/BareNose.h"

#include "machining/section/SectionCut.h"
#include "machining/section/SectionDifference.h"
#include "machining/section/ToolSweep.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace handwheel {

namespace {

constexpr double kTiny = 1e-6;      // mm
constexpr double kPastFace = 1e-4;  // mm; the trailing edge goes so far past the last material
constexpr double kFarAway = std::numeric_limits<double>::infinity();

// Returns the part of a cutter on one side of a height. above: the part above it is taken away. index: of its loops,
// as an arc may be cut into two.
SectionCutter clipped(SectionCutter cutter, double z, bool above, std::size_t index) {
  return [cutter = std::move(cutter), z, above, index](double grown) -> SectionLoop {
    SectionLoop loop = cutter(grown);
    if (loop.empty()) return loop;
    const ProfileBox box = boxOf(loop);
    const bool isWhole = above ? box.max().y() <= z : box.min().y() >= z;
    if (isWhole) return index == 0 ? loop : SectionLoop();
    const double low = above ? z : box.min().y() - 1.0, high = above ? box.max().y() + 1.0 : z;
    if (!(high > low)) return {};
    const double left = box.min().x() - 1.0, right = box.max().x() + 1.0;
    const std::array<ProfilePoint, 4> corners{ProfilePoint(left, low), ProfilePoint(right, low),
                                              ProfilePoint(right, high), ProfilePoint(left, high)};
    SectionLoop beyond;
    for (std::size_t i = 0; i < corners.size(); ++i)
      beyond.push_back(SectionSegment::line(corners[i], corners[(i + 1) % corners.size()]));
    const std::vector<SharedLoop> whole{SharedLoop::of(loop)};
    const std::optional<SectionDifference> part = differenceOf(whole, beyond);
    if (!part) return {};
    const std::vector<SharedLoop>& loops = part->removal.isEmpty() ? whole : part->loops;
    return index < loops.size() ? loops[index].segments() : SectionLoop();
  };
}

}  // namespace

BareNose::BareNose(const TurningPass& how, const ProfileSegment& move, const ProfilePoint& end)
    : m_move(move),
      m_end(end),
      m_radius(how.noseRadius),
      m_outward(how.side == TurningSide::Outside ? 1.0 : -1.0),
      m_trailing(-how.edges.y()),
      m_isFacing(goesInward(how, move.direction(0.5))) {}

std::vector<SectionCutter> BareNose::nose(const TurnedSection& section) const {
  const std::array<ProfilePoint, 1> shadows{toShank(section)};
  return cuttersOf({{ProfilePoint(0, 0)}, m_radius}, m_move, shadows);
}

std::vector<SectionCutter> BareNose::trailingEdge(const TurnedSection& section, double face) const {
  const double least = std::min(m_trailing * m_move.from.y(), m_trailing * m_move.to.y());
  if (m_trailing * face <= least) return {};
  // All of the move is extended beyond the face, and ends there.
  const double length = m_trailing * face - least + 2.0 * m_radius + 1.0;
  const ProfilePoint outward = toShank(section), along(0.0, m_trailing * length);
  const std::array<ProfilePoint, 3> shadows{outward, along, outward + along};
  std::vector<SectionCutter> cutters;
  for (SectionCutter& cutter : cuttersOf({{ProfilePoint(0, 0)}, m_radius}, m_move, shadows))
    for (const std::size_t index : {0, 1})
      if (index == 0 || m_move.isArc()) cutters.push_back(clipped(cutter, face, m_trailing > 0.0, index));
  return cutters;
}

// Returns a vector from the nose to a point that is certainly outside of the part.
ProfilePoint BareNose::toShank(const TurnedSection& section) const {
  const double widest = section.box().max().x() + std::abs(m_move.from.x()) + std::abs(m_move.to.x()) + m_radius;
  return {m_outward * (2.0 * widest + 1.0), 0.0};
}

// The face is the first plane without material on the trailing side.
std::optional<double> BareNose::faceBehind(const TurnedSection& section, std::uint32_t pass) const {
  if (!m_isFacing) return std::nullopt;
  // The trailing edge begins beside the centre of the nose.
  const double edge = tipAt(m_end), last = m_trailing * m_end.y(), farthest = last + m_radius + kTrailingEdge;
  const double beside = std::min({m_trailing * m_move.from.y(), m_trailing * m_move.to.y(), last});
  // Most moves of a contour have the contour itself behind them.
  if (hasOwnSurface(section, pass, beside, beside + kPastFace)) return std::nullopt;
  std::vector<double> ends{last};
  eachOutward(section, edge, last, farthest, [&](const SectionSegment&, const ProfileBox& box) {
    for (const double end : {box.min().y(), box.max().y()})
      if (end > last && end <= farthest) ends.push_back(end);
  });
  std::sort(ends.begin(), ends.end());
  const auto free = std::find_if(ends.begin(), ends.end(),
                                 [&](double end) { return isFree(section, m_trailing * (end + kPastFace), edge); });
  if (free == ends.end() || hasOwnSurface(section, pass, beside, *free)) return std::nullopt;
  if (!isDeepEnough(section, pass, last, *free)) return std::nullopt;
  return m_trailing * (*free + kPastFace);
}

// Returns true if the pass has left a surface between two heights, other than by its trailing edge.
bool BareNose::hasOwnSurface(const TurnedSection& section, std::uint32_t pass, double from, double to) const {
  bool isThere = false;
  eachOutward(section, tipAt(m_end), from, to, [&](const SectionSegment& segment, const ProfileBox& box) {
    const bool isBetween = box.max().y() > from + kTiny && box.min().y() < to - kTiny;
    isThere = isThere || (isBetween && segment.pass == pass && !segment.isOfTrailingEdge);
  });
  return isThere;
}

// Returns true if the tool goes into the material as far as the heights are apart, goes through it, or has begun to
// face.
bool BareNose::isDeepEnough(const TurnedSection& section, std::uint32_t pass, double from, double to) const {
  const double edge = tipAt(m_end), start = tipAt(m_move.from);
  double outermost = edge;
  bool goesOn = false;
  eachOutward(section, edge, from, to, [&](const SectionSegment& segment, const ProfileBox& box) {
    outermost = std::max(outermost, box.max().x());
    goesOn = goesOn || (segment.pass == pass && segment.isOfTrailingEdge && std::abs(box.max().x() - start) <= kTiny);
  });
  return goesOn || outermost - edge >= to - from - kTiny || isThrough(section, m_trailing * (from + kTiny), edge);
}

// Returns true if there is no material outward of a coordinate at a height.
bool BareNose::isFree(const TurnedSection& section, double z, double edge) const {
  const auto radii = section.radiiAt(z);
  if (!radii) return true;
  return m_outward > 0.0 ? radii->outer <= edge + kTiny
                         : -radii->inner <= edge + kTiny || radii->inner >= -edge - kTiny;
}

// Returns true if all material at a height is outward of a coordinate.
bool BareNose::isThrough(const TurnedSection& section, double z, double edge) const {
  const auto radii = section.radiiAt(z);
  return !radii || (m_outward > 0.0 ? radii->inner : -radii->outer) >= edge - kTiny;
}

// Calls visit(segment, box) with the segments outward of a coordinate and between two coordinates to the trailing
// side. The box is in these coordinates.
template <class Visit>
void BareNose::eachOutward(const TurnedSection& section, double edge, double from, double to, Visit visit) const {
  ProfileBox there(ProfilePoint(m_outward * edge, m_trailing * from));
  there.extend(ProfilePoint(m_outward * kFarAway, m_trailing * to));
  section.eachSegment(there, [&](const SectionSegment& segment) {
    const ProfileBox box = segment.box();
    ProfileBox turned(ProfilePoint(m_outward * box.min().x(), m_trailing * box.min().y()));
    turned.extend(ProfilePoint(m_outward * box.max().x(), m_trailing * box.max().y()));
    if (turned.max().y() >= from && turned.min().y() <= to && turned.max().x() > edge + kTiny) visit(segment, turned);
  });
}

}  // namespace handwheel
