// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/ControlPointCut.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kPositionsPerSpan = 4.0;  // positions of the nose per span
constexpr double kMostVisits = 1e8;        // largest number of samples, looked at once for each position of a step
constexpr double kDepthLeft = 1e-12;       // mm; below this depth the nose counts as free
constexpr double kPartsPerSpan = 4.0;      // parts of a depth as large as a span
constexpr double kMostDepthParts = 64.0;   // largest number of parts of a depth at one position
// After its start a nose is deep only beside walls, where few control points are below it: each part but the last,
// whose moves make it free, needs this many.
constexpr std::size_t kMovesAfterStart = 2;

}  // namespace

ControlPointCut::ControlPointCut(const TurnedProfile& profile, double resolution, bool isInParts)
    : m_isInParts(isInParts) {
  const double wanted = std::clamp(std::isfinite(resolution) ? resolution : 1.0, kLeastResolution, kLargestResolution);
  m_spans = static_cast<std::size_t>(std::max(1.0, std::ceil(profile.length() / wanted)));
  m_span = profile.length() / static_cast<double>(m_spans);
}

// Recursion of Cox and de Boor, of degree 2. Pole k has the knots k - 2 to k + 1 in spans, which are clamped to the
// ends.
double ControlPointCut::basis(std::size_t pole, double z) const {
  const double u = std::clamp(z / m_span, 0.0, static_cast<double>(m_spans));
  std::array<double, 4> knots;
  for (std::size_t i = 0; i < 4; ++i) {
    const double position = static_cast<double>(pole + i) - 2.0;
    knots[i] = std::clamp(position, 0.0, static_cast<double>(m_spans));
  }
  const double end = static_cast<double>(m_spans);
  std::array<double, 3> level{};
  for (std::size_t i = 0; i < 3; ++i) {
    const bool isLast = u == end && knots[i + 1] == end;
    level[i] = knots[i] < knots[i + 1] && u >= knots[i] && (u < knots[i + 1] || isLast) ? 1.0 : 0.0;
  }
  for (std::size_t degree = 1; degree <= 2; ++degree) {
    for (std::size_t i = 0; i + degree < 3; ++i) {
      const double low = knots[i + degree] - knots[i], high = knots[i + degree + 1] - knots[i + 1];
      level[i] = (low > 0.0 ? (u - knots[i]) / low * level[i] : 0.0) +
                 (high > 0.0 ? (knots[i + degree + 1] - u) / high * level[i + 1] : 0.0);
    }
  }
  return level[0];
}

std::size_t ControlPointCut::strongest(double z) const {
  const auto span = static_cast<std::size_t>(std::clamp(std::floor(z / m_span), 0.0, static_cast<double>(m_spans - 1)));
  std::size_t best = span;
  for (std::size_t pole = span + 1; pole <= span + 2; ++pole) {
    if (basis(pole, z) > basis(best, z)) best = pole;
  }
  return best;
}

std::size_t ControlPointCut::movesUnder(double noseRadius) const {
  const double poles = std::min(2.0 * noseRadius / m_span, static_cast<double>(m_spans)) + 3.0;
  return static_cast<std::size_t>(std::ceil(poles));
}

// Returns the number of positions of the nose on its path from a to b.
double ControlPointCut::positionsOn(const TurnedProfile& profile, const ProfilePoint& a, const ProfilePoint& b,
                                    double noseRadius) const {
  const double each = std::min(2.0 * noseRadius / profile.spacing() + 1.0, static_cast<double>(profile.size()));
  return std::clamp(std::ceil(kPositionsPerSpan * (b - a).norm() / m_span), 1.0, std::max(1.0, kMostVisits / each));
}

ControlPointCut::Deepest ControlPointCut::deepestUnder(const TurnedProfile& profile, TurningSide side,
                                                       const ProfilePoint& nose, double radius) const {
  const TurnedProfile::Range under = profile.samplesUnder(nose, nose, radius);
  Deepest deepest;
  for (std::size_t i = under.first; i < under.last; ++i) {
    const double along = profile.z(i) - nose.y();
    const double half = std::sqrt(std::max(0.0, radius * radius - along * along));
    const bool isBore = side == TurningSide::Bore;
    // On the far side of the material, or without material, it touches nothing.
    const bool isBeside =
        isBore ? nose.x() - half >= profile.radius(i) : profile.inner(i) > 0.0 && nose.x() + half <= profile.inner(i);
    if (isBeside || !profile.hasMaterial(i)) continue;
    const double low = std::max(nose.x() - half, profile.inner(i)), high = std::min(nose.x() + half, profile.radius(i));
    const double depth = isBore ? high - profile.inner(i) : profile.radius(i) - low;
    if (depth > deepest.depth) deepest = {i, depth};
  }
  return deepest;
}

TurnedProfile::Range ControlPointCut::move(TurnedProfile& profile, TurningSide side, std::size_t pole,
                                           double by) const {
  const double from = (static_cast<double>(pole) - 2.0) * m_span, to = (static_cast<double>(pole) + 1.0) * m_span;
  const double last = static_cast<double>(profile.size() - 1);
  const auto begin = static_cast<std::size_t>(std::clamp(std::floor(from / profile.spacing()), 0.0, last));
  const auto end = static_cast<std::size_t>(std::clamp(std::ceil(to / profile.spacing()), 0.0, last));
  TurnedProfile::Range changed;
  for (std::size_t i = begin; i <= end; ++i) {
    const double change = by * basis(pole, profile.z(i));
    if (!(change > 0.0)) continue;
    // A film that only rounding leaves is not material.
    const double inner = profile.inner(i), outer = profile.radius(i);
    const bool isAll = outer - inner - change <= kDepthLeft;
    const bool isChanged = side == TurningSide::Bore ? profile.limitInner(i, isAll ? outer : inner + change)
                                                     : profile.limitOuter(i, isAll ? inner : outer - change);
    if (isChanged) changed.extend({i, i + 1});
  }
  return changed;
}

// Returns the largest number of parts of a depth after a travel from a free position. A round nose is no deeper there
// than that travel and the flank that it has entered; without a travel it begins, at any depth.
double ControlPointCut::mostPartsAfter(double travel, double noseRadius) const {
  if (!m_isInParts) return 1.0;
  if (travel == 0.0) return kMostDepthParts;
  return std::clamp(std::ceil(kPartsPerSpan * (travel + std::sqrt(2.0 * noseRadius * travel)) / m_span), 1.0,
                    kMostDepthParts);
}

// Applies eq. 5-9 for one position of the nose, until it is free. A control point that removes a depth d at u removes
// up to d / 2 too much beside u: so d is a fraction of the distance of the control points, as if the nose came in
// straight from outside.
TurnedProfile::Range ControlPointCut::cutAt(TurnedProfile& profile, TurningSide side, const ProfilePoint& nose,
                                            double radius, double mostParts, std::size_t movesBefore) const {
  TurnedProfile::Range changed;
  const double depth = deepestUnder(profile, side, nose, radius).depth;
  // A depth that is a whole number of parts but for rounding has that number.
  const double parts = std::clamp(std::ceil(kPartsPerSpan * depth / m_span - 1e-9), 1.0, mostParts);
  const double out = side == TurningSide::Bore ? -depth : depth;
  for (double left = parts - 1.0; left >= 0.0; --left) {
    const ProfilePoint position = nose + ProfilePoint(left / parts * out, 0.0);
    const std::size_t moves = left == 0.0 ? movesUnder(radius) : movesBefore;
    for (std::size_t k = 0; k < moves; ++k) {
      const Deepest deepest = deepestUnder(profile, side, position, radius);
      if (!(deepest.depth > kDepthLeft)) break;
      const double z = profile.z(deepest.sample);
      const std::size_t pole = strongest(z);
      const TurnedProfile::Range moved = move(profile, side, pole, deepest.depth / basis(pole, z));
      if (moved.isEmpty()) break;
      changed.extend(moved);
    }
  }
  return changed;
}

TurnedProfile::Range ControlPointCut::cut(TurnedProfile& profile, TurningSide side, const ProfilePoint& a,
                                          const ProfilePoint& b, double noseRadius) const {
  TurnedProfile::Range changed;
  if (profile.samplesUnder(a, b, noseRadius).isEmpty()) return changed;
  const double positions = positionsOn(profile, a, b, noseRadius);
  const double parts = mostPartsAfter((b - a).norm() / positions, noseRadius);
  changed.extend(cutAt(profile, side, a, noseRadius, mostPartsAfter(0.0, noseRadius), movesUnder(noseRadius)));
  for (int i = 1; i <= static_cast<int>(positions); ++i)
    changed.extend(cutAt(profile, side, a + i / positions * (b - a), noseRadius, parts, kMovesAfterStart));
  return changed;
}

double ControlPointCut::work(const TurnedProfile& profile, const ProfilePoint& a, const ProfilePoint& b,
                             double noseRadius, bool isFree) const {
  const auto under = static_cast<double>(profile.samplesUnder(a, b, noseRadius).size());
  if (under == 0.0) return 0.0;
  const double positions = positionsOn(profile, a, b, noseRadius);
  const double each = std::min(under, 2.0 * noseRadius / profile.spacing() + 1.0) + 3.0 * m_span / profile.spacing();
  const auto moves = static_cast<double>(movesUnder(noseRadius));
  const double travel = (b - a).norm() / positions, first = isFree ? 1.0 : mostPartsAfter(0.0, noseRadius);
  const double parts = travel > 0.0 ? mostPartsAfter(travel, noseRadius) : 1.0;  // already free at the same position
  const double afterStart = static_cast<double>(kMovesAfterStart) * (parts - 1.0) + moves;
  return (first * moves + 1.0 + positions * (afterStart + 1.0)) * each;
}

}  // namespace handwheel
