// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/force/CuttingEdge.h"

#include "TestClass.h"

#include <rapidcheck.h>

#include <QtTest>
#include <cmath>

using namespace handwheel;

namespace {

constexpr double kRight = 1.5707963267948966;

CuttingEdge noseOf(double radius, double approach = kRight) {
  CuttingEdge edge;
  edge.noseRadius = radius;
  edge.approach = approach;
  return edge;
}

}  // namespace

// Feed and radial force by depth and nose.
class CuttingEdgeTest : public QObject {
  Q_OBJECT

 private slots:
  // Depth as large as the nose: the chord of a quarter of a circle, and half the feed behind it.
  void chordOfAQuarterCircle() {
    QVERIFY(std::abs(chordAngle({0.8, 0.0, 100.0}, noseOf(0.8)) - 0.25 * M_PI) < 1e-12);
    QVERIFY(std::abs(chordAngle({0.8, 0.2, 100.0}, noseOf(0.8)) - std::atan(0.8 / 0.9)) < 1e-12);
  }

  // A sharp corner: the chord is the edge itself, but for half a feed.
  void chordOfASharpCorner() {
    for (const double approach : {0.5, 1.0, kRight, 2.0})
      QVERIFY(std::abs(chordAngle({2.0, 0.0, 100.0}, noseOf(0.0, approach)) - approach) < 1e-12);
  }

  // Against points along the edge, found by stepping along its outline.
  void chordEndsOnTheEdge() {
    rc::check([] {
      const double radius = *rc::gen::inRange(1, 300) / 100.0, approach = *rc::gen::inRange(20, 160) / 100.0;
      const double depth = *rc::gen::inRange(1, 500) / 100.0;
      double along = 0.0, height = 0.0;
      constexpr double kStep = 1e-5;
      for (double turned = 0.0; height < depth;) {
        along += kStep * radius * std::cos(turned);
        height += kStep * radius * std::sin(turned);
        turned = std::min(turned + kStep, approach);
      }
      RC_ASSERT(std::abs(chordAngle({depth, 0.0, 1.0}, noseOf(radius, approach)) - std::atan2(depth, along)) < 1e-3);
    });
  }

  // The measured means of two sets (share of feed and radial force): as the depth grows the feed force rises and the
  // radial force falls, by about as much as here. The direction is within 17 degrees of the measured one throughout.
  void followsMeasuredDirections() {
    struct Row {
      double depth, feed, nose, feedShare, radialShare;
    };
    // First set: nose 0.4 mm by its roughness. Second: nose not given, 0.8 mm taken.
    constexpr Row kRows[] = {{0.25, 0.10, 0.4, 0.35, 0.77}, {0.50, 0.10, 0.4, 0.48, 0.49},
                             {0.80, 0.10, 0.4, 0.95, 0.35}, {0.25, 0.102, 0.8, 0.12, 0.72},
                             {0.50, 0.10, 0.8, 0.32, 0.52}, {1.00, 0.098, 0.8, 0.47, 0.37},
                             {1.25, 0.101, 0.8, 0.45, 0.26}};
    for (const Row& row : kRows) {
      const CutForces f = withThrust(1.0, {row.depth, row.feed, 350.0}, noseOf(row.nose), {});
      const double measured = std::atan2(row.feedShare, row.radialShare), ours = std::atan2(f.feed, f.radial);
      QVERIFY2(std::abs(measured - ours) < 17.0 * M_PI / 180.0, qPrintable(QString::number(row.depth)));
    }
  }

  void sharesGoApartWithTheDepth() {
    CutForces before = withThrust(100.0, {0.05, 0.1, 100.0}, noseOf(0.8), {});
    for (double depth = 0.1; depth < 5.0; depth += 0.05) {
      const CutForces now = withThrust(100.0, {depth, 0.1, 100.0}, noseOf(0.8), {});
      QVERIFY(now.feed > before.feed && now.radial < before.radial);
      QVERIFY(std::abs(std::hypot(now.feed, now.radial) - 70.0) < 1e-9);
      before = now;
    }
  }

  void constantSharesAreOffered() {
    ThrustSettings settings;
    settings.law = ThrustLaw::Constant;
    settings.feedRatio = 0.5;
    settings.radialRatio = 0.25;
    const CutForces forces = withThrust(200.0, {1.0, 0.1, 100.0}, {}, settings);
    QCOMPARE(forces, (CutForces{200.0, 100.0, 50.0}));
  }
};

HANDWHEEL_TEST(CuttingEdgeTest)
#include "CuttingEdgeTest.moc"
