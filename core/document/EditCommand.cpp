// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/EditCommand.h"

namespace handwheel {

bool EditCommand::mergeWith(const QUndoCommand* later) {
  const auto& next = *static_cast<const EditCommand*>(later);
  return next.m_stroke == m_stroke && m_edit->absorb(*next.m_edit);
}

}  // namespace handwheel
