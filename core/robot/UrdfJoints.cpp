// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/UrdfJoints.h"

#include "base/Tolerance.h"
#include "robot/UrdfValues.h"
#include "xml/XmlNumbers.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

// Reads a limit of travel in rad or m; infinite ones are allowed.
Result<double> readBound(const XmlElement& limit, std::string_view attribute) {
  const std::string* text = limit.attribute(attribute);
  if (!text) return 0.0;
  std::string_view rest = *text;
  Result<double> bound = parseNumber(takeWord(rest));
  if (bound && std::isnan(*bound)) bound = Error{ErrorCode::NumberNotFinite, {*text}, {}, {}};
  if (bound && !takeWord(rest).empty()) bound = Error{ErrorCode::NumberMalformed, {*text}, {}, {}};
  if (bound) return *bound;
  Error error = bound.error();
  error.position = InputPosition::line(limit.line);
  return error;
}

}  // namespace

Status UrdfJoints::read(const XmlElement& element) {
  Joint joint;
  if (const std::string* name = element.attribute("name")) joint.name = *name;
  if (joint.name.empty()) return malformed(element, "it has no name");
  if (!m_numbers.try_emplace(joint.name, m_robot.joints.size()).second)
    return malformed(element, "there are two of that name");
  const Result<JointKind> kind = readKind(element);
  if (!kind) return kind.error();
  joint.kind = *kind;
  const Result<std::uint32_t> parent = readLink(element, "parent");
  if (!parent) return parent.error();
  joint.parent = *parent;
  const Result<std::uint32_t> child = readLink(element, "child");
  if (!child) return child.error();
  joint.child = *child;
  const Result<Pose> origin = readOrigin(element);
  if (!origin) return origin.error();
  joint.origin = *origin;
  if (joint.kind != JointKind::Fixed) {
    if (const Status status = readMotion(element, joint); !status) return status;
  }
  m_robot.joints.push_back(std::move(joint));
  m_positions.joints.push_back(InputPosition::line(element.line));
  return Done{};
}

Result<JointKind> UrdfJoints::readKind(const XmlElement& element) {
  const std::string* type = element.attribute("type");
  if (!type) return malformed(element, "it has no type");
  if (*type == "fixed") return JointKind::Fixed;
  if (*type == "revolute") return JointKind::Revolute;
  if (*type == "continuous") return JointKind::Continuous;
  if (*type == "prismatic") return JointKind::Prismatic;
  if (*type != "floating" && *type != "planar") return malformed(element, "its type '" + *type + "' is not known");
  const std::string what = "the " + *type + " joint '" + *element.attribute("name") + "', which is held still,";
  m_shapes.note({ErrorCode::Unsupported, {what}, InputPosition::line(element.line), {}});
  return JointKind::Fixed;
}

Result<std::uint32_t> UrdfJoints::readLink(const XmlElement& element, std::string_view role) const {
  const XmlElement* end = element.child(role);
  const std::string* name = end ? end->attribute("link") : nullptr;
  if (!name) return malformed(element, "it names no " + std::string(role));
  const auto found = m_links.find(*name);
  if (found == m_links.end())
    return Error{ErrorCode::ReferenceMissing, {"the link", *name}, InputPosition::line(end->line), {}};
  return found->second;
}

Status UrdfJoints::readMotion(const XmlElement& element, Joint& joint) {
  if (const XmlElement* axis = element.child("axis")) {
    const Result<Vec3> direction = readVector(*axis, "xyz", Vec3::UnitX());
    if (!direction) return direction.error();
    joint.axis = direction->stableNormalized();
    if (!(std::abs(joint.axis.norm() - 1.0) < tolerance::kUnitLength))
      return malformed(element, "its axis has no direction");
  }
  const Result<JointLimits> limits = readLimits(element, joint);
  if (!limits) return limits.error();
  joint.limits = *limits;
  const XmlElement* mimic = element.child("mimic");
  return mimic ? readFollowing(*mimic) : Done{};
}

Result<JointLimits> UrdfJoints::readLimits(const XmlElement& element, const Joint& joint) {
  JointLimits limits;
  const double unit = joint.kind == JointKind::Prismatic ? kMillimetresPerMetre : 1.0;
  const XmlElement* limit = element.child("limit");
  if (limit) {
    limits.velocity = readKnown(*limit, "velocity", unit);
    limits.effort = readKnown(*limit, "effort", 1.0);
  }
  if (joint.kind == JointKind::Continuous) return limits;
  if (limit) {
    const Result<double> lower = readBound(*limit, "lower");
    if (!lower) return lower.error();
    const Result<double> upper = readBound(*limit, "upper");
    if (!upper) return upper.error();
    limits.lower = *lower * unit;
    limits.upper = *upper * unit;
    if (limits.lower > limits.upper) return malformed(element, "its lower limit is above the upper one");
    const double most = joint.kind == JointKind::Prismatic ? kFarthestTravel : kMostTurn;
    if (limits.lower > most || limits.upper < -most) return malformed(element, "its limits are too far away");
  } else {
    m_shapes.note(malformed(element, "it has no limits, so it moves without limits"));
  }
  if (joint.kind == JointKind::Prismatic) {
    limits.lower = std::clamp(limits.lower, -kFarthestTravel, kFarthestTravel);
    limits.upper = std::clamp(limits.upper, -kFarthestTravel, kFarthestTravel);
  }
  return limits;
}

// Generators write 0 for unknown values.
std::optional<double> UrdfJoints::readKnown(const XmlElement& limit, std::string_view attribute, double unit) {
  const std::string* text = limit.attribute(attribute);
  if (!text) return {};
  std::string_view rest = *text;
  const Result<double> value = parseNumber(takeWord(rest));
  if (!value)
    m_shapes.note({ErrorCode::NumberMalformed, {text->substr(0, 40)}, InputPosition::line(limit.line), {}});
  else if (std::isfinite(*value * unit) && *value > 0.0)
    return *value * unit;
  return {};
}

Status UrdfJoints::readFollowing(const XmlElement& mimic) {
  const std::string* leader = mimic.attribute("joint");
  if (!leader) return malformed(mimic, "it names no joint");
  const Result<double> multiplier = readNumber(mimic, "multiplier", 1.0);
  if (!multiplier) return multiplier.error();
  const Result<double> offset = readNumber(mimic, "offset", 0.0);
  if (!offset) return offset.error();
  m_following.push_back({static_cast<std::uint32_t>(m_robot.joints.size()), *leader, *multiplier, *offset});
  return Done{};
}

}  // namespace handwheel
