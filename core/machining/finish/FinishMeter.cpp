// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/finish/FinishMeter.h"

#include "machining/PassSteps.h"
#include "machining/measure/RoughnessGrade.h"
#include "machining/section/SectionSource.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handwheel {

namespace {

constexpr double kMicrometresPerMm = 1e3;  // in a mm
constexpr double kHeightOfRa = 4.0;        // crest height in Ra: f²/(8 R) by f²/(32 R)

double radiusOf(const TurnedProfile& profile, TurningSide side, std::size_t i) {
  return side == TurningSide::Outside ? profile.radius(i) : profile.inner(i);
}

// Returns true if the move to a point continues the move before: not back, nor around a corner.
bool goesOn(const TurningPass& pass, std::size_t i) {
  return i < 2 || (pass.path[i] - pass.path[i - 1]).dot(pass.path[i - 1] - pass.path[i - 2]) > 0.0;
}

// Returns true if the move to a point is that of a drill: along the axis, where it leaves a hole.
bool isDrilling(const TurningPass& pass, std::size_t i) {
  constexpr double kOnAxis = 1e-9;  // mm
  if (pass.tool && pass.tool->kind == LatheToolKind::Drill) return true;
  return pass.side == TurningSide::Bore && std::abs(pass.path[i].x()) <= kOnAxis &&
         std::abs(pass.path[i == 0 ? 0 : i - 1].x()) <= kOnAxis;
}

}  // namespace

void FeedMeter::clear() {
  m_moves.clear();
  m_distance = m_turns = 0.0;
}

double FeedMeter::add(double distance, double turns, bool isTurning) {
  if (!isTurning) return distance > 0.0 ? std::numeric_limits<double>::infinity() : 0.0;
  m_moves.push_back({distance, turns});
  m_distance += distance;
  m_turns += turns;
  while (m_moves.size() > 1 && m_turns - m_moves.front().turns >= 1.0) {
    m_distance -= m_moves.front().distance;
    m_turns -= m_moves.front().turns;
    m_moves.pop_front();
  }
  return m_moves.size() == 1 && turns >= 1.0 ? distance / turns : m_distance / std::max(m_turns, 1.0);
}

FinishMeter::FinishMeter(TurnedProfile profile, SurfaceFinish finish, double usualSpeed)
    : m_profile(std::move(profile)),
      m_finish(finish.size() == m_profile.size() ? std::move(finish) : SurfaceFinish::unknown(m_profile)),
      m_usualSpeed(usualSpeed) {
  for (auto& each : m_taken) each.resize(m_profile.size());
}

void FinishMeter::endContact() {
  for (auto& each : m_taken) {
    const auto first = each.begin();
    std::fill(first + static_cast<std::ptrdiff_t>(m_touched.first), first + static_cast<std::ptrdiff_t>(m_touched.last),
              0.0);
  }
  m_touched = {};
}

void FinishMeter::add(const TurningPass& pass, std::size_t i, std::uint32_t number, const TurnedProfile& profile,
                      const TurnedProfile::Range& beside) {
  m_feed = 0.0;
  TurnedProfile::Range changed = beside;
  if (i == 1 && number == m_number) changed.extend(m_first);
  const bool isOther = i == 0 || changed.isEmpty() || number != m_number;
  if (isOther) m_meter.clear();
  if (isOther || !goesOn(pass, i)) endContact();
  m_number = number;
  // The material removed at the begin of a pass has the feed of the first move, since the manual lathe cuts it as a
  // part of that move.
  m_first = i == 0 && pass.path.size() > 1 ? changed : TurnedProfile::Range();
  if (changed.isEmpty() || !m_first.isEmpty()) return;
  m_touched.extend(changed);
  const bool isAbrasive = pass.tool && pass.tool->isAbrasive();
  const double distance = i == 0 ? 0.0 : (pass.path[i] - pass.path[i - 1]).norm();
  const double seconds = i == 0 ? 0.0 : pass.times[i] - pass.times[i - 1];
  const double speed = i < pass.speeds.size() ? pass.speeds[i] : m_usualSpeed;
  m_feed = m_meter.add(distance, seconds * speed / 60.0, speed > 0.0);
  for (const TurningSide side : {TurningSide::Outside, TurningSide::Bore}) {
    if (side == TurningSide::Bore && !profile.isBored()) continue;
    for (std::size_t k = changed.first; k < changed.last; ++k) {
      const double radius = radiusOf(profile, side, k), removed = std::abs(radiusOf(m_profile, side, k) - radius);
      if (removed == 0.0) continue;
      double& taken = m_taken[static_cast<std::size_t>(side)][k];
      taken += removed;
      follow(side, k, radius);
      if (!isAbrasive && !(taken > TurningPass::kTouch)) continue;
      FinishMark mark = markOf(pass, i, m_finish.at(side, k), removed);
      mark.pass = number;
      m_finish.set(side, k, mark);
    }
  }
}

// An abrasive lowers Ra; an edge makes a new one. A surface finer than the abrasive gets the marks of its grain.
FinishMark FinishMeter::markOf(const TurningPass& pass, std::size_t i, const FinishMark& before, double removed) const {
  FinishMark mark;
  const bool isSpeedKnown = !pass.speeds.empty() || m_usualSpeed > 0.0;
  if (isSpeedKnown) mark.feed = static_cast<float>(m_feed);
  if (pass.tool && pass.tool->isAbrasive()) {
    const double left = before.roughness - kMicrometresPerMm * removed / kHeightOfRa;
    mark.roughness =
        before.roughness < 0.0f ? before.roughness : static_cast<float>(std::max(pass.tool->leastRoughness, left));
    return mark;
  }
  const double nose = pass.tool ? pass.tool->noseRadius : pass.noseRadius;
  const double left = isDrilling(pass, i) ? drilledRoughness(m_feed) : idealRoughness(m_feed, nose);
  mark.roughness = isSpeedKnown ? static_cast<float>(left) : FinishMark::kUnknown;
  return mark;
}

void FinishMeter::follow(TurningSide side, std::size_t i, double radius) {
  if (side == TurningSide::Outside)
    m_profile.limitOuter(i, radius);
  else
    m_profile.limitInner(i, radius);
}

TurnedProfile::Range cut(TurnedProfile& profile, const std::shared_ptr<const TurningPass>& pass, std::uint32_t number,
                         FinishMeter& meter, Progress progress) {
  constexpr std::size_t kLook = 64;  // points between two checks of the cancel flag
  const TurnedProfile before = profile;
  const PassSteps steps(*pass, number);
  TurnedProfile::Range changed;
  for (std::size_t i = 0; i < pass->path.size(); ++i) {
    if (i % kLook == 0) {
      if (progress.cancelled()) return changed;
      progress.set(static_cast<double>(i) / static_cast<double>(pass->path.size()));
    }
    const TurnedProfile::Range now = steps.cut(profile, i);
    meter.add(*pass, i, number, profile, now);
    changed.extend(now);
  }
  // The section also has what lies between two samples.
  if (changed.isEmpty() && !pass->isExact) {
    profile.setSection(before.section());
    return changed;
  }
  changed.extend(settlePass(profile, before, pass, number, progress));
  meter.renew(profile);
  return changed;
}

}  // namespace handwheel
