// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/JointEdit.h"

#include "document/cell/RobotCellDocument.h"

#include <algorithm>
#include <utility>

namespace handwheel {

void JointEdit::exchange(Document& document) {
  auto& cell = static_cast<RobotCellDocument&>(document);
  for (Move& move : m_moves) std::swap(cell.m_joints[move.dof], move.value);
  cell.wasChanged();
}

bool JointEdit::absorb(const Edit& later) {
  const auto* moved = dynamic_cast<const JointEdit*>(&later);
  return moved && std::equal(m_moves.begin(), m_moves.end(), moved->m_moves.begin(), moved->m_moves.end(),
                             [](const Move& a, const Move& b) { return a.dof == b.dof; });
}

}  // namespace handwheel
