// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ToolEvents.h"
#include "document/cell/RobotCellKind.h"
#include "robot/ShapeSurfaces.h"
#include "robot/UrdfReader.h"
#include "tools/cell/JointDragTool.h"

#include <memory>
#include <numbers>
#include <string>

// A robot for the tests of dragging.
namespace handwheel::test {

inline constexpr double kPi = std::numbers::pi;

inline std::string bar(const std::string& name) {
  return "<link name='" + name + "'><visual><origin xyz='0.2 0 0'/><geometry><box size='0.4 0.1 0.1'/></geometry>" +
         "</visual></link>";
}

inline std::string joint(const std::string& name, const std::string& type, const std::string& parent,
                         const std::string& child, double x, const std::string& axis,
                         const std::string& more = "<limit lower='-2' upper='2'/>") {
  return "<joint name='" + name + "' type='" + type + "'><parent link='" + parent + "'/><child link='" + child +
         "'/><origin xyz='" + std::to_string(x) + " 0 0'/><axis xyz='" + axis + "'/>" + more + "</joint>";
}

// The URDF of the robot. Two arms of 400 mm turn about z in the plane z = 0, by at most 2 rad. A sledge slides along
// the second arm, a finger on the first arm turns with the second joint, and a free link turns without limits.
inline const std::string kRobot =
    "<robot name='r'>" + bar("foot") + bar("upper") + bar("lower") + bar("sledge") + bar("finger") + bar("free") +
    joint("shoulder", "revolute", "foot", "upper", 0, "0 0 1") +
    joint("elbow", "revolute", "upper", "lower", 0.4, "0 0 1") +
    joint("slide", "prismatic", "lower", "sledge", 0.4, "1 0 0", "<limit lower='0' upper='0.3'/>") +
    joint("grip", "revolute", "upper", "finger", 0.2, "0 0 1", "<limit lower='-2' upper='2'/><mimic joint='elbow'/>") +
    joint("spin", "continuous", "foot", "free", -1.0, "0 0 1", "") + "</robot>";

class Fixture {
 public:
  explicit Fixture(const std::string& urdf = kRobot) {
    auto read = readUrdf(urdf);
    auto robot = std::make_shared<CellRobot>();
    robot->model = std::move(read->robot);
    robot->arms = {wholeArm(robot->model)};
    for (const Shape& shape : robot->model.shapes)
      robot->surfaces.push_back(std::make_shared<const TriangleSoup>(surfaceOf(shape)));
    auto cell = std::make_shared<RobotCellSnapshot>();
    cell->joints = restValues(robot->model);
    cell->robot = robot;
    OpenedFile opened;
    opened.kind = &m_kind;
    opened.content = cell;
    m_document = std::make_unique<RobotCellDocument>(std::move(opened));
  }

  RobotCellDocument& document() { return *m_document; }

  // Returns a picker that always hits this part, in the plane z = 0. The rays of the tests look straight down.
  JointDragTool::Pick picking(const std::string& part) {
    return [part](const Ray& ray) -> std::optional<RobotCellPick> {
      return RobotCellPick{part, Vec3(ray.origin.x(), ray.origin.y(), 0)};
    };
  }

 private:
  RobotCellKind m_kind;
  std::unique_ptr<RobotCellDocument> m_document;
};

inline PointerEvent at(Kind kind, double x, double y, Modifiers modifiers = {}) {
  return above(kind, x, y, modifiers);
}

}  // namespace handwheel::test
