// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/measure/RoughnessGrade.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace handwheel {

namespace {

constexpr std::array<double, 12> kGradeRoughness = {0.025, 0.05, 0.1, 0.2, 0.4, 0.8, 1.6, 3.2, 6.3, 12.5, 25.0, 50.0};

}  // namespace

std::optional<double> roughnessOf(std::string_view grade) {
  if (grade.size() < 2 || grade.size() > 3 || grade[0] != 'N') return std::nullopt;
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(grade.data() + 1, grade.data() + grade.size(), number);
  if (error != std::errc() || end != grade.data() + grade.size()) return std::nullopt;
  if (number < 1 || number > kGradeRoughness.size()) return std::nullopt;
  return kGradeRoughness[number - 1];
}

std::string roughnessGrade(double ra) {
  for (std::size_t i = 0; i < kGradeRoughness.size(); ++i) {
    if (ra <= kGradeRoughness[i]) return "N" + std::to_string(i + 1);
  }
  return {};
}

double drilledRoughness(double feed) {
  constexpr double kFinest = 1.6, kRoughest = 6.3;                  // µm
  constexpr double kLeastRatedFeed = 0.05, kMostRatedFeed = 0.381;  // mm
  if (!(feed > 0.0)) return 0.0;
  if (!std::isfinite(feed)) return feed;  // the spindle stands
  const double share = std::log(feed / kLeastRatedFeed) / std::log(kMostRatedFeed / kLeastRatedFeed);
  return kFinest * std::pow(kRoughest / kFinest, std::clamp(share, 0.0, 1.0));
}

double idealRoughness(double feed, double noseRadius) {
  constexpr double kMicrometres = 1e3;  // a mm
  if (feed == 0.0) return 0.0;
  const bool hasCusps = feed <= 2.0 * noseRadius;  // otherwise the nose leaves a ridge of the previous surface
  if (!(noseRadius > 0.0 && hasCusps)) return std::numeric_limits<double>::infinity();
  return kMicrometres * feed * feed / (32.0 * noseRadius);
}

}  // namespace handwheel
