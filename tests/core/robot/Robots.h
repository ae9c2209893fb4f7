// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/UrdfReader.h"

#include <rapidcheck.h>
#include <QString>
#include <stdexcept>
#include <string>

// Texts of robot descriptions for tests.
namespace handwheel::test {

inline std::string robotOf(const std::string& inside) {
  return "<robot name='r'>" + inside + "</robot>";
}

inline std::string link(const std::string& name, const std::string& inside = {}) {
  return "<link name='" + name + "'>" + inside + "</link>";
}

inline std::string joint(const std::string& name, const std::string& type, const std::string& parent,
                         const std::string& child, const std::string& inside = {}) {
  return "<joint name='" + name + "' type='" + type + "'><parent link='" + parent + "'/><child link='" + child + "'/>" +
         inside + "</joint>\n";
}

inline std::string limit(double lower, double upper) {
  return "<limit lower='" + QString::number(lower, 'g', 17).toStdString() + "' upper='" +
         QString::number(upper, 'g', 17).toStdString() + "' velocity='1' effort='1'/>";
}

inline ImportedRobot readOrThrow(const std::string& urdf) {
  Result<ImportedRobot> read = readUrdf(urdf);
  if (!read) throw std::runtime_error("not read: error " + std::string(read.error().code->id));
  return std::move(read).value();
}

// Returns an arm in the xy plane. It has revolute joints about z, a link of each of these lengths (m) after its joint,
// and a tool at the end. inside: further elements of the joints, by default their limits. Links are called "l0" to
// "l<n>" and "tool", joints "j1" to "j<n>".
inline std::string planarArm(const std::vector<double>& lengths, const std::string& inside = limit(-1000, 1000)) {
  std::string text = link("l0");
  double before = 0.0;
  for (std::size_t i = 0; i <= lengths.size(); ++i) {
    const bool isTool = i == lengths.size();
    const std::string child = isTool ? "tool" : "l" + std::to_string(i + 1);
    const std::string origin = "<origin xyz='" + QString::number(before, 'g', 17).toStdString() + " 0 0'/>";
    text += link(child);
    text += joint(isTool ? "end" : "j" + std::to_string(i + 1), isTool ? "fixed" : "revolute", "l" + std::to_string(i),
                  child, origin + (isTool ? "" : "<axis xyz='0 0 1'/>" + inside));
    if (!isTool) before = lengths[i];
  }
  return robotOf(text);
}

inline double anyNumber(double least, double largest) {
  return least + (largest - least) * *rc::gen::inRange(0, 1'000'001) / 1e6;
}

inline std::string anyNumbers(double least, double largest) {
  std::string text;
  for (int i = 0; i < 3; ++i) text += QString::number(anyNumber(least, largest), 'g', 17).toStdString() + " ";
  return text;
}

// Returns a tree of links with joints of any kind, some of which follow other joints.
inline std::string anyRobot() {
  const int count = *rc::gen::inRange(2, 10);
  std::string text = link("l0");
  for (int i = 1; i < count; ++i) {
    static const char* const kTypes[] = {"revolute", "continuous", "prismatic", "fixed"};
    std::string inside = "<origin xyz='" + anyNumbers(-1, 1) + "' rpy='" + anyNumbers(-3, 3) + "'/><axis xyz='" +
                         anyNumbers(0.1, 1) + "'/>" + limit(-2.5, 2.5);
    if (i > 1 && *rc::gen::inRange(0, 4) == 0)
      inside += "<mimic joint='j" + std::to_string(*rc::gen::inRange(1, i)) + "' multiplier='-0.7' offset='0.1'/>";
    text += link("l" + std::to_string(i)) + joint("j" + std::to_string(i), kTypes[*rc::gen::inRange(0, 4)],
                                                  "l" + std::to_string(*rc::gen::inRange(std::max(0, i - 2), i)),
                                                  "l" + std::to_string(i), inside);
  }
  return robotOf(text);
}

inline JointValues anyValues(const RobotModel& robot, double size = 2.0) {
  JointValues values(Eigen::Index(robot.dofs.size()));
  for (double& v : values) v = anyNumber(-size, size);
  return values;
}

}  // namespace handwheel::test
