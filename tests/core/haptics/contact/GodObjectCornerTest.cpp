// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The god-object at corners of many planes, and its memory from tick to tick.
#include "haptics/contact/GodObject.h"

#include "ExactGodObject.h"
#include "MeshShapes.h"
#include "TestClass.h"

#include <QtTest>
#include <numbers>
#include <random>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// Returns triangles around a point whose neighbours rise and fall arbitrarily; the rim is far away.
TriangleSoup fanOf(double steepness, std::mt19937& random) {
  std::uniform_real_distribution<double> rise(-steepness, steepness), apart(0.5, 1.5);
  const int spokes = std::uniform_int_distribution<int>(3, 9)(random);
  std::vector<double> angles(static_cast<std::size_t>(spokes) + 1, 0.0);
  for (std::size_t i = 1; i < angles.size(); ++i) angles[i] = angles[i - 1] + apart(random);
  TriangleSoup fan;
  fan.points.push_back(Vec3::Zero());
  for (int i = 0; i < spokes; ++i) {
    const double angle = 2 * std::numbers::pi * angles[static_cast<std::size_t>(i)] / angles.back();
    fan.points.push_back(100.0 * Vec3(std::cos(angle), std::sin(angle), rise(random)));
  }
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(spokes); ++i)
    fan.triangles.push_back({0, 1 + i, 1 + (i + 1) % static_cast<std::uint32_t>(spokes)});
  return fan;
}

// Returns a path under the fan, around its middle and through it.
std::vector<Vec3> walkUnder(std::mt19937& random) {
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  std::vector<Vec3> path;
  Vec3 at(number(random), number(random), 0.0);
  for (int leg = 0; leg < 8; ++leg) {
    const Vec3 next(number(random), number(random), 0.0);
    const int steps = static_cast<int>((next - at).norm() / 0.05) + 1;
    for (int i = 0; i < steps; ++i) path.push_back(at + (next - at) * (double(i) / steps) + Vec3(0, 0, -2.5));
    at = next;
  }
  return path;
}

}  // namespace

class GodObjectCornerTest : public QObject {
  Q_OBJECT

 private slots:
  // A walk downhill over the triangles themselves would stay where the proxy comes to rest. Among spikes, whose skins
  // close every crack between steep walls, it may be held once in many corners.
  void restsWhereTheExactOneWould_data() {
    QTest::addColumn<double>("steepness");
    QTest::addColumn<double>("mostHeld");  // share of the ticks
    QTest::newRow("nearly flat") << 0.1 << 0.0;
    QTest::newRow("slopes of 40 degrees") << 0.8 << 1e-4;
    QTest::newRow("spikes") << 2.0 << 1e-3;
  }
  void restsWhereTheExactOneWould() {
    QFETCH(double, steepness);
    QFETCH(double, mostHeld);
    std::mt19937 random(3);
    int compared = 0, atCorner = 0, held = 0;
    for (int round = 0; round < 1000; ++round) {
      const TriangleSoup fan = fanOf(steepness, random);
      const ContactSurface surface(fan.points, fan.triangles);
      ExactGodObject exact(fan);
      GodObject god;
      god.place({0, 0, 100});
      for (const Vec3& tip : walkUnder(random)) {
        const Contact& contact = god.follow(surface, tip, {});
        if (!contact.touching) continue;
        ++compared;
        atCorner += contact.proxy.norm() < 1e-4 ? 1 : 0;
        exact.place(contact.proxy);
        held += contact.depth - (exact.follow(tip) - tip).norm() > 1e-4 ? 1 : 0;
      }
    }
    qInfo("%d of %d ticks at the corner, %d held there", atCorner, compared, held);
    QVERIFY(compared > 50'000 && atCorner > 300);
    QVERIFY(held <= mostHeld * compared);
  }

  // Met obliquely at the edge of a hole, the proxy is beside the triangle; pulled straight down, it falls.
  void fallsBesideAnEdge() {
    TriangleSoup floor;  // for x <= 0
    floor.points = {{0, -50, 0}, {0, 50, 0}, {-100, -50, 0}, {-100, 50, 0}};
    floor.triangles = {{0, 1, 2}, {3, 2, 1}};
    const ContactSurface surface(floor.points, floor.triangles);
    const ContactOptions rough{.friction = 10.0};
    GodObject god;
    god.place({1, 0, 0.5});
    god.follow(surface, Vec3(-1e-9, 0, 0) - 0.5 * Vec3(1, 0, 0.5), rough);  // held at its arrival
    const Vec3 held = god.contact().proxy;
    QVERIFY(god.contact().touching && held.x() > 0.0);
    QVERIFY(!god.follow(surface, held - Vec3(0, 0, 1), rough).touching);
  }

  // The round ends of turned parts: hundreds of slivers around one point, whose boxes all meet.
  void slidesOverFansOfSlivers_data() {
    QTest::addColumn<double>("slope");
    QTest::newRow("a flat cap") << 0.0;
    QTest::newRow("a countersink of 90 degrees") << 1.0;
    QTest::newRow("a cone") << -1.0;
  }
  void slidesOverFansOfSlivers() {
    QFETCH(double, slope);
    constexpr int kSlivers = 1000;
    constexpr double kRadius = 10.0;  // mm
    TriangleSoup fan;
    fan.points.push_back(Vec3::Zero());
    for (std::uint32_t i = 0; i < kSlivers; ++i) {
      const double angle = 2 * std::numbers::pi * i / kSlivers;
      fan.points.push_back(kRadius * Vec3(std::cos(angle), std::sin(angle), slope));
      fan.triangles.push_back({0, 1 + i, 1 + (i + 1) % kSlivers});
    }
    const ContactSurface surface(fan.points, fan.triangles);
    GodObject god;
    god.place({-6, 0.3, 20});
    int late = 0;
    for (int i = 0; i <= 600; ++i) {
      const double x = -6 + 0.02 * i, depth = 0.2;
      const Vec3 tip(x, 0.3, slope * std::hypot(x, 0.3) - depth);
      const Contact& contact = god.follow(surface, tip, {});
      // It is never farther than the point of the surface above the tip.
      late += !contact.touching || contact.depth > 1.01 * depth ? 1 : 0;
    }
    QVERIFY2(late == 0, qPrintable(QString::number(late)));
  }

  // The cache of earlier ticks is used only where a look-up would find the same: a surface that calls itself changed is
  // looked up anew in each tick. If a step ends at the side of the cached region, it may continue on another path.
  void findsWhatItRemembers() {
    const TriangleSoup ball = bumpySphere(5);
    const ContactSurface surface(ball.points, ball.triangles);
    ContactSurface restless = surface;
    std::mt19937 random(9);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    GodObject remembers, forgets;
    remembers.place({2, 0, 0});
    forgets.place({2, 0, 0});
    Vec3 tip(2, 0, 0), drift(0, 0, 0);
    int touched = 0, apart = 0;
    for (int i = 0; i < 100'000; ++i) {
      drift =
          0.9 * drift + 5e-4 * std::pow(10.0, (i / 500) % 3 - 1) * Vec3(number(random), number(random), number(random));
      tip += drift;
      if (tip.norm() > 1.3 || tip.norm() < 0.6) tip = 0.95 * tip.normalized();
      restless.update({}, {});
      const Contact& a = remembers.follow(surface, tip, {});
      const Contact& b = forgets.follow(restless, tip, {});
      QCOMPARE(a.touching, b.touching);
      touched += a.touching ? 1 : 0;
      if ((a.proxy - b.proxy).norm() < 1e-5) continue;
      ++apart;
      forgets = remembers;
    }
    qInfo("%d of %d ticks apart", apart, touched);
    QVERIFY(touched > 10'000 && apart <= 1e-3 * touched);
  }
};

HANDWHEEL_TEST(GodObjectCornerTest)
#include "GodObjectCornerTest.moc"
