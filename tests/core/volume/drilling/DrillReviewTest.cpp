// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/drilling/DrillReview.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "volume/SurfaceToVolume.h"
#include "volume/drilling/DrillBits.h"

#include <QtTest>
#include <cmath>
#include <random>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kPlate = 5.0;  // mm thick, its top at z = 0

SparseVolume drilledPlate() {
  TriangleSoup plate = cube(1.0);
  for (Vec3& p : plate.points) p = Vec3(16.0 * (p.x() - 0.5), 16.0 * (p.y() - 0.5), kPlate * (p.z() - 1.0));
  return volumeOfSurface(plate, 0.25)->volume;
}

// Down at 2 mm/s until the tip is at `to`, this far beside the axis; 100 Hz. Then back to where it came from.
std::shared_ptr<const DrillRecord> hole(const char* tool, double to, double beside = 0.0, bool isTakenBack = true) {
  auto record = std::make_shared<DrillRecord>();
  record->setup.tool = *drillBitOf(tool);
  const double from = 2.0, speed = 2.0, rate = 100.0;
  const int count = static_cast<int>(std::lround((from - to) / speed * rate));
  for (int i = 0; i <= (isTakenBack ? 2 * count : count); ++i) {
    const double travel = speed / rate * std::min(i, 2 * count - i);
    const Vec3 position(beside, 0.0, from + record->setup.tool.reach() - travel);
    record->poses.push_back(DrillPose::of(position, Vec3::UnitZ(), i / rate));
  }
  return record;
}

DrillReview reviewOf(const std::vector<std::shared_ptr<const DrillRecord>>& holes, DrillPlan plan = {}) {
  return *reviewDrilling(drilledPlate(), plan, holes);
}

bool isNear(double value, double expected, double by) {
  if (std::abs(value - expected) <= by) return true;
  qWarning("%g is not within %g of %g", value, by, expected);
  return false;
}

}  // namespace

class DrillReviewTest : public QObject {
  Q_OBJECT

 private slots:
  // Contact, breakthrough and plunge are those of the path: from 2 mm above at 2 mm/s through 5 mm.
  void timesAndDepths_data() {
    QTest::addColumn<QString>("tool");
    for (const char* const tool : {"ball:4", "twist:4"}) QTest::addRow("%s", tool) << tool;
  }
  void timesAndDepths() {
    QFETCH(QString, tool);
    const DrillReview review = reviewOf({hole(tool.toLatin1().constData(), -7.5)});
    QVERIFY(review.figures.contact && review.figures.breakthrough);
    QVERIFY(isNear(*review.figures.contact, 1.0, 0.07));  // half a voxel
    QVERIFY(isNear(*review.figures.breakthrough, 3.5, 0.02));
    QVERIFY(isNear(review.figures.plunge, 2.5, 0.03));
    QVERIFY(isNear(review.figures.end, 9.5, 1e-6));
    QVERIFY(isNear(review.figures.deviation, 0.0, 1e-5));
    QCOMPARE(review.figures.forbidden, 0.0);
  }

  // Out of a blind hole nothing is broken through.
  void blindHole() {
    const DrillReview review = reviewOf({hole("ball:4", -3.0)});
    QVERIFY(review.figures.contact && !review.figures.breakthrough && !review.lastThrust);
    QCOMPARE(review.figures.plunge, 0.0);
  }

  // Full in the material, thrust and torque are those of the balance of energy at the section of the head; the mean
  // before a breakthrough of a twist drill is theirs, as its cone is in the plate until then.
  void loads() {
    const auto record = hole("twist:4", -7.5);
    const DrillReview review = reviewOf({record});
    const double section = M_PI * 4.0;
    const DrillLoad steady =
        drillLoad(record->setup.material, record->setup.tool, section * 2.0, 1.0, 2.0, record->setup.spindle);
    QVERIFY(isNear(*review.lastThrust, steady.thrust, 0.02 * steady.thrust));
    QVERIFY(isNear(review.figures.thrust, steady.thrust, 0.1 * steady.thrust));
    QVERIFY(isNear(review.figures.torque, steady.torque, 0.1 * steady.torque));
  }

  // Beside the plan by 0.7 mm, or tilted: then the tip is further away than the centre.
  // A steady load is shown as it is; one cycle of a millisecond counts as a fiftieth of what is shown for 50 ms.
  void loadsAreMeans() {
    DrillMonitor watch{DrillPlan()};
    watch.beginHole(DrillSetup());
    int i = 0;
    const auto add = [&](double thrust) {
      DrillTick tick{0.001 * i, Vec3(0.0, 0.0, -0.002 * i)};
      ++i;
      tick.thrust = thrust;
      tick.torque = Vec3(0.0, 0.0, -4.0 * thrust);
      return watch.add(tick, Vec3::UnitZ(), false);
    };
    for (int k = 0; k < 100; ++k) add(0.0);
    add(35.0);
    QVERIFY(isNear(watch.figures().thrust, 0.7, 1e-9) && isNear(watch.figures().torque, 2.8, 1e-9));
    for (int k = 0; k < 60; ++k) add(0.0);
    QCOMPARE(add(0.0).thrust, 0.0);
    for (int k = 0; k < 60; ++k) add(3.0);
    const DrillMoment steady = add(3.0);
    QVERIFY(isNear(steady.thrust, 3.0, 1e-9) && isNear(steady.torque, 12.0, 1e-9) && isNear(steady.feed, 2.0, 1e-9));
    QVERIFY(isNear(watch.figures().thrust, 3.0, 1e-9));
  }

  void deviation() {
    QVERIFY(isNear(reviewOf({hole("ball:4", -3.0, 0.7)}).figures.deviation, 0.7, 1e-5));
    DrillPlan tilted;
    tilted.direction = Vec3(std::sin(0.1), 0.0, -std::cos(0.1));
    // The tip of the straight hole is 3 mm below the entry at the end: 3 sin 0.1 beside the tilted line.
    QVERIFY(isNear(reviewOf({hole("ball:4", -3.0)}, tilted).figures.deviation, 3.0 * std::sin(0.1), 1e-3));
  }

  // The region is entered by what the tip is nearer to it than its surface; a head far from it is not in it.
  void forbiddenRegion_data() { timesAndDepths_data(); }
  void forbiddenRegion() {
    QFETCH(QString, tool);
    DrillPlan plan;
    plan.forbidden = {{{0.0, 0.0, -20.0}, 13.0}};  // its top at -7
    const auto deepest = [&](double to) {
      return reviewOf({hole(tool.toLatin1().constData(), to)}, plan).figures.forbidden;
    };
    QCOMPARE(deepest(-6.9), 0.0);
    QVERIFY(isNear(deepest(-8.24), 1.24, 1e-3));
  }

  // Two gestures are one work: times go on, and what the first left the second takes.
  void twoGestures() {
    const auto first = hole("ball:4", -3.0), second = hole("ball:4", -7.0);
    const DrillReview review = reviewOf({first, second});
    QVERIFY(isNear(*review.figures.breakthrough, 5.0 + 3.5, 0.02));
    const DrillReview whole = reviewOf({second});
    QVERIFY(isNear(countedMaterial(review.left), countedMaterial(whole.left), 1e-2));
  }

  // The estimate of heat follows its equation: under a steady load it rises towards share · P · time / (heat · V).
  void heat() {
    DrillSetup setup;
    setup.spindle = 100.0;
    DrillMonitor watch({});
    watch.beginHole(setup);
    double rise = 0.0;
    for (int i = 0; i <= 4000; ++i) {
      DrillTick tick;
      tick.time = 0.01 * i;
      tick.torque = Vec3(0.0, 0.0, 30.0);
      rise = watch.add(tick, Vec3::UnitZ(), false).temperature;
    }
    const double power = 3.0, layer = 2.0 * M_PI / 3.0 * (64.0 - 27.0);  // W, mm³
    QVERIFY(isNear(rise, 0.15 * power * 4.4 / (2.4e-3 * layer), 0.1));
    QCOMPARE(watch.figures().temperature, rise);
  }

  void cancelled() {
    JobState state;
    state.cancelled = true;
    const std::shared_ptr<const DrillRecord> holes[] = {hole("ball:4", -1.0)};
    QVERIFY(!reviewDrilling(drilledPlate(), {}, holes, Progress(state)).has_value());
  }

  // Invalid positions and times become ones that can be stored.
  void hostilePoses() {
    const double nan = std::nan("");
    QVERIFY(DrillPose::of(Vec3(nan, 1e30, -1e30), Vec3::UnitZ(), nan).micros == 0);
    QVERIFY(DrillPose::of(Vec3::Zero(), Vec3::UnitZ(), -1.0).micros == 0);
    QVERIFY(DrillPose::of(Vec3::Zero(), Vec3::UnitZ(), 1e12).micros == 9'000'000'000'000'000u);
    QVERIFY(!DrillPose::of(Vec3::Zero(), Vec3::Zero(), 0.0).isSound());
    QVERIFY(!DrillPose::of(Vec3::Zero(), Vec3(nan, 0.0, 1.0), 0.0).isSound());
    const Vec3 position(123.4567891, -987.654321, 0.000001);
    QVERIFY((DrillPose::of(position, Vec3::UnitX(), 0.0).position() - position).norm() < 1e-6);
  }

  // A hand trembles, sideways and along the drill: it is through when the tip is, and not when it slips on the surface.
  void trembling_data() {
    QTest::addColumn<double>("sideways");
    QTest::addColumn<double>("along");
    QTest::newRow("steady") << 0.0 << 0.0;
    QTest::newRow("sideways") << 0.05 << 0.0;
    QTest::newRow("along") << 0.0 << 0.02;
    QTest::newRow("both") << 0.05 << 0.02;
  }
  void trembling() {
    QFETCH(double, sideways);
    QFETCH(double, along);
    auto record = std::make_shared<DrillRecord>();
    record->setup.tool = *drillBitOf("ball:6");
    const double reach = record->setup.tool.reach();
    std::mt19937 random(7);
    std::normal_distribution<double> trembling;
    double time = 0.0;
    const auto add = [&](double tip, double beside) {
      const Vec3 position(beside + sideways * trembling(random), sideways * trembling(random),
                          tip + reach + along * trembling(random));
      record->poses.push_back(DrillPose::of(position, Vec3::UnitZ(), time));
      time += 1e-3;
    };
    // Over the surface, a little into it, and out of it again; then through the plate at 2 mm/s.
    for (int i = 0; i < 500; ++i) add(0.05 * std::cos(0.1 * i), 0.5 * std::sin(0.03 * i));
    const double begun = time;
    for (double tip = 0.1; tip > -kPlate - 0.5; tip -= 0.002) add(tip, 0.0);
    const DrillReview review = reviewOf({record});
    QVERIFY(review.figures.breakthrough);
    const double tip = 0.1 - 2.0 * (*review.figures.breakthrough - begun);
    QVERIFY(isNear(tip, -kPlate, 0.15));
    QVERIFY(isNear(review.figures.plunge, 0.5, 0.25));
  }

  // A nerve that is thinner than the drill and lies between its axis and its rim is drilled away, not missed.
  void forbiddenBesideTheAxis() {
    DrillPlan plan;
    plan.forbidden = {{Vec3(1.5, 0.0, -1.5), 1.0}};
    DrillReview review = reviewOf({hole("twist:6", -5.0)}, plan);
    QVERIFY(isNear(review.figures.forbidden, 1.0 + 1.5, 0.1));  // its centre ends 1.5 mm below the side of the drill
    plan.forbidden = {{Vec3(5.0, 0.0, -1.5), 1.0}};
    review = reviewOf({hole("twist:6", -5.0)}, plan);
    QCOMPARE(review.figures.forbidden, 0.0);
  }
};

HANDWHEEL_TEST(DrillReviewTest)
#include "DrillReviewTest.moc"
