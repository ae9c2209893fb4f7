// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/RobotTree.h"
#include "robot/UrdfShapes.h"

#include <map>

namespace handwheel {

// A reader of the joints of a URDF description, one by one.
class UrdfJoints {
 public:
  // Prepares the reading of joints into a robot. links: the indices of all links by name. positions: receives the
  // positions of the joints in the file. shapes: receives the notes on invalid elements by UrdfShapes::note().
  UrdfJoints(RobotModel& robot, const std::map<std::string, std::uint32_t>& links, RobotInputPositions& positions,
             UrdfShapes& shapes)
      : m_robot(robot), m_links(links), m_positions(positions), m_shapes(shapes) {}

  Status read(const XmlElement& element);

  const std::vector<MimicJoint>& following() const { return m_following; }

 private:
  Result<JointKind> readKind(const XmlElement& element);
  Result<std::uint32_t> readLink(const XmlElement& element, std::string_view role) const;
  Status readMotion(const XmlElement& element, Joint& joint);
  Result<JointLimits> readLimits(const XmlElement& element, const Joint& joint);
  std::optional<double> readKnown(const XmlElement& limit, std::string_view attribute, double unit);
  Status readFollowing(const XmlElement& mimic);

  RobotModel& m_robot;
  const std::map<std::string, std::uint32_t>& m_links;
  RobotInputPositions& m_positions;
  UrdfShapes& m_shapes;
  std::map<std::string, std::uint32_t> m_numbers;
  std::vector<MimicJoint> m_following;
};

}  // namespace handwheel
