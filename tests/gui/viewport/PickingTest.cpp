// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SheetModel.h"
#include "TestClass.h"
#include "mesh/structure/MeshBuilder.h"
#include "viewport/BrushOutline.h"
#include "viewport/Picking.h"
#include "viewport/surface/MeshLayer.h"
#include "viewport/surface/PartsLayer.h"

#include <rapidcheck.h>
#include <QtTest>

using namespace handwheel;

namespace {

const Vec2 kPickingSize(600, 500);

double pickingNumber(double limit) {
  return *rc::gen::inRange(-1000, 1001) * limit / 1000.0;
}

// Nothing of these layers is drawn.

std::unique_ptr<MeshLayer> layerOf(const TriangleSoup& soup, std::vector<LoopMark> loops = {}) {
  auto layer = std::make_unique<MeshLayer>();
  layer->setMesh(buildMesh(soup).mesh);
  layer->setLoops(std::move(loops));
  if (!QTest::qWaitFor([&] { return layer->isSearchable(); })) qFatal("the search structure was not built");
  return layer;
}

std::unique_ptr<PartsLayer> layerOf(const std::vector<DisplayPart>& parts) {
  auto layer = std::make_unique<PartsLayer>();
  layer->setPartsAtOnce(parts);
  return layer;
}

std::unique_ptr<MeshLayer> layerOf(std::vector<LoopMark> loops) {
  auto layer = std::make_unique<MeshLayer>();
  layer->setLoops(std::move(loops));
  return layer;
}

CameraState cameraAbove(Projection projection) {
  CameraState c;
  c.centre = Vec3(10, 10, 0);
  c.height = 25;
  c.projection = projection;
  return c;
}

Pose raisedBy(double z) {
  Pose pose = Pose::Identity();
  pose.translation().z() = z;
  return pose;
}

}  // namespace

class PickingTest : public QObject {
  Q_OBJECT

  const std::shared_ptr<const TriangleSoup> m_soup = std::make_shared<const TriangleSoup>(sheet(kCells));
  std::unique_ptr<MeshLayer> m_sheet;

 private slots:
  void initTestCase() { m_sheet = layerOf(*m_soup); }

  // Project a point of the sheet, pick there: the same point comes back.
  void pickInvertsProjection() {
    QVERIFY(rc::check([&] {
      CameraState c = cameraAbove(*rc::gen::element(Projection::Parallel, Projection::Perspective));
      c.orientation = Eigen::Quaterniond(2 + pickingNumber(1), pickingNumber(0.5), pickingNumber(0.5), pickingNumber(1))
                          .normalized();
      const CameraNavigation view(c, kPickingSize);
      const Vec3 p(10 + pickingNumber(9.9), 10 + pickingNumber(9.9), 0);
      if (!view.isBeforeEye(p)) return;
      const Pick pick = pickAt({{m_sheet.get()}}, view, view.toScreen(p));
      RC_ASSERT(faceOf(pick) != kNone);
      RC_ASSERT((pick.point - p).norm() < 1e-9);
      RC_ASSERT(partOf(pick).empty());
    }));
  }

  void theNearestPartIsPicked() {
    const auto parts =
        layerOf({{"low", m_soup, raisedBy(1)}, {"high", m_soup, raisedBy(3)}, {"below", m_soup, raisedBy(-3)}});
    for (const Projection projection : {Projection::Parallel, Projection::Perspective}) {
      const CameraNavigation view(cameraAbove(projection), kPickingSize);
      const Vec3 p(7.3, 8.4, 3);
      const Pick pick = pickAt({{m_sheet.get(), parts.get()}}, view, view.toScreen(p));
      QCOMPARE(partOf(pick), "high");
      QCOMPARE(faceOf(pick), kNone);
      QVERIFY((pick.point - p).norm() < 1e-9);
      QVERIFY(!pick.isNothing());
    }
    const Pickable all{{m_sheet.get(), parts.get()}};
    QCOMPARE(partOf(pickAlong(all, Vec3(7.3, 8.4, 2), -Vec3::UnitZ())), "low");
    QCOMPARE(faceOf(pickAlong(all, Vec3(7.3, 8.4, 0.5), -Vec3::UnitZ())), static_cast<Face>(2 * (8 * kCells + 7) + 1));
    QVERIFY(pickAlong(all, Vec3(7.3, 8.4, 4), Vec3::UnitZ()).isNothing());
  }

  // A part is found at its pose, at any distance.
  void partsArePickedInTheirPose() {
    QVERIFY(rc::check([&] {
      Pose pose = Pose::Identity();
      pose.linear() = Eigen::Quaterniond(1 + pickingNumber(0.9), pickingNumber(1), pickingNumber(1), pickingNumber(1))
                          .normalized()
                          .toRotationMatrix();
      pose.translation() = Vec3(1e7, -1e7, 5e6);
      const Vec3 p = pose * Vec3(10 + pickingNumber(9.9), 10 + pickingNumber(9.9), 0);
      CameraState c = cameraAbove(Projection::Perspective);
      c.orientation = Eigen::Quaterniond(pose.linear());
      c.centre = p;
      const auto parts = layerOf({{"sheet", m_soup, pose}});
      const Pick pick = pickAt({{parts.get()}}, CameraNavigation(c, kPickingSize), kPickingSize / 2);
      RC_ASSERT(partOf(pick) == "sheet");
      RC_ASSERT((pick.point - p).norm() < 1e-6);
    }));
  }

  // The plane opens the upper sheet on one side: there the lower one is picked, and nothing when it is clipped as well.
  void whatIsClippedAwayIsNotPicked() {
    const auto parts = layerOf({{"low", m_soup, raisedBy(0)}, {"high", m_soup, raisedBy(3)}});
    for (const Projection projection : {Projection::Parallel, Projection::Perspective}) {
      const CameraNavigation view(cameraAbove(projection), kPickingSize);
      const auto pickedAt = [&](const Vec3& p, const ClipPlane& clip) {
        return partOf(pickAt({{parts.get()}, clip}, view, view.toScreen(p)));
      };
      const ClipPlane between{Vec3::UnitZ(), 1.5, true};
      QCOMPARE(pickedAt({5, 5, 3}, between), "low");
      QCOMPARE(pickedAt({5, 5, 3}, between.flipped()), "high");
      const ClipPlane slanted{Vec3(1, 0, 1).normalized(), 10 / std::sqrt(2.0), true};  // keeps x + z <= 10
      QCOMPARE(pickedAt({6.9, 5, 3}, slanted), "high");
      QCOMPARE(pickedAt({9.9, 10, 0}, slanted), "low");
      QCOMPARE(pickedAt({10.1, 10, 0}, slanted), "");
      QCOMPARE(pickedAt({5, 5, 3}, {Vec3::UnitZ(), -1, true}), "");
      QCOMPARE(pickedAt({5, 5, 3}, {Vec3::UnitZ(), -1, false}), "high");
      QCOMPARE(pickedAt({8, 8, 0}, {Vec3::UnitX(), 5, true}), "");
    }
  }

  void clippedLoopIsNotPicked() {
    const auto layer = layerOf(*m_soup, {squareLoop(0, Qt::blue)});
    const CameraNavigation view(cameraAbove(Projection::Perspective), kPickingSize);
    const Vec2 at = view.toScreen({5, 10, 0});
    QCOMPARE(loopOf(pickAt({{layer.get()}}, view, at)), 7);
    const Pick clipped = pickAt({{layer.get()}, {-Vec3::UnitX(), -8, true}}, view, at);
    QCOMPARE(loopOf(clipped), -1);
    QVERIFY(clipped.isNothing());
  }

  // On a slanted line under perspective the middle of the picture is not the middle of the line.
  void loopPointIsWhereTheCursorIs() {
    CameraState c = cameraAbove(Projection::Perspective);
    c.orientation = Eigen::Quaterniond(Eigen::AngleAxisd(1.2, Vec3::UnitX()));
    const CameraNavigation view(c, kPickingSize);
    const auto layer = layerOf(std::vector<LoopMark>{{4, {{10, 2, 0}, {10, 18, 0}}, Qt::blue, false}});
    for (const double y : {2.5, 7.0, 10.0, 17.0}) {
      const Pick pick = pickAt({{layer.get()}}, view, view.toScreen({10, y, 0}));
      QCOMPARE(loopOf(pick), 4);
      QVERIFY((pick.point - Vec3(10, y, 0)).norm() < 1e-9);
    }
  }

  void loopBehindTheEyeIsNotPicked() {
    const CameraState c = cameraAbove(Projection::Perspective);
    const CameraNavigation view(c, kPickingSize);
    const double behind = 2 * c.eyeDistance();
    const auto layer = layerOf(std::vector<LoopMark>{{4, {{9, 9, behind}, {11, 11, behind}}, Qt::blue, false}});
    QCOMPARE(loopOf(pickAt({{layer.get()}}, view, kPickingSize / 2)), -1);
  }

  // A circle on a plane is unchanged; on a roof it follows both slopes; beyond the surface it is flat.
  void brushLiesOnTheSurface() {
    const BrushCircle brush{Vec3(10, 10, 0), 3.0};
    for (const Vec3& p : brushOutline({{m_sheet.get()}}, brush, Vec3::UnitZ())) {
      QVERIFY(std::abs((p - brush.centre).norm() - 3) < 1e-9);
      QVERIFY(std::abs(p.z()) < 1e-9);
    }
    TriangleSoup roof;  // ridge along y at z = 0, slopes of 15°
    const double fall = 20 * std::tan(15 * kRadiansPerDegree);
    roof.points = {{0, -20, 0}, {0, 20, 0}, {-20, 0, -fall}, {20, 0, -fall}};
    roof.triangles = {{0, 1, 2}, {1, 0, 3}};
    const auto slopes = layerOf(roof);
    for (const Vec3& p : brushOutline({{slopes.get()}}, {Vec3(0.01, 0, 0), 2.0}, Vec3::UnitZ())) {
      QVERIFY(std::abs(p.z() + std::abs(p.x()) * std::tan(15 * kRadiansPerDegree)) < 1e-9);
    }
    // A brush wider than the rod below it: neither torn between the rod and the floor beneath it nor zigzag.
    TriangleSoup rod;
    rod.points = {{-1, -20, 0}, {1, -20, 0}, {1, 20, 0}, {-1, 20, 0}, {-20, -20, -2.5}, {20, -20, -2.5}, {0, 40, -2.5}};
    rod.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}};
    const auto rodAndFloor = layerOf(rod);
    for (const Vec3& p : brushOutline({{rodAndFloor.get()}}, {Vec3::Zero(), 3.0}, Vec3::UnitZ())) {
      QVERIFY(std::abs(p.z()) < 1e-9 && std::abs(p.norm() - 3) < 1e-9);
    }
    const std::vector<Vec3> free = brushOutline({}, brush, Vec3::UnitX());
    for (const Vec3& p : free) QVERIFY(std::abs(p.x() - 10) < 1e-12);
    QVERIFY((free.front() - free.back()).norm() < 1e-12);
  }
};

HANDWHEEL_TEST(PickingTest)
#include "PickingTest.moc"
