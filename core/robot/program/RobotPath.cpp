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

template <class Named>
std::string freeName(const std::vector<Named>& all, const std::string& wish) {
  std::string name = wish;
  for (std::size_t number = 2; withName(all, name); ++number) name = wish + ' ' + std::to_string(number);
  return name;
}

}  // namespace

bool NamedTarget::operator==(const NamedTarget& other) const {
  return name == other.name && pose.matrix() == other.pose.matrix() && body == other.body;
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

std::string CellPlans::freePathName(const std::string& wish) const {
  return freeName(paths, wish);
}

std::string CellPlans::freePlaceName(const std::string& wish) const {
  std::string name = wish;
  for (std::size_t number = 2; configuration(name) || target(name); ++number)
    name = wish + ' ' + std::to_string(number);
  return name;
}

std::size_t CellPlans::bytes() const {
  const auto ofValues = [](const JointValues& values) {
    return static_cast<std::size_t>(values.size()) * sizeof(double);
  };
  std::size_t sum = sizeof *this;
  for (const NamedConfiguration& each : configurations) sum += sizeof each + each.name.size() + ofValues(each.joints);
  for (const NamedTarget& each : targets) sum += sizeof each + each.name.size();
  for (const RobotPath& path : paths) {
    sum += sizeof path + path.name.size();
    for (const PathPlace& place : path.places) sum += sizeof place + place.name.size() + ofValues(place.joints);
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
         allowed == other.allowed && arm == other.arm && tool.matrix() == other.tool.matrix() &&
         std::equal(otherTools.begin(), otherTools.end(), other.otherTools.begin(), other.otherTools.end(),
                    [](const auto& a, const auto& b) {
                      return a.first == b.first && a.second.matrix() == b.second.matrix();
                    }) &&
         clearance == other.clearance;
}

}  // namespace handwheel
