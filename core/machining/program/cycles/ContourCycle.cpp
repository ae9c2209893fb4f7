// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/cycles/ContourCycle.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kOffsetGap = 1e-2;     // an arc is inserted in a larger gap between the offsets of two segments
constexpr double kLeastSegment = 1e-3;  // shorter segments are left out
constexpr std::size_t kMostOffsetSteps = 4'000'000;  // times segments

constexpr const char* kContourRemedy =
    "The contour of the cycle must go on in one direction of Z (of X for G72), and its first move goes in to its "
    "start.";

}  // namespace

ContourCycle::ContourCycle(std::vector<ContourSegment> contour, const SourceLocation& location, CycleBudget& work)
    : m_work(work), m_segments(std::move(contour)), m_location(location) {}

void ContourCycle::rotate() {
  for (ContourSegment& segment : m_segments) segment.turnQuarter();
  m_turned ^= 4;
}

void ContourCycle::orient() {
  const PlanePoint along = m_segments.front().to - m_segments.back().to;
  if (along.imag() > 0.0) {
    for (ContourSegment& segment : m_segments) segment.mirrorRadius();
    m_turned ^= 2;
  }
  if (along.real() < 0.0) {
    for (ContourSegment& segment : m_segments) segment.mirrorLength();
    m_turned ^= 1;
  }
}

CycleOutput ContourCycle::turned(const CycleOutput& out) const {
  const int bits = m_turned;
  const auto back = [bits](PlanePoint p) {
    if (bits & 1) p = -std::conj(p);
    if (bits & 2) p = std::conj(p);
    return bits & 4 ? PlanePoint(0.0, 1.0) * p : p;
  };
  const bool isMirrored = ((bits & 1) != 0) != ((bits & 2) != 0);
  return {[=](const PlanePoint& p) { out.rapid(back(p)); }, [=](const PlanePoint& p) { out.feed(back(p)); },
          [=](int turn, const PlanePoint& centre, const PlanePoint& to) {
            out.arc(isMirrored ? -turn : turn, back(centre), back(to));
          }};
}

void ContourCycle::checkMonotonic() {
  ContourSegment& in = m_segments.front();
  if ((in.to - in.from).real() > 0.0) in.from.real(in.to.real());
  for (const ContourSegment& segment : m_segments)
    if (!segment.isMonotonic()) refuse(m_location, "contour", "it goes back", kContourRemedy);
}

// Refuses a contour with pockets. It must have been oriented, so that its depth becomes less from its start on.
void ContourCycle::checkRising() {
  constexpr double kSlack = 1e-3;  // rounding of a program's numbers
  for (std::size_t i = 1; i < m_segments.size(); ++i) {
    const ContourSegment& segment = m_segments[i];
    const bool fallsWithin = segment.turn > 0   ? segment.to.real() < segment.centre.real() - kSlack
                             : segment.turn < 0 ? segment.from.real() > segment.centre.real() + kSlack
                                                : false;
    if (fallsWithin || segment.to.imag() < segment.from.imag() - kSlack)
      refuse(m_location, "contour", "it has a pocket, which type I of the cycle does not cut",
             "Name X and Z in its first line, with W0 if Z stays, which makes it type II.");
  }
}

// A rounded or chamfered corner between its neighbours: tangent to both at this distance from their meeting point.
void ContourCycle::finishCorner(std::size_t i) {
  ContourSegment& corner = m_segments[i];
  ContourSegment &before = m_segments[i - 1], &after = m_segments[i + 1];
  const auto offset = [&](double by) {
    std::pair<ContourSegment, ContourSegment> both(before, after);
    both.first.offset(by);
    both.second.offset(by);
    return both;
  };
  double by = corner.corner;
  auto [p, n] = offset(by);
  if ((p.to - n.from).real() > kOffsetGap) {
    by = -by;
    std::tie(p, n) = offset(by);
  }
  if ((p.to - n.from).real() > kOffsetGap || !meet(p, n))
    refuse(m_location, "contour", "a corner cannot be rounded or chamfered", "Use a smaller A or C at this corner.");
  const PlanePoint centre = 0.5 * (p.to + n.from);
  p.offset(-by);
  n.offset(-by);
  corner.from = before.to = p.to;
  corner.to = after.from = n.from;
  if (corner.turn != 0) {
    corner.centre = centre;
    corner.turn = (corner.from - centre).imag() > 0.0 || (corner.to - centre).imag() > 0.0 ? 1 : -1;
    corner.corner = 0.0;
  }
}

void ContourCycle::finishCorners() {
  for (std::size_t i = 1; i + 1 < m_segments.size(); ++i)
    if (m_segments[i].corner != 0.0) finishCorner(i);
  std::erase_if(m_segments, [](const ContourSegment& segment) { return segment.size() < kLeastSegment; });
  if (m_segments.size() < 2) refuse(m_location, "contour", "nothing of it is left", kContourRemedy);
}

void ContourCycle::offsetStep(double step, bool isOutward) {
  m_work.spend(m_segments.size(), m_location);
  for (ContourSegment& segment : m_segments) segment.offset(step);
  std::erase_if(m_segments, [](const ContourSegment& segment) { return segment.size() < kLeastSegment; });
  for (std::size_t i = 0; i + 1 < m_segments.size(); ++i) {
    ContourSegment before = m_segments[i], after = m_segments[i + 1];
    if (!((before.to - after.from).real() > kOffsetGap)) continue;
    ContourSegment around;
    around.turn = isOutward ? 1 : -1;
    around.from = before.to;
    around.to = after.from;
    before.offset(-step);
    after.offset(-step);
    around.centre = 0.5 * (before.to + after.from);
    m_work.spend(m_segments.size() - i, m_location);
    m_segments.insert(m_segments.begin() + static_cast<std::ptrdiff_t>(i + 1), around);
    ++i;
  }
  for (std::size_t i = 0; i + 1 < m_segments.size(); ++i) {
    m_work.spend(1, m_location);
    const auto erase = [&](std::size_t k) {
      m_work.spend(m_segments.size() - k, m_location);
      m_segments.erase(m_segments.begin() + static_cast<std::ptrdiff_t>(k));
      i = 0;
    };
    if (!m_segments[i].isMonotonic()) erase(i > 0 && m_segments[i].size() >= m_segments[i - 1].size() ? i - 1 : i);
    if (i + 1 >= m_segments.size()) break;
    if (m_segments[i].size() < kLeastSegment)
      erase(i);
    else if (!meet(m_segments[i], m_segments[i + 1]))
      refuse(m_location, "contour", "two of its lines are parallel", kContourRemedy);
  }
}

// Offsets all but the approach, in steps so small that no segment is inverted.
void ContourCycle::offsetBy(double distance) {
  ContourSegment in = m_segments.front();
  const PlanePoint first = in.to - in.from, whole = m_segments.back().from - in.from;
  if ((first / whole).imag() < 0.0) distance = -distance;
  m_segments.erase(m_segments.begin());
  double done = 0.0;
  for (std::size_t steps = 0; done != distance; steps += m_segments.size()) {
    double step = std::abs(distance - done);
    for (const ContourSegment& segment : m_segments) step = std::min(step, 0.5 * segment.size());
    if (distance < 0.0) step = -step;
    offsetStep(step, distance > 0.0);
    if (m_segments.empty() || steps > kMostOffsetSteps || !std::isfinite(distance))
      refuse(m_location, "D", "the allowance does not fit into the contour", "Use a smaller allowance.");
    done += step;
  }
  for (std::size_t i = 0; i + 1 < m_segments.size(); ++i)
    m_segments[i].to = m_segments[i + 1].from = 0.5 * (m_segments[i].to + m_segments[i + 1].from);
  in.to = m_segments.front().from;
  m_segments.insert(m_segments.begin(), in);
}

void ContourCycle::rough(const Roughing& how, const CycleOutput& output) {
  m_segments.front().from = how.start;
  if (how.isFacing) rotate();
  orient();
  finishCorners();
  checkMonotonic();
  if (how.isMonotonic) checkRising();
  offsetBy(how.allowance);
  for (ContourSegment& segment : m_segments) segment.move(how.displacement);
  const CycleOutput out = turned(output);
  const PlanePoint start = m_segments.front().from;
  out.rapid(start);
  if (m_segments.back().to.imag() < start.imag()) {
    ContourSegment up;
    up.from = m_segments.back().to;
    up.to = {up.from.real(), start.imag()};
    m_segments.push_back(up);
  }
  ContourLevels levels(m_segments, how.depth, how.retract, how.mode, m_location, m_work);
  levels.cut(static_cast<int>(how.pockets), out);
}

void ContourCycle::finish(const Finishing& how, const CycleOutput& output) {
  m_segments.front().from = how.start;
  ContourCycle bare(Segments(m_segments.begin() + 1, m_segments.end()), m_location, m_work);
  bare.orient();
  if (std::any_of(bare.m_segments.begin(), bare.m_segments.end(),
                  [](const ContourSegment& segment) { return !segment.isMonotonic(); })) {
    bare.rotate();
    bare.orient();
  }
  bare.checkMonotonic();
  if (bare.m_turned & 4) rotate();
  orient();
  finishCorners();
  checkMonotonic();
  const CycleOutput out = turned(output);
  for (int pass = how.passes; pass > 0; --pass) {
    ContourCycle path(*this);
    path.offsetBy((pass - 1) * (how.first - how.last) / how.passes + how.last);
    out.rapid(path.m_segments.front().from);
    out.rapid(path.m_segments.front().to);
    for (std::size_t i = 1; i < path.m_segments.size(); ++i) {
      const ContourSegment& segment = path.m_segments[i];
      segment.turn == 0 ? out.feed(segment.to) : out.arc(segment.turn, segment.centre, segment.to);
    }
  }
}

}  // namespace handwheel
