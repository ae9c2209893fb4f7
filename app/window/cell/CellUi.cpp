// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/cell/CellUi.h"

#include "document/cell/CellDocument.h"
#include "tools/cell/JointDragTool.h"
#include "viewport/Viewport.h"
#include "window/OpenDocument.h"
#include "window/ToolHost.h"

namespace handwheel {

CellUi::CellUi(const WindowParts& window) : PartsUi(window, {"Joints"}) {}

std::vector<ToolOffer> CellUi::tools() {
  return {{QStringLiteral("jointTool"), tr("&Move by hand"), QStringLiteral("hand"), QKeySequence(Qt::Key_M),
           [this] { return jointTool(); }}};
}

std::unique_ptr<Tool> CellUi::jointTool() {
  auto& cell = static_cast<CellDocument&>(document()->document);
  return std::make_unique<JointDragTool>(cell, [this](const Ray& ray) -> std::optional<CellPick> {
    const Pick pick = parts().viewport.pickAlong(ray.origin, ray.direction);
    return pick.part.empty() ? std::nullopt : std::optional(CellPick{pick.part, pick.point});
  });
}

std::vector<Hint> CellUi::hints() {
  return parts().tools.hints();
}

QString CellUi::figures() const {
  if (!document()) return {};
  const RobotModel& robot = static_cast<const CellDocument&>(document()->document).robot().model;
  return tr("%Ln joint(s)", nullptr, static_cast<int>(robot.dofs.size()));
}

QString CellUi::openedText(const OpenDocument& opened) const {
  const RobotModel& robot = static_cast<const CellDocument&>(opened.document).robot().model;
  return tr("Opened %1: robot %2 with %3 links and %4 joints that move")
      .arg(opened.document.name(), QString::fromStdString(robot.name))
      .arg(robot.links.size())
      .arg(robot.dofs.size());
}

}  // namespace handwheel
