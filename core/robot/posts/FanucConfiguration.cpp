// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/FanucConfiguration.h"

#include "robot/posts/ControllerConfiguration.h"
#include "robot/posts/PostText.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr std::array<Eigen::Index, 3> kTurningJoints{0, 3, 5};

int turnsOf(double value) {
  const int turns = static_cast<int>(std::floor((std::abs(value) + M_PI) / (2.0 * M_PI)));
  return value < 0.0 ? -turns : turns;
}

}  // namespace

std::string FanucConfiguration::text() const {
  std::string text = std::string(isFlipped ? "F" : "N") + (isUp ? " U" : " D") + (isBack ? " B" : " T");
  for (const int each : turns) text += ", " + std::to_string(each);
  return text;
}

FanucConfiguration fanucConfigurationOf(const SerialArm& arm, const ArmValues& values) {
  const ControllerConfiguration how = controllerConfigurationOf(arm, values);
  FanucConfiguration configuration{values[4] > 0.0, !how.isElbowDown, how.isRear, {}};
  for (std::size_t i = 0; i < kTurningJoints.size(); ++i) configuration.turns[i] = turnsOf(values[kTurningJoints[i]]);
  return configuration;
}

std::optional<FanucConfiguration> fanucConfigurationFrom(std::string_view position) {
  constexpr std::string_view kName = "CONFIG";
  const std::size_t at = position.find(kName);
  if (at == position.npos) return std::nullopt;
  LineReader line(position.substr(at + kName.size()), 0);
  if (!line.take(":") || !line.take("'")) return std::nullopt;
  const auto isFirst = [&](const char* one, const char* other) -> std::optional<bool> {
    if (line.takeWord(one)) return true;
    return line.takeWord(other) ? std::optional(false) : std::nullopt;
  };
  const auto isFlipped = isFirst("F", "N"), isUp = isFirst("U", "D"), isBack = isFirst("B", "T");
  if (!isFlipped || !isUp || !isBack) return std::nullopt;
  FanucConfiguration configuration{*isFlipped, *isUp, *isBack, {}};
  for (int& turns : configuration.turns) {
    constexpr double kMostTurns = 9.0;  // one digit
    const auto number = line.take(",") ? line.number() : std::nullopt;
    if (!number || *number != std::floor(*number) || !(std::abs(*number) <= kMostTurns)) return std::nullopt;
    turns = static_cast<int>(*number);
  }
  return configuration;
}

std::optional<ArmValues> jointsWith(const FanucConfiguration& wanted, const SerialArm& arm, const ClosedFormIk& closed,
                                    const Pose& tip, const ArmValues& reference) {
  const auto takesJoint = [&](Eigen::Index i, double value, double off) {
    const auto at = std::ranges::find(kTurningJoints, i);
    if (at == kTurningJoints.end()) return true;
    const int turns = wanted.turns[static_cast<std::size_t>(at - kTurningJoints.begin())];
    return std::abs(value - 2.0 * M_PI * turns) <= M_PI + off;
  };
  const auto takes = [&](const ArmValues& values) {
    const FanucConfiguration now = fanucConfigurationOf(arm, values);
    return now.isUp == wanted.isUp && now.isBack == wanted.isBack &&
           (now.isFlipped == wanted.isFlipped || isWristInLine(values));
  };
  // If two axes are in line, the solution has the first from the reference, and the other is in any of its turns.
  ArmValues within = reference;
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    double& value = within[kTurningJoints[i]];
    const double middle = 2.0 * M_PI * wanted.turns[i];
    value = std::clamp(value, middle - M_PI, middle + M_PI);
  }
  return jointsOfConfiguration({takesJoint, takes}, arm, closed, tip, std::array{within});
}

}  // namespace handwheel
