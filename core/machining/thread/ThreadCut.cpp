// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/thread/ThreadCut.h"

namespace handwheel {

bool ThreadCut::isSound() const {
  const auto isBetween = [](double value, double least, double largest) { return value >= least && value <= largest; };
  return isBetween(pitch, kLeastPitch, kLargestPitch) && starts >= 1 && starts <= kMostStarts &&
         isBetween(angle, kLeastAngle, kLargestAngle) && isBetween(flat, 0.0, pitch) && std::isfinite(offset);
}

double ThreadCut::distanceAt(double height, double noseRadius) const {
  const double half = 0.5 * angle;
  const double tangent = noseRadius * (1.0 - std::sin(half));
  if (height <= tangent) return 0.5 * flat + std::sqrt(height * (2.0 * noseRadius - height));
  return 0.5 * flat + noseRadius * std::cos(half) + (height - tangent) * std::tan(half);
}

ThreadEdge::ThreadEdge(const ThreadCut& cut, double noseRadius)
    : m_halfFlat(0.5 * cut.flat),
      m_nose(noseRadius),
      m_tangent(noseRadius * std::cos(0.5 * cut.angle)),
      m_atTangent(noseRadius * (1.0 - std::sin(0.5 * cut.angle))),
      m_slope(std::tan(0.5 * cut.angle)) {}

double ThreadEdge::heightAt(double distance) const {
  const double beside = std::abs(distance) - m_halfFlat;
  if (!(beside > 0.0)) return 0.0;
  if (beside <= m_tangent) return m_nose - std::sqrt(m_nose * m_nose - beside * beside);
  return m_atTangent + (beside - m_tangent) / m_slope;
}

}  // namespace handwheel
