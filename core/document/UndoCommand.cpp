// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/UndoCommand.h"

namespace handwheel {

bool UndoCommand::mergeWith(const QUndoCommand* later) {
  const auto& next = *static_cast<const UndoCommand*>(later);
  if (next.m_stroke != m_stroke || !m_edit->absorb(*next.m_edit)) return false;
  setObsolete(m_values && next.m_values && m_values->before == next.m_values->after);
  return true;
}

}  // namespace handwheel
