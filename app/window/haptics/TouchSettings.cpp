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

constexpr const char* kTouch = QT_TRANSLATE_NOOP("Property", "Touch");
constexpr const char* kSnapping = QT_TRANSLATE_NOOP("Property", "Snapping");
constexpr const char* kStiffness = QT_TRANSLATE_NOOP("Property", "Stiffness (N/mm)");

// Stiffness: the range of contact.stiffness. 10 N/mm are more than any device states (4 N/mm of an Omega.3); the loop
// softens what it cannot carry.
const Field kFields[] = {
    {"touch_stiffness", kStiffness, &TouchSettings::stiffness, {0.1, 10.0}},
    {"touch_damping", QT_TRANSLATE_NOOP("Property", "Damping (N·s/mm)"), &TouchSettings::damping, {0.0, 0.1}},
    {"touch_friction", QT_TRANSLATE_NOOP("Property", "Friction"), &TouchSettings::friction, {0.0, 2.0}},
};

// Snapping is felt from nowhere further than 5 mm of the hand, so the spring's leap is at most 10 N.
constexpr Limits kSnapStiffness{0.02, 2.0};

// In the order of SnapShape and SnapMethod.
const std::vector<std::string> kSnapShapes{
    QT_TRANSLATE_NOOP("Property", "Spring"), QT_TRANSLATE_NOOP("Property", "Triangle"),
    QT_TRANSLATE_NOOP("Property", "Quadratic"), QT_TRANSLATE_NOOP("Property", "Gaussian")};
const std::vector<std::string> kSnapMethods{QT_TRANSLATE_NOOP("Property", "One (proxy)"),
                                            QT_TRANSLATE_NOOP("Property", "Sum (force)")};

std::vector<Property> snapProperties(const TouchSettings& touch) {
  const auto numberOf = [](auto choice) { return static_cast<int>(choice); };
  std::vector<Property> all;
  all.push_back(switchSetting("snap_on", QT_TRANSLATE_NOOP("Property", "Snap"), touch.isSnapping));
  all.push_back(
      choiceSetting("snap_profile", QT_TRANSLATE_NOOP("Property", "Profile"), numberOf(touch.snapShape), kSnapShapes));
  all.push_back(
      choiceSetting("snap_method", QT_TRANSLATE_NOOP("Property", "Method"), numberOf(touch.snapMethod), kSnapMethods));
  all.push_back(numberSetting("snap_stiffness", kStiffness, touch.snapStiffness, Quantity::Number, kSnapStiffness));
  all.push_back(
      switchSetting("snap_rims", QT_TRANSLATE_NOOP("Property", "Hole boundaries as curves"), touch.hasBoundaryCurves));
  for (Property& property : all) property.group = kSnapping;
  return all;
}

bool isKept(const Property& property) {
  return property.id != "touch_stiffness";
}

QString keyOf(const Property& property) {
  return QStringLiteral("haptics/") + QString::fromStdString(property.id);
}

// Returns the stored value of a property, or its own value if the stored one is invalid.
PropertyValue keptValue(const Property& property) {
  const QVariant kept = QSettings().value(keyOf(property));
  if (std::holds_alternative<bool>(property.value)) {
    const QString word = kept.toString();
    return word == u"true" || word == u"false" ? PropertyValue(kept.toBool()) : property.value;
  }
  bool isNumber = false;
  const double number = kept.toDouble(&isNumber);
  return isNumber && number >= property.least && number <= property.largest ? PropertyValue(number) : property.value;
}

}  // namespace

TouchSettings loadTouch() {
  TouchSettings touch;
  for (const Property& property : propertiesOf(touch))
    if (isKept(property)) setProperty(touch, property.id, keptValue(property));
  return touch;
}

void storeTouch(const TouchSettings& touch) {
  for (const Property& property : propertiesOf(touch)) {
    if (!isKept(property)) continue;
    if (const bool* isOn = std::get_if<bool>(&property.value)) QSettings().setValue(keyOf(property), *isOn);
    if (const double* number = std::get_if<double>(&property.value)) QSettings().setValue(keyOf(property), *number);
  }
}

std::vector<Property> propertiesOf(const TouchSettings& touch) {
  std::vector<Property> all;
  for (const Field& field : kFields) {
    all.push_back(numberSetting(field.id, field.label, touch.*field.value, Quantity::Number, field.limits));
    all.back().group = kTouch;
  }
  for (Property& property : snapProperties(touch)) all.push_back(std::move(property));
  return all;
}

void setProperty(TouchSettings& touch, std::string_view id, const PropertyValue& value) {
  for (const Field& field : kFields) {
    if (id == field.id) assignNumber(touch.*field.value, value, field.limits);
  }
  if (id == "snap_on") assignSwitch(touch.isSnapping, value);
  if (id == "snap_profile") assignChoice(touch.snapShape, value, static_cast<int>(kSnapShapes.size()));
  if (id == "snap_method") assignChoice(touch.snapMethod, value, static_cast<int>(kSnapMethods.size()));
  if (id == "snap_stiffness") assignNumber(touch.snapStiffness, value, kSnapStiffness);
  if (id == "snap_rims") assignSwitch(touch.hasBoundaryCurves, value);
}

}  // namespace handwheel
