// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/path/PathBlends.h"

#include "TestClass.h"
#include "document/cell/CellImport.h"
#include "robot/arm/NumericalIk.h"
#include "robot/dh/DhTable.h"
#include "scene/PrimitiveGeometry.h"

#include <rapidcheck.h>
#include <QTest>
#include <cmath>

using namespace handwheel;

namespace {

JointValues jointValues(std::initializer_list<double> numbers) {
  JointValues values(static_cast<Eigen::Index>(numbers.size()));
  std::copy(numbers.begin(), numbers.end(), values.begin());
  return values;
}

// An IRB 120, alone or with a ball.
class BlendFixture {
 public:
  explicit BlendFixture(const std::optional<std::pair<Vec3, double>>& ball = {}, bool hasPen = false) {
    auto cell = std::make_shared<RobotCellSnapshot>(*cellOf(*libraryTable("irb120")));
    if (ball) {
      Body body{.id = 1, .name = "ball", .geometry = *PrimitiveGeometry::make(Primitive::Sphere, {ball->second})};
      body.pose.translation() = ball->first;
      cell->bodies = cell->bodies.with(std::make_shared<const Body>(std::move(body)));
    }
    if (hasPen) {
      Body pen{.id = 2, .name = "pen", .geometry = *PrimitiveGeometry::make(Primitive::Cylinder, {6.0, 90.0})};
      pen.carrier = "flange";
      pen.pose.translation() = Vec3(0.0, 0.0, 45.0);
      cell->bodies = cell->bodies.with(std::make_shared<const Body>(std::move(pen)));
      plans.tool.translation() = Vec3(0.0, 0.0, 90.0);
    }
    CollisionMeshes meshes;
    m_scene = std::make_shared<const CellScene>(std::move(sceneOf(*cell, meshes)).value());
  }
  const CellScene& scene() const { return *m_scene; }
  std::vector<double> blends(const RobotPath& path, double clearance = 0.0) const {
    return certifiedBlends(scene(), plans, path, resolved(scene(), plans, path), clearance);
  }
  // Joint values for the tool so far from where it is at others.
  JointValues moved(const JointValues& from, const Vec3& by) const {
    Pose tip = scene().arm.tipPose(scene().planned(from));
    tip.translation() += by;
    return scene().whole(solvedNumerically(scene().arm, tip, scene().planned(from), {.tolerance = 1e-10}).values);
  }

  CellPlans plans;

 private:
  std::shared_ptr<const CellScene> m_scene;
};

}  // namespace

// The free zones of blends.
class PathBlendsTest : public QObject {
  Q_OBJECT

 private slots:
  // In the open: joint motions and lines, in every combination; also with a tool, which is next to a link that it can
  // never meet.
  void inTheOpen_data() {
    QTest::addColumn<bool>("hasPen");
    QTest::newRow("bare") << false;
    QTest::newRow("with a pen") << true;
  }
  void inTheOpen() {
    QFETCH(const bool, hasPen);
    const BlendFixture fixture({}, hasPen);
    const JointValues a = jointValues({0.2, 0.3, 0.1, 0.1, 0.8, 0.0}), b = fixture.moved(a, {0.0, -80.0, 0.0}),
                      c = fixture.moved(b, {0.0, 0.0, 60.0});
    for (const bool isLine : {false, true}) {
      for (const bool isNextLine : {false, true}) {
        const auto kind = [](bool line) { return line ? ProgramMotion::Kind::Linear : ProgramMotion::Kind::Joint; };
        const RobotPath path{"p",
                             {{.joints = a},
                              {.joints = b, .motion = kind(isLine), .blend = 5.0},
                              {.joints = c, .motion = kind(isNextLine)}}};
        const auto blends = fixture.blends(path);
        QCOMPARE(blends[0], 0.0);
        QVERIFY2(blends[1] > 1.0 && blends[1] <= 5.0, qPrintable(QString::number(blends[1])));
        QCOMPARE(blends[2], 0.0);
      }
    }
  }

  // A corner in the plane of the arm: the joints that stand still there do not make it an exact stop.
  void inThePlaneOfTheArm() {
    const BlendFixture fixture;
    const JointValues a = jointValues({0.0, 0.3, 0.1, 0.0, 0.8, 0.0}), b = fixture.moved(a, {-40.0, 0.0, 0.0}),
                      c = fixture.moved(b, {0.0, 0.0, -40.0});
    const auto line = ProgramMotion::Kind::Linear;
    const RobotPath path{"p",
                         {{.joints = a}, {.joints = b, .motion = line, .blend = 3.0}, {.joints = c, .motion = line}}};
    QVERIFY(fixture.blends(path)[1] > 0.5);
  }

  // A process path with waypoints 1 mm apart, whose blends reach half of the distance to the next one: 0.5 mm of 5 mm,
  // and with 3 mm between tool and part they stay.
  void closeWaypoints() {
    const JointValues a = jointValues({0.2, 0.3, 0.1, 0.1, 0.8, 0.0});
    const BlendFixture open;
    const Vec3 flange = open.scene().arm.tipPose(open.scene().planned(a)).translation();
    for (const bool isBeside : {false, true}) {
      std::optional<std::pair<Vec3, double>> ball;
      if (isBeside) ball = std::pair{Vec3(flange + Vec3(0.0, 0.0, -200.0)), 20.0};
      const BlendFixture fixture(ball);
      const double distance =
          isBeside ? fixture.scene().scene.nearestObstacle(fixture.scene().planned(a), 1e3).distance : 4.0;
      RobotPath path{"p", {{.joints = a}}};
      for (int i = 1; i <= 4; ++i)
        path.waypoints.push_back(
            {.joints = fixture.moved(path.waypoints.back().joints, {0.0, i % 2 ? 1.0 : 0.0, i % 2 ? 0.0 : 1.0}),
             .motion = ProgramMotion::Kind::Linear,
             .blend = 5.0});
      const auto blends = fixture.blends(path, std::max(0.0, distance - 4.0));
      for (const std::size_t i : {1, 2, 3})
        QVERIFY2(blends[i] > 0.49 && blends[i] <= 0.5 + 1e-6, qPrintable(QString::number(blends[i])));
    }
  }

  // A ball beside the flange at the waypoint: everything within the triangle of the corner keeps clear of it, and a
  // waypoint without the clearance has no zone. The triangle ends where the tool leaves the ball of the zone, which on
  // an arc is farther along it than the radius.
  void besideABall_data() {
    QTest::addColumn<double>("wanted");
    QTest::newRow("5 mm") << 5.0;
    QTest::newRow("150 mm") << 150.0;
    QTest::newRow("400 mm") << 400.0;
  }
  void besideABall() {
    QFETCH(double, wanted);
    const JointValues a = jointValues({-1.5, 0.6, 0.0, 0.0, 0.5, 0.0}), b = jointValues({0.0, 0.6, 0.0, 0.0, 0.5, 0.0}),
                      c = jointValues({0.0, -0.6, 0.0, 0.0, 0.5, 0.0});
    const BlendFixture open;
    const Vec3 flange = open.scene().arm.tipPose(open.scene().planned(b)).translation();
    const RobotPath path{"p", {{.joints = a}, {.joints = b, .blend = wanted}, {.joints = c}}};
    int near = 0;
    for (const double away : {120.0, 90.0, 75.0, 66.0, 62.0}) {
      const BlendFixture fixture(std::pair{Vec3(flange + Vec3(0.6 * away, 0.0, -0.8 * away)), 30.0});
      const double distance = fixture.scene().scene.nearestObstacle(fixture.scene().planned(b), 1e3).distance;
      if (distance <= 0.0) continue;
      const double blend = fixture.blends(path)[1];
      const CellScene& scene = fixture.scene();
      const ArmValues at = scene.planned(b), in = scene.planned(a) - at, out = scene.planned(c) - at;
      const auto shareOf = [&](const ArmValues& side) {
        double share = 0.0;
        while (share < 0.5 && (scene.arm.tipPose(at + share * side).translation() - flange).norm() < blend)
          share += 1e-4;
        return share;
      };
      const double first = shareOf(in), second = shareOf(out);
      for (int i = 0; i <= 20 && blend > 0.0; ++i) {
        for (int k = 0; i + k <= 20; ++k)
          QVERIFY(scene.scene.nearest(at + 0.05 * i * first * in + 0.05 * k * second * out, 1.0).distance > 0.0);
      }
      QCOMPARE(fixture.blends(path, distance)[1], 0.0);
      ++near;
    }
    QVERIFY(near >= 3);
  }

  // The zone of a small blend on a long motion is as small as the blend: a clearance that 1 mm leaves is kept, although
  // the motions are 150 mm long.
  void smallOnALongMotion() {
    const BlendFixture open;
    const JointValues a = jointValues({0.0, 0.3, 0.1, 0.0, 0.8, 0.0}), b = open.moved(a, {0.0, 150.0, 0.0}),
                      c = open.moved(b, {0.0, 0.0, 150.0});
    const auto line = ProgramMotion::Kind::Linear;
    const RobotPath path{"p",
                         {{.joints = a}, {.joints = b, .motion = line, .blend = 1.0}, {.joints = c, .motion = line}}};
    const Vec3 flange = open.scene().arm.tipPose(open.scene().planned(b)).translation();
    int found = 0;
    for (double away = 60.0; away < 140.0; away += 10.0) {
      const BlendFixture fixture(std::pair{Vec3(flange + Vec3(0.0, -away, away)), 5.0});
      const CellScene& scene = fixture.scene();
      const ResolvedPath resolvedPath = resolved(scene, fixture.plans, path);
      QVERIFY(!resolvedPath.stopsAt);
      double least = 1e3;
      for (const ArmValues& values : resolvedPath.joints)
        least = std::min(least, scene.scene.nearestObstacle(values, 1e3).distance);
      if (least <= 3.0) continue;
      // Within the triangle of 1 mm the tool is at most 0.71 mm nearer to the ball than on the path.
      QCOMPARE(fixture.blends(path, least - 2.0)[1], 1.0);
      ++found;
    }
    QVERIFY(found > 0);
  }

  // Blends that were wanted and not certified are counted, but at the ends, where the robot stops in any case.
  void stoppedBlendsAreCounted() {
    RobotPath path{"p", std::vector<Waypoint>(5, Waypoint{.joints = JointValues::Zero(6), .blend = 1.0})};
    path.waypoints[3].blend = 0.0;
    CheckedPath checked;
    checked.blends = {0.0, 0.0, 0.7, 0.0, 0.0};
    QCOMPARE(stoppedBlends(path, checked), std::size_t{1});
    const std::vector<SmallerBlend> smaller = smallerBlends(path, checked);
    QCOMPARE(smaller.size(), std::size_t{1});
    QVERIFY(smaller[0].waypoint == 2 && smaller[0].wanted == 1.0 && smaller[0].kept == 0.7);
    checked.blends[1] = 1.0;
    QCOMPARE(stoppedBlends(path, checked), std::size_t{0});
    path.waypoints.clear();
    QCOMPARE(stoppedBlends(path, checked), std::size_t{0});
  }

  // For any corner: if the tool goes from a point of one motion to a point of the other within the zone, nothing
  // collides.
  void anyCorner() {
    int zones = 0;
    QVERIFY(rc::check("free", [&zones] {
      const auto number = [](double low, double high) {
        return low + (high - low) * *rc::gen::inRange(0, 10'001) / 1e4;
      };
      const JointValues b = jointValues({number(-0.5, 0.5), number(0.0, 0.5), number(-0.3, 0.3), number(-1.0, 1.0),
                                         number(0.4, 1.2), number(-1.0, 1.0)});
      const BlendFixture open;
      const Pose tip = open.scene().arm.tipPose(open.scene().planned(b));
      const Vec3 direction(number(-1.0, 1.0), number(-1.0, 1.0), number(-1.0, 1.0));
      if (direction.norm() < 0.1) return;
      const BlendFixture fixture(
          std::pair{Vec3(tip.translation() + (50.0 + number(2.0, 100.0)) * direction.normalized()), 20.0});
      const JointValues a = fixture.moved(b, {number(-40.0, 40.0), number(-40.0, 40.0), number(10.0, 40.0)});
      const JointValues c = fixture.moved(b, {number(-40.0, 40.0), number(10.0, 40.0), number(-40.0, 40.0)});
      const bool isLine = *rc::gen::arbitrary<bool>();
      const auto kind = isLine ? ProgramMotion::Kind::Linear : ProgramMotion::Kind::Joint;
      const RobotPath path{"p",
                           {{.joints = a}, {.joints = b, .motion = kind, .blend = 8.0}, {.joints = c, .motion = kind}}};
      const double blend = fixture.blends(path)[1];
      if (blend == 0.0) return;
      ++zones;
      const CellScene& scene = fixture.scene();
      const ArmValues in = scene.planned(a), at = scene.planned(b), out = scene.planned(c);
      const auto within = [&](const ArmValues& end) {
        ArmValues last = at;
        for (int i = 1; i <= 200; ++i) {
          const ArmValues values = at + (0.5 * i / 200.0) * (end - at);
          if ((scene.arm.tipPose(values).translation() - scene.arm.tipPose(at).translation()).norm() > blend) break;
          last = values;
        }
        return last;
      };
      const ArmValues first = within(in), second = within(out);
      for (int i = 0; i <= 10; ++i) {
        const ArmValues across = first + 0.1 * i * (second - first);
        for (const ArmValues& values : {across, ArmValues(0.5 * (across + at))})
          RC_ASSERT(scene.scene.nearest(values, 1.0).distance > 0.0);
      }
    }));
    QVERIFY(zones >= 10);
  }
};

HANDWHEEL_TEST(PathBlendsTest)
#include "PathBlendsTest.moc"
