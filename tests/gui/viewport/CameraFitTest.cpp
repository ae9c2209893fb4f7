// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "viewport/camera/CameraNavigation.h"

#include <rapidcheck.h>
#include <QtTest>

using namespace handwheel;

namespace {

const Vec2 kFitSize(800, 600);

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

class CameraFitTest : public QObject {
  Q_OBJECT
 private slots:
  // All points are within the share of the free part of the view, and at least two opposite sides of it are touched.
  void perspectiveFitShowsAllAndIsTight() {
    QVERIFY(rc::check([] {
      std::vector<Vec3> points;
      for (int i = 0; i < 20; ++i) points.push_back(anyPoint());
      points.push_back(points[0] + Vec3::Ones());  // never all the same
      CameraState c = anyCamera();
      c.projection = Projection::Perspective;
      const double covered = *rc::gen::element(0.0, kFitSize.y() / 4);
      const CameraNavigation view(CameraNavigation(c, kFitSize).fitted(points, 0.5, covered), kFitSize);
      const Vec2 free = kFitSize - Vec2(0, covered);
      Vec2 low = kFitSize, high = Vec2::Zero();
      for (const Vec3& p : points) {
        RC_ASSERT(view.isBeforeEye(p));
        low = low.cwiseMin(view.toScreen(p));
        high = high.cwiseMax(view.toScreen(p));
      }
      const Vec2 reach = (low - free / 2).cwiseAbs().cwiseMax((high - free / 2).cwiseAbs()).cwiseQuotient(free / 2);
      RC_ASSERT(reach.maxCoeff() < 0.5 + 1e-9);
      const Vec2 share = (high - low).cwiseQuotient(free);
      RC_ASSERT(std::abs(share.maxCoeff() - 0.5) < 1e-9);
    }));
  }

  void perspectiveFitOfDegeneratePoints() {
    CameraState c;
    c.projection = Projection::Perspective;
    const Vec3 p(3, 4, 5);
    const CameraNavigation one(CameraNavigation(c, kFitSize).fitted(std::array{p, p}, 0.5), kFitSize);
    QVERIFY((one.toScreen(p) - kFitSize / 2).norm() < 1e-9);
    QVERIFY(one.camera().height > 0);
    const std::array along{p, Vec3(3, 4, 9)};  // one behind the other
    const CameraNavigation line(CameraNavigation(c, kFitSize).fitted(along, 0.5), kFitSize);
    for (const Vec3& q : along) {
      QVERIFY(line.isBeforeEye(q));
      QVERIFY((line.toScreen(q) - kFitSize / 2).norm() < 1e-9);
    }
  }

  void fittedShowsAllAndFillsTheShare() {
    QVERIFY(rc::check([] {
      std::vector<Vec3> points;
      for (int i = 0; i < 20; ++i) points.push_back(anyPoint());
      points.push_back(points[0] + Vec3::Ones());  // never all the same
      const CameraNavigation view(CameraNavigation(anyCamera(), kFitSize).fitted(points, 0.5), kFitSize);
      Vec2 low = kFitSize, high = Vec2::Zero();
      for (const Vec3& p : points) {
        low = low.cwiseMin(view.toScreen(p));
        high = high.cwiseMax(view.toScreen(p));
      }
      RC_ASSERT(((low + high) / 2 - kFitSize / 2).norm() < 1e-6);
      const Vec2 share = (high - low).cwiseQuotient(kFitSize);
      RC_ASSERT(std::abs(share.maxCoeff() - 0.5) < 1e-9);
    }));
  }

  void fittedKeepsClearOfWhatCoversTheLowerEdge() {
    QVERIFY(rc::check([] {
      std::vector<Vec3> points;
      for (int i = 0; i < 20; ++i) points.push_back(anyPoint());
      points.push_back(points[0] + Vec3::Ones());  // never all the same
      const double covered = kFitSize.y() / 4;
      const CameraNavigation view(CameraNavigation(anyCamera(), kFitSize).fitted(points, 0.5, covered), kFitSize);
      const Vec2 free = kFitSize - Vec2(0, covered);
      Vec2 low = kFitSize, high = Vec2::Zero();
      for (const Vec3& p : points) {
        low = low.cwiseMin(view.toScreen(p));
        high = high.cwiseMax(view.toScreen(p));
      }
      RC_ASSERT(((low + high) / 2 - free / 2).norm() < 1e-6);
      RC_ASSERT(std::abs((high - low).cwiseQuotient(free).maxCoeff() - 0.5) < 1e-9);
    }));
  }
};

HANDWHEEL_TEST(CameraFitTest)
#include "CameraFitTest.moc"
