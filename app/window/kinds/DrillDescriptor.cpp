// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/kinds/DrillDescriptor.h"

#include "tools/carving/HandDrill.h"

namespace handwheel {

ToolDescriptor drillToolDescriptor(std::function<std::unique_ptr<Tool>()> make) {
  return {QStringLiteral("drillTool"),
          KindUi::tr("&Drill"),
          KindUi::tr("Drill into the part, with thrust and torque"),
          QStringLiteral("drill"),
          QKeySequence(Qt::SHIFT | Qt::Key_D),
          std::move(make),
          "drill",
          HandDrill::keys()};
}

}  // namespace handwheel
