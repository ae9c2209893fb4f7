// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/cell/CellUi.h"

#include "document/cell/CellDocument.h"
#include "window/OpenDocument.h"
#include "window/ToolHost.h"

namespace handwheel {

CellUi::CellUi(const WindowParts& parts) : PartsUi(parts, {"Joints"}) {}

std::vector<ToolOffer> CellUi::tools() {
  return {};
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
