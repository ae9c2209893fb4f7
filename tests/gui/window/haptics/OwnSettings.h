// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QSettings>
#include <QTemporaryDir>

namespace handwheel::test {

// An environment without plugins, and with settings that no other test uses.
class OwnSettings {
 public:
  void use() {
    qputenv("HANDWHEEL_PLUGINS", m_folder.path().toLocal8Bit());  // an empty folder
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
    QCoreApplication::setOrganizationName(QStringLiteral("Handwheel"));
    QCoreApplication::setApplicationName(QStringLiteral("HandwheelTest"));
  }

 private:
  QTemporaryDir m_folder;
};

}  // namespace handwheel::test
