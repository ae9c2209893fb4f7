// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/WorkpieceEdit.h"

#include "document/workpiece/WorkpieceDocument.h"

namespace handwheel {

void WorkpieceEdit::exchange(Document& document) {
  auto& owner = static_cast<WorkpieceDocument&>(document);
  PropertyValue before = propertyOf(owner.workpiece(), m_field).value;
  owner.set(withValue(owner.workpiece(), m_field, m_value));
  m_value = std::move(before);
}

bool WorkpieceEdit::absorb(const Edit& later) {
  const auto* edit = dynamic_cast<const WorkpieceEdit*>(&later);
  return edit && edit->m_field == m_field;
}

std::size_t WorkpieceEdit::bytes() const {
  const auto* text = std::get_if<std::string>(&m_value);
  return sizeof *this + (text ? text->capacity() : 0);
}

}  // namespace handwheel
