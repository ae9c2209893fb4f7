// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "base/Tolerance.h"
#include "tools/AxisDrag.h"

#include <rapidcheck.h>
#include <QTest>
#include <cmath>
#include <numbers>

using namespace handwheel;

namespace {

constexpr double kHalfTurn = std::numbers::pi;

Ray rayThrough(const Vec3& eye, const Vec3& point) {
  return {eye, (point - eye).normalized()};
}

PickRay parallel(const Ray& ray) {
  return {ray, std::nullopt};
}

double anyNumber(double least, double largest) {
  return least + (largest - least) * *rc::gen::inRange(0, 1'000'001) / 1e6;
}

Vec3 anyDirection() {
  const double z = anyNumber(-0.99, 0.99), turn = anyNumber(0, 2 * kHalfTurn), r = std::sqrt(1 - z * z);
  return {r * std::cos(turn), r * std::sin(turn), z};
}

HeldPoint anyHeld() {
  const Vec3 axis = anyDirection();
  const Vec3 centre(anyNumber(-500, 500), anyNumber(-500, 500), anyNumber(-500, 500));
  return {centre, axis, centre + anyNumber(50, 500) * axis.unitOrthogonal() + anyNumber(-100, 100) * axis};
}

Vec3 turned(const HeldPoint& held, double angle) {
  return held.centre + Eigen::AngleAxisd(angle, held.axis) * (held.point - held.centre);
}

double distance(const Vec3& p, const Ray& ray) {
  return (p - ray.origin).cross(ray.direction).norm();
}

}  // namespace

class AxisDragTest : public QObject {
  Q_OBJECT

 private slots:
  void aroundTheAxis();
  void pointsOnTheCircle();
  void wholeTurnsAreCounted();
  void fromTheSide();
  void outmostPoint();
  void raysThatDoNotTell();
  void slides();
  void slidesWithTheRay();
  void positions();
  void nearlyParallelRays();
};

// Seen along the axis only the direction of the ray around it counts, not its distance.
void AxisDragTest::aroundTheAxis() {
  const HeldPoint held{{10, 20, 5}, {0, 0, 1}, {110, 20, 30}};
  for (double angle : {-3.0, -1.0, 0.0, 0.4, 2.0, 3.1}) {
    for (double radius : {5.0, 100.0, 900.0}) {
      const Vec3 under(10 + radius * std::cos(angle), 20 + radius * std::sin(angle), 30);
      const auto turn = rotationUnder(held, parallel({under + Vec3(0, 0, 700), -Vec3::UnitZ()}), 0.0);
      QVERIFY(turn && std::abs(*turn - angle) < 1e-12);
    }
  }
}

// From any viewpoint, a ray through a point of the circle turns the held point there.
void AxisDragTest::pointsOnTheCircle() {
  QVERIFY(rc::check("points on the circle", [] {
    const HeldPoint held = anyHeld();
    const double angle = anyNumber(-3.0, 3.0);
    const Vec3 goal = turned(held, angle);
    const Vec3 eye = goal + 2000 * anyDirection();
    const Ray ray = rayThrough(eye, goal);
    if (std::abs(ray.direction.dot(held.axis)) >= 0.21) {
      const auto turn = rotationUnder(held, {ray, eye}, 0.0);
      RC_ASSERT(turn.has_value());
      RC_ASSERT(std::abs(std::remainder(*turn - angle, 2 * kHalfTurn)) < 1e-6);
    }
    // A small rotation from a start near by, the side view included.
    const auto near = rotationUnder(held, {ray, eye}, angle + 0.05);
    RC_ASSERT(near.has_value());
    RC_ASSERT(distance(turned(held, *near), ray) < 0.05 * held.lever());
  }));
}

void AxisDragTest::wholeTurnsAreCounted() {
  const HeldPoint held{Vec3::Zero(), Vec3::UnitZ(), {100, 0, 0}};
  double soFar = 0.0;
  for (int step = 1; step <= 100; ++step) {  // five times around
    const double angle = step * kHalfTurn / 10;
    soFar = *rotationUnder(held, parallel({{100 * std::cos(angle), 100 * std::sin(angle), 9}, -Vec3::UnitZ()}), soFar);
    QVERIFY(std::abs(soFar - angle) < 1e-9);
  }
}

// Straight from the side a turn by θ shows as a shift by r sin θ.
void AxisDragTest::fromTheSide() {
  const HeldPoint held{Vec3::Zero(), Vec3::UnitZ(), {100, 0, 0}};
  for (double angle : {-1.4, -0.5, 0.0, 0.3, 1.0, 1.5}) {
    const auto turn = rotationUnder(held, parallel({{1000, 100 * std::sin(angle), 0}, -Vec3::UnitX()}), 0.0);
    QVERIFY(turn && std::abs(*turn - angle) < 1e-6);
    // Above or below the circle's plane nothing else happens.
    const auto beside = rotationUnder(held, parallel({{1000, 100 * std::sin(angle), 40}, -Vec3::UnitX()}), 0.0);
    QVERIFY(beside && std::abs(*beside - angle) < 1e-6);
  }
  // Out of its reach it goes as far as it can.
  const auto most = rotationUnder(held, parallel({{1000, 250, 0}, -Vec3::UnitX()}), 0.5);
  QVERIFY(most && std::abs(*most - kHalfTurn / 2) < 1e-2);
}

// Grabbed at the outline, where its first motion is along the ray: it leaves that position.
void AxisDragTest::outmostPoint() {
  const HeldPoint held{Vec3::Zero(), Vec3::UnitZ(), {0, 100, 0}};
  const auto turn = rotationUnder(held, parallel({{1000, 50, 0}, -Vec3::UnitX()}), 0.0);
  QVERIFY(turn && std::abs(std::abs(*turn) - kHalfTurn / 3) < 1e-4);
}

void AxisDragTest::raysThatDoNotTell() {
  const HeldPoint held{Vec3::Zero(), Vec3::UnitZ(), {100, 0, 0}};
  const Vec3 eye(50, 50, 300);
  QVERIFY(!rotationUnder(held, {{eye, Vec3::UnitZ()}, eye}, 0.0));              // looks away from the plane
  QVERIFY(!rotationUnder(held, parallel({{0, 0, 300}, -Vec3::UnitZ()}), 0.0));  // through the axis
  QVERIFY(!rotationUnder(held, parallel({{1e308, -1e308, 1e308}, Vec3(0.6, 0, -0.8)}), 0.0));
  for (const Vec3& far : {Vec3(1e12, 1e12, 1e12), Vec3(1e200, 0, 0)}) {
    for (const Vec3& direction : {Vec3(-1, 0, 0), Vec3(0, 0, -1), Vec3(0.6, 0, 0.8)}) {
      const auto turn = rotationUnder(held, parallel({far, direction}), 0.0);
      QVERIFY(!turn || std::isfinite(*turn));
    }
  }
}

void AxisDragTest::slides() {
  const HeldPoint held{Vec3::Zero(), Vec3::UnitX(), {10, 20, 30}};
  const auto travel = translationUnder(held, rayThrough({200, 500, 900}, {85, 20, 30}));
  QVERIFY(travel && std::abs(*travel - 75) < 1e-9);
  QVERIFY(!translationUnder(held, {{0, 0, 0}, -Vec3::UnitX()}));
  // Beside the line the nearest point counts.
  const auto beside = translationUnder(held, {{40, 500, 500}, -Vec3::UnitZ()});
  QVERIFY(beside && std::abs(*beside - 30) < 1e-9);
}

void AxisDragTest::slidesWithTheRay() {
  QVERIFY(rc::check("slides", [] {
    const HeldPoint held = anyHeld();
    const double travel = anyNumber(-800, 800);
    const Vec3 goal = held.point + travel * held.axis;
    const Ray ray = rayThrough(goal + 2000 * anyDirection(), goal);
    RC_PRE(std::abs(ray.direction.dot(held.axis)) < 0.99);
    const auto found = translationUnder(held, ray);
    RC_ASSERT(found.has_value());
    RC_ASSERT(std::abs(*found - travel) < 1e-6);
  }));
}

void AxisDragTest::positions() {
  const auto position = positionUnder({0, 0, 10}, -Vec3::UnitZ(), rayThrough({0, 0, 110}, {30, 40, 60}));
  QVERIFY(position && (*position - Vec3(60, 80, 10)).norm() < 1e-9);
  QVERIFY(!positionUnder({0, 0, 10}, -Vec3::UnitZ(), {{0, 0, 0}, Vec3::UnitX()}));
}

// A ray determines a position if the sine between it and the axis, or the plane, is at least kParallelLines.
void AxisDragTest::nearlyParallelRays() {
  const HeldPoint held{Vec3::Zero(), Vec3::UnitX(), {10, 0, 0}};
  for (const double share : {0.9, 1.1}) {
    const double sine = share * tolerance::kParallelLines;
    const Vec3 direction(std::sqrt(1.0 - sine * sine), 0.0, -sine);
    const Ray ray{Vec3(40, 0, 0) - 100.0 * direction, direction};  // through the axis at x = 40
    const auto travel = translationUnder(held, ray);
    const auto position = positionUnder({0, 0, 0}, Vec3::UnitZ(), ray);
    QCOMPARE(travel.has_value(), share > 1.0);
    QCOMPARE(position.has_value(), share > 1.0);
    if (travel) QVERIFY(std::abs(*travel - 30.0) < 1e-6);
    if (position) QVERIFY((*position - Vec3(40, 0, 0)).norm() < 1e-6);
  }
}

HANDWHEEL_TEST(AxisDragTest)
#include "AxisDragTest.moc"
