// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../WindowTestMain.h"
#include "HandFixture.h"
#include "document/volume/VolumeDocument.h"
#include "plot/PlotWidget.h"
#include "tools/volume/DrillingTool.h"
#include "volume/VolumeSampler.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/tools/ToolHost.h"

#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// A window in which a mesh becomes a volume that the simulated hand works on.
struct HandOnVolume : HandFixture {
  Viewport* view = driver.find<Viewport>("viewport");

  ToolRunner& runner() { return driver.window().findChild<ToolHost*>()->runner(); }
  VolumeDocument* document() {
    return dynamic_cast<VolumeDocument*>(&driver.window().findChild<DocumentTabs*>()->current()->document);
  }
  double depthAt(const Vec3& p) { return VolumeSampler(document()->volume()->volume).depthAt(p).depth; }
  double material() { return document()->volume()->volume.material(); }

  // Volumes are made by jobs, which take long with sanitizers.
  bool settlesLong() {
    return QTest::qWaitFor([this] { return driver.window().isSettled(); }, 4 * kPatienceMs);
  }
  // Copies with the parameters that the dialog proposes.
  bool copyAsVolume() {
    driver.choose("copyAs/volume");
    if (!driver.settle()) return false;
    auto* const voxel =
        driver.find<QDialog>("voxelizeDialog")->findChild<QWidget*>("property/voxel")->findChild<QLineEdit*>();
    voxel->setFocus();
    voxel->selectAll();
    QTest::keyClicks(voxel, QStringLiteral("0.255"));  // the force of drilling at 1 mm/s
    driver.find<QPushButton>("propertiesAccept")->click();
    return settlesLong() && document();
  }
  // A tool in use and the hand there, once the view has the room that they leave it.
  bool takeUp(StandardView side, const char* tool) {
    view->setStandardView(side);
    driver.find<QAction>(tool)->trigger();
    if (!driver.settle() || !QTest::qWaitFor([this] { return view->isPickingReady(); }, kPatienceMs)) return false;
    if (!runner().tool() || !viewRests()) return false;
    session.choose("simulated", "hand");
    return QTest::qWaitFor([this] { return session.latest() != nullptr; }, kPatienceMs) && driver.settle() &&
           viewRests();
  }
  bool viewRests() {
    for (int i = 0; i < 50; ++i) {
      const ViewRay before = view->rayAt({0, 0});
      const QSize size = view->size();
      QTest::qWait(350);  // longer than a flight pauses
      const ViewRay after = view->rayAt({0, 0});
      if (view->size() == size && after.origin == before.origin && after.direction == before.direction) return true;
    }
    return false;
  }
  // Moves the hand to a free position, with these buttons held.
  bool goTo(const Vec3& position, std::uint32_t buttons = 0) {
    const auto isThere = [&] {
      bringHandTo(session, position, buttons);
      return (now().tip.position - position).norm() < 0.5 && now().tip.velocity.norm() < 5.0 &&
             now().device.buttons == buttons;
    };
    return QTest::qWaitFor(isThere, kPatienceMs);
  }
  // Presses on towards a position until a condition holds.
  template <class Condition>
  bool pressesTo(const Vec3& position, std::uint32_t buttons, Condition isSo) {
    const auto look = [&] {
      bringHandTo(session, position, buttons);
      return isSo();
    };
    return QTest::qWaitFor(look, 4 * kPatienceMs);
  }
  // It is led straight, with the first button held and slowly enough to be held back, until something is so.
  template <class Condition>
  bool isLedTo(const Vec3& from, const Vec3& to, Condition isSo) {
    constexpr double kStep = 0.1;  // mm
    const int steps = static_cast<int>(std::ceil((to - from).norm() / kStep));
    bool isOver = false;
    for (int i = 0; i <= steps && !isOver; ++i) {
      bringHandTo(session, from + (to - from) * i / steps, 1);
      QTest::qWait(20);
      isOver = isSo();
    }
    return isOver || pressesTo(to, 1, isSo);
  }
  bool isFelt(const Vec3& direction) { return now().felt.isContact && now().felt.force.dot(direction) > 0.05; }
};

}  // namespace

// From a file to a volume that a simulated hand with force works on, in the window.
class VolumeByHandTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;

 private slots:
  void init() { QSettings().clear(); }

  // A hole through a plate: the hand is held back until it is through, which is said and plotted; what is gone is a
  // cylinder at least, as a hand that sways takes more, and one undo step.
  void aHoleThroughAPlate() {
    constexpr double kThick = 8.0, kDiameter = 4.0;  // mm
    const QString path = m_folder.filePath(QStringLiteral("plate.stl"));
    writeStl(path, cornersOf(test::box({-10.0, -10.0, 0.0}, {20.0, 20.0, kThick})));
    HandOnVolume hand;
    QVERIFY(hand.driver.open(path));
    QVERIFY(hand.copyAsVolume());
    QVERIFY(hand.takeUp(StandardView::Top, "drillTool"));
    hand.runner().setSetting("diameter", PropertyValue(kDiameter));
    hand.runner().setSetting("material", PropertyValue(3.0));  // cancellous bone
    const auto before = hand.document()->volume();
    const Vec3 above(0.0, 0.0, kThick + 6.0), below(0.0, 0.0, -6.0);
    QVERIFY(hand.goTo(above));
    QVERIFY(hand.goTo(above, 1));
    QTRY_VERIFY_WITH_TIMEOUT(hand.runner().tool()->isLive(), kPatienceMs);
    auto* const verdict = hand.driver.find<QLabel>("drillVerdict");
    const auto isThrough = [&] { return verdict->text().startsWith(QStringLiteral("Breakthrough")); };
    bool wasFelt = false;
    QVERIFY(hand.isLedTo(above, below, [&] {
      wasFelt = wasFelt || hand.isFelt(Vec3::UnitZ());
      return isThrough();
    }));
    QVERIFY(wasFelt);
    QVERIFY(hand.pressesTo(below, 1, [&] { return hand.now().felt.proxy.z() < -0.6 * kDiameter; }));
    QVERIFY(hand.pressesTo(below, 0, [&] { return hand.now().device.buttons == 0; }));
    QTRY_COMPARE_WITH_TIMEOUT(hand.document()->history()->count(), 1, kPatienceMs);
    QVERIFY(hand.driver.settle());

    const auto hole = dynamic_cast<const DrillingTool*>(hand.runner().tool())->hole();
    QVERIFY(hole && hole->breakthrough && hole->figures.thrust > 0.0 && hole->energy > 0.0);
    const double cylinder = M_PI * 0.25 * kDiameter * kDiameter * kThick;
    QVERIFY2(hole->removed > 0.95 * cylinder, qPrintable(QString::number(hole->removed / cylinder)));
    const double gone = before->volume.material() - hand.material();
    // By voxels, of which some sixteen go across the hole: their number is that of a circle on a grid.
    QVERIFY2(std::abs(gone / hole->removed - 1.0) < 0.05, qPrintable(QString::number(gone / hole->removed)));
    for (const double z : {0.5, 0.5 * kThick, kThick - 0.5}) QVERIFY(hand.depthAt({0.0, 0.0, z}) < 0.0);
    QVERIFY(hand.depthAt({8.0, 8.0, 0.5 * kThick}) > 0.0);
    for (const char* const name : {"drillThrust", "drillTorque"}) {
      const auto plot = hand.driver.find<PlotWidget>(name)->plot();
      QCOMPARE(plot.series.size(), std::size_t{3});  // ours, the reference, the breakthrough
      double highest = 0.0;
      for (const QPointF& p : plot.series[0].points) highest = std::max(highest, p.y());
      QVERIFY(highest > 0.0);
    }
    hand.document()->history()->undo();
    QCOMPARE(hand.document()->volume(), before);
  }

  // A scan with a hole, of two balls that go through one another: repaired by volume it is sound, a copy of it is
  // felt and carved by the hand, saved and opened again.
  void fromAScanToClay() {
    const QString path = m_folder.filePath(QStringLiteral("scan.stl"));
    TriangleSoup scan = moved(sphereWithoutCap(3), Vec3::Zero(), 20.0);
    append(scan, moved(icosphere(2), Vec3(0.0, 0.0, -18.0), 10.0));
    writeStl(path, cornersOf(scan));
    HandOnVolume hand;
    QVERIFY(hand.driver.open(path));
    QVERIFY(hand.driver.count(DefectKind::Hole) > 0);
    hand.driver.find<QAction>("volumeRepairTool")->trigger();
    QVERIFY(hand.driver.settle());
    hand.runner().setSetting("voxel", PropertyValue(0.5));
    QCOMPARE(hand.runner().perform("commit"), ToolReply::Used);
    QVERIFY(hand.settlesLong());
    QCOMPARE(hand.driver.count(DefectKind::Hole), 0);
    QCOMPARE(hand.driver.count(DefectKind::SelfIntersection), 0);
    QVERIFY(hand.copyAsVolume());
    QCOMPARE(hand.driver.tabs(), 2);
    QVERIFY(hand.depthAt({0.0, 0.0, 0.0}) > 0.0 && hand.depthAt({0.0, 0.0, -25.0}) > 0.0);

    QVERIFY(hand.takeUp(StandardView::Front, "clayTool"));
    const double whole = hand.material();
    const Vec3 outside(26.0, 0.0, 0.0), inside(16.0, 0.0, 0.0);
    QVERIFY(hand.goTo(outside));
    QVERIFY(hand.pressesTo(inside, 0, [&] { return hand.isFelt(Vec3::UnitX()); }));
    QVERIFY(std::abs(hand.now().felt.proxy.norm() - 20.0) < 1.0);  // on the ball, but for facets and reduction
    QVERIFY(hand.pressesTo(inside, 1, [&] { return hand.now().felt.proxy.x() < 18.0; }));
    QVERIFY(hand.goTo(outside, 1));
    QVERIFY(hand.goTo(outside));
    QTRY_COMPARE_WITH_TIMEOUT(hand.document()->history()->count(), 1, kPatienceMs);
    QVERIFY(hand.driver.settle());
    const double carved = hand.material();
    QVERIFY(carved < whole - 1.0);
    QVERIFY(hand.depthAt({19.0, 0.0, 0.0}) < 0.0 && hand.depthAt({0.0, 18.0, 0.0}) > 0.0);

    const QString saved = m_folder.filePath(QStringLiteral("carved.handwheel"));
    hand.driver.choose("saveFileAs");
    QVERIFY(hand.driver.enterFileName("saveDialog", saved));
    QVERIFY(hand.settlesLong());
    HandOnVolume second;
    QVERIFY(second.driver.open(saved));
    QVERIFY(second.document());
    QCOMPARE(second.material(), carved);
  }
};

HANDWHEEL_WINDOW_TEST(VolumeByHandTest)
#include "VolumeByHandTest.moc"
