// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/JsonFields.h"
#include "base/JsonText.h"
#include "base/NumberText.h"
#include "robot/dh/DhTable.h"

#include <array>
#include <cmath>

namespace handwheel {

namespace {

using Json = nlohmann::json;

constexpr double kRadians = M_PI / 180.0;
constexpr double kFarthest = 1e6;      // mm
constexpr double kLargestAngle = 1e5;  // degrees
constexpr std::size_t kLongestName = 200;

Error malformedTable(std::string element, const char* reason) {
  return {ErrorCode::ElementMalformed, {std::move(element), reason}, {}, {}};
}

// Returns a number of a joint; none if it is present, but is no number within ±largest.
std::optional<double> numberAt(const Json& joint, const char* key, double otherwise, double largest) {
  const auto found = joint.find(key);
  if (found == joint.end() || found->is_null()) return otherwise;
  if (!found->is_number()) return std::nullopt;
  const double value = found->get<double>();
  return std::abs(value) <= largest ? std::optional(value) : std::nullopt;
}

Result<DhJoint> jointFrom(const Json& json, std::size_t number) {
  const std::string element = "joints[" + std::to_string(number) + "]";
  if (!json.is_object()) return malformedTable(element, "an object was expected");
  constexpr double kFree = std::numeric_limits<double>::infinity();
  DhJoint joint;
  joint.name = stringAt(json, "name", "joint_" + std::to_string(number + 1));
  joint.mesh = stringAt(json, "mesh");
  if (joint.name.empty() || joint.name.size() > kLongestName) return malformedTable(element, "its name is impossible");
  const std::string type = stringAt(json, "type", "revolute");
  if (type != "revolute" && type != "prismatic") return malformedTable(element, "its type is not known");
  joint.isPrismatic = type == "prismatic";
  const double unit = joint.isPrismatic ? 1.0 : kRadians, largest = joint.isPrismatic ? kFarthest : kLargestAngle;
  double velocity = 0.0, effort = 0.0;
  const struct {
    const char* key;
    double& value;
    double otherwise, unit, largest;
  } kNumbers[] = {{"a", joint.a, 0.0, 1.0, kFarthest},
                  {"alpha", joint.alpha, 0.0, kRadians, kLargestAngle},
                  {"d", joint.d, 0.0, 1.0, kFarthest},
                  {"theta", joint.theta, 0.0, kRadians, kLargestAngle},
                  {"sign", joint.sign, 1.0, 1.0, 1.0},
                  {"lower", joint.lower, -kFree, unit, largest},
                  {"upper", joint.upper, kFree, unit, largest},
                  {"velocity", velocity, 0.0, unit, 1e9},
                  {"effort", effort, 0.0, 1.0, 1e9}};
  for (const auto& each : kNumbers) {
    const auto given = numberAt(json, each.key, each.otherwise, each.largest);
    if (!given) return malformedTable(element + "." + each.key, "a number within the limits was expected");
    each.value = *given * each.unit;
  }
  if (std::abs(joint.sign) != 1.0) return malformedTable(element + ".sign", "1 or -1 was expected");
  if (joint.lower > joint.upper) return malformedTable(element, "its lower limit is above the upper one");
  if (velocity > 0.0) joint.velocity = velocity;
  if (effort > 0.0) joint.effort = effort;
  return joint;
}

}  // namespace

bool looksLikeDhTable(std::string_view head) {
  const std::size_t begin = head.find_first_not_of(" \t\r\n");
  if (begin == head.npos || head[begin] != '{') return false;
  return head.find("\"joints\"") != head.npos &&
         (head.find("\"alpha\"") != head.npos || head.find("\"theta\"") != head.npos);
}

Result<DhTable> readDhTable(std::string_view json) {
  const Result<Json> read = parseJson(json, "robot");
  if (!read) return read.error();
  if (!read->is_object()) return malformedTable("robot", "an object was expected");
  DhTable table;
  table.name = stringAt(*read, "name", "robot");
  table.baseMesh = stringAt(*read, "base_mesh");
  if (table.name.size() > kLongestName) return malformedTable("name", "it is too long");
  const std::string unit = stringAt(*read, "mesh_unit", "mm");
  if (unit != "mm" && unit != "m") return malformedTable("mesh_unit", "mm or m was expected");
  table.meshUnit = unit == "m" ? 1000.0 : 1.0;
  const auto thickness = numberAt(*read, "thickness", 0.0, kFarthest);
  if (!thickness || *thickness < 0.0) return malformedTable("thickness", "a length was expected");
  table.thickness = *thickness;
  const auto joints = read->find("joints");
  if (joints == read->end() || !joints->is_array() || joints->empty())
    return malformedTable("joints", "a list was expected");
  if (joints->size() > static_cast<std::size_t>(kMostArmJoints)) return malformedTable("joints", "there are too many");
  for (std::size_t i = 0; i < joints->size(); ++i) {
    Result<DhJoint> joint = jointFrom((*joints)[i], i);
    if (!joint) return joint.error();
    for (const DhJoint& other : table.joints) {
      if (other.name == joint->name)
        return malformedTable("joints[" + std::to_string(i) + "]", "its name is not unique");
    }
    table.joints.push_back(std::move(joint.value()));
  }
  return table;
}

}  // namespace handwheel
