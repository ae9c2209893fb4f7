// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/Preferences.h"

#include <QSettings>
#include <algorithm>

namespace handwheel {

namespace {

const auto kNavigation = QStringLiteral("navigation");
const auto kLengthUnit = QStringLiteral("lengthUnit");
const auto kLanguage = QStringLiteral("language");
const auto kAutosave = QStringLiteral("autosaveSeconds");
const auto kSpaceMouse = QStringLiteral("view/space_mouse");
const auto kSpaceMouseSpeed = QStringLiteral("view/space_mouse_speed");
const auto kMachineSound = QStringLiteral("sound/machine");
const auto kMachineVolume = QStringLiteral("sound/machine_volume");

constexpr LengthUnit kUnits[] = {LengthUnit::Millimetre, LengthUnit::Centimetre, LengthUnit::Metre, LengthUnit::Inch};

}  // namespace

Preferences loadPreferences() {
  const QSettings settings;
  Preferences preferences;
  preferences.navigation = settings.value(kNavigation).toString();
  preferences.language = settings.value(kLanguage, preferences.language).toString();
  const QString symbol = settings.value(kLengthUnit).toString();
  for (LengthUnit unit : kUnits) {
    if (symbol == QLatin1String(symbolOf(unit))) preferences.lengthUnit = unit;
  }
  bool isNumber = false;
  const int seconds = settings.value(kAutosave).toInt(&isNumber);
  if (isNumber && seconds >= 0) {
    preferences.autosaveSeconds = seconds == 0 ? 0 : std::clamp(seconds, kShortestAutosave, kLongestAutosave);
  }
  preferences.hasSpaceMouse = settings.value(kSpaceMouse, true).toBool();
  const int percent = settings.value(kSpaceMouseSpeed).toInt(&isNumber);
  if (isNumber) preferences.spaceMouseSpeed = std::clamp(percent, kLeastSpaceMouseSpeed, kLargestSpaceMouseSpeed);
  preferences.hasMachineSound = settings.value(kMachineSound, false).toBool();
  const int volume = settings.value(kMachineVolume).toInt(&isNumber);
  if (isNumber) preferences.machineVolume = std::clamp(volume, kLeastMachineVolume, kLargestMachineVolume);
  return preferences;
}

void storePreferences(const Preferences& preferences) {
  QSettings settings;
  settings.setValue(kNavigation, preferences.navigation);
  settings.setValue(kLengthUnit, QLatin1String(symbolOf(preferences.lengthUnit)));
  settings.setValue(kLanguage, preferences.language);
  settings.setValue(kAutosave, preferences.autosaveSeconds);
  settings.setValue(kSpaceMouse, preferences.hasSpaceMouse);
  settings.setValue(kSpaceMouseSpeed, preferences.spaceMouseSpeed);
  settings.setValue(kMachineSound, preferences.hasMachineSound);
  settings.setValue(kMachineVolume, preferences.machineVolume);
}

}  // namespace handwheel
