// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The tools of robot cells, and what of the window they use.
#include "collision/ProximityFidelity.h"
#include "document/cell/CellArms.h"
#include "document/cell/RobotCellDocument.h"
#include "fidelity/Cases.h"
#include "robot/arm/IkFidelity.h"
#include "tools/cell/CellTool.h"
#include "tools/cell/FaceMateTool.h"
#include "tools/cell/IkSolutionsTool.h"
#include "tools/cell/ProcessPathTool.h"
#include "viewport/Viewport.h"
#include "viewport/surface/PartsLayer.h"
#include "window/cell/RobotCellUi.h"
#include "window/documents/DocumentTab.h"
#include "window/fidelity/FidelityChoice.h"

namespace handwheel {

std::vector<ToolDescriptor> RobotCellUi::tools() {
  ToolDescriptor joints{QStringLiteral("jointTool"),
                        tr("Move &joints by hand"),
                        tr("Drag the links of the robot, and the bodies beside it"),
                        QStringLiteral("hand"),
                        QKeySequence(Qt::Key_J),
                        [this] { return handTool(); },
                        "joints",
                        CellTool::keys()};
  joints.isDefault = true;
  const ToolDescriptor process{QStringLiteral("processTool"),
                               tr("&Process path along a curve"),
                               tr("Choose an edge or a section of a part for the robot's tool to work along"),
                               QStringLiteral("boundary"),
                               QKeySequence(Qt::Key_X),
                               [this] { return processTool(); },
                               "process",
                               ProcessPathTool::keys()};
  const ToolDescriptor lead{QStringLiteral("leadTool"),
                            tr("&Lead the robot by hand"),
                            tr("Lead the robot's tool by hand; the arm follows without collisions"),
                            QStringLiteral("lead"),
                            QKeySequence(Qt::SHIFT | Qt::Key_J),
                            [this] { return handGuidingTool(); },
                            "lead",
                            HandGuidingTool::keys()};
  const ToolDescriptor solutions{
      QStringLiteral("armWaysTool"),
      tr("&Choose the arm's configuration"),
      tr("Show all configurations in which the arm reaches a pose of its tool: shoulder, elbow and wrist"),
      QStringLiteral("arm-ways"),
      QKeySequence(Qt::SHIFT | Qt::Key_K),
      [this] { return ikSolutionsTool(); },
      "ways",
      IkSolutionsTool::keys()};
  const ToolDescriptor placing{QStringLiteral("placeTool"),
                               tr("Place a body or robot with &handles"),
                               tr("Move and turn the selected body, or the base of the selected robot, along and about "
                                  "axes"),
                               QStringLiteral("axes"),
                               QKeySequence(Qt::SHIFT | Qt::Key_W),
                               [this] { return placeBodyTool(); },
                               "place",
                               PlaceBodyTool::keys()};
  const ToolDescriptor snap{QStringLiteral("faceSnapTool"),
                            tr("Lay a body &face to face"),
                            tr("Lay a body with one of its faces on a face of another"),
                            QStringLiteral("face-to-face"),
                            QKeySequence(Qt::SHIFT | Qt::Key_B),
                            [this] { return faceMateTool(); },
                            "snap",
                            FaceMateTool::keys()};
  return {joints, lead, solutions, placing, snap, process, measureParts()};
}

std::optional<RobotCellPick> RobotCellUi::pickCell(const Ray& ray) const {
  const Pick hit = parts().viewport.pickAlong(ray.origin, ray.direction);
  const std::string part = partOf(hit);
  return part.empty() ? std::nullopt : std::optional(RobotCellPick{part, hit.point});
}

void RobotCellUi::markShown(DisplayModel& shown, const JointValues& joints, const Body* moved) {
  m_contacts->show(CellContactMarks::Source::Tool, m_collisions.mark(shown, joints, moved));
}

std::unique_ptr<Tool> RobotCellUi::processTool() {
  const auto& cell = static_cast<const RobotCellDocument&>(document()->document);
  ProcessPathServices services;
  services.pick = [this](const Ray& ray) { return pickCell(ray); };
  services.surface = [this](const BodyPointer& body) { return m_surfaces.of(body); };
  services.plan = [this, &cell](const OperationValues& values) {
    const BodyPointer part = cell.bodies().withId(static_cast<BodyId>(std::stoul(values.text("part"))));
    const auto surface = part ? m_surfaces.of(part) : nullptr;
    if (surface) m_paths.planProcess(values, surface);
  };
  return std::make_unique<ProcessPathTool>(cell, std::move(services));
}

std::unique_ptr<Tool> RobotCellUi::handGuidingTool() {
  HandGuidingServices services;
  services.scene = [this] { return m_collisions.scene(); };
  services.mark = [this](DisplayModel& shown, const JointValues& joints) { markShown(shown, joints); };
  services.addWaypoint = [this] { m_paths.addWaypoint(); };
  services.time = [this] { return 1e-3 * static_cast<double>(m_clock.elapsed()); };
  services.tolerance = parts().fidelity.values().of(proximityToleranceSetting());
  services.ikTolerance = parts().fidelity.values().of(ikToleranceSetting());
  services.trials = &m_trials[document()];
  services.guide = [this](const std::string& path) {
    return m_guides.of(path, static_cast<const RobotCellDocument&>(document()->document).plans());
  };
  return std::make_unique<HandGuidingTool>(static_cast<RobotCellDocument&>(document()->document), std::move(services));
}

std::unique_ptr<Tool> RobotCellUi::ikSolutionsTool() {
  IkSolutionsServices services;
  services.scene = [this] { return m_collisions.scene(); };
  services.mark = [this](DisplayModel& shown, const JointValues& joints) { markShown(shown, joints); };
  return std::make_unique<IkSolutionsTool>(static_cast<RobotCellDocument&>(document()->document), std::move(services));
}

HeldApproachServices RobotCellUi::approachServices() {
  HeldApproachServices services;
  services.scene = [this](std::optional<std::size_t> robot) {
    return robot ? m_collisions.sceneFor(*robot) : m_collisions.scene();
  };
  services.tolerance = parts().fidelity.values().of(proximityToleranceSetting());
  services.settings = m_approach;
  return services;
}

PlaceBodyServices RobotCellUi::placeServices() {
  PlaceBodyServices services;
  services.approach = approachServices();
  services.pick = [this](const Ray& ray) { return pickCell(ray); };
  services.mark = [this](DisplayModel& shown, const Body& moved) {
    markShown(shown, static_cast<const RobotCellDocument&>(document()->document).joints(), &moved);
  };
  services.markRobot = [this](DisplayModel& shown, std::size_t robot, const Pose& displacement) {
    m_contacts->show(CellContactMarks::Source::Tool, m_collisions.markMoved(shown, robot, displacement));
  };
  services.robot = [this] {
    const std::string name = selectedRobot();
    const CellRobot& robots = static_cast<const RobotCellDocument&>(document()->document).robot();
    return name.empty() ? std::nullopt : armNumber(robots, name);
  };
  services.frame = [this] {
    const NamedFrame* const frame = m_showsRow ? m_paths.frame() : nullptr;
    return frame ? frame->name : std::string();
  };
  services.selectRobot = [this](std::size_t robot) { selectRobotToPlace(robot); };
  return services;
}

// The one on the root cannot be placed, which is said.
void RobotCellUi::selectRobotToPlace(std::size_t number) {
  const CellRobot& robots = static_cast<const RobotCellDocument&>(document()->document).robot();
  const RobotArm& robot = robots.arms[number];
  selectRobot(robot.base);
  if (robot.base != robots.model.root) return;
  say({Message::Weight::Info,
       tr("%1 cannot be moved").arg(QString::fromStdString(robot.name)),
       tr("Everything in the cell is measured from the base of its first robot."),
       tr("Move the bodies and the other robots."),
       {},
       {},
       {},
       {},
       &document()->document});
}

std::unique_ptr<Tool> RobotCellUi::placeBodyTool() {
  auto& cell = static_cast<RobotCellDocument&>(document()->document);
  return std::make_unique<PlaceBodyTool>(cell, m_bodies.selection(), placeServices());
}

std::unique_ptr<Tool> RobotCellUi::faceMateTool() {
  auto& cell = static_cast<RobotCellDocument&>(document()->document);
  return std::make_unique<FaceMateTool>(cell, m_bodies.selection(), placeServices());
}

std::unique_ptr<Tool> RobotCellUi::handTool() {
  auto& cell = static_cast<RobotCellDocument&>(document()->document);
  const auto pick = [this](const Ray& ray) { return pickCell(ray); };
  const auto mark = [this](DisplayModel& shown, const JointValues& joints, const Body* moved) {
    markShown(shown, joints, moved);
  };
  return std::make_unique<CellTool>(
      cell, m_bodies.selection(), pick, mark, [this](std::uint32_t link) { selectRobot(link); }, approachServices());
}

}  // namespace handwheel
