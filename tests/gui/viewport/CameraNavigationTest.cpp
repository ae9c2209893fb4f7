// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "viewport/camera/CameraNavigation.h"

#include <rapidcheck.h>
#include <QtTest>

using namespace handwheel;

namespace {

const Vec2 kCameraNavigationSize(800, 600);

double cameraNavigationNumber(double limit) {
  return *rc::gen::inRange(-1000, 1001) * limit / 1000.0;
}

Vec3 cameraNavigationAnyPoint() {
  return {cameraNavigationNumber(50), cameraNavigationNumber(50), cameraNavigationNumber(50)};
}

CameraState cameraNavigationAnyCamera() {
  CameraState c;
  c.centre = cameraNavigationAnyPoint();
  c.orientation = Eigen::Quaterniond(2 + cameraNavigationNumber(1), cameraNavigationNumber(1),
                                     cameraNavigationNumber(1), cameraNavigationNumber(1))
                      .normalized();
  c.height = 10 + std::abs(cameraNavigationNumber(90));
  return c;
}

// Returns cameras of both projections, one after the other.
CameraState anyCameraOfBoth() {
  CameraState c = cameraNavigationAnyCamera();
  c.projection = *rc::gen::element(Projection::Parallel, Projection::Perspective);
  return c;
}

// Returns a point that the camera sees: about the focus, and before the eye.
Vec3 anyPointBefore(const CameraState& c) {
  return c.centre + c.orientation *
                        Vec3(cameraNavigationNumber(1), cameraNavigationNumber(1), cameraNavigationNumber(1)) *
                        c.height;
}

}  // namespace

class CameraNavigationTest : public QObject {
  Q_OBJECT
 private slots:
  // The motion of the model on the screen when it is carried: a point moves like a point of a rigid body.
  void carriesTheModel() {
    const bool ok = rc::check([] {
      const CameraState c = anyCameraOfBoth();
      const Vec3 pivot = anyPointBefore(c);
      const Vec2 shift(cameraNavigationNumber(0.5), cameraNavigationNumber(0.5));
      const Vec3 turn(cameraNavigationNumber(1), cameraNavigationNumber(1), cameraNavigationNumber(1));
      const Vec3 point = anyPointBefore(c);
      const auto inView = [](const CameraState& camera, const Vec3& p) -> Vec3 {
        return camera.orientation.conjugate() * (p - camera.centre);
      };
      const CameraState carried = CameraNavigation(c, kCameraNavigationSize).movedByHand(pivot, shift, turn);
      const Eigen::AngleAxisd turned(turn.norm(), turn.norm() > 0 ? Vec3(turn.normalized()) : Vec3(Vec3::UnitX()));
      const Vec3 move = c.height * Vec3(shift.x(), shift.y(), 0);
      const Vec3 wanted = turned * (inView(c, point) - inView(c, pivot)) + inView(c, pivot) + move;
      RC_ASSERT((inView(carried, point) - wanted).norm() < 1e-9 * c.height);
      RC_ASSERT(carried.height == c.height);
    });
    QVERIFY(ok);
  }

  void screenAxes() {
    CameraState c;  // x right, y up, looks down z
    c.height = 60;  // a tenth of a unit to the pixel
    const CameraNavigation view(c, kCameraNavigationSize);
    QVERIFY((view.toScreen({0, 0, 7}) - Vec2(400, 300)).norm() < 1e-12);
    QVERIFY((view.toScreen({1, 0, 0}) - Vec2(410, 300)).norm() < 1e-12);
    QVERIFY((view.toScreen({0, 1, 0}) - Vec2(400, 290)).norm() < 1e-12);
    QCOMPARE(view.depth({3, 4, 5}), 5.0);
  }

  void standardViewsLookInTheRightDirection() {
    const auto towards = [](StandardView v) -> Vec3 { return orientationOf(v) * Vec3::UnitZ(); };
    const auto up = [](StandardView v) -> Vec3 { return orientationOf(v) * Vec3::UnitY(); };
    const auto right = [](StandardView v) -> Vec3 { return orientationOf(v) * Vec3::UnitX(); };
    QVERIFY((towards(StandardView::Front) + Vec3::UnitY()).norm() < 1e-12);
    QVERIFY((right(StandardView::Front) - Vec3::UnitX()).norm() < 1e-12);
    QVERIFY((up(StandardView::Front) - Vec3::UnitZ()).norm() < 1e-12);
    QVERIFY((right(StandardView::Right) - Vec3::UnitY()).norm() < 1e-12);
    QVERIFY((right(StandardView::Top) - Vec3::UnitX()).norm() < 1e-12);
    QVERIFY((right(StandardView::Bottom) - Vec3::UnitX()).norm() < 1e-12);
    QVERIFY((towards(StandardView::Bottom) + Vec3::UnitZ()).norm() < 1e-12);
    QVERIFY((towards(StandardView::Isometric) - Vec3(1, -1, 1).normalized()).norm() < 1e-12);
    // The axis of a lathe is level on the screen, its end away from the chuck on the right and to be seen, and the side
    // of the tool is nearer to the viewer.
    const Eigen::Quaterniond lathe = orientationOf(StandardView::Lathe);
    const Vec3 axis = lathe.conjugate() * Vec3::UnitZ();
    QVERIFY(axis.x() > 0.9 && axis.z() > 0.0 && std::abs(axis.y()) < 1e-12);
    QVERIFY((lathe.conjugate() * Vec3::UnitX()).z() > 0.5);
  }

  // The view of a turner: the chuck on the left in front and from above, the tool nearer to the viewer in front and
  // below the work from above, the end of the bar visible from the right.
  void aLatheFromItsSides() {
    const auto see = [](StandardView v, const Vec3& direction) -> Vec3 {
      return (latheFrame() * orientationOf(v)).conjugate() * direction;  // on the screen: right, up, to the viewer
    };
    const Vec3 axis = Vec3::UnitZ(), tool = Vec3::UnitX();
    QVERIFY((see(StandardView::Front, axis) - Vec3::UnitX()).norm() < 1e-12);
    QVERIFY((see(StandardView::Front, tool) - Vec3::UnitZ()).norm() < 1e-12);
    QVERIFY((see(StandardView::Top, axis) - Vec3::UnitX()).norm() < 1e-12);
    QVERIFY((see(StandardView::Top, tool) + Vec3::UnitY()).norm() < 1e-12);
    QVERIFY((see(StandardView::Right, axis) - Vec3::UnitZ()).norm() < 1e-12);
    QVERIFY((see(StandardView::Right, tool) + Vec3::UnitX()).norm() < 1e-12);
    QVERIFY(see(StandardView::Isometric, axis).x() > 0.5 && see(StandardView::Isometric, tool).z() > 0.0);
    // The top is the same side as in the view in which a workpiece is shown first.
    QVERIFY((orientationOf(StandardView::Lathe).conjugate() * (latheFrame() * Vec3::UnitZ())).y() > 0.5);
  }

  void fromScreenInvertsToScreen() {
    QVERIFY(rc::check([] {
      const CameraNavigation view(anyCameraOfBoth(), kCameraNavigationSize);
      const Vec2 s(cameraNavigationNumber(1000), cameraNavigationNumber(1000));
      RC_ASSERT((view.toScreen(view.fromScreen(s)) - s).norm() < 1e-6);
    }));
  }

  // Every point of the line of sight through s appears at s, and lies before the eye or the model.
  void rayRunsThroughWhatAppearsThere() {
    QVERIFY(rc::check([] {
      const CameraState c = anyCameraOfBoth();
      const CameraNavigation view(c, kCameraNavigationSize);
      const Box box(cameraNavigationAnyPoint().cwiseMin(c.centre), cameraNavigationAnyPoint().cwiseMax(c.centre));
      const Vec3 p = anyPointBefore(c);
      const ViewRay ray = view.rayAt(view.toScreen(p), Box(box).extend(p));
      const double along = (p - ray.origin).dot(ray.direction);
      RC_ASSERT(along > 0);
      RC_ASSERT((ray.origin + along * ray.direction - p).norm() < 1e-9 * along);
      RC_ASSERT(std::abs(ray.direction.norm() - 1) < 1e-12);
      RC_ASSERT(ray.eye.has_value() == view.isPerspective());
      if (ray.eye) RC_ASSERT((*ray.eye - c.eye()).norm() == 0.0);
      RC_ASSERT(ray.pixel == c.height / kCameraNavigationSize.y());
    }));
  }

  // Similar triangles: at half the distance to the eye everything is twice as large.
  void perspectiveShrinksWithTheDistance() {
    CameraState c;
    c.height = 60;
    c.projection = Projection::Perspective;
    const CameraNavigation view(c, kCameraNavigationSize);
    const double distance = 30 / std::tan(15 * kRadiansPerDegree);
    QVERIFY((c.eye() - Vec3(0, 0, distance)).norm() < 1e-12);
    QVERIFY((view.toScreen({1, 0, 0}) - Vec2(410, 300)).norm() < 1e-9);
    QVERIFY((view.toScreen({1, 0, distance / 2}) - Vec2(420, 300)).norm() < 1e-9);
    QVERIFY((view.toScreen({1, 0, -distance}) - Vec2(405, 300)).norm() < 1e-9);
    QVERIFY(view.isBeforeEye({0, 0, distance / 2}));
    QVERIFY(!view.isBeforeEye({0, 0, distance}));
    QVERIFY(!view.isBeforeEye({0, 0, 2 * distance}));
  }

  void switchingTheProjectionKeepsTheFocalPlane() {
    QVERIFY(rc::check([] {
      CameraState c = cameraNavigationAnyCamera();
      const Vec3 p =
          c.centre + c.orientation * Vec3(cameraNavigationNumber(1), cameraNavigationNumber(1), 0) * c.height;
      const Vec2 parallel = CameraNavigation(c, kCameraNavigationSize).toScreen(p);
      c.projection = Projection::Perspective;
      RC_ASSERT((CameraNavigation(c, kCameraNavigationSize).toScreen(p) - parallel).norm() < 1e-6);
    }));
  }

  // For any size and distance of the model, all of it is drawn but the part next to the eye, and the depth buffer's 24
  // bits still tell a hundredth of the view's height apart at the focus.
  void depthRangeHoldsTheModel_data() {
    QTest::addColumn<double>("size");
    QTest::addColumn<double>("offset");
    for (const double size : {1e-6, 1.0, 1e6}) {
      QTest::addRow("%g", size) << size << 0.0;
    }
    QTest::addRow("far away") << 1.0 << 1e7;
  }

  void depthRangeHoldsTheModel() {
    QFETCH(double, size);
    QFETCH(double, offset);
    QVERIFY(rc::check([&] {
      const Box box(Vec3(offset, -offset, offset), Vec3(offset, -offset, offset) + Vec3(size, size / 3, size / 7));
      CameraState c = anyCameraOfBoth();
      c.centre = box.center() + cameraNavigationAnyPoint() / 100 * size;
      c.height = size * std::pow(10.0, cameraNavigationNumber(4) - 2);
      const CameraNavigation view(c, kCameraNavigationSize);
      const CameraClippingRange v = view.viewpoint(box);
      RC_ASSERT(v.nearest > 0);
      RC_ASSERT(v.farthest > v.nearest);
      for (const Vec3& corner : cornersOf(box)) {
        const double distance = (v.position - corner).dot(c.towardsViewer());
        RC_ASSERT(distance <= v.farthest);
        RC_ASSERT(distance >= v.nearest || (view.isPerspective() && v.nearest <= 0.05 * c.eyeDistance()));
      }
      const double focus = view.isPerspective() ? c.eyeDistance() : (v.position - c.centre).dot(c.towardsViewer());
      if (view.isPerspective() && focus > v.nearest) {
        const double step = focus * focus / v.nearest * (1 - v.nearest / v.farthest) / (1 << 24);
        RC_ASSERT(step < c.height / 100);
      }
    }));
  }

  void orbitKeepsThePivotInPlace() {
    QVERIFY(rc::check([] {
      const CameraState c = anyCameraOfBoth();
      const Vec3 pivot = anyPointBefore(c);
      const CameraState turned = CameraNavigation(c, kCameraNavigationSize)
                                     .orbited(pivot, {cameraNavigationNumber(300), cameraNavigationNumber(300)});
      const Vec2 before = CameraNavigation(c, kCameraNavigationSize).toScreen(pivot),
                 after = CameraNavigation(turned, kCameraNavigationSize).toScreen(pivot);
      RC_ASSERT((before - after).norm() < 1e-6);
      RC_ASSERT(std::abs(turned.orientation.norm() - 1) < 1e-12);
    }));
  }

  void orbitFollowsTheCursor() {
    const CameraNavigation view(CameraState{}, kCameraNavigationSize);
    const Vec3 front(0, 0, 0.3);  // before the pivot
    const CameraState turned = view.orbited(Vec3::Zero(), {20, 0});
    QVERIFY(CameraNavigation(turned, kCameraNavigationSize).toScreen(front).x() > view.toScreen(front).x());
    const CameraState tilted = view.orbited(Vec3::Zero(), {0, 20});
    QVERIFY(CameraNavigation(tilted, kCameraNavigationSize).toScreen(front).y() > view.toScreen(front).y());
  }

  void panTakesTheGrabbedPointAlong() {
    QVERIFY(rc::check([] {
      const CameraState c = anyCameraOfBoth();
      const Vec2 delta(cameraNavigationNumber(300), cameraNavigationNumber(300));
      const Vec3 p = anyPointBefore(c);
      const CameraState panned = CameraNavigation(c, kCameraNavigationSize).panned(delta, p);
      const Vec2 moved = CameraNavigation(panned, kCameraNavigationSize).toScreen(p) -
                         CameraNavigation(c, kCameraNavigationSize).toScreen(p);
      RC_ASSERT((moved - delta).norm() < 1e-6);
    }));
  }

  void panMovesEverythingWithTheCursor() {
    QVERIFY(rc::check([] {
      const CameraState c = cameraNavigationAnyCamera();
      const Vec2 delta(cameraNavigationNumber(300), cameraNavigationNumber(300));
      const Vec3 p = cameraNavigationAnyPoint();
      const CameraState panned = CameraNavigation(c, kCameraNavigationSize).panned(delta);
      const Vec2 moved = CameraNavigation(panned, kCameraNavigationSize).toScreen(p) -
                         CameraNavigation(c, kCameraNavigationSize).toScreen(p);
      RC_ASSERT((moved - delta).norm() < 1e-6);
    }));
  }

  void zoomKeepsWhatIsUnderTheCursor() {
    QVERIFY(rc::check([] {
      const CameraState c = anyCameraOfBoth();
      const Vec2 cursor(cameraNavigationNumber(400) + 400, cameraNavigationNumber(300) + 300);
      const Vec3 p = CameraNavigation(c, kCameraNavigationSize).fromScreen(cursor);
      const CameraState zoomed = CameraNavigation(c, kCameraNavigationSize).zoomedAt(cursor, 2.5);
      RC_ASSERT((CameraNavigation(zoomed, kCameraNavigationSize).toScreen(p) - cursor).norm() < 1e-6);
      RC_ASSERT(std::abs(zoomed.height * 2.5 - c.height) < 1e-9);
    }));
  }

  void zoomAboutAPointKeepsItThere() {
    QVERIFY(rc::check([] {
      const CameraState c = anyCameraOfBoth();
      const Vec3 p = anyPointBefore(c);
      const CameraState zoomed = CameraNavigation(c, kCameraNavigationSize).zoomedAbout(p, 2.5);
      const CameraNavigation before(c, kCameraNavigationSize), after(zoomed, kCameraNavigationSize);
      RC_ASSERT((after.toScreen(p) - before.toScreen(p)).norm() < 1e-6);
      RC_ASSERT(std::abs(after.unitsPerPixelAt(p) * 2.5 - before.unitsPerPixelAt(p)) < 1e-9);
    }));
  }

  void uprightViewsLookAlongTheirDirection() {
    QVERIFY(rc::check([] {
      const Vec3 outward = cameraNavigationAnyPoint() + Vec3(0.01, 0.02, 0.03);
      const Eigen::Quaterniond q = uprightTowards(outward);
      RC_ASSERT((q * Vec3::UnitZ() - outward.normalized()).norm() < 1e-9);
      RC_ASSERT(std::abs((q * Vec3::UnitX()).z()) < 1e-9);  // the horizon is level
      RC_ASSERT((q * Vec3::UnitY()).z() > 0);
    }));
    for (const StandardView v : {StandardView::Front, StandardView::Back, StandardView::Left, StandardView::Right,
                                 StandardView::Top, StandardView::Bottom, StandardView::Isometric}) {
      const Eigen::Quaterniond q = orientationOf(v);
      QVERIFY(uprightTowards(3 * (q * Vec3::UnitZ())).angularDistance(q) < 1e-9);
    }
    QVERIFY(uprightTowards(Vec3::Zero()).angularDistance(orientationOf(StandardView::Isometric)) < 1e-12);
  }

  void turnedTowardsLooksAgainstTheDirection() {
    const Vec3 up = Vec3::UnitZ();
    QVERIFY(rc::check([&] {
      const CameraState c = cameraNavigationAnyCamera();
      const Vec3 outward = cameraNavigationAnyPoint() + Vec3(0.01, 0.02, 0.03);
      const Eigen::Matrix3d axes = turnedTowards(c.orientation, outward, up).toRotationMatrix();
      RC_ASSERT((axes.col(2) - outward.normalized()).norm() < 1e-6);
      RC_ASSERT((axes.col(0).cross(axes.col(1)) - axes.col(2)).norm() < 1e-9);
    }));
    const Vec3 opposite = turnedTowards(Eigen::Quaterniond::Identity(), -up, up) * Vec3::UnitZ();
    QVERIFY((opposite + up).norm() < 1e-9);
    QVERIFY(turnedTowards(Eigen::Quaterniond::Identity(), Vec3::Zero(), up).isApprox(Eigen::Quaterniond::Identity()));
  }

  // A view that is level stays level, and one that the user has rolled stays rolled by the same angle.
  void turnedTowardsKeepsTheHorizon() {
    QVERIFY(rc::check([] {
      const auto direction = [] {
        const double around = *rc::gen::inRange(0, 360) * kRadiansPerDegree;
        const double height = *rc::gen::inRange(-80, 81) * kRadiansPerDegree;
        return Vec3(std::cos(around) * std::cos(height), std::sin(around) * std::cos(height), std::sin(height));
      };
      const double roll = *rc::gen::element(0, 0, 10, -35, 120, 180) * kRadiansPerDegree;
      const Vec3 from = direction(), to = direction(), up = Vec3::UnitZ();
      const Eigen::Quaterniond present = Eigen::AngleAxisd(roll, from) * uprightTowards(from);
      const Eigen::Quaterniond expected = Eigen::AngleAxisd(roll, to) * uprightTowards(to);
      RC_ASSERT(turnedTowards(present, to, up).angularDistance(expected) < 1e-6);
      // By way of a view from above, from where any side may be at the right.
      const Eigen::Quaterniond level = uprightTowards(from);
      const Eigen::Quaterniond above = turnedTowards(level, Vec3(0.01, -0.02, 1), up);
      RC_ASSERT((above * Vec3::UnitX()).dot(level * Vec3::UnitX()) > 0.99);
      RC_ASSERT(turnedTowards(above, to, up).angularDistance(uprightTowards(to)) < 1e-6);
    }));
  }

  void flightBeginsAndEndsWhereItShould() {
    QVERIFY(rc::check([] {
      const CameraState a = cameraNavigationAnyCamera(), b = cameraNavigationAnyCamera();
      RC_ASSERT(between(a, b, 1.0) == b);
      const CameraState start = between(a, b, 0.0);
      RC_ASSERT((start.centre - a.centre).norm() < 1e-9);
      RC_ASSERT(std::abs(start.height - a.height) < 1e-9);
      RC_ASSERT(start.orientation.angularDistance(a.orientation) < 1e-6);
    }));
  }
};

HANDWHEEL_TEST(CameraNavigationTest)
#include "CameraNavigationTest.moc"
