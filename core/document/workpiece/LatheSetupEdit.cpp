// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/LatheSetupEdit.h"

#include "document/workpiece/WorkpieceDocument.h"

namespace handwheel {

void LatheSetupEdit::exchange(Document& document) {
  auto& owner = static_cast<WorkpieceDocument&>(document);
  WorkpieceSnapshot workpiece = owner.workpiece();
  std::swap(workpiece.lathe, m_setup);
  owner.set(std::move(workpiece));
}

std::size_t LatheSetupEdit::bytes() const {
  return sizeof *this + (m_setup ? sizeof *m_setup + m_setup->stations.size() * sizeof(LatheSlot) : 0);
}

LatheSetup latheOf(const WorkpieceSnapshot& workpiece) {
  return workpiece.lathe ? *workpiece.lathe : defaultLatheSetup(workpiece.stock);
}

}  // namespace handwheel
