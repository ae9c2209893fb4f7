// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/NoseCompensation.h"

#include <cmath>

namespace handwheel {

namespace {

constexpr double kCorner = 0.05;        // radian; flatter corners do not count (LinuxCNC's TOLERANCE_CONCAVE_CORNER)
constexpr double kRadiusChange = 0.01;  // mm, between the ends of an arc
// radian; tolerance of an arc's growth in a corner, in programs in mm and in inches
constexpr double kGrowth = 0.0254, kGrowthInch = 0.001;
constexpr const char* kSmallerNose = "Use a tool with a smaller nose radius, or make the corner rounder.";
constexpr const char* kNoFit = "the nose of the tool does not fit into this corner without cutting into the contour";

double angleTo(const PlanePoint& from, const PlanePoint& to) {
  return std::arg(to - from);
}

double sweepBetween(const PlanePoint& from, const PlanePoint& centre, int turn, const PlanePoint& to) {
  ToolMove move;
  move.turn = static_cast<std::int8_t>(turn);
  move.from = profilePoint(from);
  move.to = profilePoint(to);
  move.centre = profilePoint(centre);
  return sweepOf(move);
}

[[noreturn]] void refuseCorner(const SourceLocation& location) {
  refuse(location, "nose compensation", kNoFit, kSmallerNose);
}

double cosineIn(double value, const SourceLocation& location) {
  if (!(value >= -1.0 && value <= 1.0)) refuseCorner(location);
  return value;
}

}  // namespace

void NoseCompensation::begin(int side, double radius, const ProfilePoint& tip, const PlanePoint& at, bool isInch) {
  m_side = side;
  m_radius = radius;
  m_growth = isInch && !m_isFanuc ? kGrowthInch : kGrowth;
  m_tip = radius * planePoint(tip);
  m_isFirst = true;
  m_isEntry = false;
  m_contour = m_centre = at;  // like LinuxCNC: the entry move starts from the tip as if the nose's centre were there
  m_held.clear();
  m_heldFrom.reset();
}

void NoseCompensation::move(const Step& programmed) {
  const bool isArc = programmed.modal.turn != 0;
  if (m_isFirst)
    isArc ? enterByArc(programmed) : enter(programmed);
  else
    isArc ? arc(programmed) : line(programmed);
}

PlanePoint NoseCompensation::end() {
  if (!m_held.empty()) endHeldAt(m_centre, m_held.back().step.location);
  m_side = 0;
  return m_contour;
}

void NoseCompensation::flush() {
  for (Held& held : m_held) {
    held.step.to += m_tip;
    held.step.centre += m_tip;
    m_emit(held.step);
  }
  m_held.clear();
  m_heldFrom.reset();
}

// Ends the held moves here instead. More than one is held only if a move had no length.
void NoseCompensation::endHeldAt(const PlanePoint& corner, const SourceLocation& location) {
  if (m_held.empty()) return;
  for (Held& held : m_held) {
    Step& step = held.step;
    if (step.modal.turn != 0) {
      const double before = std::abs(step.to - step.centre), after = std::abs(corner - step.centre);
      if (std::abs(before - after) > kRadiusChange) refuseCorner(location);
      if (held.sweep != 0.0 && m_heldFrom) {
        const double sweep = sweepBetween(*m_heldFrom, step.centre, step.modal.turn, corner);
        if (std::abs(sweep) > std::abs(held.sweep) + held.growth) refuseCorner(location);
      }
    } else if (m_heldFrom) {
      const PlanePoint now = corner - *m_heldFrom;
      if (held.direction.real() * now.real() + held.direction.imag() * now.imag() < 0.0) refuseCorner(location);
    }
    step.to = corner;
  }
  flush();
  m_heldFrom = corner;
}

void NoseCompensation::enter(const Step& programmed) {
  const PlanePoint along = programmed.to - m_centre;
  if (std::abs(along) <= m_radius)
    refuse(programmed.location, "nose compensation", "the first move is not longer than the nose radius",
           "Begin compensation farther from the part.");
  const double out = std::arg(along) + (m_side > 0 ? M_PI_2 : -M_PI_2);
  Held held{programmed, m_isFanuc ? PlanePoint{} : std::polar(1.0, out), 0.0};
  m_isEntry = m_isFanuc;
  held.step.to = programmed.to + std::polar(m_radius, out);
  m_heldFrom = m_centre;
  m_isFirst = false;
  m_contour = programmed.to;
  m_centre = held.step.to;
  hold(std::move(held));
}

// Ends the entry move beside the beginning of the contour.
void NoseCompensation::endEntryAt(const PlanePoint& offset) {
  m_isEntry = false;
  m_centre = m_contour + offset;
  for (Held& held : m_held) held.step.to = m_centre;
  flush();
  m_heldFrom = m_centre;
}

// Adds the arc that ends in the offset of the programmed end, towards its centre, and begins at the tool.
void NoseCompensation::enterByArc(const Step& programmed) {
  if (std::abs(programmed.to - m_centre) <= m_radius)
    refuse(programmed.location, "nose compensation", "the first arc is not longer than the nose radius",
           "Begin compensation farther from the part.");
  const PlanePoint inward = programmed.centre - programmed.to;
  const double out = std::arg(isInside(programmed.modal.turn) ? inward : -inward);
  const PlanePoint to = programmed.to + std::polar(m_radius, out);
  const double direction = angleTo(to, programmed.centre);
  const double half = 0.5 * std::abs(m_centre - to);
  const double share = std::cos(angleTo(to, m_centre) - direction);
  if (std::abs(share) < 1e-4) refuseCorner(programmed.location);
  Held held{programmed, {}, 0.0};
  held.step.to = to;
  held.step.centre = to + std::polar(half / share, direction);
  Held shift{
      programmed, {}, 0.0};  // the tip first moves by the offset of its orientation; otherwise the arc would be invalid
  shift.step.modal.turn = 0;
  shift.step.to = m_centre;
  m_isFirst = false;
  m_contour = programmed.to;
  if (m_tip != PlanePoint{}) {
    m_heldFrom = m_centre;
    hold(std::move(shift));
    flush();
  }
  m_heldFrom = m_centre;
  held.sweep = sweepBetween(m_centre, held.step.centre, programmed.modal.turn, to);
  held.growth = m_growth;
  m_centre = to;
  hold(std::move(held));
}

// Adds an arc of the nose around a convex corner; for rapids a straight move, since there are no rapid arcs.
void NoseCompensation::roundCorner(const Step& programmed, const PlanePoint& to) {
  Held round{programmed, {}, 0.0};
  const bool isRapid = programmed.modal.kind == ToolMove::Kind::Rapid;
  round.step.modal.turn = static_cast<std::int8_t>(isRapid ? 0 : -m_side);
  round.step.to = to;
  round.step.centre = m_contour;
  hold(std::move(round));
  flush();
  m_heldFrom = to;
}

void NoseCompensation::line(const Step& programmed) {
  const PlanePoint along = programmed.to - m_contour;
  if (along == PlanePoint{}) {
    Held still{programmed, {}, 0.0};
    still.step.to = m_centre;
    hold(std::move(still));
    return;
  }
  if (m_isEntry) endEntryAt(std::polar(m_radius, std::arg(along) + m_side * M_PI_2));
  double theta = angleTo(m_contour, m_centre), alpha = std::arg(along);
  if (m_side > 0 && theta < alpha) theta += 2.0 * M_PI;
  if (m_side < 0 && alpha < theta) alpha += 2.0 * M_PI;
  const double beta = std::abs(theta - alpha) - M_PI_2;
  const PlanePoint offset = std::polar(m_radius, alpha + m_side * M_PI_2);
  const bool isAfterArc = !m_held.empty() && m_held.front().step.modal.turn != 0;
  // An h: around a half circle and back beside its leg. The nose stays above.
  const bool isBackBeside = beta > M_PI - kCorner && isAfterArc && m_side * m_held.front().step.modal.turn < 0;
  if (beta < -kCorner || beta > M_PI + kCorner || isBackBeside) {
    if (!m_held.empty())
      endHeldAt(isAfterArc ? cornerFromArc(programmed.to, programmed.location)
                           : cornerOfLines(std::polar(1.0, theta + m_side * M_PI_2), beta, programmed.location),
                programmed.location);
  } else if (beta > kCorner) {
    if (!m_held.empty()) endHeldAt(m_centre, programmed.location);
    roundCorner(programmed, m_contour + offset);
  } else {
    flush();
    m_heldFrom = m_centre;
  }
  Held held{programmed, along, 0.0};
  held.step.to = programmed.to + offset;
  m_contour = programmed.to;
  m_centre = held.step.to;
  hold(std::move(held));
}

PlanePoint NoseCompensation::cornerOfLines(const PlanePoint& direction, double beta,
                                           const SourceLocation& location) const {
  const double half = 0.5 * (beta + M_PI);
  if (half == 0.0) refuseCorner(location);
  return m_centre + m_radius / std::tan(half) * direction;
}

// Returns the intersection of the offset line and the offset arc that is held back.
PlanePoint NoseCompensation::cornerFromArc(const PlanePoint& to, const SourceLocation& location) const {
  const Step& before = m_held.front().step;
  const int turn = before.modal.turn;
  const double radius = std::abs(before.to - before.centre);
  const bool inside = isInside(turn);
  const double contourRadius = inside ? radius + m_radius : radius - m_radius;
  const double across = angleTo(m_contour, to) + turn * M_PI_2;
  const double distance = contourRadius * std::cos(across - angleTo(m_contour, before.centre));
  const double share = cosineIn((inside ? distance - m_radius : distance + m_radius) / radius, location);
  const double spread = (inside ? -turn : turn) * std::acos(share);
  return before.centre + std::polar(radius, spread + across + M_PI);
}

// Returns the intersection of the offset arc and the offset line that is held back, whose direction is theta.
PlanePoint NoseCompensation::cornerToArc(const Step& programmed, double theta, double beta) const {
  const int turn = programmed.modal.turn;
  const double arcRadius = std::abs(programmed.to - programmed.centre);
  const double across = arcRadius * std::sin(beta - M_PI_2);
  if (isInside(turn)) {
    const double radius = arcRadius - m_radius;
    const double share = cosineIn((across + m_radius) / radius, programmed.location);
    return programmed.centre + std::polar(radius, theta + turn * std::asin(share));
  }
  const double radius = arcRadius + m_radius;
  const double share = cosineIn((across - m_radius) / radius, programmed.location);
  return programmed.centre + std::polar(radius, theta + M_PI - turn * std::asin(share));
}

PlanePoint NoseCompensation::cornerOfArcs(const Step& programmed) const {
  const Step& before = m_held.front().step;
  const int turn = programmed.modal.turn;
  const double old = std::abs(before.to - before.centre);
  const double arcRadius = std::abs(programmed.to - programmed.centre);
  const double radius = isInside(turn) ? arcRadius - m_radius : arcRadius + m_radius;
  const PlanePoint between = programmed.centre - before.centre;
  const double distance = std::abs(between);
  if (old == 0.0 || distance == 0.0) refuseCorner(programmed.location);
  const double share =
      cosineIn((old * old + distance * distance - radius * radius) / (2.0 * old * distance), programmed.location);
  const double spread = (isInside(before.modal.turn) ? turn : -turn) * std::acos(share);
  return before.centre + std::polar(old, std::arg(between) + spread);
}

void NoseCompensation::arc(const Step& programmed) {
  const int turn = programmed.modal.turn;
  const double arcRadius = std::abs(programmed.to - programmed.centre);
  const double inward = angleTo(m_contour, programmed.centre);
  const double side = isInside(turn) ? m_radius : -m_radius;  // towards the centre
  if (m_isEntry) endEntryAt(std::polar(side, inward));
  const double theta = angleTo(m_contour, m_centre) - m_side * M_PI_2;
  const double alpha = inward - turn * M_PI_2;
  double beta = m_side * (theta - alpha);
  if (beta > 1.5 * M_PI) beta -= 2.0 * M_PI;
  if (beta < -M_PI_2) beta += 2.0 * M_PI;
  if (isInside(turn) && arcRadius <= m_radius) refuseCorner(programmed.location);
  const PlanePoint to = programmed.to + std::polar(side, angleTo(programmed.to, programmed.centre));

  double growth = m_growth;
  const bool isTangentBack = std::abs(beta - M_PI) < kCorner && !isInside(turn);
  if (beta < -kCorner || beta > M_PI + kCorner || isTangentBack) {
    if (!m_held.empty()) {
      const bool isAfterArc = m_held.front().step.modal.turn != 0;
      endHeldAt(isAfterArc ? cornerOfArcs(programmed) : cornerToArc(programmed, theta, beta), programmed.location);
    }
  } else if (beta > kCorner) {
    flush();
    roundCorner(programmed, m_contour + std::polar(side, inward));
  } else {
    flush();
    m_heldFrom = m_centre;
    // The arc grows by the angle between the end of the last move and its own begin.
    if (m_isFanuc) growth += std::abs(std::arg((m_centre - programmed.centre) / (m_contour - programmed.centre)));
  }
  Held held{programmed, {}, sweepBetween(m_contour, programmed.centre, turn, programmed.to), growth};
  held.step.to = to;
  m_contour = programmed.to;
  m_centre = to;
  hold(std::move(held));
}

}  // namespace handwheel
