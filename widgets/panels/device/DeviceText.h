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
  // Returns the remedy for a status; empty if there is none. driver: that of the device, as each homes differently.
  static QString advice(DeviceStatus status, const std::string& driver);
  // Returns one sentence for each action of the safety chain, in the order of its stages.
  static QStringList safety(SafetyActions actions);
  // Describes a reduced stiffness and its reason. Both stiffnesses at the device, N/mm; rate: that of the loop, Hz.
  static QString softened(double stiffness, double asked, const DeviceInUse& device, double rate,
                          const QLocale& locale);
  // Returns advice for a loop that is not real-time, and the command to follow it.
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
