// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/drilling/DrillRun.h"

#include "ClosedSurface.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "proximity/SelfIntersection.h"
#include "volume/SurfaceToVolume.h"
#include "volume/VolumeSampler.h"
#include "volume/VolumeShapes.h"
#include "volume/drilling/DrillBits.h"
#include "volume/surface/VolumeToSurface.h"

#include <rapidcheck.h>

#include <QtTest>
#include <cmath>
#include <limits>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// A cube of this edge, its top face at z = 0.
SparseVolume plate(double edge, double voxel) {
  return volumeOfSurface(moved(cube(edge), Vec3(-0.5 * edge, -0.5 * edge, -edge)), voxel)->volume;
}

struct Drilled {
  DrillRun run;
  std::vector<DrillTick> ticks;

  // Down the z axis from one height to another, at a feed, mm/s; 1 kHz.
  Drilled(SparseVolume& volume, const DrillSetup& setup, double from, double to, double feed) : run(volume, setup) {
    const int count = static_cast<int>(std::ceil((from - to) / feed * 1000.0));
    for (int i = 0; i <= count; ++i)
      ticks.push_back(run.move({0.013, -0.021, from + (to - from) * i / count}, Vec3::UnitZ(), 0.001 * i));
  }
  // Mean over ticks between two times.
  DrillLoad mean(double from, double to) const {
    DrillLoad sum;
    int n = 0;
    for (const DrillTick& tick : ticks) {
      if (tick.time < from || tick.time > to) continue;
      sum.thrust += tick.thrust;
      sum.torque += tick.torque.norm();
      ++n;
    }
    return {sum.thrust / n, sum.torque / n};
  }
};

}  // namespace

class DrillRunTest : public QObject {
  Q_OBJECT

 private slots:
  // Through a plate: what is gone is a cylinder, and the work of the vectors that were sent is kp times it.
  void volumeAndEnergyOfAHole_data() {
    QTest::addColumn<QString>("tool");
    QTest::addColumn<double>("voxel");
    for (const char* const tool : {"ball:4", "twist:4", "burr:3"})
      for (const double voxel : {0.25, 0.18}) QTest::addRow("%s at %g", tool, voxel) << tool << voxel;
  }
  void volumeAndEnergyOfAHole() {
    QFETCH(QString, tool);
    QFETCH(double, voxel);
    SparseVolume volume = plate(8.0, voxel);
    const double before = countedMaterial(volume);
    DrillSetup setup;
    setup.tool = *drillBitOf(tool.toStdString());
    const Drilled drilled(volume, setup, 3.0, -12.0, 25.0);
    const double radius = setup.tool.radius(), exact = M_PI * radius * radius * 8.0;
    QVERIFY2(std::abs(drilled.run.removed() / exact - 1.0) < 0.01,
             qPrintable(QString::number(drilled.run.removed() / exact)));
    const double work = 1e-3 * setup.material.energy * exact;
    QVERIFY2(std::abs(drilled.run.energy() / work - 1.0) < 0.01,
             qPrintable(QString::number(drilled.run.energy() / work)));
    QVERIFY(std::abs(before - countedMaterial(volume) - drilled.run.removed()) < 1e-6 * before);
    const TriangleSoup surface = surfaceOf(volume);
    QVERIFY(isClosedManifold(surface));
    QCOMPARE(selfIntersections(surface.points, surface.triangles)->size(), std::size_t{0});
  }

  // A saw that goes once over a block, 2 mm below its top and across its axis, leaves a slot as wide as the saw: from
  // edge to edge, with a round end where it has not come out. What it took is the work; where the rim came out of the
  // far side, it is through.
  void aSlot() {
    constexpr double kBlock = 8.0, kDown = 2.0, kFeed = 20.0;  // mm, mm, mm/s
    SparseVolume volume = plate(kBlock, 0.2);
    DrillSetup setup;
    setup.tool = *drillBitOf("saw:10:1.5");
    DrillRun run(volume, setup);
    const double from = -0.5 * kBlock - 6.0, height = 0.5 * setup.tool.diameter - kDown;
    std::vector<DrillTick> ticks;
    for (int i = 0; i <= 1000; ++i)
      ticks.push_back(run.move({from + 1e-3 * kFeed * i, 0.03, height}, Vec3::UnitY(), 1e-3 * i));
    const double exact = kBlock * kDown * setup.tool.width;
    QVERIFY2(std::abs(run.removed() / exact - 1.0) < 0.02, qPrintable(QString::number(run.removed() / exact)));
    QVERIFY(run.energy() > 0.0);
    const VolumeSampler sampler(volume);
    QVERIFY(sampler.depthAt({0.0, 0.03, -1.0}).depth < 0.0 && sampler.depthAt({0.0, 1.0, -1.0}).depth > 0.0);
    QVERIFY(sampler.depthAt({0.0, 0.03, -2.3}).depth > 0.0);
    QVERIFY(isClosedManifold(surfaceOf(volume)));
    // The rim is above the block where it is foremost: nothing comes out. 1 mm deep in the block it does, by (3-24).
    QVERIFY(!run.breakthrough());
    SparseVolume other = plate(kBlock, 0.2);
    DrillRun within(other, setup);
    for (int i = 0; i <= 1000; ++i) within.move({from + 1e-3 * kFeed * i, 0.03, -1.0}, Vec3::UnitY(), 1e-3 * i);
    const double through = (0.5 * kBlock - 5.0 - from) / kFeed;
    QVERIFY(within.breakthrough());
    QVERIFY2(std::abs(*within.breakthrough() - through) < 0.015, qPrintable(QString::number(*within.breakthrough())));
    QCOMPARE(ticks.back().ahead, Vec3(Vec3::UnitX()));
  }

  // Force is linear in the radius and in the feed below 6 mm/s, torque quadratic in the radius and linear in the feed.
  void shapesOfTheCurves() {
    const auto steady = [](double diameter, double feed) {
      SparseVolume volume = plate(10.0, 0.3);
      DrillSetup setup;
      setup.tool.diameter = diameter;
      const Drilled drilled(volume, setup, 0.5 * diameter, -4.0 - 0.5 * diameter, feed);
      return drilled.mean((diameter + 1.0) / feed, (diameter + 3.0) / feed);
    };
    const DrillLoad usual = steady(4.0, 5.0), wide = steady(6.0, 5.0), slow = steady(4.0, 2.5);
    QVERIFY2(std::abs(wide.thrust / usual.thrust / 1.5 - 1.0) < 0.03,
             qPrintable(QString::number(wide.thrust / usual.thrust)));
    QVERIFY2(std::abs(wide.torque / usual.torque / 2.25 - 1.0) < 0.03,
             qPrintable(QString::number(wide.torque / usual.torque)));
    QVERIFY2(std::abs(slow.thrust / usual.thrust * 2.0 - 1.0) < 0.03,
             qPrintable(QString::number(slow.thrust / usual.thrust)));
    QVERIFY2(std::abs(slow.torque / usual.torque * 2.0 - 1.0) < 0.03,
             qPrintable(QString::number(slow.torque / usual.torque)));
  }

  // Build-up, steady, breakthrough, which is flagged in the cycle in which the front comes out.
  void threeStages() {
    SparseVolume volume = plate(8.0, 0.25);
    DrillSetup setup;
    setup.tool.diameter = 4.0;
    const Drilled drilled(volume, setup, 2.5, -12.0, 10.0);
    const double contact = 0.05, full = contact + 0.2, through = contact + 0.8;  // s
    QVERIFY(drilled.run.breakthrough());
    QVERIFY(std::abs(*drilled.run.breakthrough() - through) < 0.01);
    const double steady = drilled.mean(full + 0.05, through - 0.05).thrust;
    QVERIFY(drilled.mean(0.0, contact - 0.03).thrust == 0.0);
    QVERIFY(drilled.mean(contact, contact + 0.05).thrust < drilled.mean(contact + 0.1, contact + 0.15).thrust);
    QVERIFY(drilled.mean(full - 0.05, full).thrust < 1.02 * steady);
    QVERIFY(drilled.mean(through + 0.1, through + 0.15).thrust < 0.7 * steady);
    QVERIFY(drilled.mean(through + 0.25, through + 0.4).thrust < 0.01 * steady);
    // Thrust is along the axis, against the feed.
    for (const DrillTick& tick : drilled.ticks)
      if (tick.thrust > 0.5 * steady) QVERIFY(tick.force.z() > 0.98 * tick.thrust);
  }

  // A limited erosion takes as much in the end, later.
  void erosion() {
    const auto removed = [](double rate, double to) {
      SparseVolume volume = plate(8.0, 0.25);
      DrillSetup setup;
      setup.tool.diameter = 4.0;
      setup.erosion = rate;
      return Drilled(volume, setup, 2.5, to, 10.0).run.removed();
    };
    const double all = removed(std::numeric_limits<double>::infinity(), -3.0);
    QVERIFY(std::abs(removed(1.0, -3.0) / all - 1.0) < 0.01);  // proportional to the path
    QVERIFY(removed(0.5, -3.0) < 0.9 * all);
    QVERIFY(std::abs(removed(4.0, -12.0) / (M_PI * 4.0 * 8.0) - 1.0) < 0.01);
  }

  // The balance of A-6 and A-7: thrust times feed and torque times spindle are kp times the rate.
  void balance() {
    QVERIFY(rc::check([] {
      const auto number = [](double most) { return *rc::gen::inRange(1, 1001) / 1000.0 * most; };
      DrillBit tool;
      tool.diameter = number(20.0);
      DrillMaterial material = drillMaterials().front();
      material.energy = number(1000.0);
      material.tangential = number(3.0);
      const double removed = number(1.0), dt = number(0.01), feed = number(10.0), spindle = number(500.0);
      const DrillLoad load = drillLoad(material, tool, removed, dt, feed, spindle);
      const double power = load.thrust * feed + load.torque * spindle, rate = material.energy * removed / dt;
      RC_ASSERT(std::abs(power / rate - 1.0) < 1e-9);
      RC_ASSERT(std::abs(load.torque / (load.thrust * material.tangential * tool.radius()) - 1.0) < 1e-9);
    }));
  }

  // l = s f / (Δs q) is 0.255 mm at 1 mm/s and 1 kHz.
  void resolutionRule() {
    QVERIFY(std::abs(drillVoxel(1.0, 1000.0) - 0.255) < 1e-12);
    QVERIFY(std::abs(drillVoxel(2.0, 1000.0, 255.0, 2.0) - 0.255) < 1e-12);
  }

  // Forces are finite at rest, backwards, without a spindle, at 1 m/s, and at invalid positions.
  void extremes() {
    SparseVolume volume = plate(6.0, 0.25);
    DrillSetup setup;
    setup.tool.diameter = 2.0;
    DrillRun run(volume, setup);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    run.move({0.0, 0.0, 2.0}, Vec3::UnitZ(), 0.0);
    QVERIFY(run.move({0.0, 0.0, -2.0}, Vec3::UnitZ(), 0.004).thrust > 0.0);
    QCOMPARE(run.move({0.0, 0.0, -2.0}, Vec3::UnitZ(), 0.005).thrust, 0.0);  // at rest
    QCOMPARE(run.move({0.0, 0.0, 2.0}, Vec3::UnitZ(), 0.009).thrust, 0.0);   // out again
    QCOMPARE(run.move({nan, 0.0, 0.0}, Vec3::UnitZ(), 0.010).thrust, 0.0);
    QCOMPARE(run.move({0.0, 0.0, 1.0}, Vec3::UnitZ(), nan).thrust, 0.0);
    QCOMPARE(run.move({0.0, 0.0, -4.0}, Vec3::UnitZ(), 0.001).thrust, 0.0);  // time goes back
    QVERIFY(std::isfinite(run.move({1e300, 0.0, 0.0}, Vec3::UnitZ(), 1.0).thrust));
    setup.spindle = 0.0;
    DrillRun still(volume, setup);
    still.move({2.0, 0.0, 2.0}, Vec3::UnitZ(), 0.0);
    const DrillTick tick = still.move({2.0, 0.0, -3.0}, Vec3::UnitZ(), 1.0);
    QVERIFY(std::isfinite(tick.thrust) && tick.thrust > 0.0);
    SparseVolume nothing;
    QCOMPARE(DrillRun(nothing, setup).move(Vec3::Zero(), Vec3::UnitZ(), 1.0).thrust, 0.0);
  }

  void toolWords() {
    QCOMPARE(drillBitOf("ball:6")->diameter, 6.0);
    QVERIFY(drillBitOf("twist:2.5")->shape == DrillShape::Twist);
    QVERIFY(drillBitOf("burr:4")->shape == DrillShape::Burr);
    QVERIFY(drillBitOf("saw:20")->shape == DrillShape::Saw && drillBitOf("saw:20")->diameter == 20.0);
    QCOMPARE(drillBitOf("saw:20:0.8")->width, 0.8);
    for (const char* const word : {"ball:6", "twist:2.5", "burr:4", "saw:20:0.8"})
      QCOMPARE(wordOf(*drillBitOf(word)), std::string(word));
    for (const char* const bad : {"", "ball", "ball:", "ball:x", "ball:-1", "ball:1e9", "ball:nan", ":3", "chisel:3",
                                  "ball:3:1", "saw", "saw:20:", "saw:20:0", "saw:20:21", "saw:20:1:1", "saw:20:nan"})
      QVERIFY2(!drillBitOf(bad), bad);
    // 118° between the sides of the cone.
    const DrillBit tool = *drillBitOf("twist:2");
    QVERIFY(std::abs(std::atan(tool.radius() / tool.reach()) - 59.0 * M_PI / 180.0) < 1e-3);
  }

  // The built-in table has one of each shape; invalid tables are refused, with the drill and its problem.
  void tables() {
    std::vector<DrillShape> shapes;
    for (const DrillBitType& type : drillBits()) shapes.push_back(type.tool.shape);
    std::sort(shapes.begin(), shapes.end());
    QVERIFY((shapes == std::vector{DrillShape::Ball, DrillShape::Burr, DrillShape::Twist, DrillShape::Saw}));
    // With ' for ", which moc does not read in all raw strings.
    const auto with = [](std::string rows) {
      std::replace(rows.begin(), rows.end(), '\'', '"');
      return drillBitsFromJson("{\"tools\":[" + rows + "]}");
    };
    const std::string twist = "{'id':'t','shape':'twist','diameter':4,'point_angle':90,'length':40}";
    QVERIFY(with(twist).hasValue());
    QVERIFY(std::abs(with(twist)->front().tool.pointAngle - 0.5 * M_PI) < 1e-12);
    std::string many = twist;
    for (int i = 0; i < 101; ++i) many += ",{'id':'" + std::to_string(i) + "','shape':'ball','diameter':4}";
    for (const std::string& bad :
         {std::string(), many, twist + "," + twist, std::string("7"), std::string("{'id':'x'}"),
          std::string("{'id':'x','shape':'chisel','diameter':4}"), std::string("{'id':'','shape':'ball','diameter':4}"),
          std::string("{'id':'a:b','shape':'ball','diameter':4}"),
          std::string("{'id':'x','shape':'ball','diameter':1e300}"),
          std::string("{'id':'x','shape':'ball','diameter':'4'}"),
          std::string("{'id':'x','shape':'twist','diameter':4,'point_angle':0,'length':40}"),
          std::string("{'id':'x','shape':'twist','diameter':4,'point_angle':118,'length':1e9}"),
          std::string("{'id':'x','shape':'saw','diameter':4,'width':5}"),
          std::string("{'id':'x','shape':'saw','diameter':4}")})
      QVERIFY2(!with(bad), bad.c_str());
    const Error error = with("{'id':'flat','shape':'saw','diameter':4,'width':0}").error();
    QVERIFY(error.code == ErrorCode::ElementMalformed && error.arguments.at(1).find("flat") == 0);
    QVERIFY(!drillBitsFromJson("") && !drillBitsFromJson("[]"));
  }

  void materials() {
    QVERIFY(drillMaterial("cortical-bone"));
    QVERIFY(!drillMaterial("moon"));
    // 2 T / (d F) of the measured pairs.
    QVERIFY(std::abs(drillMaterial("cortical-bone")->tangential - 2.0 * 41.2 / (2.5 * 20.07)) < 0.01);
    QVERIFY(std::abs(drillMaterial("porcine-bone")->tangential - 2.0 * 37.0 / (2.5 * 11.25)) < 0.01);
    for (
        const char* const bad :
        {"", "{}", "[]", R"({"sources":{},"materials":[{"id":"x"}]})",
         R"({"sources":{"s":"t"},"materials":[{"id":"x","name":"x","energy":-1,"tangential":1,"source":"s","verified":false}]})"})
      QVERIFY2(!drillMaterialsFromJson(bad), bad);
  }
};

HANDWHEEL_TEST(DrillRunTest)
#include "DrillRunTest.moc"
