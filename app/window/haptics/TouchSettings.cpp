// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/haptics/TouchSettings.h"

#include "tools/ToolProperty.h"

#include <QCoreApplication>
#include <QSettings>

namespace handwheel {

namespace {

struct Field {
  const char* id;
  const char* label;
  double TouchSettings::*value;
  Limits limits;
};

constexpr const char* kGroup = QT_TRANSLATE_NOOP("Property", "Touch");

// Stiffness: the range of contact.stiffness. 10 N/mm are more than any device states (4 N/mm of an Omega.3); the loop
// softens what it cannot carry.
const Field kFields[] = {
    {"touch_stiffness", QT_TRANSLATE_NOOP("Property", "Stiffness (N/mm)"), &TouchSettings::stiffness, {0.1, 10.0}},
    {"touch_damping", QT_TRANSLATE_NOOP("Property", "Damping (N·s/mm)"), &TouchSettings::damping, {0.0, 0.1}},
    {"touch_friction", QT_TRANSLATE_NOOP("Property", "Friction"), &TouchSettings::friction, {0.0, 2.0}},
};

bool isKept(const Field& field) {
  return field.value != &TouchSettings::stiffness;
}

QString keyOf(const Field& field) {
  return QStringLiteral("haptics/") + QString::fromLatin1(field.id);
}

}  // namespace

TouchSettings keptTouch() {
  TouchSettings touch;
  for (const Field& field : kFields) {
    if (!isKept(field)) continue;
    bool isNumber = false;
    const double kept = QSettings().value(keyOf(field)).toDouble(&isNumber);
    if (isNumber && kept >= field.limits.least && kept <= field.limits.largest) touch.*field.value = kept;
  }
  return touch;
}

void keepTouch(const TouchSettings& touch) {
  for (const Field& field : kFields) {
    if (isKept(field)) QSettings().setValue(keyOf(field), touch.*field.value);
  }
}

std::vector<Property> propertiesOf(const TouchSettings& touch) {
  std::vector<Property> all;
  for (const Field& field : kFields) {
    all.push_back(numberSetting(field.id, field.label, touch.*field.value, Quantity::Number, field.limits));
    all.back().group = kGroup;
  }
  return all;
}

void setProperty(TouchSettings& touch, std::string_view id, const PropertyValue& value) {
  for (const Field& field : kFields) {
    if (id == field.id) takeNumber(touch.*field.value, value, field.limits);
  }
}

}  // namespace handwheel
