// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../../core/volume/image/MadeImages.h"
#include "../WindowDriver.h"
#include "../WindowTestMain.h"
#include "LPhantom.h"
#include "document/volume/VolumeDocument.h"
#include "viewport/overlay/ViewCube.h"
#include "volume/image/NrrdWriter.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/volume/segmentation/SliceCanvas.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <fstream>

using namespace handwheel;
using namespace handwheel::test;

// A scan in the window: its sides, its labels, and the patient's name in its path.
class ScanWindowTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;

  QString write(const QString& name, const ImageVolume& image) {
    const QString path = m_folder.filePath(name);
    QDir().mkpath(QFileInfo(path).path());
    std::ofstream(path.toStdString(), std::ios::binary) << nrrdOf(image);
    return path;
  }
  // The phantom, whose bars go to the left, the back and the head; the grid is stored in an order of its own.
  QString phantom(const QString& name) {
    ImageGrid grid{{40, 26, 46}, Vec3::Zero(), Eigen::Matrix3d::Zero()};
    grid.steps.col(0) = -Vec3::UnitY();
    grid.steps.col(1) = Vec3::UnitZ();
    grid.steps.col(2) = -Vec3::UnitX();
    grid.origin = Vec3(31, 25, -5);
    return write(name, test::imageOf<std::int16_t>(grid, lPhantom));
  }
  static DocumentTab& shown(WindowDriver& driver) { return *driver.window().findChild<DocumentTabs*>()->current(); }

 private slots:
  void init() { QSettings().clear(); }

  // Letters of slices and cube agree with the phantom, also when the slices are turned; the cube never is.
  void sides() {
    WindowDriver driver;
    QVERIFY(driver.open(phantom(QStringLiteral("phantom.nrrd"))));
    auto* const cube = driver.find<ViewCube>("viewCube");
    auto* const setting = driver.find<QCheckBox>("segmentLeftAtLeft");
    const ImageGrid& grid = static_cast<VolumeDocument&>(shown(driver).document).scan()->image.grid();
    const auto indexOf = [&](const Vec3& p) -> Vec3 { return grid.steps.inverse() * (p - grid.origin); };
    for (const bool isTurned : {false, true}) {
      setting->setChecked(isTurned);
      for (const char* name : {"slice/axial", "slice/coronal", "slice/sagittal"}) {
        const auto* const canvas = driver.find<SliceCanvas>(name);
        const SliceView& view = canvas->view();
        const QPointF corner = canvas->shownAt(indexOf(Vec3(4, 4, 4)));
        const bool isSagittal = QLatin1String(name) == QLatin1String("slice/sagittal");
        // The bar to the left, or of sagittal slices the one to the back, lies towards the letter of its side.
        const QPointF end = canvas->shownAt(indexOf(isSagittal ? Vec3(4, 20, 4) : Vec3(28, 4, 4)));
        const char letter = isSagittal ? 'P' : 'L';
        QCOMPARE(end.x() > corner.x() ? view.atRight : view.atLeft, letter);
        QCOMPARE(end.x() > corner.x(), isSagittal || !isTurned);
      }
      if (!isTurned) continue;
      // The letter in front is that of the side that looks at the viewer, and the slices' letters are beside it: the
      // coronal slice is the front view, and the sagittal one is seen from the patient's left.
      const auto isFacing = [&](const char* action, const char* letter) {
        driver.choose(action);
        const QString wanted = QStringLiteral("(%1)").arg(QLatin1String(letter));
        return QTest::qWaitFor([&] {  // until the camera is there
          const QString described = cube->accessibleDescription();
          return described.endsWith(wanted) && !described.contains(QStringLiteral(" · "));
        });
      };
      QVERIFY(isFacing("viewFront", "A"));
      QVERIFY(isFacing("viewTop", "H"));
      QVERIFY(isFacing("viewRight", "L"));
      QVERIFY(isFacing("viewLeft", "R"));
      QVERIFY(isFacing("viewBack", "P"));
      QVERIFY(isFacing("viewBottom", "F"));
    }
    // A volume that is no scan has no patient.
    driver.choose("newVolume");
    QVERIFY(driver.settle());
    QVERIFY(!cube->accessibleDescription().contains(QStringLiteral("patient")));
    driver.find<QTabBar>("documentTabBar")->setCurrentIndex(0);
    QVERIFY(driver.settle());
    QVERIFY(cube->accessibleDescription().contains(QStringLiteral("patient")));
  }

  // The labels of a label map are listed by number and name, and one or all of them are taken.
  void labels() {
    const ImageGrid grid{{20, 20, 20}, Vec3::Zero(), Eigen::Matrix3d::Identity()};
    ImageVolume image = test::imageOf<std::int16_t>(grid, [](const Vec3& p) {
      const bool isIn = p.x() > 3 && p.x() < 16 && p.y() > 3 && p.y() < 16 && p.z() > 3 && p.z() < 16;
      return !isIn ? 0.0 : p.x() < 8 ? 2.0 : 5.0;
    });
    image.setLabels({{2.0, "femur"}, {5.0, "tibia"}});
    WindowDriver driver;
    QVERIFY(driver.open(write(QStringLiteral("bones.seg.nrrd"), image)));
    auto* const list = driver.find<QComboBox>("segmentLabels");
    QTRY_VERIFY(list->isVisible());
    QCOMPARE(list->count(), 3);
    QCOMPARE(list->itemText(1), QStringLiteral("2: femur"));
    QCOMPARE(list->itemText(2), QStringLiteral("5: tibia"));
    const auto& document = static_cast<VolumeDocument&>(shown(driver).document);
    const auto volume = [&] { return document.volume()->volume.material(); };
    QCOMPARE(volume(), 12.0 * 12.0 * 12.0);
    const auto* const older = driver.find<QLabel>("segmentOlder");
    QVERIFY(!older->isVisible());
    bool isWarned = false;
    const auto take = [&](int index) {
      list->setCurrentIndex(index);
      emit list->activated(index);
      if (!driver.settle()) return;
      isWarned = older->isVisible();
      driver.click("segmentMakeSurface");
      (void)driver.settle();
    };
    take(1);
    QCOMPARE(document.segment().range().least, 2.0);
    QCOMPARE(document.segment().range().largest, 2.0);
    QCOMPARE(volume(), 4.0 * 12.0 * 12.0);
    QVERIFY(isWarned && !older->isVisible());
    driver.choose("undo");
    QVERIFY(older->isVisible());
    driver.choose("undo");
    QVERIFY(!older->isVisible());
    take(2);
    QCOMPARE(volume(), 8.0 * 12.0 * 12.0);
    take(0);
    QCOMPARE(volume(), 12.0 * 12.0 * 12.0);
    // No other scan has them.
    QVERIFY(driver.open(phantom(QStringLiteral("phantom.nrrd"))));
    QTRY_VERIFY(!list->isVisible());
  }

  // Title, tab and recent files show what was opened; what is proposed for saving names no patient.
  void names() {
    const QString path = phantom(QStringLiteral("Zentinel Anna/Zentinel.nrrd"));
    WindowDriver driver;
    QVERIFY(driver.open(path));
    QVERIFY(driver.window().windowTitle().contains(QStringLiteral("Zentinel.nrrd")));
    QVERIFY(driver.find<QTabBar>("documentTabBar")->tabText(0).contains(QStringLiteral("Zentinel")));
    const QString proposed = shown(driver).ui.suggestedName(shown(driver));
    QCOMPARE(QFileInfo(proposed).fileName(), QStringLiteral("Volume.handwheel"));
    driver.choose("saveFileAs");
    QFileDialog* dialog = nullptr;
    QTRY_VERIFY((dialog = driver.window().findChild<QFileDialog*>(QStringLiteral("saveDialog"))));
    QTRY_VERIFY(dialog->isVisible());
    const auto* const name = dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
    QCOMPARE(name->text(), QStringLiteral("Volume.handwheel"));
    dialog->reject();
    driver.click("closeTab");
    QTRY_COMPARE(driver.tabs(), 0);
    QVERIFY(driver.window().findChild<QAbstractButton*>(QStringLiteral("recent/Zentinel.nrrd")));
  }
};

HANDWHEEL_WINDOW_TEST(ScanWindowTest)
#include "ScanWindowTest.moc"
