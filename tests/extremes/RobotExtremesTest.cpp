// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "document/cell/CellImport.h"
#include "document/cell/CellScene.h"
#include "planning/PathVerification.h"
#include "planning/RoutePlanning.h"
#include "robot/dh/DhTable.h"
#include "scene/MeshGeometry.h"

#include <QTest>
#include <cmath>

using namespace handwheel;

namespace {

constexpr std::size_t kBallTriangles = 1'000'000;
constexpr double kBallRadius = 120.0;  // mm

// A closed ball of at least so many triangles, all corners on the sphere, with parallels and meridians.
TriangleSoup fineBall(std::size_t triangles, double radius) {
  const auto rings = static_cast<std::uint32_t>(std::ceil(0.5 * std::sqrt(static_cast<double>(triangles))) + 1.0);
  const std::uint32_t sides = 2 * rings;
  TriangleSoup ball;
  ball.points.emplace_back(0.0, 0.0, radius);
  for (std::uint32_t r = 1; r < rings; ++r) {
    for (std::uint32_t s = 0; s < sides; ++s) {
      const double polar = M_PI * r / rings, around = 2.0 * M_PI * s / sides;
      ball.points.emplace_back(
          radius * Vec3(std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), std::cos(polar)));
    }
  }
  ball.points.emplace_back(0.0, 0.0, -radius);
  const auto last = static_cast<std::uint32_t>(ball.points.size()) - 1;
  const auto at = [&](std::uint32_t r, std::uint32_t s) { return 1 + (r - 1) * sides + s % sides; };
  for (std::uint32_t s = 0; s < sides; ++s) {
    ball.triangles.push_back({0, at(1, s), at(1, s + 1)});
    for (std::uint32_t r = 1; r + 1 < rings; ++r) {
      ball.triangles.push_back({at(r, s), at(r + 1, s), at(r + 1, s + 1)});
      ball.triangles.push_back({at(r, s), at(r + 1, s + 1), at(r, s + 1)});
    }
    ball.triangles.push_back({last, at(rings - 1, s + 1), at(rings - 1, s)});
  }
  return ball;
}

ArmValues reaching(double first) {
  ArmValues values = ArmValues::Zero(6);
  values[0] = first;
  values[1] = 0.5;
  return values;
}

}  // namespace

// A robot among obstacles that are larger than any that people model by hand.
class RobotExtremesTest : public QObject {
  Q_OBJECT

 private slots:
  // Moves past a ball of a million triangles in the middle of the path. The planned path is judged with the exact
  // sphere that contains the ball.
  void aMillionTriangles() {
    TriangleSoup ball = fineBall(kBallTriangles, kBallRadius);
    QVERIFY(ball.triangles.size() >= kBallTriangles);
    auto cell = std::make_shared<RobotCellSnapshot>(*cellOf(*libraryTable("irb120")));
    CollisionMeshes meshes;
    const Result<CellScene> empty = sceneOf(*cell, meshes);
    QVERIFY(empty.hasValue());
    const Vec3 middle = empty->arm.tipPose(reaching(0.0)).translation();
    Body body{.id = 1, .name = "ball", .geometry = std::make_shared<MeshGeometry>(std::move(ball))};
    body.pose.translation() = middle;
    cell->bodies = cell->bodies.with(std::make_shared<const Body>(std::move(body)));
    const Result<CellScene> scene = sceneOf(*cell, meshes);
    QVERIFY(scene.hasValue());
    const std::array<ArmValues, 2> ends{reaching(1.2), reaching(-1.2)};
    MotionCheckSettings check;
    check.clearance = 1.0;
    // A path straight through is detected, and so is a configuration inside it.
    QVERIFY(!verified(scene->scene, {ends[0], ends[1]}, check).isCertified());
    QVERIFY(!scene->scene.isFree(reaching(0.0), 0.0, 0.0));
    RouteSettings settings;
    settings.plan.check = check;
    settings.plan.seconds = 600.0;  // never reached; not a limit that a busy machine should meet
    settings.shortcuts = 10;
    const Route route = planRoute(scene->scene, ends, settings);
    QVERIFY(route.isSolved());
    QVERIFY(verified(scene->scene, route.legs.front(), check).isCertified());
    RobotScene exact = empty->scene;
    exact.addObstacle(CollisionBody({CollisionPiece::sphere(Vec3::Zero(), kBallRadius)}),
                      Pose(Eigen::Translation3d(middle)), 1);
    check.clearance = 0.9;  // the facets are within 0.01 mm of the sphere
    QVERIFY(verified(exact, route.legs.front(), check).isCertified());
  }
};

HANDWHEEL_TEST(RobotExtremesTest)
#include "RobotExtremesTest.moc"
