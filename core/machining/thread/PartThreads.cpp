// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/thread/PartThreads.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

std::shared_ptr<const PartThreads> PartThreads::of(const TurningPasses& passes) {
  PartThreads all;
  for (const auto& pass : passes) {
    if (pass->thread) all.add(*pass);
  }
  return all.m_grooves.empty() ? nullptr : std::make_shared<const PartThreads>(std::move(all));
}

std::shared_ptr<const PartThreads> PartThreads::with(const std::shared_ptr<const PartThreads>& before,
                                                     const TurningPass& pass) {
  PartThreads all = before ? *before : PartThreads();
  all.add(pass);
  return all.m_grooves.empty() ? nullptr : std::make_shared<const PartThreads>(std::move(all));
}

void PartThreads::add(const TurningPass& pass) {
  for (ThreadGroove& groove : ThreadGroove::of(pass)) {
    const bool isKnown = std::any_of(m_grooves.begin(), m_grooves.end(),
                                     [&](const ThreadGroove& other) { return groove.isWithin(other); });
    if (isKnown) continue;
    std::erase_if(m_grooves, [&](const ThreadGroove& other) { return other.isWithin(groove); });
    if (m_grooves.size() >= kMostGrooves) return;
    (groove.side() == TurningSide::Bore ? m_isBore : m_isOutside) = true;
    m_grooves.push_back(std::move(groove));
  }
}

const ThreadGroove* PartThreads::between(TurningSide side, double low, double high, double radiusLow,
                                         double radiusHigh) const {
  for (const ThreadGroove& groove : m_grooves) {
    if (groove.side() != side) continue;
    const double reach = groove.cut().pitch + ThreadGroove::kRunOut * groove.cut().lead();
    if (high < groove.from() - reach || low > groove.to() + reach) continue;
    const bool isCut = side == TurningSide::Bore ? std::min(radiusLow, radiusHigh) < groove.deepest()
                                                 : std::max(radiusLow, radiusHigh) > groove.deepest();
    if (isCut) return &groove;
  }
  return nullptr;
}

double PartThreads::radius(TurningSide side, double radius, double otherSide, double z, double angle) const {
  double cut = radius;
  for (const ThreadGroove& groove : m_grooves) {
    if (groove.side() != side) continue;
    const double reach = groove.cut().pitch + ThreadGroove::kRunOut * groove.cut().lead();
    if (z < groove.from() - reach || z > groove.to() + reach) continue;
    cut = side == TurningSide::Bore ? std::max(cut, groove.radius(z, angle)) : std::min(cut, groove.radius(z, angle));
  }
  // A hundredth of the wall stays; with threads on both sides each may take half of the wall.
  const double left = m_isOutside && m_isBore ? 0.5 : 0.01;
  const double deepest = std::lerp(otherSide, radius, left);
  return side == TurningSide::Bore ? std::min(cut, deepest) : std::max(cut, deepest);
}

// The mean over a turn, by the rectangle rule, which is exact for periodic functions in the limit.
double PartThreads::volume(const TurnedProfile& profile, double low, double high) const {
  constexpr int kAngles = 32;
  constexpr double kSteps = 96.0;  // samples along a pitch
  double least = ThreadCut::kLargestPitch;
  for (const ThreadGroove& groove : m_grooves) least = std::min(least, groove.cut().pitch);
  const auto parts = std::max(1, static_cast<int>(std::ceil(profile.spacing() * kSteps / least)));
  double sum = 0.0;
  for (const TurningSide side : {TurningSide::Outside, TurningSide::Bore}) {
    const bool isBore = side == TurningSide::Bore;
    if (!(isBore ? m_isBore : m_isOutside)) continue;
    const auto own = [&](std::size_t i) { return isBore ? profile.inner(i) : profile.radius(i); };
    const auto other = [&](std::size_t i) { return isBore ? profile.radius(i) : profile.inner(i); };
    for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
      if (profile.z(i) < low || profile.z(i) > high) continue;
      if (!between(side, profile.z(i), profile.z(i + 1), own(i), own(i + 1))) continue;
      for (int k = 0; k < parts * kAngles; ++k) {
        const double t = (k / kAngles + 0.5) / parts, angle = 2.0 * M_PI * (k % kAngles) / kAngles;
        const double here = std::lerp(own(i), own(i + 1), t), beyond = std::lerp(other(i), other(i + 1), t);
        const double cut = radius(side, here, beyond, profile.z(i) + t * profile.spacing(), angle);
        sum += std::abs(here * here - cut * cut) * M_PI * profile.spacing() / (parts * kAngles);
      }
    }
  }
  return sum;
}

}  // namespace handwheel
