// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../controls/Accessibility.h"
#include "QuickWindow.h"
#include "StlFiles.h"
#include "WindowTestMain.h"
#include "window/documents/Thumbnails.h"

#include <QDockWidget>
#include <QDropEvent>
#include <QMimeData>
#include <QStandardPaths>
#include <QToolBar>

using namespace handwheel;
using namespace handwheel::test;

// Properties of the window as a whole.
class MainWindowTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;
  ClassWindow m_window;

  QString fileWithHoles(const char* name) {
    const QString path = m_folder.filePath(QString::fromLatin1(name));
    writeStl(path, quadTorus(48, 24, {{3, 5}, {20, 11}, {35, 17}}));
    return path;
  }

  // Not of panels that lie behind others: they are laid out when they come to the front.
  static QString cutTextsInSight(QWidget& window) {
    QStringList cut;
    for (auto* part : window.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
      if (part->isVisible() && !part->visibleRegion().isEmpty()) cut << cutTexts(*part) << cutCells(*part);
    }
    return cut.join('\n');
  }

 private slots:
  // Pictures of recent files are written into the folder of this test. Mesa goes on with the shaders that it has
  // compiled for others.
  void initTestCase() {
    const QString shaders = QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation);
    qputenv("MESA_SHADER_CACHE_DIR", QFile::encodeName(shaders));
    qputenv("XDG_CACHE_HOME", QFile::encodeName(m_folder.path()));
  }

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

  // Widgets that take the focus have a name, and texts have the space that they need: with each kind of document, in
  // each panel.
  void everybodyCanReadIt() {
    WindowDriver driver;
    const auto lookAt = [&driver](const QList<QDockWidget*>& panels, const char* what) {
      QCOMPARE(withoutAccessibleName(driver.window()).join('\n'), QString());
      for (QDockWidget* panel : panels) {
        if (!panel->isVisible()) continue;
        panel->raise();
        QString cut;
        const auto isReadable = [&] {
          cut = cutTextsInSight(driver.window());
          return cut.isEmpty();
        };
        const bool isRead = QTest::qWaitFor(isReadable, kPatienceMs / 4);
        QVERIFY2(isRead, qPrintable(QStringLiteral("%1, %2: %3").arg(QLatin1String(what), panel->objectName(), cut)));
      }
    };
    const auto look = [&](const char* what) { lookAt(driver.window().findChildren<QDockWidget*>(), what); };
    look("start");
    QVERIFY(driver.open(fileWithHoles("read.stl")));
    driver.clickDefect(DefectKind::Hole, 0);
    look("mesh");
    driver.click("compareMethods");
    QVERIFY(driver.settle());
    look("methods compared");
    // The other panels have nothing of the tools.
    const QList<QDockWidget*> ofTools = {driver.find<QDockWidget>("kindDock"), driver.find<QDockWidget>("toolDock")};
    for (const char* tool : {"selectTool", "boundaryTool", "makeFaceTool", "decimateTool", "subdivideTool",
                             "sculptTool", "transformTool", "volumeRepairTool"}) {
      driver.find<QAction>(tool)->trigger();
      QVERIFY(driver.settle());
      lookAt(ofTools, tool);
    }
    for (const char* other :
         {"newWorkpiece", "openRobotSample", "newVolume", "exercise/first-lesson-teacher", "exercise/skull"}) {
      driver.choose(other);
      QVERIFY(driver.settle());
      look(other);
    }
    driver.choose("beginExercise");
    QVERIFY(driver.settle());
    driver.find<QAction>("drillTool")->trigger();
    QVERIFY(driver.settle());
    look("drilling");
    driver.choose("newWorkpiece");
    QVERIFY(driver.settle());
    driver.find<QAction>("latheTool")->trigger();
    QVERIFY(driver.settle());
    look("lathe");
  }

  void withoutADocumentThereIsNothingToWorkOn() {
    QuickWindow& driver = m_window.cleared();
    QVERIFY(!driver.find<QMenu>("kindMenu/workpiece")->menuAction()->isVisible());
    driver.choose("newWorkpiece");
    QVERIFY(driver.settle());
    QVERIFY(driver.find<QMenu>("kindMenu/workpiece")->menuAction()->isVisible());
    driver.click("closeTab");
    QVERIFY(!driver.find<QMenu>("kindMenu/workpiece")->menuAction()->isVisible());
    QVERIFY(driver.find<QToolBar>("kindActions")->actions().isEmpty());
  }

  // The icon in the strip of panels is that of the kind.
  void eachKindHasItsIcon() {
    QuickWindow& driver = m_window.cleared();
    auto* button = driver.find<QAbstractButton>("panelStrip/kindDockToggle");
    QList<QImage> icons;
    const auto look = [&] {
      const QImage image = button->icon().pixmap(20, 20).toImage();
      QVERIFY(!image.isNull() && !icons.contains(image));
      icons << image;
    };
    QVERIFY(driver.open(fileWithHoles("icon.stl")));
    look();
    for (const char* other : {"newWorkpiece", "openRobotSample"}) {
      driver.choose(other);
      QVERIFY(driver.settle());
      look();
    }
  }

  // The strip brings a panel to the front that lies behind another, and folds away one that is seen.
  void thePanelStripShowsAndFolds() {
    QuickWindow driver;
    QVERIFY(driver.open(fileWithHoles("strip.stl")));
    auto* view = driver.find<QDockWidget>("viewDock");
    const auto isSeen = [view] { return !view->visibleRegion().isEmpty(); };
    QVERIFY(view->isVisible() && !isSeen());
    QVERIFY(!driver.find<QAbstractButton>("panelStrip/viewDockToggle")->isChecked());
    driver.click("panelStrip/viewDockToggle");
    QTRY_VERIFY(isSeen());
    QVERIFY(driver.find<QAbstractButton>("panelStrip/viewDockToggle")->isChecked());
    QVERIFY(!driver.find<QAbstractButton>("panelStrip/kindDockToggle")->isChecked());
    driver.click("panelStrip/viewDockToggle");
    QTRY_VERIFY(view->isHidden());
    driver.click("panelStrip/viewDockToggle");
    QTRY_VERIFY(isSeen());
    QVERIFY(driver.settle());
  }

  void movedTabsStayWithTheirDocuments() {
    QuickWindow& driver = m_window.cleared();
    for (const char* name : {"a.stl", "b.stl", "c.stl"}) QVERIFY(driver.open(fileWithHoles(name)));
    auto* tabs = driver.find<QTabBar>("documentTabBar");
    tabs->moveTab(0, 2);
    for (int i = 0; i < tabs->count(); ++i) {
      tabs->setCurrentIndex(i);
      QVERIFY2(driver.window().windowTitle().startsWith(tabs->tabText(i)), qPrintable(tabs->tabText(i)));
    }
    QVERIFY(driver.settle());
  }

  void aDocumentClosedWhileItIsRepaired() {
    QuickWindow& driver = m_window.cleared();
    const QString path = fileWithHoles("going.stl");
    QVERIFY(driver.open(path));
    driver.click("repairAllButton");
    driver.click("closeTab");
    QCOMPARE(driver.tabs(), 0);
    QTRY_VERIFY(driver.settle());
    QVERIFY(driver.open(path));
    QCOMPARE(driver.count(DefectKind::Hole), 3);
    QVERIFY(driver.find<QAction>("repairAll")->isEnabled());
  }

  void lengthsFollowTheDisplayUnit() {
    QuickWindow& driver = m_window.cleared();
    QVERIFY(driver.open(fileWithHoles("inch.stl")));
    const auto detail = [&] {
      const QModelIndex group = driver.defects().groupIndex(DefectKind::Hole);
      return driver.defects().index(0, 0, group).data(DefectModel::DetailRole).toString();
    };
    QVERIFY(detail().endsWith(" mm"));
    QCOMPARE(driver.text("badge"), QStringLiteral("mm"));
    auto* unit = driver.find<QWidget>("property/display_unit")->findChild<QComboBox*>();
    unit->setCurrentIndex(unit->findText("in"));
    emit unit->activated(unit->currentIndex());
    QTRY_COMPARE(driver.text("badge"), QStringLiteral("in"));
    QVERIFY2(detail().endsWith(" in"), qPrintable(detail()));
    QVERIFY(driver.find<QLabel>("badge")->toolTip().contains("in"));
    driver.click("quickActions/undo");
    QVERIFY(detail().endsWith(" mm"));
    QVERIFY(driver.settle());
  }

  // Each view draws by a context of its own.
  void twoWindowsAtOnce() {
    QuickWindow& first = m_window.cleared();
    QuickWindow second;
    for (WindowDriver* driver : {&first, &second}) {
      QVERIFY(driver->open(fileWithHoles("two.stl")));
      QVERIFY(!driver->find<Viewport>("viewport")->grabImage().isNull());
    }
  }

  // The plane stays where it is when the other side is cut away, and its offset reads the same.
  void theOtherSideOfTheSamePlane() {
    QuickWindow driver;
    QVERIFY(driver.open(fileWithHoles("clip.stl")));
    const auto check = [&driver](const char* property) {
      driver.find<QWidget>(property)->findChild<QAbstractButton*>()->click();
      QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);  // rows that took another form
    };
    driver.find<QDockWidget>("viewDock")->raise();
    check("property/clip");
    QTRY_VERIFY(driver.find<QWidget>("property/clip_offset")->findChild<QLineEdit*>());
    driver.edit("clip_offset", "7.5");
    auto* view = driver.find<Viewport>("viewport");
    const ClipPlane before = view->clipPlane();
    QVERIFY(before.on);
    QCOMPARE(before.offset, 7.5);
    check("property/clip_flip");
    QCOMPARE(view->clipPlane(), before.flipped());
    driver.choose("clipModel");
    QVERIFY(!view->clipPlane().on);
    auto* box = driver.find<QWidget>("property/clip")->findChild<QAbstractButton*>();
    QVERIFY(!box->isChecked());
    driver.choose("clipModel");
    QCOMPARE(view->clipPlane(), before.flipped());
    QCOMPARE(driver.find<QWidget>("property/clip_offset")->findChild<QLineEdit*>()->text(), QStringLiteral("7.5"));
    QVERIFY(driver.settle());
  }

  void severalDocumentsKeepTheirStates() {
    QuickWindow& driver = m_window.cleared();
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
    QuickWindow& driver = m_window.cleared();
    const QString path = fileWithHoles("same.stl");
    QVERIFY(driver.open(path));
    QVERIFY(driver.open(path));
    QCOMPARE(driver.tabs(), 1);
  }

  void filesDroppedOnTheWindowOpen() {
    QuickWindow& driver = m_window.cleared();
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
      QuickWindow& driver = m_window.cleared();
      QVERIFY(driver.open(path));
      QTRY_VERIFY_WITH_TIMEOUT(driver.find<Viewport>("viewport")->isPickingReady(), kPatienceMs);
      driver.click("closeTab");
      QTRY_VERIFY_WITH_TIMEOUT(!Thumbnails::of(path).isNull(), kPatienceMs);
    }
    QuickWindow driver;
    driver.click("recent/recent.stl");
    QTRY_COMPARE_WITH_TIMEOUT(driver.tabs(), 1, kPatienceMs);
    QVERIFY(driver.settle());
    driver.click("closeTab");
    driver.click("clearRecent");
    QVERIFY(!driver.window().findChild<QWidget*>("recentMenu")->isEnabled());
  }

  void themesSwitch() {
    QuickWindow& driver = m_window.cleared();
    driver.click("quickActions/darkTheme");
    QCOMPARE(currentTheme(), ThemeKind::Dark);
    driver.click("quickActions/darkTheme");
    QCOMPARE(currentTheme(), ThemeKind::Light);
  }
};

HANDWHEEL_WINDOW_TEST(MainWindowTest)
#include "MainWindowTest.moc"
