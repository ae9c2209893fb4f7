// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../StlFiles.h"
#include "../WindowDriver.h"
#include "../WindowTestMain.h"
#include "MeshShapes.h"
#include "controls/CommandModel.h"
#include "document/exercise/ExerciseSnapshot.h"
#include "document/volume/VolumeDocument.h"
#include "document/volume/exercise/DrillingTask.h"
#include "mesh/structure/TriangleSoup.h"
#include "panels/ActionButton.h"
#include "plot/PlotWidget.h"
#include "tools/mesh/voxels/MeshDrillTool.h"
#include "tools/volume/DrillingTool.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/tools/ToolHost.h"

#include <QDockWidget>
#include <QHelpEvent>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QToolTip>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

// Drilling through the window with the mouse: the exercise, as a student does it, and a mesh from a file.
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
  // The same straight above a mesh.
  static void pointAtMesh(WindowDriver& driver, PointerEvent::Kind kind, double x, double y) {
    PointerEvent event;
    event.kind = kind;
    event.button = PointerButton::First;
    event.ray = {Vec3(x, y, 300.0), -Vec3::UnitZ()};
    runner(driver).pointer(event);
  }
  static bool isReady(WindowDriver& driver) {
    return QTest::qWaitFor(
        [&] { return runner(driver).tool()->actions().front().effect == "drill across the surface"; }, 60'000);
  }
  static std::vector<Corners> stlOf(const TriangleSoup& soup) {
    std::vector<Corners> all;
    for (const Triangle& t : soup.triangles) {
      Corners& corners = all.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& p = soup.points[t[k]];
        corners[k] = {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
      }
    }
    return all;
  }
  static double volumeOf(const std::vector<Corners>& triangles) {
    double sum = 0.0;
    for (const Corners& t : triangles) {
      Vec3 p[3];
      for (std::size_t k = 0; k < 3; ++k) p[k] = Vec3(t[k][0], t[k][1], t[k][2]);
      sum += p[0].dot(p[1].cross(p[2])) / 6.0;
    }
    return sum;
  }
  static bool begin(WindowDriver& driver) {
    driver.choose("exercise/skull");
    if (!driver.settle()) return false;
    driver.choose("beginExercise");
    if (!driver.settle()) return false;
    driver.find<QAction>("drillTool")->trigger();
    return driver.settle() && runner(driver).tool() && runner(driver).tool()->id() == "drill";
  }

  // Returns the tool tip of the pointer over a button of an action.
  static QString restsOn(QWidget& button) {
    QHelpEvent rest(QEvent::ToolTip, button.rect().center(), QPoint(20, 20));
    QCoreApplication::sendEvent(&button, &rest);
    return QToolTip::text();
  }

  // Checks that the tool tip of an entry in the menu shows the reason.
  static void showsTheReason(WindowDriver& driver, const char* name) {
    auto* const action = driver.find<QAction>(name);
    for (QMenu* menu : driver.window().findChildren<QMenu*>()) {
      if (!menu->actions().contains(action)) continue;
      menu->popup(driver.window().mapToGlobal(QPoint(100, 100)));
      QHelpEvent rest(QEvent::ToolTip, menu->actionGeometry(action).center(), QPoint(20, 20));
      QCoreApplication::sendEvent(menu, &rest);
      const QString text = QToolTip::text();
      menu->close();
      QVERIFY2(text.contains(action->property(kDisabledReason).toString()), qPrintable(text));
      return;
    }
    QFAIL("it is in no menu");
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
    QVERIFY(box.contains(Vec3(0.0, 179.0, 0.0)));  // voxels of 0.5 mm: 90 mm to the back
    QVERIFY(volume(driver).volume()->volume.material() > 3e5);
    for (const char* name : {"volumeSmooth", "clayLayersToggle"}) {
      const QAction* const action = driver.find<QAction>(name);
      QVERIFY2(action->isEnabled() && action->property(kDisabledReason).toString().isEmpty(), name);
    }
  }

  // Begun, drilled, stopped after the breakthrough: flagged and plotted, and measured with its marks.
  void aGoodHole() {
    WindowDriver driver;
    QVERIFY(begin(driver));
    QCOMPARE(driver.tabs(), 2);
    QVERIFY(driver.find<QDockWidget>("drillDock")->isVisible());
    // All other changes of the volume are disabled, with a reason.
    for (const char* name : {"volumeSmooth", "volumeShell", "volumeBoolean", "clayLayersToggle"}) {
      const QAction* const action = driver.find<QAction>(name);
      QVERIFY2(!action->isEnabled() && action->property(kDisabledReason).toString().contains("drilled"), name);
    }
    showsTheReason(driver, "volumeSmooth");
    QAction* const smooth = driver.find<QAction>("volumeSmooth");
    QToolButton toolButton;
    toolButton.setDefaultAction(smooth);
    ActionButton button(smooth);
    for (QWidget* const each : {static_cast<QWidget*>(&toolButton), static_cast<QWidget*>(&button)}) {
      each->show();
      const QString text = restsOn(*each);
      QVERIFY2(text.contains("drilled") && text.contains(smooth->toolTip()), qPrintable(text));
    }
    runner(driver).setSetting("feed", PropertyValue(2.0));
    point(driver, PointerEvent::Kind::Press);
    auto* const verdict = driver.find<QLabel>("drillVerdict");
    QVERIFY(QTest::qWaitFor([&] { return verdict->text().startsWith(QStringLiteral("Breakthrough")); }, 60'000));
    QVERIFY(verdict->text().contains(QStringLiteral("stop")));
    point(driver, PointerEvent::Kind::Release);
    QVERIFY(driver.settle());
    // There is nothing left to be stopped.
    QTRY_VERIFY(verdict->text().startsWith(QStringLiteral("Breakthrough")) &&
                !verdict->text().contains(QStringLiteral("stop")));
    const auto hole = dynamic_cast<const DrillingTool*>(runner(driver).tool())->hole();
    QVERIFY(hole->breakthrough && hole->figures.forbidden == 0.0);
    const auto thrust = driver.find<PlotWidget>("drillThrust")->plot();
    QCOMPARE(thrust.series.size(), std::size_t{3});  // ours, the reference, the breakthrough
    double highest = 0.0;
    for (const QPointF& p : thrust.series[0].points) highest = std::max(highest, p.y());
    QCOMPARE(highest, hole->figures.thrust);
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
    const QSize size = driver.window().size();
    runner(driver).setSetting("feed", PropertyValue(8.0));
    auto* const verdict = driver.find<QLabel>("drillVerdict");
    point(driver, PointerEvent::Kind::Press, 3.0);
    QVERIFY(
        QTest::qWaitFor([&] { return verdict->text().contains(QStringLiteral("beside the planned path")); }, 60'000));
    QVERIFY(
        QTest::qWaitFor([&] { return verdict->text().contains(QStringLiteral("this attempt has failed")); }, 60'000));
    point(driver, PointerEvent::Kind::Release, 3.0);
    QVERIFY(driver.settle());
    // The long line is wrapped, and neither widens the panel nor the window.
    QCOMPARE(driver.window().size(), size);
    QVERIFY(verdict->minimumSizeHint().width() < verdict->fontMetrics().horizontalAdvance(verdict->text()));
    QVERIFY(verdict->visibleRegion().boundingRect().height() >= verdict->fontMetrics().height());
    const auto labels = driver.window().findChildren<QLabel*>();
    QVERIFY(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
      return label->isVisible() && label->text().contains(QStringLiteral("The attempt has failed"));
    }));
    // Undone, the hole and its record are gone; that it was tried is not.
    volume(driver).history()->undo();
    QVERIFY(volume(driver).volume()->holes.empty());
    QVERIFY(volume(driver).tried() && volume(driver).tried()->back().forbidden > 0.0);
  }

  // An STL file: through a plate, the hole is in its triangles by one step, and in the file that is saved.
  void aMesh() {
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("plate.stl"));
    const TriangleSoup plate = box({-15.0, -15.0, -4.0}, {30.0, 30.0, 4.0});
    writeStl(path, stlOf(plate));
    WindowDriver driver;
    QVERIFY(driver.open(path));
    driver.find<QAction>("drillTool")->trigger();
    QVERIFY(driver.settle());
    QVERIFY(dynamic_cast<const MeshDrillTool*>(runner(driver).tool()));
    runner(driver).setSetting("diameter", PropertyValue(4.0));
    runner(driver).setSetting("feed", PropertyValue(20.0));
    QVERIFY(isReady(driver));
    pointAtMesh(driver, PointerEvent::Kind::Press, 0.113, -0.271);
    QVERIFY(QTest::qWaitFor(
        [&] {
          const auto hole = static_cast<const MeshDrillTool*>(runner(driver).tool())->hole();
          return hole && hole->breakthrough && hole->figures.plunge > 4.5;
        },
        60'000));
    pointAtMesh(driver, PointerEvent::Kind::Release, 0.113, -0.271);
    QVERIFY(driver.find<QDockWidget>("drillDock")->isVisible());
    QVERIFY(driver.find<QLabel>("drillVerdict")->text().startsWith(QStringLiteral("Breakthrough")));
    Document& document = driver.window().findChild<DocumentTabs*>()->current()->document;
    QVERIFY(QTest::qWaitFor([&] { return document.history()->count() == 1; }, 60'000));
    QVERIFY(driver.settle());
    QCOMPARE(driver.count(DefectKind::Hole), 0);
    document.history()->undo();
    document.history()->redo();
    QVERIFY(isReady(driver));
    driver.choose("saveFileAs");
    const QString saved = folder.filePath(QStringLiteral("drilled.stl"));
    QVERIFY(driver.enterFileName("saveDialog", saved));
    QTRY_VERIFY_WITH_TIMEOUT(!driver.window().isWindowModified(), kPatienceMs);
    const std::vector<Corners> drilled = readStl(saved);
    QCOMPARE(openEdges(drilled), 0);
    const double gone = 3600.0 - volumeOf(drilled), exact = M_PI * 4.0 * 4.0;
    QVERIFY2(std::abs(gone / exact - 1.0) < 0.01, QByteArray::number(gone / exact));
  }

  // A mesh with holes has no inside: the window reports it, and offers to make a volume, with a question.
  void anOpenMesh() {
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("open.stl"));
    writeStl(path, torusWithHole());
    WindowDriver driver;
    QVERIFY(driver.open(path));
    driver.find<QAction>("drillTool")->trigger();
    QVERIFY(driver.settle());
    pointAtMesh(driver, PointerEvent::Kind::Press, 30.0, 0.0);
    auto* const offer = driver.find<QPushButton>("messageAction");
    QTRY_COMPARE_WITH_TIMEOUT(offer->text(), QStringLiteral("Make a volume"), kPatienceMs);
    offer->click();
    QVERIFY(driver.settle());
    driver.find<QPushButton>("propertiesAccept")->click();
    QVERIFY(driver.settle());
    QCOMPARE(driver.tabs(), 2);
    QVERIFY(volume(driver).volume()->volume.material() > 0.0);
  }
};

HANDWHEEL_WINDOW_TEST(DrillWindowTest)
#include "DrillWindowTest.moc"
