// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/target/TargetEdit.h"

#include "document/workpiece/WorkpieceDocument.h"

namespace handwheel {

void TargetEdit::exchange(Document& document) {
  auto& owner = static_cast<WorkpieceDocument&>(document);
  WorkpieceSnapshot workpiece = owner.workpiece();
  std::swap(workpiece.target, m_target);
  owner.set(std::move(workpiece));
}

std::size_t TargetEdit::bytes() const {
  return sizeof *this + (m_target ? m_target->profile.segments().size() * sizeof(ProfileSegment) : 0);
}

}  // namespace handwheel
