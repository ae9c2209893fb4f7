// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/thread/ThreadCut.h"

namespace handwheel {

bool ThreadCut::isSound() const {
  const auto isBetween = [](double value, double least, double largest) { return value >= least && value <= largest; };
  return isBetween(pitch, kLeastPitch, kLargestPitch) && starts >= 1 && starts <= kMostStarts &&
         isBetween(angle, kLeastAngle, kLargestAngle) && isBetween(flat, 0.0, pitch) && std::isfinite(offset);
}

// A circle of the nose's radius, tangent to both flanks and to the bottom.
double ThreadCut::heightAt(double distance, double noseRadius) const {
  const double beside = std::abs(distance) - 0.5 * flat;
  if (!(beside > 0.0)) return 0.0;
  const double half = 0.5 * angle;
  const double tangent = noseRadius * std::cos(half);  // mm, where the circle ends
  if (beside <= tangent) return noseRadius - std::sqrt(noseRadius * noseRadius - beside * beside);
  return noseRadius * (1.0 - std::sin(half)) + (beside - tangent) / std::tan(half);
}

double ThreadCut::distanceAt(double height, double noseRadius) const {
  const double half = 0.5 * angle;
  const double tangent = noseRadius * (1.0 - std::sin(half));
  if (height <= tangent) return 0.5 * flat + std::sqrt(height * (2.0 * noseRadius - height));
  return 0.5 * flat + noseRadius * std::cos(half) + (height - tangent) * std::tan(half);
}

}  // namespace handwheel
