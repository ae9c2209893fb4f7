// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../controls/Accessibility.h"
#include "../WindowDriver.h"
#include "../WindowTestMain.h"
#include "document/volume/VolumeDocument.h"
#include "volume/image/NrrdWriter.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/volume/segmentation/HistogramView.h"
#include "window/volume/segmentation/SliceCanvas.h"

#include <QDockWidget>
#include <QLabel>
#include <QSlider>
#include <QSpinBox>
#include <cmath>
#include <fstream>

using namespace handwheel;
using namespace handwheel::test;

// A scan is segmented in the window: by its histogram, its parts, a brush and a click in its slices.
class SegmentationWindowTest : public QObject {
  Q_OBJECT

 private:
  static constexpr std::array<int, 3> kSize{48, 40, 32};
  static constexpr double kSpacing = 0.5, kRadius = 6.0, kSmall = 2.0;  // mm

  QTemporaryDir m_folder;

  // A synthetic CT: air, and two balls whose values rise by 500 per mm, up to 1000.
  static double valueAt(const Vec3& p) {
    const double depth = std::max(kRadius - (p - Vec3(9, 10, 8)).norm(), kSmall - (p - Vec3(20, 10, 8)).norm());
    return std::round(std::clamp(500.0 * depth, -1000.0, 1000.0));
  }

  QString scan() {
    const ImageGrid grid{kSize, Vec3::Zero(), kSpacing * Eigen::Matrix3d::Identity()};
    std::vector<std::int16_t> samples;
    for (int z = 0; z < kSize[2]; ++z)
      for (int y = 0; y < kSize[1]; ++y)
        for (int x = 0; x < kSize[0]; ++x)
          samples.push_back(static_cast<std::int16_t>(valueAt(grid.position(Vec3(x, y, z)))));
    const QString path = m_folder.filePath(QStringLiteral("balls.nrrd"));
    std::ofstream(path.toStdString(), std::ios::binary) << nrrdOf(ImageVolume(grid, std::move(samples)));
    return path;
  }

  // Compares the volume of balls with a tolerance, as a segment is counted by samples.
  static void isVolume(double samples, double expected) {
    const double volume = samples * kSpacing * kSpacing * kSpacing;
    QVERIFY2(std::abs(volume / expected - 1.0) < 0.06,
             qPrintable(QStringLiteral("%1 of %2").arg(volume).arg(expected)));
  }
  static double ball(double radius) { return 4.0 / 3.0 * M_PI * radius * radius * radius; }

  static VolumeDocument& document(WindowDriver& driver) {
    return static_cast<VolumeDocument&>(driver.window().findChild<DocumentTabs*>()->current()->document);
  }
  static double samplesIn(WindowDriver& driver) {
    const VolumeDocument& shown = document(driver);
    double count = 0.0;
    for (int z = 0; z < kSize[2]; ++z)
      for (int y = 0; y < kSize[1]; ++y)
        for (int x = 0; x < kSize[0]; ++x)
          count += shown.segment().contains(shown.scan()->image, {x, y, z}) ? 1.0 : 0.0;
    return count;
  }
  static void type(WindowDriver& driver, const char* name, const QString& value) {
    auto* const line = driver.find<QWidget>(name)->findChild<QLineEdit*>();
    line->setFocus();
    line->selectAll();
    QTest::keyClicks(line, value);
    QTest::keyClick(line, Qt::Key_Return);
  }
  static void clickInSlice(SliceCanvas& canvas, const Vec3& position) {
    QTest::mouseClick(&canvas, Qt::LeftButton, {}, canvas.shownAt(position / kSpacing).toPoint());
  }

 private slots:
  void init() { QSettings().clear(); }

  // The docks are there for a scan, and for nothing else.
  void docks() {
    WindowDriver driver;
    driver.choose("newVolume");
    QVERIFY(driver.settle());
    QVERIFY(!driver.find<QAction>("segmentationToggle")->isEnabled());
    QVERIFY(driver.open(scan()));
    QTRY_VERIFY(driver.find<QDockWidget>("segmentationDock")->isVisible());
    QVERIFY(driver.find<QDockWidget>("slicesDock")->isVisible());
    QTRY_VERIFY(!driver.find<QWidget>("segmentationPanel")->visibleRegion().isEmpty());  // in front of the other tabs
    driver.find<QAction>("segmentationToggle")->trigger();
    QTRY_VERIFY(driver.find<QDockWidget>("segmentationDock")->isHidden());
    driver.find<QAction>("segmentationToggle")->trigger();
    QTRY_VERIFY(driver.find<QDockWidget>("slicesDock")->isVisible());
    driver.find<QTabBar>("documentTabBar")->setCurrentIndex(0);
    QTRY_VERIFY(driver.find<QDockWidget>("slicesDock")->isHidden());
  }

  // All controls of both docks are reached by Tab, and they fit into 1024 by 700 pixels.
  void keyboardAndRoom() {
    WindowDriver driver;
    QVERIFY(driver.open(scan()));
    QTRY_VERIFY(driver.find<QDockWidget>("slicesDock")->isVisible());
    const QStringList missed = notReachedByTab(driver.window(), [&](const QWidget* widget) {
      return !driver.find<QWidget>("segmentationPanel")->isAncestorOf(widget) &&
             !driver.find<QWidget>("slicesPanel")->isAncestorOf(widget);
    });
    QCOMPARE(missed.join('\n'), QString());
    for (const char* panel : {"segmentationPanel", "slicesPanel"}) {
      QCOMPARE(withoutAccessibleName(*driver.find<QWidget>(panel)).join('\n'), QString());
      QCOMPARE(cutTexts(*driver.find<QWidget>(panel)).join('\n'), QString());
    }
    driver.window().resize(1024, 700);
    QTRY_VERIFY(driver.window().width() <= 1024 && driver.window().height() <= 700);
    const QSize least = driver.window().minimumSizeHint();
    QVERIFY(least.width() <= 1024 && least.height() <= 700);
  }

  // From the range over the parts to the surface; undone step by step.
  void rangeToSurface() {
    WindowDriver driver;
    QVERIFY(driver.open(scan()));
    const auto material = [&] { return document(driver).volume()->volume.material(); };
    const double opened = material();
    const Segment usual = document(driver).segment();
    type(driver, "segmentLower", QStringLiteral("0"));
    QVERIFY(driver.settle());
    QCOMPARE(document(driver).segment().range().least, 0.0);
    QVERIFY(std::isinf(document(driver).segment().range().largest));
    isVolume(samplesIn(driver), ball(kRadius) + ball(kSmall));
    QVERIFY(driver.text("segmentParts").startsWith(QStringLiteral("2 parts")));
    driver.click("segmentLargest");
    QVERIFY(driver.settle());
    isVolume(samplesIn(driver), ball(kRadius));
    QCOMPARE(material(), opened);
    driver.click("segmentMakeSurface");
    QVERIFY(driver.settle());
    QVERIFY(std::abs(material() / ball(kRadius) - 1.0) < 0.02);
    QCOMPARE(document(driver).history()->index(), 3);
    QUndoStack& history = *document(driver).history();
    history.undo();
    QCOMPARE(material(), opened);
    history.undo();
    isVolume(samplesIn(driver), ball(kRadius) + ball(kSmall));
    history.undo();
    QVERIFY(document(driver).segment() == usual);
    QVERIFY(driver.settle());
  }

  // Unfinished work ends with its document.
  void closedMeanwhile() {
    WindowDriver driver;
    QVERIFY(driver.open(scan()));
    for (const char* button : {"segmentMakeSurface", "segmentSmooth"}) {
      driver.hold();
      driver.click(button);
      driver.choose("closeDocument");
      QTRY_COMPARE(driver.tabs(), 0);
      driver.release();
      QVERIFY(driver.settle());
      QVERIFY(driver.open(scan()));
    }
    QCOMPARE(driver.tabs(), 1);
    QCOMPARE(document(driver).history()->index(), 0);
  }

  // The painted segment and the image are in the file: they are restored after closing and opening.
  void savedAndOpened() {
    const QString path = m_folder.filePath(QStringLiteral("painted.handwheel"));
    WindowDriver driver;
    QVERIFY(driver.open(scan()));
    driver.click("segmentPaint");
    auto* const axial = driver.find<SliceCanvas>("slice/axial");
    QTest::mouseClick(axial, Qt::LeftButton, {}, axial->shownAt(Vec3(40, 30, 16)).toPoint());
    QVERIFY(!document(driver).segment().isByRangeAlone());
    const double painted = samplesIn(driver);
    driver.choose("saveFileAs");
    QVERIFY(driver.enterFileName("saveDialog", path));
    QVERIFY(driver.settle());
    driver.choose("closeDocument");
    QTRY_COMPARE(driver.tabs(), 0);
    QVERIFY(driver.open(path));
    QTRY_VERIFY(driver.find<QDockWidget>("slicesDock")->isVisible());
    QCOMPARE(samplesIn(driver), painted);
    QVERIFY(!document(driver).segment().isByRangeAlone());
    QVERIFY(driver.text("segmentPainted").contains(QStringLiteral("undo")));
  }

  // A job ends while a stroke is painted: the stroke goes on and is kept, and what the job makes comes after it.
  void jobDuringAStroke() {
    WindowDriver driver;
    QVERIFY(driver.open(scan()));
    type(driver, "segmentLower", QStringLiteral("0"));
    driver.click("segmentPaint");
    driver.find<QAbstractButton>("segmentBall")->click();
    auto* const axial = driver.find<SliceCanvas>("slice/axial");
    const QPoint start = axial->shownAt(Vec3(4, 3, 16)).toPoint(), end = axial->shownAt(Vec3(40, 3, 16)).toPoint();
    for (const char* const button : {"segmentSmooth", "segmentMakeSurface"}) {
      QVERIFY(driver.settle());
      QUndoStack& history = *document(driver).history();
      const int steps = history.index();
      const double before = samplesIn(driver);
      driver.hold();
      driver.click(button);
      QTest::mousePress(axial, Qt::LeftButton, {}, start);
      QTest::mouseMove(axial, (start + end) / 2);
      driver.release();
      // Until the job has ended, with nothing of it seen.
      QVERIFY(QTest::qWaitFor([&] { return driver.window().isSettled(); }, kPatienceMs));
      QCOMPARE(history.index(), steps);
      QTest::mouseMove(axial, end);
      QTest::mouseRelease(axial, Qt::LeftButton, {}, end);
      QVERIFY(driver.settle());
      QCOMPARE(history.index(), steps + 2);
      QVERIFY(history.text(steps).contains(QStringLiteral("Paint")));
      QVERIFY(samplesIn(driver) > before);
      QVERIFY(document(driver).segment().contains(document(driver).scan()->image, VoxelIndex(36, 3, 16)));
      while (history.index() > steps) history.undo();
      QCOMPARE(samplesIn(driver), before);
    }
  }

  // An undo drops the stroke that is painted, and nothing else: what a job made meanwhile comes after it.
  void jobDuringADroppedStroke() {
    WindowDriver driver;
    QVERIFY(driver.open(scan()));
    type(driver, "segmentLower", QStringLiteral("0"));
    driver.click("segmentPaint");
    QVERIFY(driver.settle());
    QUndoStack& history = *document(driver).history();
    QCOMPARE(history.index(), 1);
    auto* const axial = driver.find<SliceCanvas>("slice/axial");
    const QPoint start = axial->shownAt(Vec3(4, 3, 16)).toPoint();
    driver.hold();
    driver.click("segmentMakeSurface");
    QTest::mousePress(axial, Qt::LeftButton, {}, start);
    driver.release();
    QVERIFY(QTest::qWaitFor([&] { return driver.window().isSettled(); }, kPatienceMs));
    QCOMPARE(history.index(), 1);
    history.undo();
    QTRY_COMPARE(history.index(), 1);
    QVERIFY(history.text(0).contains(QStringLiteral("surface")));
    QTest::mouseRelease(axial, Qt::LeftButton, {}, start);
    QVERIFY(driver.settle());
    QCOMPARE(history.index(), 1);
  }

  // A handle of the histogram: the segment is seen while it is dragged, and chosen once it is released. And by keys.
  void histogram() {
    WindowDriver driver;
    QVERIFY(driver.open(scan()));
    auto* const shown = driver.find<HistogramView>("segmentHistogram");
    const ValueRange before = document(driver).segment().range();
    const auto at = [&](double value) {
      return QPoint(static_cast<int>(6.0 + (value + 1000.0) / 2000.0 * (shown->width() - 12.0)), shown->height() / 2);
    };
    QTest::mousePress(shown, Qt::LeftButton, {}, at(before.least));
    QTest::mouseMove(shown, at(-200.0));
    QTest::mouseMove(shown, at(-300.0));
    QCOMPARE(document(driver).segment().range().least, before.least);
    QTest::mouseRelease(shown, Qt::LeftButton, {}, at(-300.0));
    QVERIFY(std::abs(document(driver).segment().range().least + 300.0) < 20.0);
    QCOMPARE(document(driver).history()->index(), 1);
    const double dragged = document(driver).segment().range().least;
    shown->setFocus();
    QTest::keyClick(shown, Qt::Key_Right);
    QCOMPARE(document(driver).segment().range().least, dragged + 20.0);
    driver.click("segmentBone");
    QCOMPARE(document(driver).segment().range().least, 300.0);
    driver.click("segmentSkin");
    QCOMPARE(document(driver).segment().range().least, -200.0);
    driver.click("segmentOtsu");
    QCOMPARE(document(driver).segment().range().least, std::round(before.least));
    QVERIFY(driver.settle());
  }

  // The slices: one crosshair, wheel, slider and keys, level and width by the right button.
  void slices() {
    WindowDriver driver;
    QVERIFY(driver.open(scan()));
    auto* const axial = driver.find<SliceCanvas>("slice/axial");
    auto* const sagittal = driver.find<SliceCanvas>("slice/sagittal");
    auto* const coronal = driver.find<SliceCanvas>("slice/coronal");
    clickInSlice(*axial, Vec3(20, 10, 8));
    QCOMPARE(sagittal->slice(), 40);
    QCOMPARE(coronal->slice(), 20);
    const int before = axial->slice();
    QWheelEvent wheel(QPointF(20, 20), axial->mapToGlobal(QPointF(20, 20)), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(axial, &wheel);
    QCOMPARE(axial->slice(), before + 1);
    driver.find<QSlider>("slider/axial")->setValue(5);
    QCOMPARE(axial->slice(), 5);
    axial->setFocus();
    QTest::keyClick(axial, Qt::Key_PageUp);
    QCOMPARE(axial->slice(), 6);
    QTest::keyClick(axial, Qt::Key_Right);
    QCOMPARE(sagittal->slice(), 41);
    QTest::keyClick(axial, Qt::Key_Up);
    QCOMPARE(coronal->slice(), 19);
    const QString level = driver.find<QWidget>("segmentLevel")->findChild<QLineEdit*>()->text();
    QTest::mousePress(axial, Qt::RightButton, {}, {30, 30});
    QTest::mouseMove(axial, {30, 60});
    QTest::mouseRelease(axial, Qt::RightButton, {}, {30, 60});
    QVERIFY(driver.find<QWidget>("segmentLevel")->findChild<QLineEdit*>()->text() != level);
    QCOMPARE(document(driver).history()->index(), 0);
  }

  // A stroke is one step; ball and disc; erased with Ctrl and by keys. Undo and redo give back exactly what was.
  void brush() {
    WindowDriver driver;
    QVERIFY(driver.open(scan()));
    auto* const axial = driver.find<SliceCanvas>("slice/axial");
    clickInSlice(*axial, Vec3(9, 10, 8));
    type(driver, "segmentLower", QStringLiteral("0"));
    type(driver, "segmentRadius", QStringLiteral("2"));
    driver.click("segmentPaint");
    const Segment before = document(driver).segment();
    const double samples = samplesIn(driver);
    const QPoint start = axial->shownAt(Vec3(4, 3, 16)).toPoint(), end = axial->shownAt(Vec3(40, 3, 16)).toPoint();
    QTest::mousePress(axial, Qt::LeftButton, {}, start);
    QTest::mouseMove(axial, (start + end) / 2);
    QTest::mouseMove(axial, end);
    QVERIFY(document(driver).segment() == before);
    QTest::mouseRelease(axial, Qt::LeftButton, {}, end);
    const Segment painted = document(driver).segment();
    // A strip with round ends, cut off by the border at y = 0: 18 mm by 3.5 mm, and nearly a disc.
    const double area = (samplesIn(driver) - samples) * kSpacing * kSpacing;
    QVERIFY2(std::abs(area - (18.0 * 3.75 + 0.9 * M_PI * 4.0)) < 6.0, qPrintable(QString::number(area)));
    QUndoStack& history = *document(driver).history();
    const int steps = history.index();
    history.undo();
    QVERIFY(document(driver).segment() == before);
    history.redo();
    QVERIFY(document(driver).segment() == painted);

    driver.find<QAbstractButton>("segmentBall")->click();
    const double flat = samplesIn(driver);
    QTest::mouseClick(axial, Qt::LeftButton, Qt::ControlModifier, axial->shownAt(Vec3(18, 20, 16)).toPoint());
    isVolume(flat - samplesIn(driver), ball(2.0));
    QCOMPARE(history.index(), steps + 1);
    QVERIFY(driver.text("segmentPainted").contains(QStringLiteral("undo")));
    // By keys, at the crosshair, which Shift moves.
    QTest::mouseClick(axial, Qt::LeftButton, Qt::ShiftModifier, axial->shownAt(Vec3(36, 32, 16)).toPoint());
    axial->setFocus();
    const double erased = samplesIn(driver);
    QTest::keyClick(axial, Qt::Key_BracketRight);
    QTest::keyClick(axial, Qt::Key_Space);
    QVERIFY(samplesIn(driver) > erased);
    QVERIFY(driver.settle());
  }

  // The part connected with the point stays; a point beside the segment is reported and changes nothing.
  void grow() {
    WindowDriver driver;
    QVERIFY(driver.open(scan()));
    auto* const axial = driver.find<SliceCanvas>("slice/axial");
    clickInSlice(*axial, Vec3(9, 10, 8));
    type(driver, "segmentLower", QStringLiteral("0"));
    driver.click("segmentGrow");
    clickInSlice(*axial, Vec3(20, 10, 8));
    QVERIFY(driver.settle());
    isVolume(samplesIn(driver), ball(kSmall));
    const int steps = document(driver).history()->index();
    clickInSlice(*axial, Vec3(9, 10, 8));
    QVERIFY(driver.settle());
    QCOMPARE(document(driver).history()->index(), steps);
    const auto labels = driver.window().findChildren<QLabel*>();
    QVERIFY(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
      return label->isVisible() && label->text().contains(QStringLiteral("not in the segment"));
    }));
  }

  void partsAndSmoothing() {
    WindowDriver driver;
    QVERIFY(driver.open(scan()));
    type(driver, "segmentLower", QStringLiteral("0"));
    QVERIFY(driver.settle());
    driver.find<QSpinBox>("segmentKeep")->setValue(2);
    driver.click("segmentKeepParts");
    QVERIFY(driver.settle());
    isVolume(samplesIn(driver), ball(kRadius) + ball(kSmall));
    // The small ball is a 27th of the large one: it is debris from 70 % of the slider on, in the logarithm.
    auto* const slider = driver.find<QSlider>("segmentDebris");
    slider->setValue(30);
    QVERIFY(driver.text("segmentDebrisText").contains(QStringLiteral("0 of 2")));
    slider->setValue(80);
    QVERIFY(driver.text("segmentDebrisText").contains(QStringLiteral("1 of 2")));
    driver.click("segmentRemoveDebris");
    QVERIFY(driver.settle());
    isVolume(samplesIn(driver), ball(kRadius));
    driver.click("segmentSmooth");
    QVERIFY(driver.settle());
    isVolume(samplesIn(driver), ball(kRadius));
  }
};

HANDWHEEL_WINDOW_TEST(SegmentationWindowTest)
#include "SegmentationWindowTest.moc"
