// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/RunWindow.h"

#include "controls/Preferences.h"
#include "text/Translations.h"
#include "theme/Icons.h"
#include "theme/Theme.h"
#include "viewport/Viewport.h"
#include "window/MainWindow.h"
#include "window/Screenshot.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QSettings>
#include <QThreadPool>
#include <clocale>
#include <cstdio>
#include <cstdlib>

namespace handwheel {

namespace {

// A library call that does not return is not waited for longer when the program ends.
constexpr int kPatienceMs = 1000;

struct StartOptions {
  QStringList files;
  QString screenshot;  // empty: none
  bool dark = false;
};

StartOptions readArguments(const QApplication& application) {
  QCommandLineParser parser;
  parser.addPositionalArgument(QStringLiteral("files"), QStringLiteral("Mesh files to open."));
  const QCommandLineOption screenshot(QStringLiteral("screenshot"), QStringLiteral("Save a picture and quit."),
                                      QStringLiteral("png"));
  const QCommandLineOption dark(QStringLiteral("dark"), QStringLiteral("Start with the dark theme."));
  parser.addOptions({screenshot, dark});
  parser.process(application);
  return {parser.positionalArguments(), parser.value(screenshot), parser.isSet(dark)};
}

bool isDisplayThere() {
  if (!qEnvironmentVariableIsEmpty("DISPLAY") || !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY")) return true;
  std::fputs(
      "handwheel: There is no display (neither DISPLAY nor WAYLAND_DISPLAY is set); 'handwheel help' lists what "
      "works without one.\n",
      stderr);
  return false;
}

ThemeKind startTheme(const StartOptions& options) {
  const bool dark = QSettings().value(QStringLiteral("darkTheme"), systemTheme() == ThemeKind::Dark).toBool();
  return options.dark || (options.screenshot.isEmpty() && dark) ? ThemeKind::Dark : ThemeKind::Light;
}

}  // namespace

int runWindow(int argc, char** argv, const KindSet& kinds, std::vector<std::unique_ptr<DeviceDriver>> drivers) {
  if (!isDisplayThere()) return 1;
  Viewport::prepareApplication();
  QApplication application(argc, argv);
  std::setlocale(LC_NUMERIC, "C");  // Qt takes over the user's locale; readers and libraries expect points
  QCoreApplication::setOrganizationName(QStringLiteral("Handwheel"));
  QCoreApplication::setApplicationName(QStringLiteral("Handwheel"));
  QCoreApplication::setApplicationVersion(QStringLiteral(HANDWHEEL_VERSION));
  QGuiApplication::setDesktopFileName(QStringLiteral("handwheel"));  // so that the window has the entry's icon
  const Translations translations(loadPreferences().language);
  const StartOptions options = readArguments(application);
  applyTheme(application, startTheme(options));
  QApplication::setWindowIcon(icon(QStringLiteral("handwheel"), themeColours(ThemeKind::Light).accent));

  QThreadPool workers;
  workers.setMaxThreadCount(kJobThreads);
  int code = 0;
  {
    MainWindow window(workers, kinds, std::move(drivers));
    window.openPaths(options.files);
    window.show();
    if (options.screenshot.isEmpty()) window.offerRecovery();
    if (options.screenshot.isEmpty()) window.openDevices();
    if (options.screenshot.isEmpty()) window.calibrateWhenIdle();
    if (!options.screenshot.isEmpty()) takeScreenshot(window, options.screenshot);
    code = QApplication::exec();
  }
  // Everything is saved by now.
  if (!workers.waitForDone(kPatienceMs)) std::_Exit(code);
  return code;
}

}  // namespace handwheel
