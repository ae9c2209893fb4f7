// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Edit.h"
#include "document/workpiece/WorkpieceProperties.h"

namespace handwheel {

// An edit that changes one field of a workpiece.
class WorkpieceEdit : public Edit {
 public:
  // The value must have passed checkValue().
  WorkpieceEdit(WorkpieceField field, PropertyValue value) : m_field(field), m_value(std::move(value)) {}

  void exchange(Document& document) override;
  bool absorb(const Edit& later) override;  // absorbs edits of the same field
  std::size_t bytes() const override;

 private:
  WorkpieceField m_field;
  PropertyValue m_value;
};

}  // namespace handwheel
