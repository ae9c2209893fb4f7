// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StlFiles.h"
#include "WindowDriver.h"
#include "WindowTestMain.h"

#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QStatusBar>
#include <QToolButton>
#include <QUndoStack>

using namespace handwheel;
using namespace handwheel::test;

// The view of a document, and the information that the status bar leaves to a panel.
class ViewCommandsTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;

  QString file(const char* name) {
    const QString path = m_folder.filePath(QString::fromLatin1(name));
    writeStl(path, quadTorus(24, 12, {{3, 5}}));
    return path;
  }
  static Projection other(Projection projection) {
    return projection == Projection::Perspective ? Projection::Parallel : Projection::Perspective;
  }

 private slots:
  void cleanup() { QSettings().clear(); }

  void theProjectionIsACommand() {
    WindowDriver driver;
    QVERIFY(driver.open(file("one.stl")));
    auto* view = driver.find<Viewport>("viewport");
    const Projection before = view->projection();
    auto* command = driver.find<QAction>("perspective");
    QCOMPARE(command->isChecked(), before == Projection::Perspective);
    QVERIFY(command->text().remove('&').contains("perspective", Qt::CaseInsensitive));
    QVERIFY(command->text().remove('&').contains("parallel", Qt::CaseInsensitive));
    QVERIFY(!command->shortcut().isEmpty());
    driver.choose("perspective");
    QCOMPARE(view->projection(), other(before));
    // Also for documents that are opened afterwards, and for those that were left before.
    QVERIFY(driver.open(file("two.stl")));
    QCOMPARE(view->projection(), other(before));
    driver.choose("perspective");
    driver.choose("previousDocument");
    QCOMPARE(view->projection(), before);
    QVERIFY(driver.settle());
  }

  void projectionAndCubeAreKept() {
    Projection chosen = Projection::Perspective;
    {
      WindowDriver driver;
      auto* view = driver.find<Viewport>("viewport");
      driver.choose("perspective");
      driver.choose("viewCube");
      chosen = view->projection();
      QVERIFY(driver.find<QWidget>("viewCube")->isHidden());
    }
    WindowDriver driver;
    QVERIFY(driver.find<QWidget>("viewCube")->isHidden());
    QVERIFY(driver.open(file("kept.stl")));
    QCOMPARE(driver.find<Viewport>("viewport")->projection(), chosen);
    QVERIFY(!driver.find<QAction>("viewCube")->isChecked());
    QVERIFY(driver.settle());
  }

  // Buttons that go must take no room beside those that come.
  void aToolDoesNotGrowTheWindow() {
    WindowDriver driver;
    driver.choose("openSample");
    QVERIFY(driver.settle());
    driver.window().resize(1280, 760);
    QTRY_COMPARE(driver.window().height(), 760);
    for (const char* tool : {"selectTool", "fillTool", "selectTool", "measureTool", "selectTool"}) {
      driver.choose(tool);
      QTest::qWait(50);
    }
    auto* by = driver.find<QWidget>("property/mode")->findChild<QComboBox*>();
    by->setCurrentIndex(by->findText("Brush"));
    emit by->activated(by->currentIndex());
    QTest::qWait(200);
    driver.find<QAbstractButton>("toolAction/all")->click();
    QTest::qWait(200);
    QCOMPARE(driver.window().height(), 760);
    QVERIFY(driver.settle());
  }

  // They are figures for developers, and stay in the panel Status.
  void theStatusBarLeavesOutWhatServicesCost() {
    WindowDriver driver;
    const auto* bar = driver.window().findChild<QStatusBar*>();
    QVERIFY(bar && bar->isVisible());
    for (const auto* label : bar->findChildren<QLabel*>()) QVERIFY(!label->text().contains(QStringLiteral("µs")));
    for (const auto* button : bar->findChildren<QToolButton*>())
      QVERIFY(!button->text().contains(QStringLiteral("µs")));
    QVERIFY(!driver.find<QDockWidget>("statusDock")->isVisible());
  }
};

HANDWHEEL_WINDOW_TEST(ViewCommandsTest)
#include "ViewCommandsTest.moc"
