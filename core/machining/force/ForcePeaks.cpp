// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/force/ForcePeaks.h"

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

// Returns the material removed by the nose of a pass, on its side. before: a buffer for the radii of that side.
RemovedSection removedBy(TurnedProfile& profile, const TurningPass& pass, const ProfilePoint& a, const ProfilePoint& b,
                         std::vector<double>& before) {
  const bool isBore = pass.side == TurningSide::Bore;
  const auto radiusOf = [&](std::size_t i) { return isBore ? profile.inner(i) : profile.radius(i); };
  const TurnedProfile::Range under = profile.samplesUnder(a, b, pass.noseRadius);
  before.clear();
  for (std::size_t i = under.first; i < under.last; ++i) before.push_back(radiusOf(i));
  cut(profile, pass, a, b);
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

double SpindleSetting::at(double radius) const noexcept {
  if (!(surfaceSpeed > 0.0)) return speed;
  const double wanted = spindleSpeed(surfaceSpeed, 2.0 * radius);
  return speed > 0.0 ? std::min(wanted, speed) : wanted;
}

ForcePeakMeter::ForcePeakMeter(const CuttingForceModel& model, const SpindleSetting& spindle, double resolution)
    : m_model(&model), m_spindle(spindle), m_resolution(resolution) {}

void ForcePeakMeter::add(double length, double seconds, double area, double radius) {
  if (!(area > 0.0)) {
    judge();
    m_time += seconds;
    return;
  }
  m_time += seconds;
  m_length += length;
  m_area += area;
  m_radius = std::max(m_radius, radius);
  m_turns += m_spindle.at(radius) / 60.0 * seconds;
  if (m_length >= kSamplesOfACut * m_resolution && m_turns >= 1.0) judge();
}

void ForcePeakMeter::judge() {
  if (m_area > 0.0 && m_length > 0.0) {
    // Per length of the path the area is the width of the cut; per turn the length is the feed.
    const double feed = m_turns > 0.0 ? std::min(m_length / m_turns, kRapidFeed) : kRapidFeed;
    // A cut that ended before it was as long as a sample does not define its width.
    const double length = std::max(m_length, m_resolution);
    const CutConditions cut{m_area / length, feed, handwheel::surfaceSpeed(m_spindle.at(m_radius), 2.0 * m_radius)};
    take(cut, m_radius);
  }
  m_length = m_area = m_turns = m_radius = 0.0;
}

void ForcePeakMeter::addChip(double width, double thickness, double seconds, double radius) {
  judge();
  m_time += seconds;
  take({width, thickness, handwheel::surfaceSpeed(m_spindle.at(radius), 2.0 * radius)}, radius);
}

void ForcePeakMeter::take(const CutConditions& cut, double radius) {
  const CutForces forces = m_model->at(cut);
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

std::optional<ForcePeaks> forcePeaks(TurnedProfile profile, std::span<const TurningPass> passes,
                                     const SpindleSetting& spindle, const CuttingForceModel& model, Progress progress) {
  constexpr std::size_t kLook = 64;      // points between two checks of the cancel flag
  constexpr double kMostParts = 10'000;  // largest number of parts of a move
  ForcePeakMeter meter(model, spindle, profile.spacing());
  std::vector<double> before;
  for (const TurningPass& pass : passes) {
    if (!pass.path.empty()) cut(profile, pass, pass.path[0], pass.path[0]);
    for (std::size_t i = 1; i < pass.path.size(); ++i) {
      if (i % kLook == 0 && progress.cancelled()) return std::nullopt;
      const ProfilePoint from = pass.path[i - 1], displacement = pass.path[i] - from;
      const double seconds = pass.times[i] - pass.times[i - 1], length = displacement.norm();
      const int parts = static_cast<int>(std::clamp(std::ceil(length / kLongestMove), 1.0, kMostParts));
      for (int k = 0; k < parts; ++k) {
        const ProfilePoint a = from + displacement * (static_cast<double>(k) / parts);
        const ProfilePoint b = from + displacement * (static_cast<double>(k + 1) / parts);
        const RemovedSection removed = removedBy(profile, pass, a, b, before);
        meter.add(length / parts, seconds / parts, removed.area, removed.radius);
      }
    }
  }
  return meter.finish();
}

}  // namespace handwheel
