// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/workpiece/LatheChips.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr int kPerCoil = 16;                           // points
constexpr double kLeastCoils = 1.5, kMostCoils = 6.0;  // coils
constexpr double kCoilsPerWidth = 1.5;                 // coils per mm of depth
constexpr double kTightest = 0.6;                      // mm, radius of a coil
constexpr double kRadiusPerFeed = 8.0;                 // mm for each mm in a turn: a thick chip curls less
constexpr double kWidest = 4.0;                        // mm, radius of a coil

}  // namespace

std::vector<std::vector<Vec3>> chipCurl(const LatheLoad& load, const Vec3& tip, double turns) {
  if (!load.isCutting || !(load.cut.depth > 0.0) || !tip.allFinite()) return {};
  const double coils = std::min(kLeastCoils + kCoilsPerWidth * load.cut.depth, kMostCoils);
  const double radius = std::min(kTightest + kRadiusPerFeed * load.cut.feed, kWidest);
  const Vec3 out = Vec3(1.0, 1.2, 0.0).normalized();  // over the rake, away from the axis and up
  const Vec3 side = Vec3::UnitZ(), up = out.cross(side).normalized();
  const double run = 2.0 * M_PI * (turns - std::floor(turns));
  std::vector<Vec3> curl;
  const int points = static_cast<int>(std::ceil(coils * kPerCoil));
  for (int i = 0; i <= points; ++i) {
    const double angle = 2.0 * M_PI * i / kPerCoil, share = std::min(1.0, 2.0 * i / points);
    const double r = radius * share;
    const Vec3 coil = r * (std::cos(angle - run) * side + std::sin(angle - run) * up);
    curl.push_back(tip + coil + 0.35 * radius * angle / M_PI * out);
  }
  return {curl};
}

}  // namespace handwheel
