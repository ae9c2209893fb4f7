// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures how long the window's thread is kept from its events while a user works on a million triangles. The bar is
// on its CPU time, which other programs do not affect; the time by the clock and that of drawing are shown beside it.
#include "bench/SimulatedUser.h"
#include "gui/window/StlFiles.h"
#include "theme/Theme.h"
#include "window/mesh/deviation/DeviationPanel.h"

#include <clocale>

using namespace handwheel;
using bench::SimulatedUser;

namespace {

bench::Bars bars;
bench::TimedApplication* application = nullptr;

// A torus of 1 M triangles with 40 holes of 24 edges and one of 400.
QString fileIn(const QTemporaryDir& folder) {
  std::set<std::pair<int, int>> missing;
  for (int hole = 0; hole < 40; ++hole) {
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) missing.emplace(24 * hole + i, (70 * hole) % 480 + j);
    }
  }
  for (int i = 0; i < 100; ++i) {
    for (int j = 0; j < 100; ++j) missing.emplace(500 + i, 120 + j);
  }
  const QString path = folder.filePath(QStringLiteral("million.stl"));
  test::writeStl(path, test::quadTorus(1010, 500, missing));
  return path;
}

void repairs(SimulatedUser& user) {
  auto& driver = user.driver();
  user.does("choose a hole", [&] { driver.clickDefect(DefectKind::Hole, 3); });
  user.does("fill it", [&] { user.trigger("fillHole"); });
  user.does("undo", [&] { user.trigger("undo"); });
  user.does("redo", [&] { user.trigger("redo"); });
  user.does("keep a hole open", [&] {
    driver.clickDefect(DefectKind::Hole, 5);
    user.trigger("keepOpen");
  });
  user.does("repair all", [&] { user.trigger("repairAll"); });
  user.does("undo of it", [&] { user.trigger("undo"); });
}

void selects(SimulatedUser& user) {
  auto& driver = user.driver();
  user.does("take up the select tool", [&] { user.trigger("selectTool"); });
  user.waits("connected faces", [&] {
    user.choose("toolDock", "mode", 3);
    QTest::mouseClick(&user.view(), Qt::LeftButton, {}, user.at(0.2, 0.55));
    return true;
  });
  user.waits("brush", [&] {
    user.choose("toolDock", "mode", 1);
    return user.drag(Qt::LeftButton, user.at(0.2, 0.5), user.at(0.5, 0.6));
  });
  user.waits("lasso", [&] {
    user.choose("toolDock", "mode", 2);
    return user.drag(Qt::LeftButton, user.at(0.1, 0.1), user.at(0.9, 0.8));
  });
  user.does("select all", [&] { driver.find<QAbstractButton>("toolAction/all")->click(); });
  user.does("invert the selection", [&] { driver.find<QAbstractButton>("toolAction/invert")->click(); });
  user.waits("brush again", [&] {
    user.choose("toolDock", "mode", 1);
    return user.drag(Qt::LeftButton, user.at(0.2, 0.5), user.at(0.5, 0.6));
  });
  user.does("delete the selection", [&] { driver.find<QAbstractButton>("toolAction/delete")->click(); });
  user.does("take up the measuring tool", [&] { user.trigger("measureTool"); });
  user.waits("measure", [&] {
    QTest::mouseClick(&user.view(), Qt::LeftButton, {}, user.at(0.2, 0.55));
    QTest::mouseClick(&user.view(), Qt::LeftButton, {}, user.at(0.7, 0.55));
    return true;
  });
}

void looks(SimulatedUser& user) {
  user.waits("orbit", [&] { return user.drag(Qt::MiddleButton, user.at(0.5, 0.5), user.at(0.7, 0.4)); });
  user.waits("hover", [&] {
    for (int i = 0; i < 50; ++i) QTest::mouseMove(&user.view(), user.at(0.1 + 0.016 * i, 0.5));
    return true;
  });
  for (const char* action : {"shadedWithEdges", "shaded", "viewTop", "fitView", "clipModel", "fidelityDockToggle",
                             "statusDockToggle", "logDockToggle", "searchCommands"}) {
    user.does(action, [&, action] { user.trigger(action); });
  }
}

// Qt styles every widget of the window anew, at once.
void changesTheme(SimulatedUser& user) {
  for (const char* what : {"dark theme", "light theme", "dark theme again"}) {
    user.does(what, [&] { user.trigger("darkTheme"); });
  }
}

// Colours by distance, a brush on the surface, and a plane through it.
void shapes(SimulatedUser& user) {
  auto& driver = user.driver();
  user.does("deviation colours", [&] { user.trigger("deviation"); });
  user.does("another range of them", [&] { emit driver.find<DeviationPanel>("deviationPanel")->rangeChosen(1.0); });
  user.does("without them", [&] { user.trigger("deviation"); });
  user.does("take up the sculpt tool", [&] { user.trigger("sculptTool"); });
  user.does("all of the mesh", [&] { driver.find<QAbstractButton>("toolAction/whole")->click(); });
  const QPoint position = user.at(0.2, 0.55);
  user.waits("a dab", [&] {
    QTest::mouseClick(&user.view(), Qt::LeftButton, {}, position);
    return true;
  });
  if (!driver.find<QAction>("undo")->isEnabled()) qFatal("the dab missed");
  user.waits("a stroke", [&] { return user.drag(Qt::LeftButton, position, user.at(0.3, 0.6)); });
  user.does("leave the tool", [&] { user.trigger("selectTool"); });
  user.does("a section", [&] { user.trigger("clipModel"); });
  for (const int axis : {0, 1, 2}) {
    user.does((std::string("a section across ") + "XYZ"[axis]).c_str(),
              [&] { user.choose("viewDock", "clip_axis", axis); });
  }
}

void files(SimulatedUser& user, const QTemporaryDir& folder, const QString& path) {
  auto& driver = user.driver();
  user.does("ask for a name", [&] { user.trigger("saveFileAs"); });
  user.waits("save", [&] { return driver.enterFileName("saveDialog", folder.filePath("saved.handwheel")); });
  user.does("a second document", [&] { driver.window().openPaths({path}); });
  user.does("back to the first", [&] { driver.find<QTabBar>("documentTabBar")->setCurrentIndex(0); });
}

// A window of its own for each kind of work, so that one can be measured alone (--benchmark_filter).
void add(const char* name, const std::function<void(SimulatedUser&, const QTemporaryDir&, const QString& path)>& work) {
  benchmark::RegisterBenchmark(name,
                               [work](benchmark::State& state) {
                                 const QTemporaryDir folder;
                                 const QString path = fileIn(folder);
                                 for (auto _ : state) {
                                   SimulatedUser user(*application, bars);
                                   user.does("open", [&] { user.driver().window().openPaths({path}); });
                                   work(user, folder, path);
                                 }
                               })
      ->Unit(benchmark::kSecond)
      ->Iterations(1);
}

}  // namespace

int main(int argc, char** argv) {
  Viewport::prepareApplication();
  bench::TimedApplication app(argc, argv);
  application = &app;
  std::setlocale(LC_NUMERIC, "C");
  const QTemporaryDir settings;
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
  QCoreApplication::setOrganizationName(QStringLiteral("Handwheel"));
  QCoreApplication::setApplicationName(QStringLiteral("HandwheelBench"));
  applyTheme(app, ThemeKind::Light);
  const auto alone = [](void (*work)(SimulatedUser&)) {
    return [work](SimulatedUser& user, const QTemporaryDir&, const QString&) { work(user); };
  };
  add("looks", alone(looks));
  add("theme", alone(changesTheme));
  add("repairs", alone(repairs));
  add("selects", alone(selects));
  add("shapes", alone(shapes));
  add("files", files);
  return bench::run(argc, argv, bars);
}
