// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/force/KienzleModel.h"

#include "base/Units.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

// Change of kc for each degree of rake; constant beyond ±30°, where there are no tools.
constexpr double kPerDegreeOfRake = 0.01, kMostRake = 30.0;

double rakeFactor(const CuttingEdge& edge) {
  const double degrees = edge.rake.value_or(0.0) / kRadiansPerDegree;
  return 1.0 - kPerDegreeOfRake * std::clamp(degrees, -kMostRake, kMostRake);
}

}  // namespace

KienzleConstants fittedConstants(std::span<const std::pair<double, double>> table) {
  double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const auto& [thickness, kc] : table) {
    x += std::log(thickness);
    y += std::log(kc);
    xx += std::log(thickness) * std::log(thickness);
    xy += std::log(thickness) * std::log(kc);
  }
  const auto n = static_cast<double>(table.size());
  const double slope = (n * xy - x * y) / (n * xx - x * x);
  return {std::exp((y - slope * x) / n), -slope};
}

KienzleModel::KienzleModel(const KienzleConstants& constants, const CuttingEdge& edge, const ThrustSettings& thrust)
    : m_constants(constants),
      m_edge(edge),
      m_thrust(thrust),
      m_thickness(std::sin(edge.approach.value_or(kUsualApproach))) {
  m_cutting.logC = std::log(constants.kc11 * rakeFactor(edge)) - constants.mc * std::log(m_thickness);
  m_cutting.x = 1.0;
  m_cutting.y = 1.0 - constants.mc;
}

CutForces KienzleModel::at(const CutConditions& given) const noexcept {
  const CutConditions cut = bounded(given);
  return cut.depth == 0.0 ? CutForces() : withThrust(m_cutting.at(cut), cut, m_edge, m_thrust);
}

// The rake of a drill is not in the tables: it grows from its axis to its margin.
CutForces KienzleModel::onDrill(const CutConditions& given) const noexcept {
  const CutConditions cut = bounded({given.depth, 0.5 * given.feed, given.speed});
  if (cut.depth == 0.0) return {};
  const double specific = m_constants.kc11 * std::pow(cut.feed * std::sin(kDrillPoint), -m_constants.mc);
  return drillForces(specific * cut.depth * cut.feed);
}

// The tables hold for chips of 0.05 to 2.5 mm (VDI 3206).
bool KienzleModel::covers(const CutConditions& cut) const noexcept {
  const double thickness = cut.feed * m_thickness;
  return cut.depth > 0.0 && thickness >= 0.05 && thickness <= 2.5 && cut.speed > 0.0;
}

}  // namespace handwheel
