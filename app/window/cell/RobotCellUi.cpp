// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/cell/RobotCellUi.h"

#include "document/cell/RobotCellDocument.h"
#include "document/cell/RobotCellKind.h"
#include "document/scene/BodyProperties.h"
#include "fidelity/Cases.h"
#include "theme/Theme.h"
#include "tools/cell/CellTool.h"
#include "viewport/Viewport.h"
#include "viewport/surface/PartsLayer.h"
#include "window/documents/DocumentTab.h"
#include "window/fidelity/FidelityChoice.h"
#include "window/tools/ToolHost.h"

namespace handwheel {

RobotCellUi::RobotCellUi(const WindowContext& window, RobotCellKind& kind)
    : RigidPartsUi(window, {"Joints"}), m_bodies(window, this) {
  const auto follow = [&kind, &choice = window.fidelity] {
    kind.setShapeSides(static_cast<std::uint32_t>(choice.values().of(shapeSidesSetting())));
  };
  connect(&window.fidelity, &FidelityChoice::changed, this, follow);
  follow();
  connect(&m_bodies, &CellBodies::message, this, &KindUi::message);
  connect(&m_bodies, &CellBodies::selectionChanged, this, [this, &tools = window.tools] {
    refreshPanel();
    tools.refresh();
  });
}

void RobotCellUi::setDocument(DocumentTab* document) {
  m_bodies.setDocument(document);
  RigidPartsUi::setDocument(document);
}

// Of the bodies the selected one only: there may be very many.
bool RobotCellUi::isListed(const Property& property) const {
  const auto body = bodyOfProperty(property.id);
  return !body || body == m_bodies.selection().body();
}

bool RobotCellUi::isInPanel(const Property& property) const {
  return bodyOfProperty(property.id) ? isListed(property) : RigidPartsUi::isInPanel(property);
}

std::vector<StartAction> RobotCellUi::startActions() const {
  return {{QStringLiteral("openRobotSample"), tr("Open the sample &robot"), tr("Open the sample robot arm"),
           panelIcon(), QStringLiteral("robot-arm.urdf"),
           StartTile{QStringLiteral("cellTile"), panelIcon(), tr("Robot cell"),
                     tr("An arm with six joints. Move it by hand within its limits.")}}};
}

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
  return {joints, measureParts()};
}

std::unique_ptr<Tool> RobotCellUi::handTool() {
  auto& cell = static_cast<RobotCellDocument&>(document()->document);
  return std::make_unique<CellTool>(cell, m_bodies.selection(), [this](const Ray& ray) -> std::optional<RobotCellPick> {
    const Pick pick = parts().viewport.pickAlong(ray.origin, ray.direction);
    const std::string part = partOf(pick);
    return part.empty() ? std::nullopt : std::optional(RobotCellPick{part, pick.point});
  });
}

NextStep RobotCellUi::nextStep() {
  if (!document() || document()->document.history()->count() > 0) return {};
  const CellRobot& robot = static_cast<const RobotCellDocument&>(document()->document).robot();
  return {panelIcon(), themeColours(currentTheme()).accent,
          tr("Robot %1: %Ln joint(s) that move.", nullptr, static_cast<int>(robot.model.dofs.size()))
              .arg(QString::fromStdString(robot.model.name)),
          tr("Drag a link with the mouse, or with Shift the whole arm. The list of joints takes angles. The menu adds "
             "bodies beside the robot."),
          panelActions()};
}

QString RobotCellUi::statistics() const {
  if (!document()) return {};
  const auto& cell = static_cast<const RobotCellDocument&>(document()->document);
  const QString joints = tr("%Ln joint(s)", nullptr, static_cast<int>(cell.robot().model.dofs.size()));
  if (cell.bodies().empty()) return joints;
  return tr("%1, %2").arg(joints, tr("%Ln body(ies)", nullptr, static_cast<int>(cell.bodies().size())));
}

QString RobotCellUi::openedText(const DocumentTab& opened) const {
  const RobotModel& robot = static_cast<const RobotCellDocument&>(opened.document).robot().model;
  return tr("Opened %1: robot %2 with %3 links and %4 joints that move")
      .arg(opened.document.name(), QString::fromStdString(robot.name))
      .arg(robot.links.size())
      .arg(robot.dofs.size());
}

}  // namespace handwheel
