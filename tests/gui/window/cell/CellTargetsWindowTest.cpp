// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../WindowTestMain.h"
#include "CellWindow.h"
#include "PixelsLike.h"
#include "viewport/path/PathLayer.h"

#include <QListWidget>
#include <QTreeWidget>
#include <numbers>
#include <set>

using namespace handwheel;
using namespace handwheel::test;

namespace {

class TargetsWindow : public CellWindow {
 public:
  QTreeWidget* tree() { return find<QTreeWidget>("planTree"); }
  QTreeWidgetItem* targets() { return tree()->topLevelItem(2); }
  double number(const char* property) { return field(property).split(' ').front().toDouble(); }
  void bend() {
    edit("joint.joint_2", "20");
    edit("joint.joint_3", "30");
    edit("joint.joint_5", "40");
  }
};

}  // namespace

// Targets in the window, and the solutions of the arm for the pose of its tool.
class CellTargetsWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void storeGoRenameRemove() {
    TargetsWindow driver;
    driver.bend();
    QVERIFY(driver.settle());
    const double z = driver.number("tool.z");
    driver.choose("storeTarget");
    QCOMPARE(driver.targets()->childCount(), 1);
    QTRY_VERIFY_WITH_TIMEOUT(driver.targets()->child(0)->text(1).contains("configuration"), kPatienceMs);
    driver.edit("joint.joint_2", "0");
    QVERIFY(std::abs(driver.number("tool.z") - z) > 1.0);
    QVERIFY(driver.settle());
    driver.tree()->setCurrentItem(driver.targets()->child(0));
    driver.choose("goToConfiguration");
    QVERIFY(std::abs(driver.number("target.Target 1.z") - z) < 1e-3);  // in the panel, as it is selected
    driver.edit("target.Target 1.z", QString::number(z + 5.0));
    driver.choose("goToConfiguration");
    driver.tree()->setCurrentItem(driver.tree()->topLevelItem(0));
    QVERIFY(std::abs(driver.number("tool.z") - (z + 5.0)) < 1e-3);
    driver.tree()->setCurrentItem(driver.targets()->child(0));
    driver.targets()->child(0)->setText(0, "spot");
    QCOMPARE(driver.targets()->child(0)->text(0), QString("spot"));
    driver.choose("removePlan");
    QCOMPARE(driver.targets()->childCount(), 0);
    driver.click("quickActions/undo");
    QCOMPARE(driver.targets()->childCount(), 1);
  }

  // Each axis has its own colour, and lengths along the axes of the pose.
  void axesAreReported() {
    Pose pose = Pose::Identity();
    pose.linear() = Eigen::AngleAxisd(std::numbers::pi / 2.0, Vec3::UnitZ()).toRotationMatrix();
    pose.translation() = Vec3(1.0, 2.0, 3.0);
    const std::vector<PathLine> axes = axisLines(pose, {10.0, 20.0, 30.0});
    QCOMPARE(axes.size(), std::size_t{3});
    const Vec3 ends[] = {{1.0, 12.0, 3.0}, {-19.0, 2.0, 3.0}, {1.0, 2.0, 33.0}};
    std::set<QRgb> colours;
    for (std::size_t i = 0; i < axes.size(); ++i) {
      QVERIFY(axes[i].points.front() == pose.translation());
      QVERIFY((axes[i].points.back() - ends[i]).norm() < 1e-12);
      colours.insert(pathColour(axes[i].look, sceneColours(false)).rgb());
    }
    QCOMPARE(colours.size(), std::size_t{3});
  }

  // A frame that is stored shows all three in the view; selected, they are longer.
  void axesAreSeen() {
    TargetsWindow driver;
    driver.bend();
    driver.showAll();
    QVERIFY(driver.settle());
    const auto greens = [&] {
      return pixelsLike(driver.view()->grabImage(), pathColour(PathLine::Look::AxisY, sceneColours(false)));
    };
    const int before = greens();
    driver.choose("storeFrame");
    QVERIFY(driver.settle());
    const int selected = greens();
    QVERIFY(selected > before);
    driver.tree()->setCurrentItem(driver.tree()->topLevelItem(0));
    QVERIFY(driver.settle());
    QTRY_VERIFY(greens() > before && greens() <= selected);
    // Selected once more, also under another name.
    QTreeWidgetItem* const frames = driver.tree()->topLevelItem(3);
    driver.tree()->setCurrentItem(frames->child(0));
    QVERIFY(driver.settle());
    QTRY_COMPARE(greens(), selected);
    frames->child(0)->setText(0, "spot");
    QVERIFY(driver.settle());
    QTRY_COMPARE(greens(), selected);
  }

  // Moved away with its body it is out of reach, and says so.
  void onABodyThatGoesAway() {
    TargetsWindow driver;
    driver.bend();
    driver.choose("add-box");
    QVERIFY(driver.settle());
    driver.edit("body.1.x", "500");
    driver.edit("body.1.y", "600");
    driver.choose("storeTarget");
    QTRY_VERIFY_WITH_TIMEOUT(driver.targets()->child(0)->text(1).contains("configuration"), kPatienceMs);
    driver.edit("body.1.x", "9000");
    QTRY_VERIFY_WITH_TIMEOUT(driver.targets()->child(0)->text(1).contains("out of reach"), kPatienceMs);
    driver.click("quickActions/undo");
    QTRY_VERIFY_WITH_TIMEOUT(driver.targets()->child(0)->text(1).contains("configuration"), kPatienceMs);
  }

  // Chosen from a list, with the mouse alone.
  void aSolutionIsChosen() {
    TargetsWindow driver;
    driver.bend();
    QVERIFY(driver.settle());
    const double z = driver.number("tool.z");
    driver.choose("armWaysTool");
    QVERIFY(driver.settle());
    auto* list = driver.find<QListWidget>("propertyList/choices");
    QTRY_VERIFY_WITH_TIMEOUT(list->count() >= 2, kPatienceMs);
    QVERIFY(list->item(0)->text().contains("lbow"));
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(1)).center());
    QCOMPARE(list->currentRow(), 1);
    auto* commit = driver.find<QAbstractButton>("toolAction/commit");
    QTRY_VERIFY(commit->isEnabled());
    const QString before = driver.field("joint.joint_5");
    QTest::mouseClick(commit, Qt::LeftButton);
    QTRY_VERIFY(driver.field("joint.joint_5") != before || driver.field("joint.joint_3") != "30 °");
    QVERIFY(std::abs(driver.number("tool.z") - z) < 1e-3);
    driver.click("quickActions/undo");
    QCOMPARE(driver.field("joint.joint_5"), before);
  }

  // A number of the pose in the panel moves the arm; what is out of reach is refused at its field.
  void aTypedPose() {
    TargetsWindow driver;
    driver.bend();
    QVERIFY(driver.settle());
    const double z = driver.number("tool.z");
    driver.edit("tool.z", QString::number(z - 10.0));
    QVERIFY(std::abs(driver.number("tool.z") - (z - 10.0)) < 1e-3);
    driver.edit("tool.x", "90000");
    QVERIFY(driver.number("tool.x") < 5000.0);
    driver.click("quickActions/undo");
    QVERIFY(std::abs(driver.number("tool.z") - z) < 1e-3);
  }
};

HANDWHEEL_WINDOW_TEST(CellTargetsWindowTest)
#include "CellTargetsWindowTest.moc"
#include "PixelsLike.h"
