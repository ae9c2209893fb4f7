// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "TestClass.h"
#include "text/EnglishPlurals.h"
#include "theme/Theme.h"

#include <QApplication>
#include <QSettings>
#include <QTemporaryDir>
#include <clocale>

namespace handwheel::test {

// Runs a test of widgets, with settings in a temporary folder. In all other respects the test starts like the program.
template <class Test>
int runControlsTest(int argc, char** argv) {
  QApplication application(argc, argv);
  std::setlocale(LC_NUMERIC, "C");
  const QTemporaryDir settings;
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
  QCoreApplication::setOrganizationName("Handwheel");
  QCoreApplication::setApplicationName("HandwheelTest");
  QLocale::setDefault(QLocale::c());
  EnglishPlurals plurals;
  QCoreApplication::installTranslator(&plurals);
  applyTheme(application, ThemeKind::Light);
  Test test;
  return QTest::qExec(&test, argc, argv);
}

}  // namespace handwheel::test

#define HANDWHEEL_CONTROLS_TEST(Test) HANDWHEEL_TEST_RUN(Test, handwheel::test::runControlsTest<Test>)
