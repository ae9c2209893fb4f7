// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "TestClass.h"
#include "text/EnglishPlurals.h"
#include "theme/Theme.h"
#include "viewport/Viewport.h"

#include <QApplication>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>
#include <clocale>

namespace handwheel::test {

// Runs a test of the window, with settings and autosaves in a temporary folder. Everything else starts as in the
// program. Test classes run at the same time, and must not find or remove each other's recovery data.
template <class Test>
int runWindowTest(int argc, char** argv) {
  Viewport::prepareApplication();
  QApplication application(argc, argv);
  std::setlocale(LC_NUMERIC, "C");
  const QTemporaryDir folder;
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder.path());
  qputenv("XDG_DATA_HOME", QFile::encodeName(folder.path()));
  QCoreApplication::setOrganizationName("Handwheel");
  QCoreApplication::setApplicationName("HandwheelTest");
  EnglishPlurals plurals;
  QCoreApplication::installTranslator(&plurals);
  applyTheme(application, ThemeKind::Light);
  Test test;
  return QTest::qExec(&test, argc, argv);
}

}  // namespace handwheel::test

#define HANDWHEEL_WINDOW_TEST(Test) HANDWHEEL_TEST_RUN(Test, handwheel::test::runWindowTest<Test>)
