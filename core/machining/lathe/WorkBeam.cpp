// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/lathe/WorkBeam.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

double fourthPower(double r) {
  return r * r * r * r;
}

}  // namespace

WorkBeam::WorkBeam(const TurnedProfile& part, double grip) : m_grip(grip), m_sums(1) {
  const double first = std::clamp(std::ceil(grip / part.spacing()), 0.0, static_cast<double>(part.size()));
  m_first = static_cast<std::size_t>(first);
  m_end = m_first;
  while (m_end < part.size() && part.hasMaterial(m_end)) ++m_end;
}

// Material only leaves, so the end of the held material only comes nearer to the jaws.
void WorkBeam::change(const TurnedProfile& part, const TurnedProfile::Range& changed) {
  if (changed.isEmpty()) return;
  for (std::size_t i = std::max(changed.first, m_first); i < std::min(changed.last, m_end); ++i)
    if (!part.hasMaterial(i)) m_end = i;
  const std::size_t kept = changed.first > m_first ? changed.first - m_first : 0;
  if (kept + 1 < m_sums.size()) m_sums.resize(kept + 1);
}

void WorkBeam::sumUpTo(const TurnedProfile& part, std::size_t end) {
  for (std::size_t i = m_first + m_sums.size() - 1; i < end; ++i) {
    Sums sums = m_sums.back();
    const double s = part.z(i) - m_grip;
    const double soft = 1.0 / (fourthPower(part.radius(i)) - fourthPower(part.inner(i)));
    sums.count += 1.0;
    sums.first += s;
    sums.second += s * s;
    sums.soft += soft;
    sums.softFirst += soft * s;
    sums.softSecond += soft * s * s;
    m_sums.push_back(sums);
  }
}

SlenderWork WorkBeam::at(const TurnedProfile& part, double position) {
  SlenderWork beam;
  beam.diameter = beam.length = beam.position = 0.0;
  if (m_first == m_end) return beam;
  beam.length = part.z(m_end - 1) - m_grip;
  beam.position = std::clamp(position - m_grip, 0.0, beam.length);
  const double samples = std::floor((beam.position + m_grip) / part.spacing() + 1e-9);
  const std::size_t last = std::clamp(static_cast<std::size_t>(samples), m_first, m_end - 1);
  sumUpTo(part, last + 1);
  const Sums& sums = m_sums[last + 1 - m_first];
  const double arm = beam.position + 0.5 * part.spacing();
  const double weight = arm * arm * sums.count - 2.0 * arm * sums.first + sums.second;
  const double compliance = arm * arm * sums.soft - 2.0 * arm * sums.softFirst + sums.softSecond;
  const bool isBent = beam.position > 0.0 && compliance > 0.0;
  beam.diameter = isBent ? 2.0 * std::pow(weight / compliance, 0.25) : 2.0 * part.radius(last);
  return beam;
}

SlenderWork beamOf(const TurnedProfile& part, double grip, double position) {
  return WorkBeam(part, grip).at(part, position);
}

}  // namespace handwheel
