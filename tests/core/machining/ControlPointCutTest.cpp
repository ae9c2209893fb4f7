// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/ControlPointCut.h"

#include "TestClass.h"
#include "machining/TurningPass.h"

#include <rapidcheck.h>

#include <QtTest>
#include <cmath>
#include <limits>

using namespace handwheel;

namespace {

constexpr StockCylinder kCurveShaft{40.0, 100.0, 0.0};

double anyOf(double low, double high) {
  return low + (high - low) * *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 1'000'001)) / 1e6;
}

// N(i, 2) at u over uniform clamped knots by the textbook's recursion (Piegl and Tiller, eq. 2.5).
double cardinal(int i, int degree, double u, int spans) {
  const auto knot = [spans](int j) { return std::clamp(j - 2.0, 0.0, static_cast<double>(spans)); };
  if (degree == 0) {
    const bool isLast = u == spans && knot(i + 1) == spans && knot(i) < spans;
    return (u >= knot(i) && u < knot(i + 1)) || isLast ? 1.0 : 0.0;
  }
  double sum = 0.0;
  if (knot(i + degree) > knot(i))
    sum += (u - knot(i)) / (knot(i + degree) - knot(i)) * cardinal(i, degree - 1, u, spans);
  if (knot(i + degree + 1) > knot(i + 1))
    sum += (knot(i + degree + 1) - u) / (knot(i + degree + 1) - knot(i + 1)) * cardinal(i + 1, degree - 1, u, spans);
  return sum;
}

double largestDistance(const TurnedProfile& a, const TurnedProfile& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, std::abs(a.radius(i) - b.radius(i)));
    largest = std::max(largest, std::abs(a.inner(i) - b.inner(i)));
  }
  return largest;
}

}  // namespace

class ControlPointCutTest : public QObject {
  Q_OBJECT

 private slots:
  // One plunge of a small nose moves one pole: eq. 5-9 by its definition.
  void onePoleMoves_data() {
    QTest::addColumn<double>("z");
    for (const double z : {0.0, 0.3, 1.0, 2.4, 37.1, 50.0, 99.9, 100.0}) QTest::addRow("%g", z) << z;
  }
  void onePoleMoves() {
    QFETCH(double, z);
    constexpr double kResolution = 2.0, kNoseRadius = 0.011, kDepth = 0.5;
    constexpr int kSpans = 50;
    TurnedProfile part(kCurveShaft, 0.02);
    const auto at = static_cast<std::size_t>(std::lround(z / part.spacing()));
    const ProfilePoint nose(20.0 - kDepth + kNoseRadius, part.z(at));
    ControlPointCut(part, kResolution).cut(part, TurningSide::Outside, nose, nose, kNoseRadius);
    const double u = part.z(at) / kResolution;
    int strongest = 0;
    for (int k = 1; k < kSpans + 2; ++k) {
      if (cardinal(k, 2, u, kSpans) > cardinal(strongest, 2, u, kSpans) + 1e-12) strongest = k;
    }
    const double by = kDepth / cardinal(strongest, 2, u, kSpans);
    for (std::size_t i = 0; i < part.size(); ++i) {
      const double expected = 20.0 - by * cardinal(strongest, 2, part.z(i) / kResolution, kSpans);
      QVERIFY2(std::abs(part.radius(i) - expected) < 1e-9, qPrintable(QString::number(part.z(i))));
    }
    QVERIFY(std::abs(part.radius(at) - (20.0 - kDepth)) < 1e-9);
  }

  // A pass without parts, as older programs cut it: each control point moves by the whole depth that is left, wherever
  // that is deepest. By the definition, with a nose that is nearly three spans deep. No sample is at a knot, where two
  // control points would be equally strong.
  void aPassWithoutPartsTakesTheWholeDepth() {
    constexpr double kNose = 4.0, kAt = 37.13, kResolution = 0.7;
    constexpr int kSpans = 143, kMoves = 15;  // number of poles in 8 mm, and 3 beyond
    TurningPass pass;
    pass.noseRadius = kNose;
    pass.method = TurningMethod::Poles;
    pass.resolution = kResolution;
    pass.path = {{22.0, kAt}};
    pass.times = {0.0};
    TurnedProfile inParts(kCurveShaft, 0.1), whole = inParts;
    std::vector<double> expected(whole.size(), 20.0);
    const auto basis = [&](int pole, std::size_t i) { return cardinal(pole, 2, whole.z(i) * kSpans / 100.0, kSpans); };
    for (int move = 0; move < kMoves; ++move) {
      std::size_t deepest = 0;
      double depth = 0.0;
      for (std::size_t i = 0; i < whole.size(); ++i) {
        const double along = whole.z(i) - kAt;
        if (std::abs(along) > kNose) continue;
        const double left = expected[i] - (22.0 - std::sqrt(kNose * kNose - along * along));
        if (left > depth) deepest = i, depth = left;
      }
      if (!(depth > 1e-12)) break;
      int strongest = 0;
      for (int k = 1; k < kSpans + 2; ++k)
        if (basis(k, deepest) > basis(strongest, deepest)) strongest = k;
      const double by = depth / basis(strongest, deepest);
      for (std::size_t i = 0; i < whole.size(); ++i) expected[i] -= by * basis(strongest, i);
    }
    cut(inParts, pass);
    pass.isInParts = false;
    cut(whole, pass);
    for (std::size_t i = 0; i < whole.size(); ++i) QVERIFY(std::abs(whole.radius(i) - expected[i]) < 1e-9);
    QVERIFY(largestDistance(inParts, whole) > 0.1);
  }

  // Parts are few, or of few moves, if a hand moves by a hundredth of a millimetre at a time: a review may repeat about
  // as long a pass as without them.
  void partsCostLittle() {
    const TurnedProfile part(kCurveShaft, 0.01);
    TurningPass pass;
    pass.noseRadius = 4.0;
    pass.method = TurningMethod::Poles;
    for (int i = 0; i < 2000; ++i) {
      pass.path.emplace_back(22.0, 90.0 - 0.02 * i);
      pass.times.push_back(0.002 * i);
    }
    for (const double resolution : {2.0, 0.5, 0.12}) {
      pass.resolution = resolution;
      pass.isInParts = true;
      const auto inParts = static_cast<double>(samplesUnder(part, pass));
      pass.isInParts = false;
      const auto whole = static_cast<double>(samplesUnder(part, pass));
      QVERIFY2(inParts >= whole && inParts < 1.5 * whole, qPrintable(QString::number(inParts / whole)));
    }
  }

  void materialOnlyLeavesAndNothingFolds() {
    QVERIFY(rc::check("radii of both sides only go apart from the material", [] {
      TurnedProfile part(kCurveShaft, 1.0);
      const ControlPointCut poles(part, anyOf(0.5, 20.0));
      for (int step = 0; step < 12; ++step) {
        const TurnedProfile before = part;
        const ProfilePoint a(anyOf(-5.0, 40.0), anyOf(-10.0, 110.0)), b(anyOf(-5.0, 40.0), anyOf(-10.0, 110.0));
        const TurningSide side = *rc::gen::inRange(0, 2) ? TurningSide::Bore : TurningSide::Outside;
        const TurnedProfile::Range changed = poles.cut(part, side, a, b, anyOf(0.2, 5.0));
        for (std::size_t i = 0; i < part.size(); ++i) {
          RC_ASSERT(part.radius(i) <= before.radius(i) && part.inner(i) >= before.inner(i));
          RC_ASSERT(part.inner(i) >= 0.0 && part.inner(i) <= part.radius(i));
          const bool isIn = i >= changed.first && i < changed.last;
          RC_ASSERT(isIn || (part.radius(i) == before.radius(i) && part.inner(i) == before.inner(i)));
        }
      }
    }));
  }

  // A long taper, which degree 2 reproduces exactly: the finer the control points, the nearer to the sweep of the nose.
  void finerIsNearer() {
    TurnedProfile exact(kCurveShaft, 0.02);
    const ProfilePoint from(25.0, 10.0), to(18.0, 80.0);
    exact.cut(from, to, 4.0);
    double last = std::numeric_limits<double>::infinity();
    for (const double resolution : {4.0, 1.0, 0.25}) {
      TurnedProfile part(kCurveShaft, 0.02);
      ControlPointCut(part, resolution).cut(part, TurningSide::Outside, from, to, 4.0);
      double largest = 0.0;
      for (std::size_t i = 0; i < part.size(); ++i) {
        if (part.z(i) > 40.0 && part.z(i) < 75.0)
          largest = std::max(largest, std::abs(part.radius(i) - exact.radius(i)));
      }
      QVERIFY2(largest < 0.6 * last, qPrintable(QString::number(largest)));
      last = largest;
    }
    QVERIFY2(last < 0.05, qPrintable(QString::number(last)));
  }

  // A pass that begins 2 mm deep with a nose of 4 mm leaves a cylinder of 18 mm between two arcs of the nose. Wherever
  // one looks, the ends too, the error is less than the distance of the control points, and so goes to zero with it.
  void aPassThatBeginsInTheMaterial() {
    const ProfilePoint from(22.0, 30.0), to(22.0, 38.0);
    for (const double resolution : {2.0, 1.0, 0.5, 0.25, 0.125}) {
      TurnedProfile part(kCurveShaft, 0.02);
      ControlPointCut(part, resolution).cut(part, TurningSide::Outside, from, to, 4.0);
      double largest = 0.0;
      for (std::size_t i = 0; i < part.size(); ++i) {
        const double beyond = std::max({from.y() - part.z(i), part.z(i) - to.y(), 0.0});
        const double nose = beyond < 4.0 ? 22.0 - std::sqrt(16.0 - beyond * beyond) : 20.0;
        largest = std::max(largest, std::abs(part.radius(i) - std::min(20.0, nose)));
      }
      QVERIFY2(largest < resolution, qPrintable(QStringLiteral("%1: %2").arg(resolution).arg(largest)));
    }
  }

  // In a bore the mirror image of the outside.
  void boresAsItTurns() {
    TurnedProfile outside(kCurveShaft, 0.1), tube(kCurveShaft, 0.1);
    for (std::size_t i = 0; i < tube.size(); ++i) tube.limitInner(i, 10.0);
    ControlPointCut(outside, 1.0).cut(outside, TurningSide::Outside, {20.0, 30.0}, {19.0, 60.0}, 2.0);
    ControlPointCut(tube, 1.0).cut(tube, TurningSide::Bore, {10.0, 30.0}, {11.0, 60.0}, 2.0);
    for (std::size_t i = 0; i < tube.size(); ++i) {
      QVERIFY(std::abs((20.0 - outside.radius(i)) - (tube.inner(i) - 10.0)) < 1e-9);
      QCOMPARE(tube.radius(i), 20.0);
    }
  }

  void nothingAndNoNumber() {
    TurnedProfile part(kCurveShaft, 1.0);
    const TurnedProfile before = part;
    const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
    const ControlPointCut poles(part, nan);
    for (const double bad : {nan, inf, -inf}) {
      QVERIFY(poles.cut(part, TurningSide::Outside, {bad, 50}, {10, 50}, 1.0).isEmpty());
      QVERIFY(poles.cut(part, TurningSide::Bore, {10, 50}, {10, bad}, 1.0).isEmpty());
    }
    QVERIFY(poles.cut(part, TurningSide::Outside, {10, 50}, {10, 60}, 0.0).isEmpty());
    QVERIFY(poles.cut(part, TurningSide::Outside, {21.0, 50}, {21.0, 60}, 1.0).isEmpty());  // touches, and no deeper
    QVERIFY(part == before);
    QVERIFY(!poles.cut(part, TurningSide::Outside, {21.0 - 1e-8, 50}, {21.0 - 1e-8, 50}, 1.0).isEmpty());
    QVERIFY(largestDistance(part, before) < 2e-8);
    poles.cut(part, TurningSide::Outside, {-1e9, 50}, {-1e9, 50}, 1e9);
    for (std::size_t i = 0; i < part.size(); ++i) QVERIFY(part.radius(i) >= 0.0);
  }

  // The whole path of a pass, in either method, twice: the same profile, bit for bit.
  void aPassRepeats() {
    for (const TurningMethod method : {TurningMethod::Trim, TurningMethod::Poles}) {
      TurningPass pass;
      pass.method = method;
      pass.resolution = 0.5;
      for (int i = 0; i < 500; ++i) {
        pass.path.emplace_back(19.0 - 3.0 * std::sin(0.02 * i), 0.2 * i);
        pass.times.push_back(0.0);
      }
      TurnedProfile once(kCurveShaft, 0.1), again = once;
      cut(once, pass);
      cut(again, pass);
      QVERIFY(once == again && once.volume() < kCurveShaft.volume());
      QVERIFY(samplesUnder(once, pass) > 0);
    }
  }
};

HANDWHEEL_TEST(ControlPointCutTest)
#include "ControlPointCutTest.moc"
