// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// How long the window's thread is kept from its events while a person works on a million triangles. The bar is on its
// CPU time, which other programs do not move; the time by the clock stands beside it, and that of drawing.
#include "base/ThreadClock.h"
#include "bench/Bars.h"
#include "gui/window/StlFiles.h"
#include "gui/window/WindowDriver.h"
#include "theme/Theme.h"
#include "viewport/Viewport.h"

#include <QApplication>
#include <QComboBox>
#include <QSettings>
#include <QTemporaryDir>
#include <clocale>

using namespace handwheel;

namespace {

constexpr double kBarMs = 50.0;

bench::Bars bars;

// Times each event from the outside of all that it leads to.
class TimedApplication : public QApplication {
 public:
  using QApplication::QApplication;

  // The longest of an event.
  Spent outside;  // outside the graphics library
  Spent drawing;  // in it

  // Null: nobody.
  void watch(const Viewport* viewport) {
    m_viewport = viewport;
    if (!viewport) return;
    // Qt puts the picture of the renderer into that of the window, by the same graphics library.
    connect(viewport, &Viewport::aboutToCompose, this, [this] { m_composing = Spent::now(); });
    connect(viewport, &Viewport::frameSwapped, this,
            [this] { m_composed = m_composed + (Spent::now() - m_composing); });
  }

  bool notify(QObject* receiver, QEvent* event) override {
    if (m_isInside || !m_viewport) return QApplication::notify(receiver, event);
    m_isInside = true;
    const Spent start = Spent::now(), drawnBefore = m_viewport->timeDrawing() + m_composed;
    const bool isAccepted = QApplication::notify(receiver, event);
    const Spent drawn = m_viewport->timeDrawing() + m_composed - drawnBefore;
    keepLongest(outside, Spent::now() - start - drawn);
    keepLongest(drawing, drawn);
    m_isInside = false;
    return isAccepted;
  }

 private:
  static void keepLongest(Spent& longest, const Spent& one) {
    longest = {std::max(longest.clock, one.clock), std::max(longest.cpu, one.cpu)};
  }

  bool m_isInside = false;
  const Viewport* m_viewport = nullptr;
  Spent m_composing;
  Spent m_composed;
};

TimedApplication* application = nullptr;

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
  test::writeStl(path, test::torus(1010, 500, missing));
  return path;
}

class Person {
 public:
  Person() : m_view(m_driver.find<Viewport>("viewport")) { application->watch(m_view); }
  ~Person() { application->watch(nullptr); }

  // How long the work and all that follows from it keep the thread busy, until the window has come to rest.
  void does(const char* what, const std::function<void()>& work, double bar = kBarMs) {
    waits(
        what, [&] { return QMetaObject::invokeMethod(&m_driver.window(), work, Qt::QueuedConnection); }, bar);
  }
  // The same for gestures and other work that runs its events itself, one by one.
  void waits(const char* what, const std::function<bool()>& work, double bar = kBarMs) {
    application->outside = application->drawing = {};
    if (!work()) qFatal("%s could not be done", what);
    for (int turn = 0; turn < 30 || !m_driver.window().isSettled(); ++turn) {
      QCoreApplication::processEvents();
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    const Spent &outside = application->outside, &drawing = application->drawing;
    std::printf("%-26s %8.1f %8.1f   %8.1f\n", what, outside.cpu, outside.clock, drawing.clock);
    bars.atMost(std::string(what) + ": the window's thread, ms of CPU", bar, outside.cpu);
  }

  test::WindowDriver& driver() { return m_driver; }
  Viewport& view() { return *m_view; }
  QPoint at(double x, double y) const {
    return {static_cast<int>(x * m_view->width()), static_cast<int>(y * m_view->height())};
  }
  bool drag(Qt::MouseButton button, QPoint from, QPoint to) {
    QTest::mousePress(m_view, button, {}, from);
    for (int step = 1; step <= 20; ++step) QTest::mouseMove(m_view, from + (to - from) * step / 20);
    QTest::mouseRelease(m_view, button, {}, to);
    return true;
  }
  void chooseInTool(const char* property, int index) {
    auto* row = m_driver.find<QWidget>("toolDock")->findChild<QWidget*>(QStringLiteral("property/") + property);
    auto* box = row->findChild<QComboBox*>();
    box->setCurrentIndex(index);
    emit box->activated(index);
  }

 private:
  test::WindowDriver m_driver;
  Viewport* m_view;
};

void repairs(Person& person) {
  auto& driver = person.driver();
  person.does("choose a hole", [&] { driver.clickDefect(DefectKind::Hole, 3); });
  person.does("fill it", [&] { driver.find<QAction>("fillHole")->trigger(); });
  person.does("undo", [&] { driver.find<QAction>("undo")->trigger(); });
  person.does("redo", [&] { driver.find<QAction>("redo")->trigger(); });
  person.does("keep a hole open", [&] {
    driver.clickDefect(DefectKind::Hole, 5);
    driver.find<QAction>("keepOpen")->trigger();
  });
  person.does("repair all", [&] { driver.find<QAction>("repairAll")->trigger(); });
  person.does("undo of it", [&] { driver.find<QAction>("undo")->trigger(); });
}

void selects(Person& person) {
  auto& driver = person.driver();
  person.does("take up the select tool", [&] { driver.find<QAction>("selectTool")->trigger(); });
  person.waits("connected faces", [&] {
    person.chooseInTool("mode", 3);
    QTest::mouseClick(&person.view(), Qt::LeftButton, {}, person.at(0.2, 0.55));
    return true;
  });
  person.waits("brush", [&] {
    person.chooseInTool("mode", 1);
    return person.drag(Qt::LeftButton, person.at(0.2, 0.5), person.at(0.5, 0.6));
  });
  person.waits("lasso", [&] {
    person.chooseInTool("mode", 2);
    return person.drag(Qt::LeftButton, person.at(0.1, 0.1), person.at(0.9, 0.8));
  });
  person.does("select all", [&] { driver.find<QAbstractButton>("toolAction/all")->click(); });
  person.does("select the rest", [&] { driver.find<QAbstractButton>("toolAction/invert")->click(); });
  person.waits("brush again", [&] {
    person.chooseInTool("mode", 1);
    return person.drag(Qt::LeftButton, person.at(0.2, 0.5), person.at(0.5, 0.6));
  });
  person.does("delete the selection", [&] { driver.find<QAbstractButton>("toolAction/delete")->click(); });
  person.does("take up the measuring tool", [&] { driver.find<QAction>("measureTool")->trigger(); });
  person.waits("measure", [&] {
    QTest::mouseClick(&person.view(), Qt::LeftButton, {}, person.at(0.2, 0.55));
    QTest::mouseClick(&person.view(), Qt::LeftButton, {}, person.at(0.7, 0.55));
    return true;
  });
}

void looks(Person& person) {
  auto& driver = person.driver();
  person.waits("orbit", [&] { return person.drag(Qt::MiddleButton, person.at(0.5, 0.5), person.at(0.7, 0.4)); });
  person.waits("hover", [&] {
    for (int i = 0; i < 50; ++i) QTest::mouseMove(&person.view(), person.at(0.1 + 0.016 * i, 0.5));
    return true;
  });
  for (const char* action : {"shadedWithEdges", "shaded", "viewTop", "fitView", "clipModel", "fidelityDockToggle",
                             "statusDockToggle", "logDockToggle", "searchCommands"}) {
    person.does(action, [&, action] { driver.find<QAction>(action)->trigger(); });
  }
  // Qt styles every widget of the window anew, at once.
  person.does(
      "darkTheme", [&] { driver.find<QAction>("darkTheme")->trigger(); }, 2.0 * kBarMs);
}

void aPersonAtWork(benchmark::State& state) {
  const QTemporaryDir folder;
  const QString path = fileIn(folder);
  std::printf("%-26s %8s %8s   %8s\n", "longest event, ms", "CPU", "clock", "drawing");
  for (auto _ : state) {
    Person person;
    auto& driver = person.driver();
    person.does("open", [&] { driver.window().openPaths({path}); });
    looks(person);
    repairs(person);
    selects(person);
    person.does("ask for a name", [&] { driver.find<QAction>("saveFileAs")->trigger(); });
    person.waits("save", [&] { return driver.enterFileName("saveDialog", folder.filePath("saved.handwheel")); });
    person.does("a second document", [&] { driver.window().openPaths({path}); });
    person.does("back to the first", [&] { driver.find<QTabBar>("documentTabBar")->setCurrentIndex(0); });
  }
}

}  // namespace

BENCHMARK(aPersonAtWork)->Unit(benchmark::kSecond)->Iterations(1);

int main(int argc, char** argv) {
  Viewport::prepareApplication();
  TimedApplication app(argc, argv);
  application = &app;
  std::setlocale(LC_NUMERIC, "C");
  const QTemporaryDir settings;
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
  QCoreApplication::setOrganizationName(QStringLiteral("Handwheel"));
  QCoreApplication::setApplicationName(QStringLiteral("HandwheelBench"));
  applyTheme(app, ThemeKind::Light);
  return bench::run(argc, argv, bars);
}
