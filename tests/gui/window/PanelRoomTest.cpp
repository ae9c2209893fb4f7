// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StlFiles.h"
#include "WindowDriver.h"
#include "WindowTestMain.h"

#include <QDockWidget>
#include <QTranslator>

using namespace handwheel;
using namespace handwheel::test;

// The window fits on a small screen whatever panels are open.
class PanelRoomTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;

 private slots:
  void init() { QSettings().clear(); }

  // All of the text about a hole with an island is visible in a narrow panel, also beside the methods.
  void theTextAboutAHole_data() {
    QTest::addColumn<QString>("language");
    QTest::addColumn<bool>("isComparing");
    for (const bool isComparing : {false, true}) {
      QTest::addRow("English, %d", isComparing) << QString() << isComparing;
      QTest::addRow("German, %d", isComparing) << QStringLiteral(":/translations/handwheel_de") << isComparing;
    }
  }
  void theTextAboutAHole() {
    QFETCH(QString, language);
    QFETCH(bool, isComparing);
    QTranslator translator;
    if (!language.isEmpty()) {
      QVERIFY(translator.load(language));
      QCoreApplication::installTranslator(&translator);
    }
    WindowDriver driver;
    const QString path = m_folder.filePath("island.stl");
    writeStl(path, quadTorus(24, 12, {{2, 4}, {3, 4}, {4, 4}, {2, 5}, {4, 5}, {2, 6}, {3, 6}, {4, 6}}));
    QVERIFY(driver.open(path));
    driver.clickDefect(DefectKind::Hole, 0);
    auto* const settings = driver.find<QWidget>("holeSettings");
    QTRY_VERIFY(settings->isVisible());
    if (isComparing) driver.click("compareMethods");
    QVERIFY(driver.settle());
    for (const int room : {280, 320, 420}) {
      driver.window().resizeDocks({driver.find<QDockWidget>("kindDock")}, {room}, Qt::Horizontal);
      QTest::qWait(50);
      for (const QLabel* label : settings->findChildren<QLabel*>()) {
        if (!label->isVisible()) continue;
        QVERIFY2(label->height() >= label->heightForWidth(label->width()),
                 qPrintable(QStringLiteral("%1 at %2").arg(label->text()).arg(room)));
      }
      const auto* const methods = driver.find<QTreeView>("methodTable");
      if (!isComparing) continue;
      const QModelIndex last = methods->model()->index(methods->model()->rowCount() - 1, 0);
      const auto* const above = driver.find<QTreeView>("defectList");
      const int row = methods->visualRect(last).height();
      const bool hasRoom = above->height() > above->minimumHeight() + row;  // the list takes no more from the methods
      QVERIFY(!hasRoom || methods->viewport()->rect().contains(methods->visualRect(last)));
      // The room below the buttons is for texts that nothing asks for while the methods are compared.
      const auto* const fill = driver.find<QWidget>("fillHoleButton");
      QVERIFY(settings->height() - fill->geometry().bottom() < 2 * settings->fontMetrics().lineSpacing());
    }
  }

  // With the panels of an exercise, of the lathe and of programs, in either language: 1024 × 700 pixels.
  void theSmallestWindow_data() {
    QTest::addColumn<QString>("language");
    QTest::addRow("English") << QString();
    QTest::addRow("German") << QStringLiteral(":/translations/handwheel_de");
  }
  void theSmallestWindow() {
    QFETCH(QString, language);
    QTranslator translator;
    if (!language.isEmpty()) {
      QVERIFY(translator.load(language));
      QCoreApplication::installTranslator(&translator);
    }
    WindowDriver driver;
    driver.choose("exercise/first-lesson-teacher");
    QVERIFY(driver.settle());
    fits(driver, "the teacher's editor");
    driver.choose("beginExercise");
    QVERIFY(driver.settle());
    QTRY_VERIFY(driver.find<QDockWidget>("lessonDock")->isVisible());
    fits(driver, "the lesson");
    driver.find<QAction>("latheTool")->trigger();
    QVERIFY(driver.settle());
    QTRY_VERIFY(driver.find<QDockWidget>("latheDock")->isVisible());
    fits(driver, "the lathe");
    driver.find<QAction>("programDockToggle")->trigger();
    QVERIFY(driver.settle());
    fits(driver, "the program");
    driver.find<QAction>("replayDockToggle")->trigger();
    QVERIFY(driver.settle());
    fits(driver, "the replay");
  }

  // However many panels are opened, and whatever they come to show, the window stays as large as it was made.
  void staysAsItIs() {
    WindowDriver driver;
    const QSize made(1280, 800);
    driver.window().resize(made);
    driver.choose("exercise/first-lesson-teacher");
    QVERIFY(driver.settle());
    driver.choose("beginExercise");
    QVERIFY(driver.settle());
    driver.find<QAction>("latheTool")->trigger();
    QVERIFY(driver.settle());
    for (const char* dock : {"lessonDock", "fidelityDock", "deviceDock", "replayDock", "statusDock"}) {
      if (QByteArray(dock) == "replayDock") driver.find<QAction>("replayDockToggle")->trigger();
      auto* const panel = driver.find<QDockWidget>(dock);
      panel->show();
      panel->raise();
      QVERIFY(driver.settle());
      QTRY_VERIFY2(panel->isVisible(), dock);
      QTest::qWait(100);  // sizes are asked for when the window is idle
      QVERIFY2(driver.window().size() == made, dock);
    }
    // Contents without space are scrolled: no panel asks for more than a small part of the height.
    for (const char* dock : {"fidelityDock", "deviceDock", "replayDock"}) {
      const int least = driver.find<QDockWidget>(dock)->minimumSizeHint().height();
      QVERIFY2(least <= made.height() / 2, qPrintable(QStringLiteral("%1: %2").arg(QLatin1String(dock)).arg(least)));
    }
    // Even where one asks for more than the screen has.
    auto* const greedy = new QWidget;
    greedy->setMinimumSize(2 * made);
    auto* const dock = new QDockWidget(&driver.window());
    dock->setObjectName(QStringLiteral("greedyDock"));
    dock->setWidget(greedy);
    driver.window().addDockWidget(Qt::LeftDockWidgetArea, dock);
    QTRY_VERIFY(dock->isVisible());
    QTest::qWait(100);
    QCOMPARE(driver.window().size(), made);
  }

 private:
  static void fits(WindowDriver& driver, const char* what) {
    driver.window().resize(1024, 700);
    const auto isSmall = [&] { return driver.window().width() <= 1024 && driver.window().height() <= 700; };
    const bool isInTime = QTest::qWaitFor(isSmall, 2000);
    QString wide;
    for (const QDockWidget* dock : driver.window().findChildren<QDockWidget*>()) {
      if (!dock->isVisible()) continue;
      const QSize least = dock->minimumSizeHint();
      wide += QStringLiteral("%1 %2 × %3; ").arg(dock->objectName()).arg(least.width()).arg(least.height());
    }
    const QSize least = driver.window().minimumSizeHint();
    QVERIFY2(isInTime && least.width() <= 1024 && least.height() <= 700,
             qPrintable(QStringLiteral("%1: %2 × %3, at least %4 × %5: %6")
                            .arg(QString::fromLatin1(what))
                            .arg(driver.window().width())
                            .arg(driver.window().height())
                            .arg(least.width())
                            .arg(least.height())
                            .arg(wide)));
  }
};

HANDWHEEL_WINDOW_TEST(PanelRoomTest)
#include "PanelRoomTest.moc"
