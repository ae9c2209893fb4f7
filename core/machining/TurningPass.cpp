// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/TurningPass.h"

#include <algorithm>

namespace handwheel {

namespace {

const ProfilePoint& pointBefore(const TurningPass& pass, std::size_t i) {
  return pass.path[i == 0 ? 0 : i - 1];
}

}  // namespace

TurnedProfile::Range cut(TurnedProfile& profile, const TurningPass& pass, Progress progress) {
  constexpr std::size_t kLook = 256;  // points between two looks at the cancel flag
  TurnedProfile::Range changed;
  for (std::size_t i = 0; i < pass.path.size(); ++i) {
    if (i % kLook == 0) {
      if (progress.cancelled()) break;
      progress.set(static_cast<double>(i) / static_cast<double>(pass.path.size()));
    }
    changed.extend(profile.cut(pointBefore(pass, i), pass.path[i], pass.noseRadius));
  }
  return changed;
}

std::uint64_t samplesUnder(const TurnedProfile& profile, const TurningPass& pass) {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < pass.path.size(); ++i)
    sum += profile.samplesUnder(pointBefore(pass, i), pass.path[i], pass.noseRadius).size();
  return sum;
}

}  // namespace handwheel
