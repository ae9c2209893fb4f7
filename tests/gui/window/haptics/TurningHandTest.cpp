// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../WindowTestMain.h"
#include "BuildPaths.h"
#include "LargeInputs.h"
#include "TurningWindow.h"
#include "haptics/recording/ForceRecorder.h"
#include "panels/device/AxisBars.h"
#include "panels/device/ButtonLamps.h"

#include <QDockWidget>
#include <QProcess>

using namespace handwheel;
using namespace handwheel::test;

namespace {

double distanceFromAxis(const Vec3& point) {
  return std::hypot(point.x(), point.y());
}

// The knobs and lamps of the panel "Device", which lead the simulated hand.
struct HandPanel {
  WindowDriver& driver;
  AxisBars* bars = driver.find<AxisBars>("axisBars");
  ButtonLamps* lamps = driver.find<ButtonLamps>("buttonLamps");

  void show() {
    driver.find<QDockWidget>("deviceDock")->show();
    driver.find<QDockWidget>("deviceDock")->raise();
  }
  // To this share of the range of an axis, from -1 to 1.
  void pull(std::size_t axis, double share) const {
    const QRectF bar = bars->barRect(axis);
    QTest::mouseClick(bars, Qt::LeftButton, {},
                      QPointF(bar.center().x() + 0.5 * share * bar.width(), bar.center().y()).toPoint());
  }
  void press(int button) const { QTest::mouseClick(lamps, Qt::LeftButton, {}, lamps->lampRect(button - 1).center()); }
};

}  // namespace

// A bar is turned by the simulated hand, which is led in the panel "Device".
class TurningHandTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { QSettings().clear(); }

  // The hand begins before the bar, seen from the front. Led into it the bar holds the nose; with button 1 it cuts.
  void byTheKnobsOfThePanel() {
    TurningWindow turning(kSmallWindow);
    QVERIFY(turning.begin());
    HandPanel panel{turning.driver};
    panel.show();
    turning.session.choose("simulated", "hand");
    QTRY_VERIFY_WITH_TIMEOUT(turning.session.latest() != nullptr, kPatienceMs);
    QVERIFY(turning.driver.settle());
    const auto now = [&turning]() -> const ServoSample& { return *turning.session.latest(); };
    QTRY_VERIFY(now().tip.position.y() < -26.0);
    QTRY_VERIFY(panel.bars->isVisible() && panel.bars->focusPolicy() != Qt::NoFocus);
    panel.pull(2, -0.5);  // away from the viewer
    QTRY_VERIFY_WITH_TIMEOUT(now().felt.isContact && now().sent.force.norm() > 0.05, kPatienceMs);
    QTest::qWait(300);
    QVERIFY(std::abs(distanceFromAxis(now().felt.proxy) - 26.0) < 0.1);  // the nose of 1 mm rests on the bar of 25
    QVERIFY(!turning.workpiece().part);
    panel.press(1);
    QTRY_VERIFY_WITH_TIMEOUT(distanceFromAxis(now().felt.proxy) < 24.0, kPatienceMs);
    QVERIFY(turning.driver.find<QLabel>("toolLabel")->isVisible());
    const double z = now().felt.proxy.z();
    panel.pull(2, 0.5);
    QTRY_VERIFY_WITH_TIMEOUT(distanceFromAxis(now().tip.position) > 27.0, kPatienceMs);
    panel.press(1);
    QTRY_VERIFY_WITH_TIMEOUT(turning.workpiece().part != nullptr, kPatienceMs);
    QVERIFY(turning.radiusAt(z) < 23.5);
  }

  // Between the tip and the viewer there is nothing of the model when the device is opened, and when a document is.
  // Each order has several kinds of documents; only large inputs have each kind in both orders.
  void theTipBeginsBeforeTheModel_data() {
    QTest::addColumn<QString>("document");
    QTest::addColumn<bool>("isOpenBefore");
    const auto add = [](const char* document, bool isOpenBefore) {
      QTest::addRow("%s, the device %s", document, isOpenBefore ? "first" : "last")
          << QString::fromLatin1(document) << isOpenBefore;
    };
    add("newWorkpiece", false);
    add("newWorkpiece", true);
    add("openRobotSample", true);
    add("openSample", false);
    if (!test::withLargeInputs()) return;
    add("openShaftSample", false);
    add("openShaftSample", true);
    add("openRobotSample", false);
    add("openSample", true);
  }
  void theTipBeginsBeforeTheModel() {
    QFETCH(QString, document);
    QFETCH(bool, isOpenBefore);
    TurningWindow turning(kSmallWindow);
    if (isOpenBefore) QVERIFY(turning.openHand());
    turning.driver.choose(document.toLatin1());
    QVERIFY(turning.driver.settle());
    QTRY_VERIFY_WITH_TIMEOUT(turning.view->isPickingReady(), kPatienceMs);
    if (!isOpenBefore) QVERIFY(turning.openHand());
    QVERIFY(turning.restsWithHand());
    const Vec3 tip = turning.session.latest()->tip.position, towards = turning.view->camera().towardsViewer();
    QVERIFY(turning.view->pickAlong(tip, towards).isNothing());
  }

  // Seen along its axis a long bar is before the middle of the view by more than the height of the view.
  void beforeALongBarSeenFromItsEnd() {
    TurningWindow turning(kSmallWindow);
    turning.driver.choose("newWorkpiece");
    QVERIFY(turning.driver.settle());
    QVERIFY(turning.document().setProperty("length", 500.0));
    turning.view->setStandardView(StandardView::Right);
    QVERIFY(turning.driver.settle());
    QVERIFY(turning.openHand() && turning.restsWithHand());
    QVERIFY(turning.session.latest()->tip.position.z() >= 500.0);
  }

  // A recorded session is turned once more by the command line. What can differ: the window begins a pass when it sees
  // the button, up to a frame after the press, so that the table has some points before it, here beside the bar.
  // Otherwise the points are the same, and so is the part.
  void aRecordingIsTurnedOnceMore() {
    const QTemporaryDir folder;
    const QString bar = folder.filePath("bar.handwheel"), table = folder.filePath("session.csv");
    const QString again = folder.filePath("again.handwheel");
    TurningWindow turning(kSmallWindow);
    QVERIFY(turning.begin());
    turning.driver.click("quickActions/saveFile");
    QVERIFY(turning.driver.enterFileName("saveDialog", bar) && turning.driver.settle());
    QVERIFY(turning.takeHand());
    auto* sign = turning.driver.find<QToolButton>("recordingSign");
    QVERIFY(!sign->isVisible());
    turning.driver.choose("recordDevice");
    QTRY_VERIFY(sign->isVisible() && sign->text() == QStringLiteral("Recording 0:00"));
    QTRY_COMPARE_WITH_TIMEOUT(sign->text(), QStringLiteral("Recording 0:01"), kPatienceMs);
    for (const double z : {40.0, 70.0}) {
      const Vec3 beside(32.0, 0.0, z);
      turning.leadTo(beside, 0);
      QTRY_VERIFY_WITH_TIMEOUT(std::abs(turning.session.latest()->tip.position.z() - z) < 2.0, kPatienceMs);
      QVERIFY(turning.pressAt(beside));
      QTest::qWait(50);  // some points of the pass are beside the bar
      turning.leadTo({21.0, 0.0, z}, 1);
      QTRY_VERIFY_WITH_TIMEOUT(turning.session.latest()->felt.proxy.x() < 24.0, kPatienceMs);
      turning.leadTo(beside, 1);
      QTRY_VERIFY_WITH_TIMEOUT(turning.session.latest()->tip.position.x() > 30.0, kPatienceMs);
      const int passes = turning.document().history()->count();
      turning.leadTo(beside, 0);
      QTRY_VERIFY_WITH_TIMEOUT(turning.document().history()->count() > passes, kPatienceMs);
    }
    turning.driver.choose("recordDevice");
    QVERIFY(!sign->isVisible());
    turning.driver.choose("exportRecording");
    QVERIFY(turning.driver.enterFileName("exportRecordingDialog", table) && turning.driver.settle());
    QProcess program;
    program.start(test::programPath(), {"turn", bar, "--path", table, "-o", again});
    QVERIFY(program.waitForFinished());
    QVERIFY2(program.exitCode() == 0, program.readAllStandardError());
    const TurnedProfile expected = turning.workpiece().part->profile;
    turning.session.close();
    QVERIFY(turning.driver.open(again));
    QCOMPARE(turning.driver.tabs(), 2);
    const WorkpieceSnapshot& turned = turning.workpiece();
    QCOMPARE(turned.part->passes.size(), std::size_t{2});
    QCOMPARE(turned.part->profile.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
      QVERIFY(std::abs(turned.part->profile.radius(i) - expected.radius(i)) < 1e-9);
  }

  // A click on the sign leads to the recordings.
  void theSignShowsTheRecordings() {
    TurningWindow turning(kSmallWindow);
    turning.driver.choose("newWorkpiece");
    QVERIFY(turning.driver.settle() && turning.openHand());
    auto* sign = turning.driver.find<QToolButton>("recordingSign");
    auto* list = turning.driver.find<QWidget>("recordingList");
    QVERIFY(!list->isVisible());
    turning.driver.choose("recordDevice");
    QTRY_VERIFY(sign->isVisible());
    QTest::mouseClick(sign, Qt::LeftButton);
    QTRY_VERIFY(list->isVisible());
    turning.session.close();
    QVERIFY(!sign->isVisible());
  }
};

HANDWHEEL_WINDOW_TEST(TurningHandTest)
#include "TurningHandTest.moc"
