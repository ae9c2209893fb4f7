// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/PlansEdit.h"

#include "document/cell/RobotCellDocument.h"

namespace handwheel {

void PlansEdit::exchange(Document& document) {
  auto& cell = static_cast<RobotCellDocument&>(document);
  std::swap(cell.m_plans, m_plans);
  cell.wasChanged();
}

}  // namespace handwheel
