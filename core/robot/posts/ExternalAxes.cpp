// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/ExternalAxes.h"

#include "base/NumberText.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

bool ExternalAxes::take(const AxisValues& values, std::size_t line) {
  if (m_line == 0) {
    m_line = line;
    m_values = values;
    return true;
  }
  constexpr double kStill = 1e-6;  // mm, degrees
  return std::ranges::all_of(values, [&](const auto& axis) {
    const auto known = m_values.find(axis.first);
    return std::abs(axis.second - (known == m_values.end() ? 0.0 : known->second)) <= kStill;
  });
}

void ExternalAxes::addTo(std::vector<ProgramLine>& lines) const {
  std::string text;
  for (const auto& [name, value] : m_values) text += (text.empty() ? "" : ",") + name + " " + shortestText(value);
  addTo(lines, std::move(text));
}

void ExternalAxes::addTo(std::vector<ProgramLine>& lines, std::string text) const {
  if (isAnySet()) lines.push_back({ProgramLine::Kind::Axes, std::move(text), m_line});
}

bool ExternalAxes::isAnySet() const {
  return std::ranges::any_of(m_values, [](const auto& axis) { return axis.second != 0.0; });
}

std::string externalAxesOf(const RobotProgram& program, std::string_view language) {
  const auto isAxes = [](const ProgramLine& line) { return line.kind == ProgramLine::Kind::Axes; };
  const auto line = std::ranges::find_if(program.head, isAxes);
  return program.language == language && line != program.head.end() ? line->text : std::string();
}

}  // namespace handwheel
