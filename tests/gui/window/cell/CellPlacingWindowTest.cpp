// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../WindowTestMain.h"
#include "CellWindow.h"
#include "PixelsLike.h"
#include "viewport/camera/CameraNavigation.h"
#include "viewport/path/PathLayer.h"

#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

class PlacingWindow : public CellWindow {
 public:
  QPoint screenOf(const Vec3& point) {
    const CameraNavigation navigation(view()->camera(), Vec2(view()->width(), view()->height()));
    const Vec2 at = navigation.toScreen(point);
    return {int(std::lround(at.x())), int(std::lround(at.y()))};
  }
  double number(const char* property) { return field(property).split(' ').front().toDouble(); }
  void look(StandardView side) {
    view()->setStandardView(side);
    showAll();
  }
};

// Pixels of the colour in which outlines are drawn.
int outlined(const QImage& image) {
  return pixelsLike(image, pathColour(PathLine::Look::Feed, sceneColours(false)));
}

}  // namespace

// Bodies placed by handles and face to face, the reach of the arm, and the view from its tool.
class CellPlacingWindowTest : public QObject {
  Q_OBJECT

 private slots:
  // An arrow that is dragged moves the body along its axis only; one step.
  void byAnArrow() {
    PlacingWindow driver;
    driver.choose("add-box");
    QVERIFY(driver.settle());
    driver.edit("body.1.x", "500");
    driver.choose("placeTool");
    driver.look(StandardView::Front);
    QVERIFY(driver.settle());
    const Vec3 middle(driver.number("body.1.x"), driver.number("body.1.y"), driver.number("body.1.z"));
    const QPoint centre = driver.screenOf(middle);
    const QPoint grip = centre + QPoint(60, 0);  // logical pixels along x, which goes to the right here
    driver.move(grip);
    QTest::mousePress(driver.view(), Qt::LeftButton, {}, grip);
    driver.move(grip + QPoint(20, 30));
    driver.move(grip + QPoint(70, 50));
    QTest::mouseRelease(driver.view(), Qt::LeftButton, {}, grip + QPoint(70, 50));
    QVERIFY(driver.find<QAction>("undo")->text().contains("Move box"));
    QVERIFY(driver.number("body.1.x") > middle.x() + 1.0);
    QCOMPARE(driver.number("body.1.y"), middle.y());
    QCOMPARE(driver.number("body.1.z"), middle.z());
    driver.click("quickActions/undo");
    QCOMPARE(driver.number("body.1.x"), middle.x());
  }

  // Two clicks and a button: the box lies on the other one.
  void faceToFace() {
    PlacingWindow driver;
    driver.choose("add-box");
    QVERIFY(driver.settle());
    driver.edit("body.1.x", "600");
    driver.choose("add-box");
    QVERIFY(driver.settle());
    driver.edit("body.2.x", "600");
    driver.edit("body.2.y", "400");
    driver.edit("body.2.rz", "20");
    const double height = driver.number("body.2.z");
    driver.choose("faceSnapTool");
    driver.look(StandardView::Top);
    QVERIFY(driver.settle());
    const auto clickOn = [&](const std::string& part) {
      const QPoint pixel = driver.pixelOf(part);
      QVERIFY(!pixel.isNull());
      driver.move(pixel);
      QTest::mouseClick(driver.view(), Qt::LeftButton, {}, pixel);
    };
    clickOn("body.1");
    auto* commit = driver.find<QAbstractButton>("toolAction/commit");
    QVERIFY(!commit->isEnabled());
    clickOn("body.2");
    QTRY_VERIFY(commit->isEnabled());
    QTest::mouseClick(commit, Qt::LeftButton);
    QVERIFY(driver.find<QAction>("undo")->text().contains("face"));
    QVERIFY(std::abs(driver.number("body.1.x") - 600.0) < 1e-3);
    QVERIFY(std::abs(driver.number("body.1.y") - 400.0) < 1e-3);
    QVERIFY(std::abs(driver.number("body.1.z") - (height + 100.0)) < 1e-3);  // upside down on top of it
    driver.click("quickActions/undo");
    QVERIFY(std::abs(driver.number("body.1.x") - 600.0) < 1e-3);
    QVERIFY(std::abs(driver.number("body.1.y")) < 1e-3);
  }

  // The camera is at the tool, moves with it, and goes back.
  void fromTheTool() {
    PlacingWindow driver;
    driver.edit("joint.joint_5", "40");
    const CameraState before = driver.view()->camera();
    driver.choose("toolCamera");
    const auto eyeIsAtTheTool = [&] {
      const Vec3 tool(driver.number("tool.x"), driver.number("tool.y"), driver.number("tool.z"));
      return (driver.view()->camera().eye() - tool).norm() < 0.1;
    };
    QVERIFY(eyeIsAtTheTool());
    const CameraState there = driver.view()->camera();
    driver.edit("joint.joint_1", "30");
    QVERIFY(eyeIsAtTheTool());
    QVERIFY(!(driver.view()->camera() == there));
    driver.choose("toolCamera");
    QVERIFY(driver.view()->camera() == before);
  }

  // The outline appears over the picture, and goes.
  void theReachIsShown() {
    PlacingWindow driver;
    driver.look(StandardView::Front);
    QVERIFY(driver.settle());
    const int before = outlined(driver.view()->grabImage());
    driver.choose("showReach");
    QVERIFY(driver.settle());
    QTRY_VERIFY(outlined(driver.view()->grabImage()) > before + 200);
    driver.choose("showReach");
    QVERIFY(driver.settle());
    QTRY_VERIFY(outlined(driver.view()->grabImage()) < before + 20);
  }
};

HANDWHEEL_WINDOW_TEST(CellPlacingWindowTest)
#include "CellPlacingWindowTest.moc"
#include "PixelsLike.h"
