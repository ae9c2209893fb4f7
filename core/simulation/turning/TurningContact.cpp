// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/turning/TurningContact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace handwheel {

namespace {
constexpr int kHalvings = 12;  // leaves a 4000th of the distance to the material
// share of the nose radius: distance ahead of the tool at which the chip is measured
constexpr double kChipAhead = 0.1;
constexpr double kLeastChip = 0.05;  // mm: a tool that scrapes is not free, either
}  // namespace

template <class Visit>
void ProfilePatch::forEachBelow(const ProfilePoint& centre, double radius, const Visit& visit) const {
  const double first = std::ceil((centre.y() - radius - width - z) / spacing);
  const double last = std::floor((centre.y() + radius - z) / spacing);
  const auto begin = static_cast<std::int64_t>(std::max(first, 0.0));
  const auto end = static_cast<std::int64_t>(std::min(last, static_cast<double>(count) - 1.0));
  for (std::int64_t i = begin; i <= end; ++i) {
    const double from = z + spacing * static_cast<double>(i);
    visit(radii[static_cast<std::size_t>(i)], std::clamp(centre.y(), from, from + width) - centre.y());
  }
}

double ProfilePatch::penetration(const ProfilePoint& centre, double radius) const {
  double deepest = -radius;
  if (isOnFarSide(centre, radius)) return deepest;
  forEachBelow(centre, radius, [&](double top, double offset) {
    const double low = centre.x() - std::sqrt(std::max(radius * radius - offset * offset, 0.0));
    deepest = std::max(deepest, top - low);
  });
  return deepest;
}

double ProfilePatch::chipWidth(const ProfilePoint& centre, double radius, const ProfilePoint& ahead) const {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  forEachBelow(centre, radius, [&](double top, double offset) {
    const double half = std::sqrt(std::max(radius * radius - offset * offset, 0.0));
    if (!(top > centre.x() - half)) return;
    for (const double x : {-half, std::min(top - centre.x(), half)}) {
      const double across = ahead.x() * offset - ahead.y() * x;
      least = std::min(least, across);
      most = std::max(most, across);
    }
  });
  return std::max(0.0, most - least);
}

ProfilePatch patchAround(const TurnedProfile& profile, double z, double noseRadius, TurningSide side,
                         const PatchThreads& threads) {
  const bool isBore = side == TurningSide::Bore;
  const auto surface = [&](std::size_t i) {
    const double own = isBore ? profile.inner(i) : profile.radius(i);
    if (!threads.threads) return own;
    const double other = isBore ? profile.radius(i) : profile.inner(i);
    return threads.threads->radius(side, own, other, profile.z(i), threads.angle);
  };
  const double last = static_cast<double>(profile.size() - 1);
  const double half = 2.0 * noseRadius / profile.spacing() + 1.0, middle = z / profile.spacing();
  const auto begin = static_cast<std::size_t>(std::clamp(std::ceil(middle - half), 0.0, last));
  const auto end = static_cast<std::size_t>(std::clamp(std::floor(middle + half), 0.0, last));
  const std::size_t stride = (end - begin) / ProfilePatch::kMost + 1;
  ProfilePatch patch;
  patch.spacing = profile.spacing() * static_cast<double>(stride);
  patch.width = profile.spacing() * static_cast<double>(stride - 1);
  patch.z = profile.z(begin);
  double farSide = std::numeric_limits<double>::infinity();
  for (std::size_t i = begin; i <= end; i += stride) {
    double highest = -std::numeric_limits<double>::infinity();
    for (std::size_t j = i; j <= std::min(i + stride - 1, end); ++j) {
      highest = std::max(highest, sideways(side, surface(j)));
      farSide = std::min(farSide, isBore ? -profile.radius(j) : profile.inner(j));
    }
    patch.radii[patch.count++] = highest;
  }
  patch.farSide = farSide;
  return patch;
}

void TurningContact::reset(const ProfilePoint& hand) {
  *this = TurningContact();
  m_tool = hand;
}

bool TurningContact::follow(const ProfilePatch& patch, const TurningTool& tool, const ProfilePoint& hand,
                            bool isCutting, double dt) {
  const auto depth = [&](const ProfilePoint& p) { return patch.penetration(p, tool.noseRadius); };
  const double there = depth(hand);
  const bool isOnFarSide = patch.isOnFarSide(hand, tool.noseRadius);
  if (std::exchange(m_isOnFarSide, isOnFarSide) && !isOnFarSide) m_unfelt = std::max(0.0, there);
  if (std::exchange(m_simulation, patch.simulation) != patch.simulation) m_unfelt = there - m_depth;
  m_unfelt = std::max(0.0, std::min(m_unfelt, there));
  m_depth = std::max(0.0, there - m_unfelt);
  // Motion out of the material is free, even through material that the simulation has yet to remove.
  if (!(there > 0.0) || (isCutting && there <= depth(m_tool))) {
    m_tool = hand;
    return false;
  }
  if (!isCutting) {  // lies on the material, straight outward from the hand
    m_tool = hand + ProfilePoint(m_depth, 0.0);
    return m_depth > 0.0;
  }
  if (!(depth(m_tool) > 0.0)) {  // up to the material at once
    double clear = 0.0, inside = 1.0;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (clear + inside);
      (depth(m_tool + middle * (hand - m_tool)) > 0.0 ? inside : clear) = middle;
    }
    m_tool += clear * (hand - m_tool);
  }
  const ProfilePoint ahead = (hand - m_tool).normalized();
  const double reach = std::max(kChipAhead * tool.noseRadius, patch.spacing);
  const double chip = std::max(kLeastChip, patch.chipWidth(m_tool + reach * ahead, tool.noseRadius, ahead));
  m_tool += -std::expm1(-dt * tool.stiffness / (tool.resistance * chip)) * (hand - m_tool);
  return true;
}

}  // namespace handwheel
