// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/RapidConfiguration.h"

#include "robot/posts/ControllerConfiguration.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kQuarter = 0.5 * M_PI;
constexpr std::array<Eigen::Index, 3> kQuarterJoints{0, 3, 5};
constexpr double kQuarterSlack = 1e-3;  // rad: within this of the end of a quarter turn an axis may be in either

// off: tolerance of the value; rad.
bool isInQuarter(double value, int quarter, double off) {
  const double slack = kQuarterSlack + off;
  return value >= kQuarter * quarter - slack && value <= kQuarter * (quarter + 1) + slack;
}

// Compares cfx, with the sign of axis 5 within the rounding of files.
bool hasCfx(int wanted, const SerialArm& arm, const ArmValues& values) {
  if (hasParallelLinkage(arm)) return !controllerConfigurationOf(arm, values).isElbowDown;
  const int different = wanted ^ rapidConfigurationOf(arm, values).cfx;
  return different == 0 || (different == 1 && isWristInLine(values));
}

}  // namespace

std::string RapidConfiguration::text() const {
  std::string text = "[";
  for (const int quarter : quarters) text += std::to_string(quarter) + ",";
  return text + std::to_string(cfx) + "]";
}

RapidConfiguration rapidConfigurationOf(const SerialArm& arm, const ArmValues& values) {
  RapidConfiguration configuration;
  for (std::size_t i = 0; i < kQuarterJoints.size(); ++i)
    configuration.quarters[i] = static_cast<int>(std::floor(values[kQuarterJoints[i]] / kQuarter));
  if (hasParallelLinkage(arm)) return configuration;
  const ControllerConfiguration how = controllerConfigurationOf(arm, values);
  configuration.cfx = (how.isRear ? 4 : 0) + (how.isElbowDown ? 2 : 0) + (how.isFlipped ? 1 : 0);
  return configuration;
}

std::optional<RapidConfiguration> rapidConfigurationFrom(std::span<const double> numbers) {
  constexpr double kMostQuarters = 1e6;
  constexpr int kConfigurations = 8;
  const auto isCount = [](double number) { return std::abs(number) < kMostQuarters && number == std::floor(number); };
  if (numbers.size() != 4 || !std::ranges::all_of(numbers, isCount)) return std::nullopt;
  const RapidConfiguration configuration{
      {static_cast<int>(numbers[0]), static_cast<int>(numbers[1]), static_cast<int>(numbers[2])},
      static_cast<int>(numbers[3])};
  if (configuration.cfx < 0 || configuration.cfx >= kConfigurations) return std::nullopt;
  return configuration;
}

bool hasConfiguration(const RapidConfiguration& wanted, const SerialArm& arm, const ArmValues& values) {
  if (!hasCfx(wanted.cfx, arm, values)) return false;
  for (std::size_t i = 0; i < kQuarterJoints.size(); ++i) {
    const Eigen::Index joint = kQuarterJoints[i];
    if (joint != 0 && isWristInLine(values)) continue;
    if (!isInQuarter(values[joint], wanted.quarters[i], jointRounding(values, joint))) return false;
  }
  return true;
}

std::optional<ArmValues> jointsWith(const RapidConfiguration& wanted, const SerialArm& arm, const ClosedFormIk& closed,
                                    const Pose& tip, const ArmValues& reference) {
  const WantedConfiguration conditions{
      [&](Eigen::Index i, double value, double off) {
        const auto at = std::ranges::find(kQuarterJoints, i);
        return at == kQuarterJoints.end() ||
               isInQuarter(value, wanted.quarters[static_cast<std::size_t>(at - kQuarterJoints.begin())], off);
      },
      [&](const ArmValues& values) { return hasCfx(wanted.cfx, arm, values); }};
  // If two axes are in line, the first may have any share of their rotation, which the solution takes from the
  // reference. It suffices to try the ends of its quarter: if the other axis can be within a quarter of its own, too,
  // it is so at one of them.
  const auto within = [&](ArmValues values, int end) {
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
      double& value = values[kQuarterJoints[i]];
      const double lower = kQuarter * wanted.quarters[i], upper = lower + kQuarter;
      value = end < 0 ? lower : end > 0 ? upper : std::clamp(value, lower, upper);
    }
    return values;
  };
  return jointsOfConfiguration(conditions, arm, closed, tip,
                               std::array{within(reference, 0), within(reference, -1), within(reference, 1)});
}

}  // namespace handwheel
