// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/path/WaitingTime.h"

#include "base/NumberText.h"
#include "robot/posts/PostText.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace handwheel {

namespace {

// Returns the number at the beginning of a text, s; none if another expression is there.
std::optional<double> secondsAt(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t("), text.size()));
  const std::size_t length = std::min(text.find_first_not_of("0123456789.e"), text.size());
  const std::size_t rest = text.find_first_not_of(" \t", length);
  constexpr std::string_view kEnds = ");(";
  if (rest != text.npos && kEnds.find(text[rest]) == kEnds.npos) return std::nullopt;
  double seconds = 0.0;
  ErrorCode why = ErrorCode::NumberMalformed;
  std::string number(text.substr(0, length));
  if (number.starts_with('.')) number.insert(0, "0");
  const bool isNumber = parseDecimal(number, seconds, why) && std::isfinite(seconds);
  return isNumber && seconds >= 0.0 && seconds <= ProgramMotion::kLongest ? std::optional(seconds) : std::nullopt;
}

void addWaits(const std::vector<ProgramLine>& lines, WaitingTime& waiting) {
  constexpr std::array<std::string_view, 7> kOthers = {"wait", "halt", "stop", "pause", "popup", "abort", "exit"};
  for (const ProgramLine& line : lines) {
    if (line.kind != ProgramLine::Kind::Statement) continue;
    const std::string text = lowerCase(line.text);
    std::string_view rest = text;
    const auto take = [&](std::string_view word) {
      const bool isThere = rest.starts_with(word);
      if (!isThere) return false;
      rest.remove_prefix(word.size());
      rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
      return true;
    };
    bool isWait = take("waittime") || take("sleep");
    if (isWait && take("\\inpos")) take(",");
    if (!isWait && take("wait")) {
      isWait = true;
      take("sec");
    }
    const std::optional<double> seconds = isWait ? secondsAt(rest) : std::nullopt;
    if (seconds)
      waiting.seconds += *seconds;
    else if (isWait || std::ranges::any_of(kOthers, [&](std::string_view word) { return text.starts_with(word); }))
      ++waiting.unknown;
  }
}

}  // namespace

WaitingTime waitingTimeOf(const RobotPath& path) {
  WaitingTime waiting;
  addWaits(path.head, waiting);
  for (const Waypoint& waypoint : path.waypoints) addWaits(waypoint.lines, waiting);
  return waiting;
}

}  // namespace handwheel
