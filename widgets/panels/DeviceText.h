// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/DeviceInUse.h"

#include "haptics/SafetySettings.h"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

namespace handwheel {

// What there is to say about a device, in words.
class DeviceText {
  Q_DECLARE_TR_FUNCTIONS(DeviceText)

 public:
  static QString status(DeviceStatus status);
  // What the user can do; empty where there is nothing.
  static QString advice(DeviceStatus status);
  // What the safety chain does, a sentence for each, in the order of its stages.
  static QStringList safety(SafetyActions actions);
  // What to do when the loop is not real-time, and the command that does it.
  static QString realTimeAdvice();
  static QString realTimeCommand();

  // The data sheet: name and value of each line. What a device does not have is left out.
  struct Line {
    QString name;
    QString value;
  };
  static std::vector<Line> dataSheet(const DeviceCapabilities& device, const QLocale& locale);
};

}  // namespace handwheel
