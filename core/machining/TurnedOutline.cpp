// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/TurnedOutline.h"

#include <algorithm>
#include <optional>

namespace handwheel {

namespace {

using Side = std::vector<ProfilePoint>;

Side outerSide(const TurnedProfile& profile, std::size_t first, std::size_t last) {
  Side side;
  side.reserve(last - first + 1);
  for (std::size_t i = first; i <= last; ++i) side.emplace_back(profile.radius(i), profile.z(i));
  return side;
}

// Returns the inner side upwards; reversed if the outline runs down.
Side innerSide(const TurnedProfile& profile, std::size_t first, std::size_t last) {
  Side side;
  side.reserve(last - first + 1);
  for (std::size_t i = first; i <= last; ++i) side.emplace_back(profile.inner(i), profile.z(i));
  return side;
}

Side turnedRound(Side side) {
  std::reverse(side.begin(), side.end());
  return side;
}

std::optional<std::size_t> firstSolid(const TurnedProfile& profile, std::size_t first, std::size_t last) {
  for (std::size_t i = first; i <= last; ++i) {
    if (!(profile.inner(i) > 0.0)) return i;
  }
  return std::nullopt;
}

// Returns the cavities between two solid samples.
std::vector<Side> cavitiesBetween(const TurnedProfile& profile, std::size_t first, std::size_t last) {
  std::vector<Side> cavities;
  for (std::size_t i = first + 1; i < last; ++i) {
    if (!(profile.inner(i) > 0.0)) continue;
    std::size_t end = i;
    while (profile.inner(end) > 0.0) ++end;
    cavities.push_back(innerSide(profile, i - 1, end));
    i = end;
  }
  return cavities;
}

TurnedOutline outlineOf(const TurnedProfile& profile, std::size_t first, std::size_t last) {
  TurnedOutline outline;
  const std::optional<std::size_t> low = firstSolid(profile, first, last);
  if (!low) {
    outline.sides = {outerSide(profile, first, last), turnedRound(innerSide(profile, first, last))};
    outline.isClosed = true;
    return outline;
  }
  std::size_t high = last;
  while (profile.inner(high) > 0.0) --high;
  if (*low > first) outline.sides.push_back(turnedRound(innerSide(profile, first, *low)));
  outline.sides.push_back(outerSide(profile, first, last));
  if (high < last) outline.sides.push_back(turnedRound(innerSide(profile, high, last)));
  if (profile.isBored()) outline.cavities = cavitiesBetween(profile, *low, high);
  return outline;
}

}  // namespace

// A piece tapers to the samples without material beside it.
std::vector<TurnedOutline> outlinesOf(const TurnedProfile& profile) {
  std::vector<TurnedOutline> outlines;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    if (!profile.hasMaterial(i)) continue;
    std::size_t last = i;
    while (last + 1 < profile.size() && profile.hasMaterial(last + 1)) ++last;
    outlines.push_back(outlineOf(profile, i > 0 ? i - 1 : 0, std::min(last + 1, profile.size() - 1)));
    i = last;
  }
  return outlines;
}

}  // namespace handwheel
