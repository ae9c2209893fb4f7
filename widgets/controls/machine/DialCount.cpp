// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/machine/DialCount.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kTenth = 0.1;       // part of a division: the finest that a person sets
constexpr double kSameTenth = 0.01;  // part of a tenth: anything as near as that is on it

// Returns the rest of a floor division, for both signs.
double restOf(double count, double whole) {
  const double rest = count - whole * std::floor(count / whole);
  return rest >= 0.0 && rest < whole ? rest : 0.0;  // a count too large to have a rest has none
}

double onTenth(double divisions) {
  const double tenths = divisions / kTenth, nearest = std::round(tenths);
  return std::abs(tenths - nearest) <= kSameTenth ? nearest / 10.0 : divisions;
}

}  // namespace

void DialCount::setValue(double mm) {
  if (std::isfinite(mm)) m_value = mm;
}

void DialCount::setZero(double mm) {
  if (std::isfinite(mm)) m_zero = mm;
}

void DialCount::setDivisions(int perTurn, double mmPerDivision) {
  if (!std::isfinite(mmPerDivision) || mmPerDivision <= 0.0) return;
  m_perTurn = std::clamp(perTurn, 1, kMostDivisions);
  m_mmPerDivision = mmPerDivision;
}

double DialCount::divisions() const {
  return onTenth(reading() / m_mmPerDivision);
}

double DialCount::turns() const {
  return std::floor(divisions() / m_perTurn);
}

double DialCount::restOfTurn() const {
  return restOf(divisions(), m_perTurn);
}

double DialCount::wheelDegrees() const {
  return restOf(onTenth(m_value / m_mmPerDivision), m_perTurn) * 360.0 / m_perTurn;
}

double DialCount::after(double tenths) const {
  const double here = reading() / m_mmPerDivision / kTenth, nearest = std::round(here);
  if (std::abs(here - nearest) > kSameTenth) return m_value + tenths * kTenth * m_mmPerDivision;
  return m_zero + (nearest + tenths) / 10.0 * m_mmPerDivision;
}

}  // namespace handwheel
