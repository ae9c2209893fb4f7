// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SnapShapes.h"
#include "TestClass.h"
#include "haptics/snap/SnapProxy.h"

#include <rapidcheck.h>

#include <QtTest>
#include <set>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kSnapProxyStiffness = 0.7;  // N/mm
const SnapProfile kProfile(SnapShape::Triangular, kSnapProxyStiffness, 1.0);

// A hand and its held feature.
struct Play {
  SnapField field;
  SnapProxy proxy = {};

  // Returns the number of the held feature; kNone if there is none.
  std::uint32_t at(const Vec3& hand) {
    const SnapResult pull = proxy.step(field, kProfile, hand);
    return pull.featureCount ? pull.features[0].id : kNone;
  }
};

}  // namespace

class SnapProxyTest : public QObject {
  Q_OBJECT

 private slots:
  void forceByTheEquations();
  void continuousAcrossOneFeature();
  void keptUntilOutOfReach();
  void closestToTheProxyWins();
  void aLineThenItsEnd();
  void aFaceThenItsEdgeThenItsCorner();
  void aLowerOneFarFromTheProxyIsNotTaken();
  void slidesOverAFan();
  void longLinesAreKept();
  void crossingLinesAreChosenByTheHand();
  void equalFeaturesAreHeldByNumber();
  void survivesAnEdit();
  void nothingForNothing();
  void sameFarFromTheOrigin();
};

void SnapProxyTest::forceByTheEquations() {
  QVERIFY(rc::check([] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    auto simplices = randomSimplices(random, 1, 1.0, 2.0);
    const SnapField field = fieldOf(simplices);
    const Vec3 hand = randomIn(random, 2.0);
    for (const SnapShape shape : kSnapShapes) {
      const SnapProfile profile(shape, kSnapProxyStiffness, 2.0);
      SnapProxy proxy;
      const SnapResult pull = proxy.step(field, profile, hand);
      RC_ASSERT((pull.force - sumOf(simplices, shape, kSnapProxyStiffness, 2.0, hand)).norm() <= 1e-8 * profile.peak());
      const auto x = static_cast<double>(distanceTo(simplices[0], hand));
      RC_ASSERT(proxy.isHeld() == (x <= 2.0));
      RC_ASSERT(std::abs((pull.proxy - hand).norm() - (x <= 2.0 ? x : 0.0)) <= 1e-12);
      RC_ASSERT(pull.slope == (x <= 2.0 ? profile.largestSlope() : 0.0));
    }
  }));
}

void SnapProxyTest::continuousAcrossOneFeature() {
  const Vec3 a(0, 0, 0), b(3, 1, 0), c(0, 2, 1);
  for (const Simplex& s : {point(a), segment(a, b), face(a, b, c)})
    for (const SnapShape shape : kSnapShapes) {
      const SnapProfile profile(shape, kSnapProxyStiffness, 1.5);
      const SnapField field = fieldOf({s});
      SnapProxy proxy;
      const Vec3 from(-2, -1.9, -2.1), to(2.2, 2.0, 2.3);
      const int steps = 50'000;
      double largest = 0.0;
      Vec3 before = proxy.step(field, profile, from).force;
      for (int i = 1; i <= steps; ++i) {
        const Vec3 now = proxy.step(field, profile, from + (to - from) * (static_cast<double>(i) / steps)).force;
        largest = std::max(largest, (now - before).norm());
        before = now;
      }
      const double step = (to - from).norm() / steps;
      if (shape == SnapShape::Spring)
        QVERIFY(std::abs(largest - kSnapProxyStiffness * 1.5) <= kSnapProxyStiffness * step);  // the leap
      else
        QVERIFY(largest <= slopeByEquation(shape) * kSnapProxyStiffness * step * (1.0 + 1e-9));
    }
}

// Rule 1.
void SnapProxyTest::keptUntilOutOfReach() {
  Play play{fieldOf({point(Vec3(0, 0, 0)), point(Vec3(3, 0, 0))})};
  QCOMPARE(play.at(Vec3(1.5, 0, 0)), kNone);
  QCOMPARE(play.at(Vec3(0.9, 0, 0)), 0u);
  QCOMPARE(play.at(Vec3(1.0, 0, 0)), 0u);
  QCOMPARE(play.at(Vec3(1.001, 0, 0)), kNone);
  QVERIFY(!play.proxy.isHeld());
  QCOMPARE(play.at(Vec3(2.001, 0, 0)), 1u);
}

// Rule 3: fields that overlap do not hand over before the hand leaves the first.
void SnapProxyTest::closestToTheProxyWins() {
  Play play{fieldOf({point(Vec3(0, 0, 0)), point(Vec3(0.5, 0, 0)), point(Vec3(1.4, 0, 0))})};
  QCOMPARE(play.at(Vec3(-0.1, 0, 0)), 0u);
  QCOMPARE(play.at(Vec3(0.45, 0, 0)), 0u);
  QCOMPARE(play.at(Vec3(0.99, 0, 0)), 0u);
  // Outside the first's reach, the second is nearest to the proxy, the third to the hand.
  QCOMPARE(play.at(Vec3(1.1, 0, 0)), 1u);
  QCOMPARE(play.at(Vec3(1.6, 0, 0)), 2u);
  play.proxy.release();
  QCOMPARE(play.at(Vec3(0.3, 0, 0)), 1u);  // nothing held: the hand decides
}

// Rule 2.
void SnapProxyTest::aLineThenItsEnd() {
  Play play{fieldOf({segment(Vec3(0, 0, 0), Vec3(10, 0, 0)), point(Vec3(10, 0, 0))})};
  QCOMPARE(play.at(Vec3(5, 0.5, 0)), 0u);
  QCOMPARE(play.at(Vec3(8.9, 0.5, 0)), 0u);
  QCOMPARE(play.at(Vec3(9.05, 0.9, 0)), 0u);  // the proxy is within reach of the end, the hand is not
  QCOMPARE(play.at(Vec3(9.3, 0.5, 0)), 1u);
  QCOMPARE(play.proxy.step(play.field, kProfile, Vec3(9.3, 0.5, 0)).proxy, Vec3(10, 0, 0));
  QCOMPARE(play.at(Vec3(9.01, 0, 0)), 1u);  // kept, although the line is nearer
  QCOMPARE(play.at(Vec3(8.95, 0, 0)), 0u);
}

void SnapProxyTest::aFaceThenItsEdgeThenItsCorner() {
  const Vec3 a(0, 0, 0), b(20, 0, 0), c(0, 20, 0);
  Play play{fieldOf({face(a, b, c), segment(a, b), point(a)})};
  QCOMPARE(play.at(Vec3(5, 5, 0.5)), 0u);
  QCOMPARE(play.at(Vec3(5, 1.1, 0.5)), 0u);
  QCOMPARE(play.at(Vec3(5, 0.6, 0.5)), 1u);
  QCOMPARE(play.at(Vec3(0.6, 0.6, 0.3)), 2u);
  QCOMPARE(play.at(Vec3(1.2, 0.6, 0.3)), 1u);  // off the corner: the face again, and from there its edge
  QCOMPARE(play.at(Vec3(2, 2, 0.3)), 0u);
}

// The hand is in reach of a point that lies on the other side of it than the line.
void SnapProxyTest::aLowerOneFarFromTheProxyIsNotTaken() {
  Play play{fieldOf({segment(Vec3(-10, 0, 0), Vec3(10, 0, 0)), point(Vec3(0, 1.2, 0))})};
  QCOMPARE(play.at(Vec3(0, 0.5, 0)), 0u);
  QCOMPARE(play.at(Vec3(0, 0.9, 0)), 0u);
  QCOMPARE(play.at(Vec3(0, 1.1, 0)), 1u);  // out of the line's reach
  QCOMPARE(play.at(Vec3(0, 0.5, 0)), 1u);
}

// Over a fan of triangles the proxy is the foot of the hand on all of them, the force that of a plane: continuous.
void SnapProxyTest::slidesOverAFan() {
  std::vector<Simplex> fan;
  for (int i = 0; i < 12; ++i) {
    const double from = M_PI / 6.0 * i, to = M_PI / 6.0 * (i + 1);
    fan.push_back(
        face(Vec3::Zero(), 9.0 * Vec3(std::cos(from), std::sin(from), 0), 9.0 * Vec3(std::cos(to), std::sin(to), 0)));
  }
  Play play{fieldOf(fan)};
  std::set<std::uint32_t> held;
  for (int i = 0; i < 5000; ++i) {
    const double angle = 0.003 * i, radius = 4.0 * std::cos(0.0017 * i);
    const Vec3 foot(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    const SnapResult pull = play.proxy.step(play.field, kProfile, foot + Vec3(0, 0, 0.4));
    QVERIFY((pull.proxy - foot).norm() <= 1e-9);
    QVERIFY((pull.force - Vec3(0, 0, -0.4 * kSnapProxyStiffness)).norm() <= 1e-9);
    held.insert(pull.features[0].id);
  }
  QCOMPARE(held.size(), fan.size());
}

// A line 40 m long, whose nearest points are rounded by more than their distance: kept although a face is in reach, and
// left for another line at a crossing.
void SnapProxyTest::longLinesAreKept() {
  const Vec3 along = Vec3(1.0, 0.7, 0.3).normalized(), up = along.unitOrthogonal(), aside = along.cross(up);
  const double far = 2e4;
  const SnapField field =
      fieldOf({segment(-far * along, far * along), segment(-far * aside, far * aside),
               face(-9.0 * along - 9.0 * aside - 1.5 * up, 9.0 * along - 1.5 * up, 9.0 * aside - 1.5 * up)});
  SnapProxy proxy;
  const auto heldAt = [&](double x, double y, double z) {
    proxy.step(field, kProfile, x * along + y * aside + z * up);
    return proxy.isHeld() ? proxy.held().id : kNone;
  };
  for (int i = 0; i < 1000; ++i) {
    const double x = -7.0 + 0.003 * i;
    QCOMPARE(heldAt(x, 0.0, 0.3), 0u);
    QCOMPARE(heldAt(x, 0.1, -0.8), 0u);  // the face is nearer to the hand
  }
  QCOMPARE(heldAt(0.0, 0.5, 0.3), 1u);
}

void SnapProxyTest::crossingLinesAreChosenByTheHand() {
  const std::vector<Simplex> cross{segment(Vec3(-10, 0, 0), Vec3(10, 0, 0)), segment(Vec3(0, -10, 0), Vec3(0, 10, 0))};
  Play play{fieldOf(cross)};
  QCOMPARE(play.at(Vec3(-3, 0.2, 0)), 0u);
  QCOMPARE(play.at(Vec3(-0.5, 0.4, 0)), 0u);  // the other line is not closer to the proxy
  QCOMPARE(play.at(Vec3(0, 0.5, 0)), 1u);     // at the crossing both are, and the hand is on the other
  QCOMPARE(play.at(Vec3(0.1, 3, 0)), 1u);
}

void SnapProxyTest::equalFeaturesAreHeldByNumber() {
  const Vec3 a(0, 0, 0), b(3, 1, 0), c(0, 2, 1);
  Play faces{fieldOf({face(a, b, c), face(b, c, a), face(c, b, a)})};
  QCOMPARE(faces.at(Vec3(1, 1, 1)), 0u);
  Play points{fieldOf({point(b), point(a), point(a)})};
  QCOMPARE(points.at(Vec3(0.1, 0, 0)), 1u);
}

// The scene is exchanged under the hand.
void SnapProxyTest::survivesAnEdit() {
  Play play{fieldOf({point(Vec3(5, 5, 5)), point(Vec3(0, 0, 0)), point(Vec3(0.5, 0, 0))})};
  QCOMPARE(play.at(Vec3(0.1, 0, 0)), 1u);
  play.field = fieldOf({point(Vec3(0.7, 0, 0)), point(Vec3(0, 0, 0))});
  QCOMPARE(play.at(Vec3(0.6, 0, 0)), 1u);  // held before: still at its position
  play.field = fieldOf({point(Vec3(0.7, 0, 0))});
  QCOMPARE(play.at(Vec3(0.6, 0, 0)), 0u);
  play.field = SnapField();
  QCOMPARE(play.at(Vec3(0.6, 0, 0)), kNone);
  QVERIFY(!play.proxy.isHeld());
}

void SnapProxyTest::nothingForNothing() {
  using Limits = std::numeric_limits<double>;
  SnapProxy proxy;
  const SnapField field = fieldOf({point(Vec3(1, 1, 1))});
  QCOMPARE(proxy.step(SnapField(), kProfile, Vec3(1, 2, 3)).force, Vec3(0, 0, 0));
  QCOMPARE(proxy.step(field, SnapProfile(), Vec3(1, 1, 1.5)).force, Vec3(0, 0, 0));
  QVERIFY(!proxy.isHeld());
  QCOMPARE(proxy.step(field, kProfile, Vec3(1, 1, 1)).force, Vec3(0, 0, 0));
  QVERIFY(proxy.isHeld());
  for (const double bad : {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity()}) {
    QCOMPARE(proxy.step(field, kProfile, Vec3(1, bad, 1)).force, Vec3(0, 0, 0));
    QVERIFY(proxy.isHeld());
  }
  for (const double far : {Limits::max(), 1e200, -1e100}) {
    QCOMPARE(proxy.step(field, kProfile, Vec3(1, far, 1)).force, Vec3(0, 0, 0));
    QVERIFY(!proxy.isHeld());
  }
}

// The rules of an edge and its ends, a thousandth as large and ten thousand times, and far out.
void SnapProxyTest::sameFarFromTheOrigin() {
  for (const double scale : {1e-3, 1.0, 1e4})
    for (const double offset : {0.0, 1e7}) {
      const auto at = [&](double x, double y) { return Vec3(offset + scale * x, scale * y - offset, offset); };
      const SnapField field = fieldOf({segment(at(0, 0), at(10, 0)), segment(at(10, 0), at(10, 10)), point(at(0, 0))});
      const SnapProfile profile(SnapShape::Triangular, kSnapProxyStiffness, scale);
      SnapProxy proxy;
      const auto heldAt = [&](double x, double y) {
        proxy.step(field, profile, at(x, y));
        return proxy.isHeld() ? proxy.held().id : kNone;
      };
      QCOMPARE(heldAt(5.0, 0.4), 0u);
      QCOMPARE(heldAt(9.7, 0.4), 0u);
      QCOMPARE(heldAt(10.1, 0.6), 1u);  // round the corner, by the tie there
      QCOMPARE(heldAt(10.1, 5.0), 1u);
      QCOMPARE(heldAt(20.0, 5.0), kNone);
      QCOMPARE(heldAt(1.0, 0.5), 0u);
      QCOMPARE(heldAt(0.6, 0.5), 2u);
    }
}

HANDWHEEL_TEST(SnapProxyTest)
#include "SnapProxyTest.moc"
