// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/program/RobotPath.h"

#include <algorithm>

namespace handwheel {

namespace {

template <class Named>
const Named* withName(const std::vector<Named>& all, std::string_view name) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Named& each) { return each.name == name; });
  return found == all.end() ? nullptr : &*found;
}

bool areSame(const std::map<std::string, Pose, std::less<>>& one,
             const std::map<std::string, Pose, std::less<>>& other) {
  return std::equal(one.begin(), one.end(), other.begin(), other.end(), [](const auto& a, const auto& b) {
    return a.first == b.first && a.second.matrix() == b.second.matrix();
  });
}

}  // namespace

std::string FreeNames::take(const std::string& preferred) {
  if (m_taken.insert(preferred).second) return preferred;
  std::size_t& number = m_numbers.try_emplace(preferred, 1).first->second;
  std::string name;
  do {
    name = preferred + ' ' + std::to_string(++number);
  } while (!m_taken.insert(name).second);
  return name;
}

bool Waypoint::isPlannedFrom(const Waypoint& begin) const {
  const auto isSame = [](const JointValues& a, const JointValues& b) { return a.size() == b.size() && a == b; };
  return plannedBetween && motion == ProgramMotion::Kind::Joint && isSame((*plannedBetween)[0], begin.joints) &&
         isSame((*plannedBetween)[1], joints);
}

const ProgramLine* Waypoint::gripping() const {
  const auto found = std::ranges::find_if(lines, &ProgramLine::mayGrip);
  return keepsCarried || found == lines.end() ? nullptr : &*found;
}

void removeWaypoint(RobotPath& path, std::size_t index) {
  std::vector<ProgramLine>& before = index == 0 ? path.head : path.waypoints[index - 1].lines;
  std::ranges::move(path.waypoints[index].lines, std::back_inserter(before));
  path.waypoints.erase(path.waypoints.begin() + static_cast<std::ptrdiff_t>(index));
}

bool WaypointTarget::operator==(const WaypointTarget& other) const {
  return name == other.name && inTool.matrix() == other.inTool.matrix();
}

bool Waypoint::operator==(const Waypoint& other) const {
  return joints.size() == other.joints.size() && joints == other.joints && name == other.name &&
         isCritical == other.isCritical && motion == other.motion && speed == other.speed && blend == other.blend &&
         target == other.target && configuration == other.configuration && corner == other.corner &&
         seconds == other.seconds && lines == other.lines && keepsCarried == other.keepsCarried && frame == other.frame;
}

bool NamedConfiguration::operator==(const NamedConfiguration& other) const {
  return name == other.name && joints.size() == other.joints.size() && joints == other.joints && arm == other.arm;
}

bool PathProcess::operator==(const PathProcess& other) const {
  const auto areEqual = [](const std::optional<Pose>& a, const std::optional<Pose>& b) {
    return a.has_value() == b.has_value() && (!a || a->matrix() == b->matrix());
  };
  return values == other.values && part.matrix() == other.part.matrix() && planned.matrix() == other.planned.matrix() &&
         areEqual(tool, other.tool) && areEqual(base, other.base);
}

bool RobotPath::operator==(const RobotPath& other) const {
  return name == other.name && waypoints == other.waypoints && arm == other.arm && process == other.process &&
         areSame(bases, other.bases) && clearance == other.clearance && head == other.head &&
         language == other.language;
}

bool NamedFrame::operator==(const NamedFrame& other) const {
  return name == other.name && pose.matrix() == other.pose.matrix() && body == other.body && link == other.link;
}

bool NamedTarget::operator==(const NamedTarget& other) const {
  return name == other.name && pose.matrix() == other.pose.matrix() && body == other.body && frame == other.frame;
}

const NamedConfiguration* CellPlans::configuration(std::string_view name) const {
  return withName(configurations, name);
}

const NamedTarget* CellPlans::target(std::string_view name) const {
  return withName(targets, name);
}

const RobotPath* CellPlans::path(std::string_view name) const {
  return withName(paths, name);
}

const NamedFrame* CellPlans::frame(std::string_view name) const {
  return withName(frames, name);
}

FreeNames CellPlans::pathNames() const {
  FreeNames names;
  for (const RobotPath& each : paths) names.add(each.name);
  return names;
}

FreeNames CellPlans::poseNames() const {
  FreeNames names;
  for (const NamedConfiguration& each : configurations) names.add(each.name);
  for (const NamedTarget& each : targets) names.add(each.name);
  return names;
}

FreeNames CellPlans::frameNames() const {
  FreeNames names;
  for (const NamedFrame& each : frames) names.add(each.name);
  return names;
}

std::size_t CellPlans::bytes() const {
  const auto ofValues = [](const JointValues& values) {
    return static_cast<std::size_t>(values.size()) * sizeof(double);
  };
  std::size_t sum = sizeof *this;
  for (const NamedConfiguration& each : configurations) sum += sizeof each + each.name.size() + ofValues(each.joints);
  for (const NamedTarget& each : targets) sum += sizeof each + each.name.size() + each.frame.size();
  for (const NamedFrame& each : frames) sum += sizeof each + each.name.size() + each.link.size();
  for (const RobotPath& path : paths) {
    sum += sizeof path + path.name.size();
    for (const ProgramLine& line : path.head) sum += sizeof line + line.text.size();
    if (!path.process) continue;
    for (const auto& [name, value] : path.process->values) {
      const auto* const text = std::get_if<std::string>(&value);
      sum += sizeof value + name.size() + (text ? text->size() : 0);
    }
  }
  for (const RobotPath& path : paths) {
    for (const Waypoint& waypoint : path.waypoints) {
      sum += sizeof waypoint + waypoint.name.size() + waypoint.configuration.size() + ofValues(waypoint.joints);
      if (waypoint.target) sum += waypoint.target->name.size();
      if (waypoint.frame) sum += waypoint.frame->name.size();
      for (const ProgramLine& line : waypoint.lines) sum += sizeof line + line.text.size();
    }
  }
  return sum;
}

void CellPlans::choose(const std::string& other, const std::string& present) {
  if (other != present) {
    otherTools[present] = tool;
    const auto known = otherTools.find(other);
    tool = known == otherTools.end() ? Pose::Identity() : known->second;
    otherTools.erase(other);
  }
  arm = other;
}

bool CellPlans::operator==(const CellPlans& other) const {
  return configurations == other.configurations && targets == other.targets && paths == other.paths &&
         frames == other.frames && workFrame == other.workFrame && allowed == other.allowed &&
         missingAs == other.missingAs && arm == other.arm && tool.matrix() == other.tool.matrix() &&
         areSame(otherTools, other.otherTools) && clearance == other.clearance && rates == other.rates;
}

}  // namespace handwheel
