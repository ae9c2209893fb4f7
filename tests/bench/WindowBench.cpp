// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// How long the window's thread is kept from its events while a person works on a million triangles. The bar is on its
// CPU time, which other programs do not move; the time by the clock stands beside it, and that of drawing.
#include "bench/SimulatedUser.h"
#include "gui/window/StlFiles.h"
#include "theme/Theme.h"
#include "window/mesh/deviation/DeviationPanel.h"

#include <clocale>

using namespace handwheel;
using bench::Person;

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

void repairs(Person& person) {
  auto& driver = person.driver();
  person.does("choose a hole", [&] { driver.clickDefect(DefectKind::Hole, 3); });
  person.does("fill it", [&] { person.trigger("fillHole"); });
  person.does("undo", [&] { person.trigger("undo"); });
  person.does("redo", [&] { person.trigger("redo"); });
  person.does("keep a hole open", [&] {
    driver.clickDefect(DefectKind::Hole, 5);
    person.trigger("keepOpen");
  });
  person.does("repair all", [&] { person.trigger("repairAll"); });
  person.does("undo of it", [&] { person.trigger("undo"); });
}

void selects(Person& person) {
  auto& driver = person.driver();
  person.does("take up the select tool", [&] { person.trigger("selectTool"); });
  person.waits("connected faces", [&] {
    person.choose("toolDock", "mode", 3);
    QTest::mouseClick(&person.view(), Qt::LeftButton, {}, person.at(0.2, 0.55));
    return true;
  });
  person.waits("brush", [&] {
    person.choose("toolDock", "mode", 1);
    return person.drag(Qt::LeftButton, person.at(0.2, 0.5), person.at(0.5, 0.6));
  });
  person.waits("lasso", [&] {
    person.choose("toolDock", "mode", 2);
    return person.drag(Qt::LeftButton, person.at(0.1, 0.1), person.at(0.9, 0.8));
  });
  person.does("select all", [&] { driver.find<QAbstractButton>("toolAction/all")->click(); });
  person.does("invert the selection", [&] { driver.find<QAbstractButton>("toolAction/invert")->click(); });
  person.waits("brush again", [&] {
    person.choose("toolDock", "mode", 1);
    return person.drag(Qt::LeftButton, person.at(0.2, 0.5), person.at(0.5, 0.6));
  });
  person.does("delete the selection", [&] { driver.find<QAbstractButton>("toolAction/delete")->click(); });
  person.does("take up the measuring tool", [&] { person.trigger("measureTool"); });
  person.waits("measure", [&] {
    QTest::mouseClick(&person.view(), Qt::LeftButton, {}, person.at(0.2, 0.55));
    QTest::mouseClick(&person.view(), Qt::LeftButton, {}, person.at(0.7, 0.55));
    return true;
  });
}

void looks(Person& person) {
  person.waits("orbit", [&] { return person.drag(Qt::MiddleButton, person.at(0.5, 0.5), person.at(0.7, 0.4)); });
  person.waits("hover", [&] {
    for (int i = 0; i < 50; ++i) QTest::mouseMove(&person.view(), person.at(0.1 + 0.016 * i, 0.5));
    return true;
  });
  for (const char* action : {"shadedWithEdges", "shaded", "viewTop", "fitView", "clipModel", "fidelityDockToggle",
                             "statusDockToggle", "logDockToggle", "searchCommands"}) {
    person.does(action, [&, action] { person.trigger(action); });
  }
}

// Qt styles every widget of the window anew, at once.
void changesTheme(Person& person) {
  for (const char* what : {"dark theme", "light theme", "dark theme again"}) {
    person.does(what, [&] { person.trigger("darkTheme"); });
  }
}

// Colours by distance, a brush on the surface, and a plane through it.
void shapes(Person& person) {
  auto& driver = person.driver();
  person.does("deviation colours", [&] { person.trigger("deviation"); });
  person.does("another range of them", [&] { emit driver.find<DeviationPanel>("deviationPanel")->rangeChosen(1.0); });
  person.does("without them", [&] { person.trigger("deviation"); });
  person.does("take up the sculpt tool", [&] { person.trigger("sculptTool"); });
  person.does("all of the mesh", [&] { driver.find<QAbstractButton>("toolAction/whole")->click(); });
  const QPoint place = person.at(0.2, 0.55);
  person.waits("a dab", [&] {
    QTest::mouseClick(&person.view(), Qt::LeftButton, {}, place);
    return true;
  });
  if (!driver.find<QAction>("undo")->isEnabled()) qFatal("the dab missed");
  person.waits("a stroke", [&] { return person.drag(Qt::LeftButton, place, person.at(0.3, 0.6)); });
  person.does("leave the tool", [&] { person.trigger("selectTool"); });
  person.does("a section", [&] { person.trigger("clipModel"); });
  for (const int axis : {0, 1, 2}) {
    person.does((std::string("a section across ") + "XYZ"[axis]).c_str(),
                [&] { person.choose("viewDock", "clip_axis", axis); });
  }
}

void files(Person& person, const QTemporaryDir& folder, const QString& path) {
  auto& driver = person.driver();
  person.does("ask for a name", [&] { person.trigger("saveFileAs"); });
  person.waits("save", [&] { return driver.enterFileName("saveDialog", folder.filePath("saved.handwheel")); });
  person.does("a second document", [&] { driver.window().openPaths({path}); });
  person.does("back to the first", [&] { driver.find<QTabBar>("documentTabBar")->setCurrentIndex(0); });
}

// A window of its own for each kind of work, so that one can be measured alone (--benchmark_filter).
void add(const char* name, const std::function<void(Person&, const QTemporaryDir&, const QString& path)>& work) {
  benchmark::RegisterBenchmark(name,
                               [work](benchmark::State& state) {
                                 const QTemporaryDir folder;
                                 const QString path = fileIn(folder);
                                 for (auto _ : state) {
                                   Person person(*application, bars);
                                   person.does("open", [&] { person.driver().window().openPaths({path}); });
                                   work(person, folder, path);
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
  const auto alone = [](void (*work)(Person&)) {
    return [work](Person& person, const QTemporaryDir&, const QString&) { work(person); };
  };
  add("looks", alone(looks));
  add("theme", alone(changesTheme));
  add("repairs", alone(repairs));
  add("selects", alone(selects));
  add("shapes", alone(shapes));
  add("files", files);
  return bench::run(argc, argv, bars);
}
