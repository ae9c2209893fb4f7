// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "base/Units.h"
#include "document/Edit.h"
#include "document/Property.h"

namespace handwheel {

inline constexpr const char* kDisplayUnitId = "display_unit";

// In which unit the lengths of a document are shown: a property that all kinds have.
class DisplayUnitEdit : public Edit {
 public:
  explicit DisplayUnitEdit(LengthUnit unit) : m_unit(unit) {}

  void exchange(Document& document) override;
  std::size_t bytes() const override { return sizeof *this; }

 private:
  LengthUnit m_unit;
};

Property displayUnitProperty(LengthUnit present);
// value: an index into the choices of that property. Null when nothing changes. Errors: ValueOutOfRange,
// ElementMalformed.
Result<std::unique_ptr<Edit>> displayUnitEdit(LengthUnit present, const PropertyValue& value);

}  // namespace handwheel
