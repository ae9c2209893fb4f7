// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/UrdfWriter.h"

#include "base/NumberText.h"

#include <cmath>

namespace handwheel {

namespace {

constexpr double kMetresPerMillimetre = 1e-3;  // metres per mm

std::string escaped(std::string_view text) {
  std::string made;
  for (const char c : text) {
    switch (c) {
      case '&':
        made += "&amp;";
        break;
      case '<':
        made += "&lt;";
        break;
      case '>':
        made += "&gt;";
        break;
      case '"':
        made += "&quot;";
        break;
      case '\n':
      case '\r':
      case '\t':  // written as it is, it would be read as a space in an attribute
        made += "&#" + std::to_string(static_cast<int>(c)) + ';';
        break;
      default:
        made += c;
    }
  }
  return made;
}

std::string attribute(const char* name, std::string_view value) {
  return std::string(" ") + name + "=\"" + escaped(value) + '"';
}

std::string numbersText(const Vec3& v) {
  return shortestText(v.x()) + ' ' + shortestText(v.y()) + ' ' + shortestText(v.z());
}

// Returns the rotations about x, y and z, in this order, about fixed axes; if two axes are in line, none about x.
Vec3 rollPitchYaw(const Eigen::Matrix3d& turn) {
  const double across = std::hypot(turn(0, 0), turn(1, 0));
  const double pitch = std::atan2(-turn(2, 0), across);
  constexpr double kInLine = 1e-12;
  if (across < kInLine) return {0.0, pitch, std::atan2(-turn(0, 1), turn(1, 1))};
  return {std::atan2(turn(2, 1), turn(2, 2)), pitch, std::atan2(turn(1, 0), turn(0, 0))};
}

std::string originText(const Pose& pose) {
  return "<origin" + attribute("xyz", numbersText(kMetresPerMillimetre * pose.translation())) +
         attribute("rpy", numbersText(rollPitchYaw(pose.linear()))) + "/>";
}

std::string geometryText(const Shape& shape) {
  if (const auto* box = std::get_if<BoxShape>(&shape))
    return "<box" + attribute("size", numbersText(kMetresPerMillimetre * box->size)) + "/>";
  if (const auto* cylinder = std::get_if<CylinderShape>(&shape)) {
    return "<cylinder" + attribute("radius", shortestText(kMetresPerMillimetre * cylinder->radius)) +
           attribute("length", shortestText(kMetresPerMillimetre * cylinder->length)) + "/>";
  }
  if (const auto* sphere = std::get_if<SphereShape>(&shape))
    return "<sphere" + attribute("radius", shortestText(kMetresPerMillimetre * sphere->radius)) + "/>";
  const auto& mesh = std::get<MeshShape>(shape);
  return "<mesh" + attribute("filename", mesh.file) + attribute("scale", numbersText(mesh.scale)) + "/>";
}

std::string placedText(const char* element, const PlacedShape& placed, const RobotModel& robot) {
  std::string text = std::string("    <") + element + ">" + originText(placed.origin) + "<geometry>" +
                     geometryText(robot.shapes[placed.shape]) + "</geometry>";
  if (placed.colour) {
    const auto& c = *placed.colour;
    text +=
        "<material name=\"\"><color" + attribute("rgba", numbersText(Vec3(c[0], c[1], c[2])) + " 1") + "/></material>";
  }
  return text + "</" + element + ">\n";
}

// A shape that could not be read is written as an element that cannot be read, so that the link goes on lacking it.
std::string unreadText(const char* element, const std::string& shape) {
  const std::string geometry = shape.empty() ? "<geometry/>" : "<geometry><" + shape + "/></geometry>";
  return std::string("    <") + element + ">" + geometry + "</" + element + ">\n";
}

const char* typeOf(JointKind kind) {
  switch (kind) {
    case JointKind::Revolute:
      return "revolute";
    case JointKind::Continuous:
      return "continuous";
    case JointKind::Prismatic:
      return "prismatic";
    case JointKind::Fixed:
      break;
  }
  return "fixed";
}

// Returns the factor from the unit of a joint's position in the model to metres or radians.
double writtenUnit(const Joint& joint) {
  return joint.kind == JointKind::Prismatic ? kMetresPerMillimetre : 1.0;
}

std::string limitText(const Joint& joint) {
  const double unit = writtenUnit(joint);
  std::string text = "<limit";
  if (joint.kind != JointKind::Continuous) {
    text += attribute("lower", shortestText(unit * joint.limits.lower)) +
            attribute("upper", shortestText(unit * joint.limits.upper));
  }
  return text + attribute("velocity", shortestText(unit * joint.limits.velocity.value_or(0.0))) +
         attribute("effort", shortestText(joint.limits.effort.value_or(0.0))) + "/>";
}

// A joint that follows a fixed joint does not move; it is written as a fixed one at its position.
std::string jointText(const RobotModel& robot, std::uint32_t number) {
  const Joint& joint = robot.joints[number];
  const bool isFixed = joint.dof == kNone;
  Pose origin = joint.origin;
  if (isFixed && joint.kind == JointKind::Prismatic) origin.translate(joint.offset * joint.axis);
  if (isFixed && joint.kind != JointKind::Prismatic) origin.rotate(Eigen::AngleAxisd(joint.offset, joint.axis));
  std::string text = "  <joint" + attribute("name", joint.name) +
                     attribute("type", typeOf(isFixed ? JointKind::Fixed : joint.kind)) + "><parent" +
                     attribute("link", robot.links[joint.parent].name) + "/><child" +
                     attribute("link", robot.links[joint.child].name) + "/>" + originText(origin);
  if (!isFixed) text += "<axis" + attribute("xyz", numbersText(joint.axis)) + "/>" + limitText(joint);
  if (!isFixed && robot.dofs[joint.dof] != number) {
    const Joint& leader = robot.jointOfDof(joint.dof);
    text += "<mimic" + attribute("joint", leader.name) +
            attribute("multiplier", shortestText(joint.factor * writtenUnit(joint) / writtenUnit(leader))) +
            attribute("offset", shortestText(joint.offset * writtenUnit(joint))) + "/>";
  }
  return text + "</joint>\n";
}

}  // namespace

std::string urdfOf(const RobotModel& robot) {
  std::string text = "<?xml version=\"1.0\"?>\n<robot" + attribute("name", robot.name) + ">\n";
  for (const Link& link : robot.links) {
    text += "  <link" + attribute("name", link.name) + ">\n";
    for (const PlacedShape& placed : link.visuals) text += placedText("visual", placed, robot);
    for (const PlacedShape& placed : link.collisions) text += placedText("collision", placed, robot);
    for (const std::string& shape : link.unreadVisuals) text += unreadText("visual", shape);
    for (const std::string& shape : link.unreadCollisions) text += unreadText("collision", shape);
    text += "  </link>\n";
  }
  for (std::uint32_t j = 0; j < robot.joints.size(); ++j) text += jointText(robot, j);
  return text + "</robot>\n";
}

}  // namespace handwheel
