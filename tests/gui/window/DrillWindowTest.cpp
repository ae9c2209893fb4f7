// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindowDriver.h"
#include "WindowTestMain.h"
#include "document/exercise/ExerciseSnapshot.h"
#include "document/volume/VolumeDocument.h"
#include "document/volume/exercise/DrillingTask.h"
#include "plot/PlotWidget.h"
#include "tools/volume/DrillingTool.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/tools/ToolHost.h"

#include <QDockWidget>
#include <QLabel>
#include <QPushButton>

using namespace handwheel;
using namespace handwheel::test;

// The exercise of drilling through the window, as a student does it with the mouse.
class DrillWindowTest : public QObject {
  Q_OBJECT

 private:
  static VolumeDocument& volume(WindowDriver& driver) {
    return static_cast<VolumeDocument&>(driver.window().findChild<DocumentTabs*>()->current()->document);
  }
  static ToolRunner& runner(WindowDriver& driver) { return driver.window().findChild<ToolHost*>()->runner(); }
  // A press or a release of the mouse straight above the planned path, or beside it.
  static void point(WindowDriver& driver, PointerEvent::Kind kind, double beside = 0.0) {
    const DrillPlan plan = assignedDrilling(volume(driver).file().assigned)->plan;
    PointerEvent event;
    event.kind = kind;
    event.button = PointerButton::First;
    event.ray = {plan.entry - 100.0 * plan.direction + beside * plan.direction.unitOrthogonal(), plan.direction};
    event.modifiers.shift = true;
    runner(driver).pointer(event);
  }
  static bool begin(WindowDriver& driver) {
    driver.choose("exercise/skull");
    if (!driver.settle()) return false;
    driver.choose("beginExercise");
    if (!driver.settle()) return false;
    driver.find<QAction>("drillTool")->trigger();
    return driver.settle() && runner(driver).tool() && runner(driver).tool()->id() == "drill";
  }

 private slots:
  void init() { QSettings().clear(); }

  // A teacher begins an exercise about either kind of work.
  void newExercises() {
    WindowDriver driver;
    for (const auto& [command, subject] :
         {std::pair{"newExercise", "turning"}, std::pair{"newExercise/drilling", "drilling"}}) {
      driver.choose(command);
      QVERIFY(driver.settle());
      const Document& shown = driver.window().findChild<DocumentTabs*>()->current()->document;
      const SnapshotPointer content = shown.snapshot();
      QCOMPARE(static_cast<const ExerciseSnapshot&>(*content).subject->id(), std::string(subject));
      QVERIFY(static_cast<const ExerciseSnapshot&>(*content).task != nullptr);
    }
    QCOMPARE(driver.tabs(), 2);
  }

  // A skull is made without the window waiting for it.
  void newSkull() {
    WindowDriver driver;
    driver.choose("newSkull");
    QVERIFY(driver.settle());
    QCOMPARE(driver.tabs(), 1);
    const Box box = volume(driver).volume()->volume.extent();
    QVERIFY(box.contains(Vec3(0.0, 179.0, 0.0)));  // voxels of 0.5 mm: 90 mm to the front
    QVERIFY(volume(driver).volume()->volume.material() > 3e5);
  }

  // Begun, drilled, stopped after the breakthrough: flagged and plotted, and measured with its marks.
  void aGoodHole() {
    WindowDriver driver;
    QVERIFY(begin(driver));
    QCOMPARE(driver.tabs(), 2);
    QVERIFY(driver.find<QDockWidget>("drillDock")->isVisible());
    runner(driver).setSetting("feed", PropertyValue(2.0));
    point(driver, PointerEvent::Kind::Press);
    auto* const verdict = driver.find<QLabel>("drillVerdict");
    QVERIFY(QTest::qWaitFor([&] { return verdict->text().startsWith(QStringLiteral("Breakthrough")); }, 60'000));
    point(driver, PointerEvent::Kind::Release);
    QVERIFY(driver.settle());
    const auto hole = dynamic_cast<const DrillingTool*>(runner(driver).tool())->hole();
    QVERIFY(hole->breakthrough && hole->figures.forbidden == 0.0);
    const auto thrust = driver.find<PlotWidget>("drillThrust")->plot();
    QCOMPARE(thrust.series.size(), std::size_t{3});  // ours, the reference, the breakthrough
    double highest = 0.0;
    for (const QPointF& p : thrust.series[0].points) highest = std::max(highest, p.y());
    QCOMPARE(highest, hole->maxThrust);
    QVERIFY(driver.find<QWidget>("exerciseLesson")->isVisible());
    driver.find<QWidget>("exerciseLesson")->findChild<QPushButton*>("lesson/measure")->click();
    QVERIFY(driver.settle());
    QString labels;
    for (const QLabel* label : driver.find<QWidget>("exerciseLesson")->findChildren<QLabel*>()) labels += label->text();
    QVERIFY2(labels.contains(QStringLiteral("✓")), qPrintable(labels));
  }

  // Beside the path it warns; into the brain it fails, visibly.
  void intoTheBrain() {
    WindowDriver driver;
    QVERIFY(begin(driver));
    runner(driver).setSetting("feed", PropertyValue(8.0));
    auto* const verdict = driver.find<QLabel>("drillVerdict");
    point(driver, PointerEvent::Kind::Press, 3.0);
    QVERIFY(
        QTest::qWaitFor([&] { return verdict->text().contains(QStringLiteral("beside the planned path")); }, 60'000));
    QVERIFY(QTest::qWaitFor([&] { return verdict->text().contains(QStringLiteral("this try has failed")); }, 60'000));
    point(driver, PointerEvent::Kind::Release, 3.0);
    QVERIFY(driver.settle());
    const auto labels = driver.window().findChildren<QLabel*>();
    QVERIFY(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
      return label->isVisible() && label->text().contains(QStringLiteral("The try has failed"));
    }));
    // Undone, the hole and its record are gone.
    volume(driver).history()->undo();
    QVERIFY(volume(driver).volume()->holes.empty());
  }
};

HANDWHEEL_WINDOW_TEST(DrillWindowTest)
#include "DrillWindowTest.moc"
