// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../StlFiles.h"
#include "../WindowDriver.h"
#include "../WindowTestMain.h"
#include "MeshShapes.h"
#include "SimulatedHand.h"
#include "document/volume/VolumeDocument.h"
#include "plot/PlotWidget.h"
#include "tools/volume/DrillingTool.h"
#include "volume/VolumeReader.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/tools/ToolHost.h"

#include <QLabel>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

// From a file to a volume that a simulated hand with force works on, in the window.
class VolumeByHandTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;

  static VolumeDocument& volume(WindowDriver& driver) {
    return static_cast<VolumeDocument&>(driver.window().findChild<DocumentTabs*>()->current()->document);
  }
  static double depthAt(WindowDriver& driver, const Vec3& p) {
    return VolumeReader(volume(driver).volume()->volume).depthAt(p).depth;
  }
  static std::vector<Corners> cornersOf(const TriangleSoup& soup) {
    std::vector<Corners> all;
    for (const Triangle& t : soup.triangles) {
      Corners corners;
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < 3; ++i)
          corners[k][i] = static_cast<float>(soup.points[t[k]][static_cast<Eigen::Index>(i)]);
      all.push_back(corners);
    }
    return all;
  }
  // A tool and the simulated hand, seen from a side.
  static bool takeHand(WindowDriver& driver, StandardView side, const char* tool) {
    auto* const view = driver.find<Viewport>("viewport");
    view->setStandardView(side);
    driver.find<QAction>(tool)->trigger();
    if (!driver.settle() || !QTest::qWaitFor([&] { return view->isPickingReady(); }, kPatienceMs)) return false;
    auto& session = *driver.window().findChild<HapticSession*>();
    session.choose("simulated", "hand");
    return QTest::qWaitFor([&] { return session.latest() != nullptr; }, kPatienceMs) && driver.settle();
  }

 private slots:
  void init() { QSettings().clear(); }

  // A hole through a plate of 8 mm: the hand is held back by the thrust until it is through, which is said and plotted
  // with its reference; what is gone is a cylinder, and one undo step.
  void aHoleThroughAPlate() {
    constexpr double kThick = 8.0, kDiameter = 4.0;  // mm
    const QString path = m_folder.filePath(QStringLiteral("plate.stl"));
    writeStl(path, cornersOf(test::box({-10.0, -10.0, 0.0}, {20.0, 20.0, kThick})));
    WindowDriver driver;
    QVERIFY(driver.open(path));
    driver.choose("copyAs/volume");
    QVERIFY(driver.settle());
    QVERIFY(takeHand(driver, StandardView::Top, "drillTool"));
    HapticSession& session = *driver.window().findChild<HapticSession*>();
    ToolRunner& runner = driver.window().findChild<ToolHost*>()->runner();
    runner.setSetting("diameter", PropertyValue(kDiameter));
    runner.setSetting("material", PropertyValue(3.0));  // cancellous bone
    const auto before = volume(driver).volume();
    const auto tip = [&] { return session.latest()->tip.position; };
    leadHandTo(session, {0.0, 0.0, kThick + 6.0}, 0);
    QTRY_VERIFY_WITH_TIMEOUT((tip() - Vec3(0.0, 0.0, kThick + 6.0)).norm() < 0.5, kPatienceMs);
    leadHandTo(session, {0.0, 0.0, kThick + 6.0}, 1);
    QTRY_VERIFY_WITH_TIMEOUT(runner.tool()->isLive(), kPatienceMs);
    leadHandTo(session, {0.0, 0.0, -6.0}, 1);
    QTRY_VERIFY_WITH_TIMEOUT(session.latest()->felt.isContact && session.latest()->felt.force.z() > 0.2, kPatienceMs);
    auto* const verdict = driver.find<QLabel>("drillVerdict");
    QTRY_VERIFY_WITH_TIMEOUT(verdict->text().startsWith(QStringLiteral("Breakthrough")), kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(session.latest()->felt.proxy.z() < -0.6 * kDiameter, kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(session.latest()->sent.force.norm() < 0.05, kPatienceMs);
    leadHandTo(session, {0.0, 0.0, -6.0}, 0);
    QTRY_COMPARE_WITH_TIMEOUT(volume(driver).history()->count(), 1, kPatienceMs);
    QVERIFY(driver.settle());
    session.close();

    const auto hole = dynamic_cast<const DrillingTool*>(runner.tool())->hole();
    QVERIFY(hole && hole->breakthrough);
    const double cylinder = M_PI * 0.25 * kDiameter * kDiameter * kThick;
    QVERIFY2(std::abs(hole->removed / cylinder - 1.0) < 0.1, qPrintable(QString::number(hole->removed / cylinder)));
    QVERIFY(depthAt(driver, {0.0, 0.0, 0.5 * kThick}) < 0.0);
    for (const char* const name : {"drillThrust", "drillTorque"}) {
      const auto plot = driver.find<PlotWidget>(name)->plot();
      QCOMPARE(plot.series.size(), std::size_t{3});  // ours, the reference, the breakthrough
      double highest = 0.0;
      for (const QPointF& p : plot.series[0].points) highest = std::max(highest, p.y());
      QVERIFY(highest > 0.0);
      QVERIFY(std::abs(plot.series[2].points[0].x() - *hole->breakthrough) < 0.02);
    }
    driver.find<QAction>("undo")->trigger();
    QCOMPARE(volume(driver).volume(), before);
  }

  // A scan with a hole, of two balls that go through one another: repaired by volume it is sound, a copy of it is
  // carved by the hand, saved and opened again.
  void fromAScanToClay() {
    const QString path = m_folder.filePath(QStringLiteral("scan.stl"));
    TriangleSoup scan = moved(sphereWithoutCap(3), Vec3::Zero(), 20.0);
    append(scan, moved(icosphere(2), Vec3(0.0, 0.0, -18.0), 10.0));
    writeStl(path, cornersOf(scan));
    WindowDriver driver;
    QVERIFY(driver.open(path));
    QVERIFY(driver.count(DefectKind::Hole) > 0);
    driver.choose("repairByVolume");
    QVERIFY(driver.settle());
    auto* const view = driver.find<Viewport>("viewport");
    view->setFocus();
    QTest::keyClick(view, Qt::Key_Return);
    QVERIFY(QTest::qWaitFor([&] { return driver.window().isSettled(); }, 4 * kPatienceMs));
    QCOMPARE(driver.count(DefectKind::Hole), 0);
    QCOMPARE(driver.count(DefectKind::SelfIntersection), 0);
    driver.choose("copyAs/volume");
    QVERIFY(QTest::qWaitFor([&] { return driver.window().isSettled(); }, 4 * kPatienceMs));
    QCOMPARE(driver.tabs(), 2);
    QVERIFY(depthAt(driver, {0.0, 0.0, 0.0}) > 0.0 && depthAt(driver, {0.0, 0.0, -25.0}) > 0.0);

    QVERIFY(takeHand(driver, StandardView::Front, "clayTool"));
    HapticSession& session = *driver.window().findChild<HapticSession*>();
    const double whole = volume(driver).volume()->volume.material();
    const auto isAt = [&](double x) { return std::abs(session.latest()->tip.position.x() - x) < 1.0; };
    leadHandTo(session, {26.0, 0.0, 0.0}, 0);
    QTRY_VERIFY_WITH_TIMEOUT(isAt(26.0), kPatienceMs);
    leadHandTo(session, {16.0, 0.0, 0.0}, 0);
    QTRY_VERIFY_WITH_TIMEOUT(session.latest()->felt.isContact && session.latest()->felt.force.x() > 0.05, kPatienceMs);
    leadHandTo(session, {16.0, 0.0, 0.0}, 1);
    QTRY_VERIFY_WITH_TIMEOUT(session.latest()->felt.proxy.x() < 18.0, kPatienceMs);
    leadHandTo(session, {26.0, 0.0, 0.0}, 1);
    QTRY_VERIFY_WITH_TIMEOUT(isAt(26.0), kPatienceMs);
    leadHandTo(session, {26.0, 0.0, 0.0}, 0);
    QTRY_COMPARE_WITH_TIMEOUT(volume(driver).history()->count(), 1, kPatienceMs);
    QVERIFY(driver.settle());
    session.close();
    const double carved = volume(driver).volume()->volume.material();
    QVERIFY(carved < whole - 1.0);
    QVERIFY(depthAt(driver, {19.0, 0.0, 0.0}) < 0.0 && depthAt(driver, {0.0, 19.0, 0.0}) > 0.0);

    const QString saved = m_folder.filePath(QStringLiteral("carved.handwheel"));
    driver.choose("saveFileAs");
    QVERIFY(driver.enterFileName("saveDialog", saved));
    QVERIFY(driver.settle());
    WindowDriver second;
    QVERIFY(second.open(saved));
    QCOMPARE(volume(second).volume()->volume.material(), carved);
  }
};

HANDWHEEL_WINDOW_TEST(VolumeByHandTest)
#include "VolumeByHandTest.moc"
