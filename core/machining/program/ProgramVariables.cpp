// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/ProgramVariables.h"

namespace handwheel {

namespace {

constexpr const char* kFewer = "Use fewer variables.";

bool isGlobalName(const std::string& name) {
  return name.starts_with('_');
}

}  // namespace

ProgramValue ProgramVariables::get(int number, const SourceLocation& location) const {
  if (m_system.read)
    if (const std::optional<ProgramValue> value = m_system.read(number, location)) return *value;
  const auto& values = number <= m_localCount ? m_frames.back().numbers : m_global;
  const auto found = values.find(number);
  return found == values.end() ? ProgramValue{0.0, m_isVacant} : found->second;
}

void ProgramVariables::set(const ProgramAssignment& assignment) {
  const auto& [number, value, location, comment] = assignment;
  if (m_system.write && m_system.write(assignment)) return;
  if (m_system.read && m_system.read(number, location))
    refuse(location, "#" + std::to_string(number), "this variable belongs to the machine and can only be read",
           "Use another number.");
  auto& values = number <= m_localCount ? m_frames.back().numbers : m_global;
  if (values.size() >= kMost) refuse(location, "#" + std::to_string(number), "there are too many variables", kFewer);
  values[number] = value;
}

std::optional<double> ProgramVariables::get(const std::string& name) const {
  if (m_system.readNamed && isGlobalName(name))
    if (const std::optional<double> value = m_system.readNamed(name)) return value;
  const auto& names = isGlobalName(name) ? m_globalNames : m_frames.back().names;
  const auto found = names.find(name);
  return found == names.end() ? std::nullopt : std::optional<double>(found->second);
}

void ProgramVariables::set(const std::string& name, double value, const SourceLocation& location) {
  if (m_system.readNamed && isGlobalName(name) && m_system.readNamed(name))
    refuse(location, "#<" + name + ">", "this variable belongs to the machine and can only be read",
           "Use another name.");
  auto& names = isGlobalName(name) ? m_globalNames : m_frames.back().names;
  if (names.size() >= kMost) refuse(location, "#<" + name + ">", "there are too many variables", kFewer);
  names[name] = value;
}

void ProgramVariables::enter(const std::vector<ProgramValue>& arguments) {
  m_frames.emplace_back();
  for (std::size_t i = 0; i < arguments.size(); ++i) m_frames.back().numbers[static_cast<int>(i) + 1] = arguments[i];
}

void ProgramVariables::leave() {
  if (m_frames.size() > 1) m_frames.pop_back();
}

}  // namespace handwheel
