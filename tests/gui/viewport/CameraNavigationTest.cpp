// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/CameraNavigation.h"

#include <rapidcheck.h>
#include <QtTest>

using namespace handwheel;

namespace {

const Vec2 kSize(800, 600);

double number(double limit) {
  return *rc::gen::inRange(-1000, 1001) * limit / 1000.0;
}

Vec3 anyPoint() {
  return {number(50), number(50), number(50)};
}

CameraState anyCamera() {
  CameraState c;
  c.centre = anyPoint();
  c.orientation = Eigen::Quaterniond(2 + number(1), number(1), number(1), number(1)).normalized();
  c.height = 10 + std::abs(number(90));
  return c;
}

}  // namespace

class CameraNavigationTest : public QObject {
  Q_OBJECT
 private slots:
  void screenAxes() {
    CameraState c;  // x right, y up, looks down z
    c.height = 60;  // a tenth of a unit to the pixel
    const CameraNavigation view(c, kSize);
    QVERIFY((view.toScreen({0, 0, 7}) - Vec2(400, 300)).norm() < 1e-12);
    QVERIFY((view.toScreen({1, 0, 0}) - Vec2(410, 300)).norm() < 1e-12);
    QVERIFY((view.toScreen({0, 1, 0}) - Vec2(400, 290)).norm() < 1e-12);
    QCOMPARE(view.depth({3, 4, 5}), 5.0);
  }

  void standardViewsLookTheRightWay() {
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
  }

  void fromScreenInvertsToScreen() {
    QVERIFY(rc::check([] {
      const CameraNavigation view(anyCamera(), kSize);
      const Vec2 s(number(1000), number(1000));
      RC_ASSERT((view.toScreen(view.fromScreen(s)) - s).norm() < 1e-6);
    }));
  }

  void orbitKeepsThePivotInPlace() {
    QVERIFY(rc::check([] {
      const CameraState c = anyCamera();
      const Vec3 pivot = anyPoint();
      const CameraState turned = CameraNavigation(c, kSize).orbited(pivot, {number(300), number(300)});
      const Vec2 before = CameraNavigation(c, kSize).toScreen(pivot),
                 after = CameraNavigation(turned, kSize).toScreen(pivot);
      RC_ASSERT((before - after).norm() < 1e-6);
      RC_ASSERT(std::abs(turned.orientation.norm() - 1) < 1e-12);
    }));
  }

  void orbitFollowsTheCursor() {
    const CameraNavigation view(CameraState{}, kSize);
    const Vec3 front(0, 0, 0.3);  // before the pivot
    const CameraState turned = view.orbited(Vec3::Zero(), {20, 0});
    QVERIFY(CameraNavigation(turned, kSize).toScreen(front).x() > view.toScreen(front).x());
    const CameraState tilted = view.orbited(Vec3::Zero(), {0, 20});
    QVERIFY(CameraNavigation(tilted, kSize).toScreen(front).y() > view.toScreen(front).y());
  }

  void panMovesEverythingWithTheCursor() {
    QVERIFY(rc::check([] {
      const CameraState c = anyCamera();
      const Vec2 delta(number(300), number(300));
      const Vec3 p = anyPoint();
      const CameraState panned = CameraNavigation(c, kSize).panned(delta);
      const Vec2 moved = CameraNavigation(panned, kSize).toScreen(p) - CameraNavigation(c, kSize).toScreen(p);
      RC_ASSERT((moved - delta).norm() < 1e-6);
    }));
  }

  void zoomKeepsWhatIsUnderTheCursor() {
    QVERIFY(rc::check([] {
      const CameraState c = anyCamera();
      const Vec2 cursor(number(400) + 400, number(300) + 300);
      const Vec3 p = CameraNavigation(c, kSize).fromScreen(cursor);
      const CameraState zoomed = CameraNavigation(c, kSize).zoomedAt(cursor, 2.5);
      RC_ASSERT((CameraNavigation(zoomed, kSize).toScreen(p) - cursor).norm() < 1e-6);
      RC_ASSERT(std::abs(zoomed.height * 2.5 - c.height) < 1e-9);
    }));
  }

  void fittedShowsAllAndFillsTheShare() {
    QVERIFY(rc::check([] {
      std::vector<Vec3> points;
      for (int i = 0; i < 20; ++i) points.push_back(anyPoint());
      points.push_back(points[0] + Vec3::Ones());  // never all the same
      const CameraNavigation view(CameraNavigation(anyCamera(), kSize).fitted(points, 0.5), kSize);
      Vec2 low = kSize, high = Vec2::Zero();
      for (const Vec3& p : points) {
        low = low.cwiseMin(view.toScreen(p));
        high = high.cwiseMax(view.toScreen(p));
      }
      RC_ASSERT(((low + high) / 2 - kSize / 2).norm() < 1e-6);
      const Vec2 share = (high - low).cwiseQuotient(kSize);
      RC_ASSERT(std::abs(share.maxCoeff() - 0.5) < 1e-9);
    }));
  }

  void fittedKeepsClearOfWhatCoversTheLowerEdge() {
    QVERIFY(rc::check([] {
      std::vector<Vec3> points;
      for (int i = 0; i < 20; ++i) points.push_back(anyPoint());
      points.push_back(points[0] + Vec3::Ones());  // never all the same
      const double covered = kSize.y() / 4;
      const CameraNavigation view(CameraNavigation(anyCamera(), kSize).fitted(points, 0.5, covered), kSize);
      const Vec2 free = kSize - Vec2(0, covered);
      Vec2 low = kSize, high = Vec2::Zero();
      for (const Vec3& p : points) {
        low = low.cwiseMin(view.toScreen(p));
        high = high.cwiseMax(view.toScreen(p));
      }
      RC_ASSERT(((low + high) / 2 - free / 2).norm() < 1e-6);
      RC_ASSERT(std::abs((high - low).cwiseQuotient(free).maxCoeff() - 0.5) < 1e-9);
    }));
  }

  void turnedTowardsLooksAgainstTheDirection() {
    QVERIFY(rc::check([] {
      const CameraState c = anyCamera();
      const Vec3 outward = anyPoint() + Vec3(0.01, 0.02, 0.03);
      const Vec3 z = turnedTowards(c.orientation, outward) * Vec3::UnitZ();
      RC_ASSERT((z - outward.normalized()).norm() < 1e-6);
    }));
    const Vec3 opposite = turnedTowards(Eigen::Quaterniond::Identity(), -Vec3::UnitZ()) * Vec3::UnitZ();
    QVERIFY((opposite + Vec3::UnitZ()).norm() < 1e-9);
    QVERIFY(turnedTowards(Eigen::Quaterniond::Identity(), Vec3::Zero()).isApprox(Eigen::Quaterniond::Identity()));
  }

  void flightBeginsAndEndsWhereItShould() {
    QVERIFY(rc::check([] {
      const CameraState a = anyCamera(), b = anyCamera();
      RC_ASSERT(between(a, b, 1.0) == b);
      const CameraState start = between(a, b, 0.0);
      RC_ASSERT((start.centre - a.centre).norm() < 1e-9);
      RC_ASSERT(std::abs(start.height - a.height) < 1e-9);
      RC_ASSERT(start.orientation.angularDistance(a.orientation) < 1e-6);
    }));
  }
};

QTEST_APPLESS_MAIN(CameraNavigationTest)
#include "CameraNavigationTest.moc"
