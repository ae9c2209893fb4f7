// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StlFiles.h"
#include "WindowDriver.h"
#include "WindowTestMain.h"
#include "controls/property/PropertyList.h"
#include "tools/ToolRunner.h"
#include "viewport/surface/MeshLayer.h"
#include "window/tools/ToolHost.h"

#include <QComboBox>
#include <QDockWidget>

using namespace handwheel;
using namespace handwheel::test;

// The tools of a mesh in the window: their settings, and gestures in the view.
class ToolsTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;

  QString fileWithHole() {
    const QString path = m_folder.filePath(QStringLiteral("hole.stl"));
    writeStl(path, torusWithHole());
    return path;
  }

  // The choice of a property in the tool's panel.
  static QComboBox* choice(WindowDriver& driver, const char* property) {
    auto* panel = driver.find<QWidget>("toolDock");
    auto* row = panel->findChild<QWidget*>(QStringLiteral("property/") + QString::fromLatin1(property));
    return row ? row->findChild<QComboBox*>() : nullptr;
  }
  static void choose(QComboBox* box, const QString& text) {
    box->setCurrentIndex(box->findText(text, Qt::MatchFixedString));  // in any case
    emit box->activated(box->currentIndex());
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);  // rows that took another form
  }

 private slots:
  // A setting of a tool holds the next time.
  void settingsStayAsTheyWereLeft() {
    WindowDriver driver;
    QVERIFY(driver.open(fileWithHole()));
    driver.find<QAction>("selectTool")->trigger();
    choose(choice(driver, "mode"), QStringLiteral("Lasso"));
    driver.find<QAction>("measureTool")->trigger();
    driver.find<QAction>("selectTool")->trigger();
    QCOMPARE(choice(driver, "mode")->currentText(), QStringLiteral("Lasso"));
    QVERIFY(driver.settle());
  }

  // The size of the selection is shown; the button that clears it keeps its position; and a whole piece is not deleted
  // without a message.
  void aWholePieceIsDeleted() {
    WindowDriver driver;
    QVERIFY(driver.open(fileWithHole()));
    driver.find<QAction>("selectTool")->trigger();
    const auto selected = [&] {
      return driver.find<QWidget>("toolPanel")
          ->findChild<QWidget*>("property/selected")
          ->findChild<QLabel*>("propertyValue");
    };
    const auto clear = [&] {
      QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);  // those of the tool before
      return driver.find<QAbstractButton>("toolAction/revert");
    };
    QCOMPARE(selected()->text(), QString("0"));
    const QString all = driver.text("figures").section(QLatin1Char(' '), 0, 0);
    driver.find<QAbstractButton>("toolAction/all")->click();
    QCOMPARE(selected()->text(), all);
    const QString title = clear()->text();
    clear()->click();
    QCOMPARE(selected()->text(), QString("0"));
    QVERIFY(!clear()->isEnabled());
    QCOMPARE(clear()->text(), title);
    driver.find<QAbstractButton>("toolAction/all")->click();
    driver.find<QAbstractButton>("toolAction/delete")->click();
    QTRY_VERIFY_WITH_TIMEOUT(driver.find<QWidget>("messageBar")->isVisible(), kPatienceMs);
    QVERIFY(driver.text("messageText").contains("1 whole piece deleted"));
    QVERIFY(driver.text("messageText").contains(all + " triangles"));
    driver.click("messageAction");
    QTRY_COMPARE_WITH_TIMEOUT(driver.text("figures").section(QLatin1Char(' '), 0, 0), all, kPatienceMs);
    QVERIFY(driver.settle());
  }

  // A press that no movement of the pointer came before.
  void theFirstGestureCounts() {
    WindowDriver driver;
    QVERIFY(driver.open(fileWithHole()));
    driver.find<QAction>("selectTool")->trigger();
    choose(choice(driver, "mode"), QStringLiteral("Lasso"));
    QVERIFY(driver.settle());
    auto* view = driver.find<Viewport>("viewport");
    const auto at = [view](double x, double y) {
      return QPoint(static_cast<int>(x * view->width()), static_cast<int>(y * view->height()));
    };
    QTest::mousePress(view, Qt::LeftButton, {}, at(0.05, 0.05));
    for (const QPoint& p : {at(0.95, 0.05), at(0.95, 0.95), at(0.05, 0.95)}) QTest::mouseMove(view, p);
    QTest::mouseRelease(view, Qt::LeftButton, {}, at(0.05, 0.1));
    QTRY_VERIFY(driver.find<QAbstractButton>("toolAction/delete")->isEnabled());
  }

  // The edge that is worked on is that of the hole in the list; each change of it is one step. Then the list deselects
  // the hole, so that no patch is in the way and Return is the tool's.
  void theEdgeOfTheChosenHole() {
    WindowDriver driver;
    QVERIFY(driver.open(fileWithHole()));
    driver.find<QAction>("boundaryTool")->trigger();
    QVERIFY(!driver.find<QAbstractButton>("toolAction/smooth")->isEnabled());
    driver.clickDefect(DefectKind::Hole, 0);
    QTRY_VERIFY(driver.find<QAbstractButton>("toolAction/smooth")->isEnabled());
    QVERIFY(!driver.find<QAction>("undo")->isEnabled());
    QTRY_VERIFY(driver.find<QAction>("fillHole")->isEnabled());
    driver.find<QAbstractButton>("toolAction/smooth")->click();
    QTRY_COMPARE(driver.find<QAbstractButton>("toolAction/commit")->text(),
                 QStringLiteral("Apply the smoothed boundary"));
    QVERIFY(!driver.find<QAction>("fillHole")->isEnabled());
    driver.find<QAbstractButton>("toolAction/commit")->click();
    QTRY_VERIFY(driver.find<QAction>("undo")->isEnabled());
    QVERIFY(driver.settle());
    QCOMPARE(driver.count(DefectKind::Hole), 1);
    driver.find<QAction>("undo")->trigger();
    QVERIFY(!driver.find<QAction>("undo")->isEnabled());
  }

  // A tool that is left while its job waits does not take along what the next one has begun with.
  void theNextToolKeepsItsJob() {
    WindowDriver driver;
    QVERIFY(driver.open(fileWithHole()));
    ToolRunner& runner = driver.window().findChild<ToolHost*>()->runner();
    const auto canCommit = [&runner] {
      for (const ToolAction& action : runner.tool()->actions())
        if (action.id == "commit") return action.enabled;
      return false;
    };
    driver.find<QAction>("boundaryTool")->trigger();
    driver.clickDefect(DefectKind::Hole, 0);
    QTRY_VERIFY(driver.find<QAbstractButton>("toolAction/smooth")->isEnabled());
    QTRY_VERIFY_WITH_TIMEOUT(driver.find<Viewport>("viewport")->isPickingReady(), kPatienceMs);
    QVERIFY(driver.settle());
    QVERIFY(canCommit());
    driver.hold();
    QCOMPARE(runner.perform("smooth"), ToolReply::Used);
    QVERIFY(!canCommit());
    driver.find<QAction>("volumeRepairTool")->trigger();
    QVERIFY(runner.tool() && runner.tool()->id() == "volume-repair");
    runner.setSetting("wall", PropertyValue(2.0));
    QVERIFY(!canCommit());  // its walls are not measured yet
    driver.release();
    QTRY_VERIFY_WITH_TIMEOUT(canCommit(), kPatienceMs);
  }

  // The brush works on the patch of the last fill, or on all; each stroke becomes a step, also when the tool has been
  // left before they are all in.
  void sculptsWhatWasFilled() {
    WindowDriver driver;
    QVERIFY(driver.open(fileWithHole()));
    driver.find<QAction>("repairAll")->trigger();
    QVERIFY(driver.settle());
    driver.find<QAction>("sculptTool")->trigger();
    QVERIFY(driver.settle());
    driver.click("toolAction/subdivide");
    QTRY_VERIFY(driver.find<QAbstractButton>("toolAction/back")->isEnabled());
    driver.click("toolAction/whole");
    QVERIFY(driver.settle());
    auto* view = driver.find<Viewport>("viewport");
    QTRY_VERIFY(view->isPickingReady());
    QPoint position;
    for (int x = view->width() / 4; faceOf(view->pickAt(position)) == kNone && x < view->width(); x += 5)
      position = {x, view->height() / 2};
    for (int stroke = 0; stroke < 3; ++stroke) {
      QTest::mousePress(view, Qt::LeftButton, {}, position);
      QTest::mouseMove(view, position + QPoint(5, 2));
      QTest::mouseRelease(view, Qt::LeftButton, {}, position + QPoint(9, 5 * stroke));
    }
    driver.find<QAction>("selectTool")->trigger();
    QVERIFY(driver.settle());
    auto* undo = driver.find<QAction>("undo");
    for (int stroke = 0; stroke < 3; ++stroke) {
      QTRY_VERIFY2(undo->text().contains(QStringLiteral("Drag surface")), qPrintable(undo->text()));
      undo->trigger();
      QVERIFY(driver.settle());
    }
    QVERIFY2(undo->text().contains(QStringLiteral("Subdivide patch")), qPrintable(undo->text()));
  }

  // The method to fill a hole is chosen with the hole or in the tool's panel, and holds for the next one. "Repair all"
  // takes the setting of fidelity: neither changes the other, but equal values stay equal.
  void theMethodForAHoleIsItsOwn() {
    WindowDriver driver;
    QVERIFY(driver.open(fileWithHole()));
    driver.clickDefect(DefectKind::Hole, 0);
    QVERIFY(driver.settle());
    auto* withHole = driver.find<QComboBox>("fillMethod");
    auto* panel = driver.find<QWidget>("fidelityPanel");
    const auto inSettings = [panel](const char* id) {
      return panel->findChild<QWidget*>(QStringLiteral("property/mesh.") + id)->findChild<QComboBox*>();
    };
    const auto is = [&](const QString& ofHole, const QString& ofAll) {
      return QTest::qWaitFor([&] {
        return withHole->currentText() == ofHole && choice(driver, "fill")->currentText() == ofHole &&
               inSettings("fill_method")->currentText().compare(ofAll, Qt::CaseInsensitive) == 0;
      });
    };
    QVERIFY(is(QStringLiteral("Fair"), QStringLiteral("Fair")));
    const QString fine = driver.text("previewStatus");
    choose(choice(driver, "fill"), QStringLiteral("Ear clipping"));
    QVERIFY(is(QStringLiteral("Ear clipping"), QStringLiteral("Fair")));
    QVERIFY(driver.settle());
    QVERIFY2(driver.text("previewStatus") != fine, qPrintable(fine));
    for (const char* another : {"nextHole", "measureTool", "fillTool"}) driver.find<QAction>(another)->trigger();
    QVERIFY(is(QStringLiteral("Ear clipping"), QStringLiteral("Fair")));
    choose(inSettings("fill_method"), QStringLiteral("Refined"));
    QVERIFY(is(QStringLiteral("Ear clipping"), QStringLiteral("Refined")));
    choose(withHole, QStringLiteral("Refined"));
    QVERIFY(is(QStringLiteral("Refined"), QStringLiteral("Refined")));
    choose(inSettings("fill_method"), QStringLiteral("Fair"));
    QVERIFY(is(QStringLiteral("Fair"), QStringLiteral("Fair")));
    QVERIFY(driver.settle());
    QCOMPARE(driver.text("previewStatus"), fine);
    // So is what fair patches continue.
    choose(inSettings("fill_continuity"), QStringLiteral("Curvature"));
    QTRY_COMPARE(choice(driver, "continuity")->currentText(), QStringLiteral("Curvature"));
    choose(choice(driver, "continuity"), QStringLiteral("Position"));
    QVERIFY(driver.settle());
    QCOMPARE(inSettings("fill_continuity")->currentText(), QStringLiteral("curvature"));
    choose(inSettings("fill_continuity"), QStringLiteral("Tangent"));
    QVERIFY(driver.settle());
  }

  // The setting holds from the first hole on, in the next window too.
  void theUsualMethodIsThatOfTheSettings() {
    const auto setting = [](WindowDriver& driver) {
      auto* panel = driver.find<QWidget>("fidelityPanel");
      return panel->findChild<QWidget*>("property/mesh.fill_method")->findChild<QComboBox*>();
    };
    {
      WindowDriver driver;
      choose(setting(driver), QStringLiteral("Refined"));
    }
    const QVariant kept = QSettings().value("fidelity");
    WindowDriver driver;
    QVERIFY(driver.open(fileWithHole()));
    for (int i = 0; i < 2; ++i) driver.find<QAction>("nextHole")->trigger();
    QVERIFY(driver.settle());
    QCOMPARE(driver.find<QComboBox>("fillMethod")->currentText(), QStringLiteral("Refined"));
    QCOMPARE(choice(driver, "fill")->currentText(), QStringLiteral("Refined"));
    QCOMPARE(QSettings().value("fidelity"), kept);
    choose(setting(driver), QStringLiteral("Fair"));
    QVERIFY(driver.settle());
  }

  // A placement is for one edit: it would scale the next part, or this one twice.
  void aPlacementIsNotRemembered() {
    WindowDriver driver;
    QVERIFY(driver.open(fileWithHole()));
    const auto isIdle = [&] {
      return choice(driver, "unit")->currentText() == QStringLiteral("mm") &&
             !driver.find<QAbstractButton>("toolAction/commit")->isEnabled();
    };
    for (const bool isApplied : {false, true}) {
      driver.find<QAction>("transformTool")->trigger();
      QTRY_VERIFY(isIdle());
      choose(choice(driver, "unit"), QStringLiteral("m"));
      QVERIFY(!isIdle());
      if (isApplied) driver.find<QAbstractButton>("toolAction/commit")->click();
      QVERIFY(driver.settle());
      QCOMPARE(driver.find<QAction>("undo")->isEnabled(), isApplied);
      driver.find<QAction>("measureTool")->trigger();
    }
    driver.find<QAction>("transformTool")->trigger();
    QTRY_VERIFY(isIdle());
    const QString other = m_folder.filePath(QStringLiteral("other.stl"));
    writeStl(other, torusWithHole());
    QVERIFY(driver.open(other));
    driver.find<QAction>("transformTool")->trigger();
    QTRY_VERIFY(isIdle());
  }
};

HANDWHEEL_WINDOW_TEST(ToolsTest)
#include "ToolsTest.moc"
