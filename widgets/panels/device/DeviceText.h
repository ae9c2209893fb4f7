// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/device/DeviceInUse.h"

#include "haptics/safety/SafetySettings.h"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

namespace handwheel {

// Texts on the state and properties of a device, translated.
class DeviceText {
  Q_DECLARE_TR_FUNCTIONS(DeviceText)

 public:
  static QString status(DeviceStatus status);
  // What the user can do about a status; empty when there is nothing. driver: of the device, each homes in its own way.
  static QString advice(DeviceStatus status, const std::string& driver);
  // One sentence for each action of the safety chain, in the order of its stages.
  static QStringList safety(SafetyActions actions);
  // What was made softer than it was set, and why. Both stiffnesses at the device, N/mm; rate: of the loop, Hz.
  static QString softened(double stiffness, double asked, const DeviceInUse& device, double rate,
                          const QLocale& locale);
  // What to do when the loop is not real-time, and the command that does it.
  static QString realTimeAdvice();
  static QString realTimeCommand();

  // The data sheet: name and value of each line. Properties that the device lacks are left out.
  struct Line {
    QString name;
    QString value;
  };
  static std::vector<Line> dataSheet(const DeviceCapabilities& device, const QLocale& locale);
};

}  // namespace handwheel
