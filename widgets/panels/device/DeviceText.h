// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/device/DeviceInUse.h"

#include "haptics/safety/SafetySettings.h"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

namespace handwheel {

// Translated texts on the state and properties of a device.
class DeviceText {
  Q_DECLARE_TR_FUNCTIONS(DeviceText)

 public:
  static QString status(DeviceStatus status);
  // Returns the remedy for a status. The result is empty if there is none. driver: the driver of the device, because
  // homing differs between drivers.
  static QString advice(DeviceStatus status, const std::string& driver);
  // Returns one sentence for each action of the safety chain, in the order of its stages.
  static QStringList safety(SafetyActions actions);
  // Describes a reduced stiffness and its reason. stiffness, asked: the reduced and the requested stiffness at the
  // device, N/mm; rate: the rate of the loop, Hz.
  static QString softened(double stiffness, double asked, const DeviceInUse& device, double rate,
                          const QLocale& locale);
  // Returns advice for a loop that is not real-time, with the command that makes it real-time.
  static QString realTimeAdvice();
  static QString realTimeCommand();

  // A line of the data sheet, with the name and the value of a property. Properties that the device lacks are omitted.
  struct Line {
    QString name;
    QString value;
  };
  static std::vector<Line> dataSheet(const DeviceCapabilities& device, const QLocale& locale);
};

}  // namespace handwheel
