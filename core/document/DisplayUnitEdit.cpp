// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/DisplayUnitEdit.h"

#include "document/Document.h"

#include <utility>

namespace handwheel {

namespace {
constexpr int kDisplayUnits = 4;
}

void DisplayUnitEdit::exchange(Document& document) {
  m_unit = std::exchange(document.m_file.displayUnit, m_unit);
  document.wasChanged();
  emit document.fileChanged();
}

Property displayUnitProperty(LengthUnit present) {
  Property property;
  property.id = kDisplayUnitId;
  property.group = QT_TRANSLATE_NOOP("Property", "Document");
  property.label = QT_TRANSLATE_NOOP("Property", "Display unit");
  property.value = static_cast<double>(present);
  for (int i = 0; i < kDisplayUnits; ++i) property.choices.emplace_back(symbolOf(static_cast<LengthUnit>(i)));
  property.largest = kDisplayUnits - 1;
  property.least = 0;
  return property;
}

Result<std::unique_ptr<Edit>> displayUnitEdit(LengthUnit present, const PropertyValue& value) {
  const auto* number = std::get_if<double>(&value);
  if (!number) return Error{ErrorCode::ElementMalformed, {kDisplayUnitId, "a choice was expected"}, {}, {}};
  const int index = *number >= 0 && *number < kDisplayUnits ? static_cast<int>(*number) : -1;
  if (index < 0 || index != *number) {
    return Error{ErrorCode::ValueOutOfRange, {kDisplayUnitId, std::to_string(*number), "0", "3"}, {}, {}};
  }
  const auto unit = static_cast<LengthUnit>(index);
  if (unit == present) return std::unique_ptr<Edit>();
  return std::unique_ptr<Edit>(std::make_unique<DisplayUnitEdit>(unit));
}

}  // namespace handwheel
