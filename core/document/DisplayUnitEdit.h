// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "base/Units.h"
#include "document/Edit.h"
#include "document/Property.h"

namespace handwheel {

inline constexpr const char* kDisplayUnitId = "display_unit";

// An edit that changes the unit in which the lengths of a document are displayed. Documents of all kinds have this
// property.
class DisplayUnitEdit : public Edit {
 public:
  explicit DisplayUnitEdit(LengthUnit unit) : m_unit(unit) {}

  void exchange(Document& document) override;
  std::size_t bytes() const override { return sizeof *this; }

 private:
  LengthUnit m_unit;
};

// Returns the property for the display unit.
Property displayUnitProperty(LengthUnit present);
// Creates the edit for a new display unit, or returns null if the unit stays the same. value: an index into the choices
// of the property. Errors: ValueOutOfRange, ElementMalformed.
Result<std::unique_ptr<Edit>> displayUnitEdit(LengthUnit present, const PropertyValue& value);

}  // namespace handwheel
