// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/force/KosilovaModel.h"

#include <cmath>

namespace handwheel {

namespace {

constexpr double kNewtonPerForce = 10.0;  // newton in the handbook's kgf

double materialFactor(const KosilovaRow& row, const KosilovaLaw& law, double property) {
  return row.reference > 0.0 && property > 0.0 ? std::pow(property / row.reference, law.materialExponent) : 1.0;
}

PowerLaw powerLawOf(const KosilovaLaw& law, double correction) {
  return {std::log(kNewtonPerForce * law.c * correction), law.x, law.y, law.n};
}

}  // namespace

KosilovaModel::KosilovaModel(const KosilovaTables& tables, const KosilovaRow& row, double property,
                             const CuttingEdge& edge, const ThrustSettings& thrust)
    : m_edge(edge), m_thrust(thrust) {
  const EdgeFactors factors = tables.factorsOf(edge);
  m_correction = factors.cutting * materialFactor(row, row.cutting, property);
  m_hasThrustLaws = thrust.law == ThrustLaw::Table && row.radial.isGiven() && row.feed.isGiven();
  m_isVerified = row.cutting.isVerified && factors.isVerified;
  m_cutting = powerLawOf(row.cutting, m_correction);
  if (!m_hasThrustLaws) return;
  m_radial = powerLawOf(row.radial, factors.radial * materialFactor(row, row.radial, property));
  m_feed = powerLawOf(row.feed, factors.feed * materialFactor(row, row.feed, property));
}

CutForces KosilovaModel::at(const CutConditions& given) const noexcept {
  const CutConditions cut = bounded(given);
  if (cut.depth == 0.0) return {};
  const double cutting = m_cutting.at(cut);
  if (m_hasThrustLaws) return {cutting, m_feed.at(cut), m_radial.at(cut)};
  return withThrust(cutting, cut, m_edge, m_thrust);
}

// The handbook gives no limits; these are the ones of its tables of feeds, depths and speeds for turning.
bool KosilovaModel::covers(const CutConditions& cut) const noexcept {
  return cut.depth >= 0.1 && cut.depth <= 12.0 && cut.feed >= 0.05 && cut.feed <= 2.0 && cut.speed >= 10.0 &&
         cut.speed <= 600.0;
}

}  // namespace handwheel
