// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/force/ForcePeaks.h"

#include "machining/PassSteps.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kSamplesOfACut = 8.0;  // one sample more or less makes an eighth of the depth
constexpr double kLongestMove = 0.5;    // mm; longer moves are judged in parts

struct RemovedSection {
  double area = 0.0;    // mm²
  double radius = 0.0;  // mm
};

// Returns the material removed by the nose of a pass, on its side, in a cut from a to b. before: a buffer for the radii
// of that side.
template <class Cut>
RemovedSection removedBy(TurnedProfile& profile, const TurningPass& pass, const ProfilePoint& a, const ProfilePoint& b,
                         std::vector<double>& before, Cut cut) {
  const bool isBore = pass.side == TurningSide::Bore;
  const auto radiusOf = [&](std::size_t i) { return isBore ? profile.inner(i) : profile.radius(i); };
  const TurnedProfile::Range under = profile.samplesUnder(a, b, pass.noseRadius);
  before.clear();
  for (std::size_t i = under.first; i < under.last; ++i) before.push_back(radiusOf(i));
  cut();
  RemovedSection removed;
  for (std::size_t i = under.first; i < under.last; ++i) {
    const double was = before[i - under.first], is = radiusOf(i), gone = std::abs(was - is);
    if (!(gone > 0.0)) continue;
    removed.area += gone * profile.spacing();
    removed.radius = std::max({removed.radius, was, is});
  }
  return removed;
}

}  // namespace

double drillRadius(const TurningPass& pass, const ProfilePoint& a, const ProfilePoint& b) {
  constexpr double kOnAxis = 1e-9;  // mm
  if (pass.tool) return pass.tool->kind == LatheToolKind::Drill ? pass.tool->reach() : 0.0;
  const bool isOnAxis = std::abs(a.x()) <= kOnAxis && std::abs(b.x()) <= kOnAxis;
  return pass.side == TurningSide::Bore && isOnAxis ? pass.noseRadius : 0.0;
}

ForcePeakMeter::ForcePeakMeter(const CuttingForceModel& model, double resolution)
    : m_model(&model), m_resolution(resolution) {}

void ForcePeakMeter::add(const Move& move) {
  if (move.isDrill != m_isDrill) judge();
  m_isDrill = move.isDrill;
  if (!(move.area > 0.0)) {
    judge();
    m_time += move.seconds;
    return;
  }
  m_time += move.seconds;
  m_length += move.length;
  m_area += move.area;
  m_radius = std::max(m_radius, move.radius);
  m_speed = std::max(m_speed, move.speed);
  m_turns += move.spindle / 60.0 * move.seconds;
  if (m_length >= kSamplesOfACut * m_resolution && m_turns >= 1.0) judge();
}

void ForcePeakMeter::judge() {
  if (m_area > 0.0 && m_length > 0.0) {
    // Per length of the path the area is the width of the cut; per turn the length is the feed.
    const double feed = m_turns > 0.0 ? std::min(m_length / m_turns, kRapidFeed) : kRapidFeed;
    // A cut that ended before it was as long as a sample does not define its width.
    const double length = std::max(m_length, m_resolution);
    const CutConditions cut{m_area / length, feed, m_speed};
    m_isDrill ? takeDrill(cut) : take(cut, m_model->at(cut), m_radius);
  }
  m_length = m_area = m_turns = m_radius = m_speed = 0.0;
}

void ForcePeakMeter::addChip(double width, double thickness, double seconds, double radius, double speed) {
  judge();
  m_time += seconds;
  const CutConditions cut{width, thickness, speed};
  take(cut, m_model->at(cut), radius);
}

// The lips work in the middle of the ring between the hole that is there and the diameter of the drill.
void ForcePeakMeter::takeDrill(const CutConditions& cut) {
  const double depth = std::min(cut.depth, m_radius), middle = m_radius - 0.5 * depth;
  const CutConditions atMiddle{depth, cut.feed, m_radius > 0.0 ? cut.speed * middle / m_radius : 0.0};
  const CutForces forces = m_model->onDrill(atMiddle);
  take(atMiddle, forces, middle);
  DrillPeaks& drilling = m_peaks.drilling;
  const double torque = cuttingTorque(forces, 2.0 * middle);
  if (torque >= drilling.torque) drilling.diameter = 2.0 * m_radius;
  drilling.thrust = std::max(drilling.thrust, forces.feed);
  drilling.torque = std::max(drilling.torque, torque);
  drilling.power = std::max(drilling.power, cuttingPower(forces, atMiddle));
}

void ForcePeakMeter::take(const CutConditions& cut, const CutForces& forces, double radius) {
  if (forces.norm() > m_peaks.force) {
    m_peaks.force = forces.norm();
    m_peaks.cut = cut;
    m_peaks.time = m_time;
  }
  m_peaks.power = std::max(m_peaks.power, cuttingPower(forces, cut));
  m_peaks.torque = std::max(m_peaks.torque, cuttingTorque(forces, 2.0 * radius));
  m_peaks.isOutsideModel |= !m_model->covers(cut);
}

ForcePeaks ForcePeakMeter::finish() {
  judge();
  return m_peaks;
}

std::optional<ForcePeaks> forcePeaks(TurnedProfile profile, std::span<const TurningPass> passes, double spindle,
                                     const CuttingForceModel& model, Progress progress) {
  constexpr std::size_t kLook = 64;      // points between two checks of the cancel flag
  constexpr double kMostParts = 10'000;  // largest number of parts of a move
  ForcePeakMeter meter(model, profile.spacing());
  std::vector<double> before;
  std::uint32_t number = 0;
  for (const TurningPass& pass : passes) {
    const PassSteps steps(pass, number++);
    if (!pass.path.empty()) steps.cut(profile, 0);
    for (std::size_t i = 1; i < pass.path.size(); ++i) {
      if (i % kLook == 0 && progress.cancelled()) return std::nullopt;
      const ProfilePoint from = pass.path[i - 1], displacement = pass.path[i] - from;
      const double seconds = pass.times[i] - pass.times[i - 1], length = displacement.norm();
      const int parts = static_cast<int>(std::clamp(std::ceil(length / kLongestMove), 1.0, kMostParts));
      for (int k = 0; k < parts; ++k) {
        const double first = static_cast<double>(k) / parts, last = static_cast<double>(k + 1) / parts;
        const ProfilePoint a = from + displacement * first, b = from + displacement * last;
        const RemovedSection removed =
            removedBy(profile, pass, a, b, before, [&] { steps.cut(profile, i, first, last); });
        const double drill = drillRadius(pass, a, b), radius = drill > 0.0 ? drill : removed.radius;
        meter.add({length / parts, seconds / parts, removed.area, radius, spindle, surfaceSpeed(spindle, 2.0 * radius),
                   drill > 0.0});
      }
    }
  }
  return meter.finish();
}

}  // namespace handwheel
