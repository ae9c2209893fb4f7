// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StlFiles.h"
#include "WindowDriver.h"
#include "WindowTestMain.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QDropEvent>
#include <QMimeData>

using namespace handwheel;
using namespace handwheel::test;

// What holds for the window as a whole.
class MainWindowTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;

  QString fileWithHoles(const char* name) {
    const QString path = m_folder.filePath(QString::fromLatin1(name));
    writeStl(path, torus(48, 24, {{3, 5}, {20, 11}, {35, 17}}));
    return path;
  }

 private slots:
  // At 1280 x 800, with the panels of a first start.
  void theViewportHasMostOfTheWindow() {
    WindowDriver driver;
    QVERIFY(driver.open(fileWithHoles("room.stl")));
    const QSize view = driver.find<Viewport>("viewport")->size();
    QVERIFY2(view.width() * view.height() >= 0.6 * 1280 * 800, qPrintable(QString::number(view.height())));
  }

  // For screen readers, and for tests like these.
  void everyControlHasANameAndSaysWhatItIs() {
    WindowDriver driver;
    QVERIFY(driver.open(fileWithHoles("names.stl")));
    driver.clickDefect(DefectKind::Hole, 0);
    for (QWidget* widget : driver.window().findChildren<QWidget*>()) {
      const bool control = qobject_cast<QAbstractButton*>(widget) || qobject_cast<QComboBox*>(widget) ||
                           qobject_cast<QAbstractItemView*>(widget) || qobject_cast<QTabBar*>(widget);
      if (!control || !widget->isVisible()) continue;
      const QString what = QString::fromLatin1(widget->metaObject()->className()) + " " + widget->objectName();
      QVERIFY2(!widget->objectName().isEmpty(), qPrintable(what));
      const auto* button = qobject_cast<QAbstractButton*>(widget);
      QVERIFY2(!widget->accessibleName().isEmpty() || (button && !button->text().isEmpty()), qPrintable(what));
    }
  }

  void severalDocumentsKeepTheirStates() {
    WindowDriver driver;
    QVERIFY(driver.open(fileWithHoles("one.stl")));
    QVERIFY(driver.open(fileWithHoles("two.stl")));
    QCOMPARE(driver.tabs(), 2);
    driver.clickDefect(DefectKind::Hole, 2);
    QVERIFY(driver.settle());
    driver.find<QTabBar>("documentTabBar")->setCurrentIndex(0);
    QVERIFY(!driver.find<QWidget>("holeSettings")->isVisible());
    driver.click("repairAllButton");
    QTRY_COMPARE_WITH_TIMEOUT(driver.count(DefectKind::Hole), 0, kPatienceMs);
    QVERIFY(driver.settle());
    driver.find<QTabBar>("documentTabBar")->setCurrentIndex(1);
    QCOMPARE(driver.count(DefectKind::Hole), 3);
    QVERIFY(driver.find<QWidget>("holeSettings")->isVisible());
    QVERIFY(!driver.window().isWindowModified());
    QVERIFY(driver.settle());
  }

  void openingTwiceShowsTheSame() {
    WindowDriver driver;
    const QString path = fileWithHoles("same.stl");
    QVERIFY(driver.open(path));
    QVERIFY(driver.open(path));
    QCOMPARE(driver.tabs(), 1);
  }

  void filesDroppedOnTheWindowOpen() {
    WindowDriver driver;
    QMimeData files;
    files.setUrls({QUrl::fromLocalFile(fileWithHoles("first.stl")), QUrl::fromLocalFile(fileWithHoles("second.stl"))});
    QDragEnterEvent enter(QPoint(600, 400), Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&driver.window(), &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop(QPointF(600, 400), Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&driver.window(), &drop);
    QVERIFY(driver.settle());
    QCOMPARE(driver.tabs(), 2);
  }

  void filesOpenedAreRecent() {
    const QString path = fileWithHoles("recent.stl");
    {
      WindowDriver driver;
      QVERIFY(driver.open(path));
    }
    WindowDriver driver;
    driver.click("recent/recent.stl");
    QTRY_COMPARE_WITH_TIMEOUT(driver.tabs(), 1, kPatienceMs);
    QVERIFY(driver.settle());
    driver.click("closeTab");
    driver.click("clearRecent");
    QVERIFY(!driver.window().findChild<QWidget*>("recentMenu")->isEnabled());
  }

  void themesSwitch() {
    WindowDriver driver;
    driver.click("quickActions/darkTheme");
    QCOMPARE(currentTheme(), ThemeKind::Dark);
    driver.click("quickActions/darkTheme");
    QCOMPARE(currentTheme(), ThemeKind::Light);
  }
};

HANDWHEEL_WINDOW_TEST(MainWindowTest)
#include "MainWindowTest.moc"
