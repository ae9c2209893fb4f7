// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/ProgramToolsEdit.h"

#include "document/workpiece/WorkpieceDocument.h"

namespace handwheel {

void ProgramToolsEdit::exchange(Document& document) {
  auto& owner = static_cast<WorkpieceDocument&>(document);
  WorkpieceSnapshot workpiece = owner.workpiece();
  std::swap(workpiece.programTools, m_tools);
  owner.set(std::move(workpiece));
}

std::size_t ProgramToolsEdit::bytes() const {
  return sizeof *this + (m_tools ? m_tools->size() * sizeof(ProgramTools::value_type) : 0);
}

void ProgramPostEdit::exchange(Document& document) {
  auto& owner = static_cast<WorkpieceDocument&>(document);
  WorkpieceSnapshot workpiece = owner.workpiece();
  std::swap(workpiece.programPost, m_post);
  owner.set(std::move(workpiece));
}

}  // namespace handwheel
