// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "base/Units.h"

namespace handwheel {

// The user's preferences, which apply to all documents.
struct Preferences {
  QString navigation;                              // id of a preset of mouse navigation; empty: the program's default
  LengthUnit lengthUnit = LengthUnit::Millimetre;  // unit of new documents
  QString language = QStringLiteral("system");     // code of a language, such as "de", or "system"
  int autosaveSeconds = 20;                        // 0: never
  bool hasSpaceMouse = true;                       // a space mouse moves the view
  int spaceMouseSpeed = 100;                       // speed of this motion, percent
  bool hasMachineSound = false;                    // machines make sounds
  int machineVolume = 70;                          // volume of these sounds, percent

  bool operator==(const Preferences&) const = default;
};

inline constexpr int kShortestAutosave = 5;  // seconds
inline constexpr int kLongestAutosave = 600;
inline constexpr int kLeastSpaceMouseSpeed = 10;  // percent
inline constexpr int kLargestSpaceMouseSpeed = 500;
inline constexpr int kLeastMachineVolume = 5;  // percent
inline constexpr int kLargestMachineVolume = 100;

// Loads the preferences from the program's settings. Invalid values are replaced by the defaults, and numbers out of
// range by the nearest limit.
Preferences loadPreferences();
// Stores the preferences in the program's settings.
void storePreferences(const Preferences& preferences);

}  // namespace handwheel
