// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/cycles/ContourLevels.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kSameLevel = 1e-6;
constexpr double kLeastCut = 1e-3;  // shorter arcs are not cut
constexpr int kMostLevelSteps = 4'000'000;

}  // namespace

ContourLevels::ContourLevels(const std::vector<ContourSegment>& contour, double depth, double retract,
                             const RoughingMode& mode, const SourceLocation& location, CycleBudget& work)
    : m_contour(contour),
      m_depth(std::max(depth, 2.0 * kSameLevel)),
      m_retract(retract),
      m_mode(mode),
      m_location(location),
      m_work(work) {}

void ContourLevels::spend() {
  m_work.spend(1, m_location);
  if (++m_steps > kMostLevelSteps)
    refuse(m_location, "I", "the cycle has too many levels", "Use a larger depth of cut.");
}

ContourLevels::Dive ContourLevels::dive(const ContourSegment& segment, double level, bool isIn) {
  return segment.turn == 0 ? diveLine(segment, level, isIn) : diveArc(segment, level);
}

ContourLevels::Dive ContourLevels::diveLine(const ContourSegment& line, double level, bool isIn) {
  if (line.from.imag() <= line.to.imag() + kSameLevel) return Dive::Climbs;
  PlanePoint to = line.to;
  if (!(level < line.to.imag())) {
    const std::vector<double> z = line.crossings(level);
    if (z.empty()) refuse(m_location, "contour", "a level does not meet it", "Begin the cycle outside of the contour.");
    to = {z.front(), level};
  }
  isIn ? m_out->rapid(to) : m_out->feed(to);
  m_at = to;
  return Dive::Moved;
}

ContourLevels::Dive ContourLevels::diveArc(const ContourSegment& arc, double level) {
  if (std::abs(m_at - arc.to) < kSameLevel || (m_at - arc.to).real() <= kSameLevel) {
    m_at = arc.to;
    return Dive::Moved;
  }
  std::vector<double> z = arc.crossings(level);
  if (z.empty()) z = arc.crossings(level - kSameLevel);
  const double centre = arc.centre.real();
  const auto cut = [&](const PlanePoint& to) {
    m_out->arc(arc.turn, arc.centre, to);
    m_at = to;
    return Dive::Moved;
  };
  if (arc.turn > 0) {
    if (m_at.real() - kSameLevel > centre) return Dive::Climbs;
    return z.empty() || z.back() > centre ? cut(arc.to) : cut({z.back(), level});
  }
  if (m_at.real() <= centre) return Dive::Climbs;
  if (z.empty()) return cut(arc.to);
  if (z.front() < centre) return Dive::Moved;  // met on its far side only: continues at the next level
  return cut({z.front(), level});
}

// Cuts the rest of an arc from m_at, as far as it climbs.
void ContourLevels::climbRest(const ContourSegment& arc) {
  PlanePoint to = arc.to;
  if (arc.turn > 0 && arc.to.real() < arc.centre.real()) to = {arc.centre.real(), arc.centre.imag() + arc.radius()};
  if (std::abs(m_at - to) > kLeastCut) m_out->arc(arc.turn, arc.centre, to);
  m_at = to;
}

bool ContourLevels::climb(const ContourSegment& segment) {
  if (segment.turn == 0) {
    if (segment.to.imag() + kSameLevel < segment.from.imag()) return false;
    if (std::abs(m_at - segment.from) > kSameLevel)
      refuse(m_location, "contour", "it cannot be followed", "Begin the cycle outside of the contour.");
    m_out->feed(segment.to);
    m_at = segment.to;
    return true;
  }
  const double side = m_at.real() - segment.centre.real();
  if (segment.turn > 0 ? side < 0.0 : side > 0.0) return false;
  climbRest(segment);
  return segment.turn < 0;  // a convex arc goes down behind its top
}

void ContourLevels::climbOnly(const ContourSegment& segment) {
  if (segment.turn == 0 && segment.to.imag() < segment.from.imag()) return;
  const std::vector<double> z = segment.crossings(m_at.imag());
  if (z.empty()) return;
  if (segment.turn < 0 && z.back() > segment.centre.real()) return;
  if (segment.turn > 0 && z.front() < segment.centre.real()) return;
  m_at.real(segment.turn < 0 ? z.back() : z.front());
  m_out->feed(m_at);
  if (segment.turn != 0) {
    climbRest(segment);
  } else {
    m_out->feed(segment.to);
    m_at = segment.to;
  }
}

void ContourLevels::cutLevel(Index& p, double& level) {
  for (Index i = p; i < m_contour.size(); ++i) {
    spend();
    const std::vector<double> z = m_contour[i].crossings(m_at.imag());
    if (z.empty()) continue;
    const double end = i != p ? z.front() : z.back();  // for an arc that goes down, its other side
    const double length = std::abs(end - m_at.real());
    if (end - kSameLevel > m_at.real()) continue;
    if (length < kSameLevel) {
      if (i == p) continue;
      if (std::abs(m_at - m_contour[i].from) < kSameLevel)
        p = i;
      else
        level -= m_depth;
      return;
    }
    const PlanePoint begin = m_at, to(end, m_at.imag());
    m_out->feed(to);
    const PlanePoint escape = std::min(1.0, length / 2.0 / m_retract) * m_retract * PlanePoint(1.0, 1.0);
    m_out->rapid((m_mode.followsWall ? followWall(i, to, level + m_depth) : to) + escape);
    m_out->rapid(begin - std::conj(escape));
    p == 0 ? m_out->rapid(begin) : m_out->feed(begin);
    level -= m_depth;
    return;
  }
}

PlanePoint ContourLevels::followWall(Index i, PlanePoint from, double top) {
  for (; i < m_contour.size() && from.imag() < top - kSameLevel; ++i) {
    spend();
    const ContourSegment& segment = m_contour[i];
    PlanePoint to = segment.to;
    if (segment.turn > 0 && to.real() < segment.centre.real())
      to = segment.centre + PlanePoint(0.0, segment.radius());  // top of a convex arc
    if (to.imag() <= from.imag() + kSameLevel) return from;
    if (to.imag() > top) {
      const std::vector<double> z = segment.crossings(top);
      if (z.empty()) return from;
      to = {segment.turn < 0 ? z.back() : z.front(), top};
    }
    segment.turn == 0 ? m_out->feed(to) : m_out->arc(segment.turn, segment.centre, to);
    from = to;
  }
  return from;
}

bool ContourLevels::follow(Index& p, int mode) {
  for (; p < m_contour.size(); ++p) {
    if (mode == 1) {
      climbOnly(m_contour[p]);
    } else if (!climb(m_contour[p])) {
      return true;
    }
  }
  return false;
}

void ContourLevels::cut(int mode, const CycleOutput& out) {
  m_out = &out;
  m_at = m_contour.front().from;
  m_pockets.push_back(m_at);
  Index p = 0;
  if (mode == 2) {
    constexpr double kBottom = -1e9;
    for (; p < m_contour.size(); ++p)
      if (dive(m_contour[p], kBottom, p == 0) == Dive::Climbs) break;
  }
  double level = firstLevel();
  while (p < m_contour.size()) {
    spend();
    if (level - kSameLevel > m_at.imag()) level -= m_depth * std::ceil((level - kSameLevel - m_at.imag()) / m_depth);
    if (dive(m_contour[p], level, p == 0) == Dive::Climbs) {
      if (!follow(p, mode)) return;
      if (mode == 2) {
        if (m_pockets.size() > 1 && m_at.imag() > m_pockets.back().imag()) m_pockets.pop_back();
        if (m_pockets.size() == 1) m_pockets.push_back(m_at);
      }
      level = firstLevel();
    } else if (std::abs(m_at.imag() - level) > kSameLevel) {
      ++p;
    } else {
      cutLevel(p, level);
    }
  }
}

}  // namespace handwheel
