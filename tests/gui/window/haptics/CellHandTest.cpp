// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../WindowTestMain.h"
#include "../cell/PlanningWindow.h"
#include "HandFixture.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QTemporaryDir>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr std::uint32_t kFirstButton = 1, kBothButtons = 3;

// A bent arm with a box beside it, and the simulated hand.
class HandInCell : public PlanningWindow {
 public:
  HandInCell() : session(*window().findChild<HapticSession*>()) {
    edit("joint.joint_2", "28.6");
    edit("joint.joint_3", "45.8");
    edit("joint.joint_5", "40");
    choose("add-box");
    session.choose("simulated", "hand");
    if (!QTest::qWaitFor([this] { return session.latest() != nullptr; }, kPatienceMs)) qFatal("there is no hand");
    if (!settle()) qFatal("the cell is not prepared");
    showAll();
  }
  ~HandInCell() { session.close(); }

  // The hand comes to rest there, with these buttons held.
  bool goTo(const Vec3& position, std::uint32_t buttons = 0) {
    const auto isThere = [&] {
      bringHandTo(session, position, buttons);
      const ServoSample& now = *session.latest();
      return (now.tip.position - position).norm() < 0.5 && now.tip.velocity.norm() < 5.0 &&
             now.device.buttons == buttons;
    };
    if (!QTest::qWaitFor(isThere, kPatienceMs)) return false;
    QTest::qWait(50);  // three events of the device: the tool has seen it there
    return true;
  }
  Vec3 position(const char* prefix) {
    Vec3 at;
    for (int i = 0; i < 3; ++i) at[i] = field((std::string(prefix) + "xyz"[i]).c_str()).section(' ', 0, 0).toDouble();
    return at;
  }
  // A little before where this part is seen.
  Vec3 before(const std::string& part) {
    const QPoint pixel = pixelOf(part);
    if (pixel.isNull()) qFatal("the part is not seen");
    const ViewRay ray = view()->rayAt(QPointF(pixel));
    return view()->pickAlong(ray.origin, ray.direction).point - 8.0 * ray.direction.normalized();
  }

  HapticSession& session;
};

}  // namespace

// A planner's work with the simulated hand instead of a device.
class CellHandTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { QSettings().clear(); }

  // The part is placed, the robot led, a path taught by the second button, proven, and written as programs.
  void fromThePartToThePrograms() {
    HandInCell b;
    const Vec3 stood = b.position("body.1.");
    QTest::keyClick(b.view(), Qt::Key_Escape);  // nothing is selected: no handles at which the hand would hold the box
    b.choose("placeTool");
    QVERIFY(b.settle());
    const Vec3 grip = b.before("body.1"), displacement(-40.0, 30.0, 20.0);
    QVERIFY(b.goTo(grip));
    QVERIFY(b.goTo(grip, kFirstButton));
    QVERIFY(b.goTo(grip + displacement, kFirstButton));
    QVERIFY(b.goTo(grip + displacement));
    QTRY_VERIFY(b.find<QAction>("undo")->text().contains("Move box"));
    QVERIFY((b.position("body.1.") - stood - displacement).norm() < 2.0);
    QVERIFY(b.settle());

    // The tool goes as the hand does, from wherever the hand takes hold.
    b.choose("leadTool");
    QVERIFY(b.settle());
    const Vec3 clutch = b.before("body.1") + Vec3(0.0, 0.0, 60.0), up(0.0, 0.0, 30.0), aside(0.0, 40.0, 0.0);
    QVERIFY(b.goTo(clutch));
    QVERIFY(b.goTo(clutch, kFirstButton));
    QVERIFY(b.goTo(clutch + up, kFirstButton));
    QVERIFY(b.goTo(clutch + up, kBothButtons));
    QTRY_COMPARE(b.paths()->childCount(), 1);
    QVERIFY(b.goTo(clutch + up + aside, kFirstButton));
    QVERIFY(b.goTo(clutch + up + aside, kBothButtons));
    QVERIFY(b.goTo(clutch + up + aside));
    QTRY_COMPARE(b.paths()->child(0)->childCount(), 2);
    QVERIFY(b.settle());

    b.tree()->setCurrentItem(b.paths()->child(0));
    b.choose("verifyPath");
    QTRY_VERIFY_WITH_TIMEOUT(b.paths()->child(0)->text(1).contains("free"), kPatienceMs);
    const QTemporaryDir folder;
    for (const char* name : {"way.mod", "way.script"}) {
      b.choose("exportProgram");
      QVERIFY(b.enterFileName("exportProgramDialog", folder.filePath(name)));
      QTRY_VERIFY_WITH_TIMEOUT(b.text("messageText").contains(QString(name) + " was written"), kPatienceMs);
      QVERIFY(QFile::exists(folder.filePath(name)));
      // Read back it is the same path: both waypoints, 40 mm apart.
      b.choose("importProgram");
      const int paths = b.paths()->childCount();
      QVERIFY(b.enterFileName("importProgramDialog", folder.filePath(name)));
      QTRY_COMPARE_WITH_TIMEOUT(b.paths()->childCount(), paths + 1, kPatienceMs);
      QVERIFY(b.settle());
      Vec3 at[2];
      for (int i = 0; i < 2; ++i) {
        b.tree()->setCurrentItem(b.paths()->child(paths)->child(i));
        b.choose("goToConfiguration");
        QVERIFY(b.settle());
        at[i] = b.position("tool.");
      }
      QVERIFY2((at[1] - at[0] - aside).norm() < 3.0, qPrintable(QString::number((at[1] - at[0] - aside).norm())));
      b.tree()->setCurrentItem(b.paths()->child(0));
    }
  }

  // A box that the hand holds is pushed away from another one before they meet.
  void aHeldBoxFeelsAnother() {
    HandInCell b;
    const Vec3 stood = b.position("body.1.");
    b.choose("add-box");
    QVERIFY(b.settle());
    constexpr double kSize = 100.0, kGap = 40.0;  // mm
    b.edit("body.2.x", QString::number(stood.x() + kSize + kGap));
    b.edit("body.2.y", QString::number(stood.y()));
    b.edit("body.2.z", QString::number(stood.z()));
    b.showAll();
    QTest::keyClick(b.view(), Qt::Key_Escape);
    b.choose("placeTool");
    QVERIFY(b.settle());
    const Vec3 grip = b.before("body.1");
    QVERIFY(b.goTo(grip));
    QVERIFY(b.goTo(grip, kFirstButton));
    const auto forceAt = [&](double gap) {
      bringHandTo(b.session, grip + Vec3(kGap - gap, 0.0, 0.0), kFirstButton);
      return b.session.latest()->felt.force;
    };
    QVERIFY(b.goTo(grip + Vec3(kGap - 20.0, 0.0, 0.0), kFirstButton));
    QVERIFY(forceAt(20.0).norm() < 1e-9);
    // 0.2 N/mm at the device, from 10 mm on.
    const auto isAsTheLaw = [&] {
      const Vec3 force = forceAt(4.0), hand = b.session.latest()->tip.position - grip;
      const double expected = -b.session.mappingInScene().sceneStiffness(0.2) * (10.0 - (kGap - hand.x()));
      return hand.x() > kGap - 8.0 && (force - Vec3(expected, 0.0, 0.0)).norm() < 0.1 * std::abs(expected);
    };
    QTRY_VERIFY_WITH_TIMEOUT(isAsTheLaw(), kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(forceAt(20.0).norm() < 1e-9, kPatienceMs);
    auto* felt = b.find<QDockWidget>("toolDock")->findChild<QWidget*>("property/felt")->findChild<QCheckBox*>();
    felt->click();
    QVERIFY(b.goTo(grip + Vec3(kGap - 3.0, 0.0, 0.0), kFirstButton));
    QVERIFY(forceAt(3.0).norm() < 1e-9);
    felt->click();  // the next test begins as this one
    QVERIFY(b.goTo(grip + Vec3(kGap - 3.0, 0.0, 0.0)));
    QTRY_VERIFY(b.find<QAction>("undo")->text().contains("Move box"));
    QVERIFY(std::abs(b.position("body.1.").x() - stood.x() - (kGap - 3.0)) < 1.0);
  }

  // Near the tool's centre point at a waypoint the hand is drawn to it; a point that it grips there moves with it.
  void aPlaceIsPulled() {
    HandInCell b;
    b.choose("leadTool");
    QVERIFY(b.settle());
    QTest::keyClick(b.view(), Qt::Key_Space);
    QVERIFY(b.settle());
    b.edit("joint.joint_1", "25");
    QTest::keyClick(b.view(), Qt::Key_Space);
    QVERIFY(b.settle());
    QCOMPARE(b.paths()->child(0)->childCount(), 2);
    const Vec3 at = b.position("tool."), displacement(-15.0, 10.0, 25.0);
    b.edit("joint.joint_1", "-25");
    QVERIFY(b.settle());
    auto* leads = b.find<QDockWidget>("toolDock")->findChild<QWidget*>("property/way")->findChild<QComboBox*>();
    leads->setCurrentIndex(leads->findText("Places of paths"));
    emit leads->activated(leads->currentIndex());
    QVERIFY(b.goTo(at + Vec3(0.0, 0.0, 40.0)));
    const auto isDrawn = [&] {
      bringHandTo(b.session, at + Vec3(0.0, 0.0, 8.0));
      const ServoSample& now = *b.session.latest();
      return !now.felt.isContact && now.felt.force.dot(at - now.tip.position) > 0.01;
    };
    QTRY_VERIFY_WITH_TIMEOUT(isDrawn(), kPatienceMs);
    QVERIFY(b.goTo(at));
    QVERIFY(b.goTo(at, kFirstButton));
    QVERIFY(b.goTo(at + displacement, kFirstButton));
    QVERIFY(b.goTo(at + displacement));
    QTRY_VERIFY(b.find<QAction>("undo")->text().contains("Pull place 2 of"));
    b.tree()->setCurrentItem(b.paths()->child(0)->child(1));
    b.choose("goToConfiguration");
    QVERIFY(b.settle());
    QVERIFY((b.position("tool.") - at - displacement).norm() < 3.0);
    b.click("quickActions/undo");
    b.click("quickActions/undo");
    b.tree()->setCurrentItem(b.paths()->child(0)->child(1));
    b.choose("goToConfiguration");
    QVERIFY(b.settle());
    QVERIFY((b.position("tool.") - at).norm() < 0.1);
  }
};

HANDWHEEL_WINDOW_TEST(CellHandTest)
#include "CellHandTest.moc"
