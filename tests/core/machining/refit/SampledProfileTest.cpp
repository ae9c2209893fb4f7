// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/refit/SampledProfile.h"

#include "../target/AnyProfile.h"
#include "TestClass.h"

#include <QtTest>

using namespace handwheel;
using test::anyShaft;

namespace {

TargetProfile profileThrough(const std::vector<ProfilePoint>& points) {
  std::vector<ProfileSegment> all;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) all.push_back({points[i], points[i + 1], 0.0});
  return TargetProfile::make(std::move(all)).value();
}

}  // namespace

class SampledProfileTest : public QObject {
  Q_OBJECT

 private slots:
  // Off the samples by a third of a step, so that no corner is a sample.
  void cornersBetweenSamples() {
    const double off = 0.0067;
    const TargetProfile shaft = profileThrough({{0, 0},
                                                {10, 0},
                                                {10, 20 + off},
                                                {14, 24 + off},
                                                {14, 40},
                                                {20, 46},
                                                {20, 60},
                                                {18, 62 + off},
                                                {18, 70},
                                                {0, 70}});
    const auto back = sectionOf(sampled(shaft, 0.02), 1e-3);
    QVERIFY(back.hasValue());
    QCOMPARE(back->segments().size(), shaft.segments().size());
    for (std::size_t i = 0; i < shaft.segments().size(); ++i)
      QVERIFY((back->segments()[i].to - shaft.segments()[i].to).norm() < 1e-6);
  }

  void shouldersWithinASample() {
    const TargetProfile shaft = profileThrough({{0, 0}, {20, 0}, {20, 30.0}, {15, 30.0}, {15, 50}, {0, 50}});
    const auto back = sectionOf(sampled(shaft, 0.02), 1e-3);
    QVERIFY(back.hasValue());
    QCOMPARE(back->segments().size(), std::size_t{5});
    QCOMPARE(back->segments()[2].from.y(), back->segments()[2].to.y());  // flat
    QVERIFY(std::abs(back->segments()[2].from.y() - 30.0) <= 0.02);
    QCOMPARE(back->segments()[1].to.x(), 20.0);
    QCOMPARE(back->segments()[3].to.x(), 15.0);
  }

  // The profile of a round nose: a cylinder, a quarter of a circle, a wall at the steepest part of the circle.
  void aPassOfARoundNose() {
    TurnedProfile part(StockCylinder{40.0, 60.0, 0.0}, 0.02);
    part.cut({15.0 + 2.0, 30.0}, {15.0 + 2.0, 70.0}, 2.0);
    const auto back = sectionOf(part, 1e-3);
    QVERIFY(back.hasValue());
    QCOMPARE(back->segments().size(), std::size_t{6});
    const ProfileSegment arc = back->segments()[3];
    QVERIFY(arc.isArc());
    QVERIFY(std::abs(arc.radius() - 2.0) < 1e-6);
    QVERIFY((arc.centre() - ProfilePoint(17.0, 30.0)).norm() < 1e-6);
    const ProfileSegment wall = back->segments()[2];
    QVERIFY(std::abs(wall.from.y() - 28.0) < 1e-6 && std::abs(wall.to.y() - 28.0) < 1e-6);
  }

  // Noses of two passes beside each other leave pieces of a few samples, which a drawing does not list one by one.
  void passesBesideEachOther() {
    TurnedProfile part({40.0, 100.0, 0.0}, 0.013);
    for (int i = 0; i < 8; ++i) part.cut({20.0 - 0.4 * i, 105.0}, {20.0 - 0.4 * i, 60.003 + 0.05 * (i % 3)}, 0.8);
    const auto back = sectionOf(part, 5e-3);
    QVERIFY(back.hasValue());
    QVERIFY2(back->segments().size() < 16, qPrintable(QString::number(back->segments().size())));
    for (std::size_t i = 0; i < part.size(); i += 7) {
      const ProfilePoint p(part.radius(i), part.z(i));
      QVERIFY(std::any_of(back->segments().begin(), back->segments().end(),
                          [&](const ProfileSegment& s) { return (s.nearest(p) - p).norm() < 5e-3 + 1e-6; }));
    }
  }

  void boresAreFound() {
    const TargetProfile bush = profileThrough({{0, 0}, {20, 0}, {20, 40}, {8, 40}, {8, 15}, {0, 15}});
    const auto back = sectionOf(sampled(bush, 0.02), 1e-3);
    QVERIFY(back.hasValue() && !back->isClosed());
    QVERIFY(std::abs(back->volume() / bush.volume() - 1.0) < 1e-3);
    const TargetProfile tube = profileThrough({{8, 0}, {20, 0}, {20, 40}, {8, 40}, {8, 0}});
    const auto open = sectionOf(sampled(tube, 0.02), 1e-3);
    QVERIFY(open.hasValue() && open->isClosed());
    QCOMPARE(open->segments().size(), std::size_t{4});
    QVERIFY(std::abs(open->volume() / tube.volume() - 1.0) < 1e-9);
  }

  // If a bored part was faced, the samples beyond its face are the wall of the bore on both sides.
  void aFacedBush() {
    for (const double face : {39.2, 39.207, 39.213}) {
      TurnedProfile part = sampled(profileThrough({{8, 0}, {20, 0}, {20, 40}, {8, 40}, {8, 0}}), 0.02);
      for (std::size_t i = 0; i < part.size(); ++i)
        if (part.z(i) > face) part.limitOuter(i, 0.0);
      const auto back = sectionOf(part, 1e-3);
      QVERIFY(back.hasValue() && back->isClosed());
      QCOMPARE(back->segments().size(), std::size_t{4});
      QCOMPARE(back->lowerEnd(), 0.0);
      QVERIFY(std::abs(back->upperEnd() - face) <= 0.01 + 1e-9);
      QVERIFY(std::abs(back->volume() - M_PI * (400.0 - 64.0) * back->length()) < 1e-6);
    }
  }

  // A taper that meets the bore: the part ends in an edge, at a sample or between two.
  void aSharpEdge() {
    for (const double shift : {0.0, 0.0067}) {
      TurnedProfile part = sampled(profileThrough({{8, 0}, {20, 0}, {20, 40}, {8, 40}, {8, 0}}), 0.02);
      for (std::size_t i = 0; i < part.size(); ++i) part.limitOuter(i, 8.0 + (39.0 + shift - part.z(i)));
      const auto back = sectionOf(part, 1e-3);
      QVERIFY(back.hasValue() && back->isClosed());
      QVERIFY(std::abs(back->upperEnd() - 39.0 - shift) <= 0.02);
      // A cylinder of 12 mm of wall, to where the taper begins, and the cone's ring on it.
      const double cylinder = 27.0 + shift, cone = M_PI * (12.0 / 3.0 * (400.0 + 160.0 + 64.0) - 12.0 * 64.0);
      QVERIFY(std::abs(back->volume() / (M_PI * (400.0 - 64.0) * cylinder + cone) - 1.0) < 1e-3);
    }
  }

  void anyShaftComesBack() {
    QVERIFY(rc::check("its samples are near the section, and the volume is that of the shaft", [] {
      const auto shaft = TargetProfile::make(anyShaft());
      RC_PRE(shaft.hasValue());
      const TurnedProfile part = sampled(*shaft, 0.05);
      const auto back = sectionOf(part, 5e-3);
      RC_ASSERT(back.hasValue());
      for (std::size_t i = 0; i < part.size(); i += 7)
        RC_ASSERT(std::abs(back->distance({part.radius(i), part.z(i)})) < 0.06);
      // Each shoulder is off by a sample at most, and the rest by the tolerance.
      double radius = 0.0, length = 0.0;
      for (const ProfileSegment& segment : shaft->segments()) {
        radius = std::max({radius, segment.from.x(), segment.to.x()});
        length += (segment.to - segment.from).norm();
      }
      const double shoulders = static_cast<double>(shaft->segments().size());
      const double slack = M_PI * radius * (radius * 0.05 * shoulders + 2.0 * 5e-3 * length);
      RC_ASSERT(std::abs(back->volume() - shaft->volume()) < slack);
      RC_ASSERT(back->segments().size() < 4 * shaft->segments().size() + 20);
    }));
  }

  void ofACurve() {
    ProfileNurbs nurbs{2, {0, 0, 0, 1, 1, 2, 2, 2}, {{0, -5}, {5, -5}, {5, 0}, {5, 5}, {0, 5}}, {1, 1, 1, 1, 1}};
    nurbs.weights[1] = nurbs.weights[3] = std::sqrt(0.5);
    const auto ball = sectionOf(ProfileCurve::make(nurbs).value(), 1e-3);
    QVERIFY(ball.hasValue());
    QCOMPARE(ball->segments().size(), std::size_t{2});
    QVERIFY(std::abs(ball->volume() - 4.0 / 3.0 * M_PI * 125.0) < 1e-6);
  }

  // Lines stay lines: a cylinder of 10 mm below a cone to 6 mm.
  void ofLines() {
    const auto shaft = sectionOf(ProfileCurve::polyline({{0, 0}, {5, 0}, {5, 20}, {3, 30}, {0, 30}}).value(), 1e-3);
    QVERIFY(shaft.hasValue());
    QCOMPARE(shaft->segments().size(), std::size_t{4});
    for (const ProfileSegment& segment : shaft->segments()) QVERIFY(!segment.isArc());
    QVERIFY(std::abs(shaft->volume() - M_PI * (25.0 * 20.0 + 10.0 / 3.0 * (25.0 + 15.0 + 9.0))) < 1e-9);
  }

  void partedMaterialIsRefused() {
    QVERIFY(!sectionOf(TurnedProfile::fromRadii({5, 5, 0, 5, 5}, 4.0), 1e-3).hasValue());
    QVERIFY(!sectionOf(TurnedProfile::fromRadii({0, 0, 0}, 4.0), 1e-3).hasValue());
  }
};

HANDWHEEL_TEST(SampledProfileTest)
#include "SampledProfileTest.moc"
