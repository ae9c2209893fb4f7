// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/path/ProgramChoices.h"

#include <set>

namespace handwheel {

RobotPath chosen(RobotPath path, const ProgramChoices& choices) {
  const auto isNoComment = [](const ProgramLine& line) { return line.kind != ProgramLine::Kind::Comment; };
  if (choices.withoutLines) std::erase_if(path.head, isNoComment);
  for (Waypoint& waypoint : path.waypoints) {
    if (choices.cornersAsStops) waypoint.corner = 0.0;
    if (choices.withoutLines) std::erase_if(waypoint.lines, isNoComment);
    if (choices.keepsCarried) waypoint.keepsCarried = true;
  }
  return path;
}

std::vector<std::size_t> linesLeftOut(const RobotPath& path, const ProgramChoices& choices) {
  std::set<std::size_t> numbers;
  const auto add = [&](const std::vector<ProgramLine>& lines) {
    for (const ProgramLine& line : lines) {
      if (choices.withoutLines && line.kind == ProgramLine::Kind::Statement) numbers.insert(line.line);
    }
  };
  add(path.head);
  for (const Waypoint& waypoint : path.waypoints) add(waypoint.lines);
  return {numbers.begin(), numbers.end()};
}

}  // namespace handwheel
