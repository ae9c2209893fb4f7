// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/ProfileFeatures.h"

#include "TestClass.h"
#include "machining/refit/SampledProfile.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <utility>

using namespace handwheel;
using FeatureKind = ProfileFeature::Kind;

namespace {

// Face, cylinder 30, shoulder, taper of 15°, fillet, cylinder, end, bore 10 with a conical bottom.
TargetProfile shaft() {
  const double fifteen = M_PI / 12;
  const double end = 40.0 + 8.0 / std::tan(fifteen);
  std::vector<ProfileSegment> all{{{0, 0}, {15, 0}, 0.0},
                                  {{15, 0}, {15, 20}, 0.0},
                                  {{15, 20}, {25, 20}, 0.0},
                                  {{25, 20}, {25, 30}, 0.0},
                                  {{25, 30}, {25, 40}, 0.0},
                                  {{25, 40}, {17, end}, 0.0},
                                  arcAround({17, end + 3.0}, 3.0, -M_PI / 2, -M_PI),
                                  {{14, end + 3.0}, {14, end + 20}, 0.0},
                                  {{14, end + 20}, {5, end + 20}, 0.0},
                                  {{5, end + 20}, {5, end}, 0.0},
                                  {{5, end}, {0, end - 3}, 0.0}};
  return TargetProfile::make(std::move(all)).value();
}

void verifyShaft(const std::vector<ProfileFeature>& found, double slack) {
  const std::vector<FeatureKind> kinds{
      FeatureKind::FlatFace, FeatureKind::Cylinder, FeatureKind::FlatFace, FeatureKind::Cylinder, FeatureKind::Taper,
      FeatureKind::Arc,      FeatureKind::Cylinder, FeatureKind::FlatFace, FeatureKind::Cylinder, FeatureKind::Taper};
  QCOMPARE(found.size(), kinds.size());
  for (std::size_t i = 0; i < kinds.size(); ++i) QCOMPARE(found[i].kind, kinds[i]);
  QVERIFY(std::abs(found[1].value - 30.0) < slack && std::abs(found[1].length() - 20.0) < slack);
  QVERIFY(std::abs(found[3].value - 50.0) < slack && std::abs(found[3].length() - 20.0) < slack);
  QVERIFY(std::abs(found[4].value - M_PI / 12) < slack);
  QVERIFY(std::abs(found[5].value - 3.0) < slack && !found[5].isConvex && !found[5].isInner);
  QVERIFY(std::abs(found[8].value - 10.0) < slack && found[8].isInner && !found[6].isInner);
  QVERIFY(std::abs(found[9].value - std::atan2(5.0, 3.0)) < slack && found[9].isInner);
  QVERIFY(found[9].low.x() == 0.0 && found[9].low.y() < found[9].high.y());
}

}  // namespace

class ProfileFeaturesTest : public QObject {
  Q_OBJECT

 private slots:
  void ofAnExactProfile() { verifyShaft(featuresOf(shaft(), 1e-3), 1e-9); }

  void ofSamples() {
    const auto section = sectionOf(sampled(shaft(), 0.02), 1e-3);
    QVERIFY(section.hasValue());
    verifyShaft(featuresOf(*section, 1e-3), 0.021);
  }

  // A cylinder that is off by less than the tolerance is one.
  void withinATolerance() {
    const auto bent = TargetProfile::make(
        {{{10, 0}, {10.0005, 10}, 0.0}, {{10.0005, 10}, {9.9998, 25}, 0.0}, {{9.9998, 25}, {10, 40}, 0.0}});
    const auto found = featuresOf(*bent, 1e-3);
    QCOMPARE(found.size(), std::size_t{3});  // with the two ends
    QCOMPARE(found[1].kind, FeatureKind::Cylinder);
    QVERIFY(std::abs(found[1].value - 20.0) < 1e-3);
    QCOMPARE(featuresOf(*bent, 1e-5).size(), std::size_t{5});
  }

  // A wave of short lines between two cylinders is one curve with its ends, outside and in a bore; few tapers stay.
  void curvesOfManyLines() {
    const auto wave = [](double z) { return 10.0 + 2.0 * std::sin(0.25 * (z - 20.0)); };
    const double end = wave(60.0);
    for (const bool isBore : {false, true}) {
      std::vector<ProfileSegment> s{{{10, 0}, {10, 20}, 0.0}};
      for (int i = 1; i <= 100; ++i) {
        const ProfilePoint from = s.back().to, to(wave(20.0 + 0.4 * i), 20.0 + 0.4 * i);
        s.push_back({from, to, 0.0});
      }
      s.push_back({ProfilePoint(s.back().to), {end, 75}, 0.0});
      if (isBore) {
        for (ProfileSegment& each : s) std::swap(each.from, each.to);
        std::reverse(s.begin(), s.end());
        s.insert(s.begin(), {{{30, 0}, {30, 75}, 0.0}, {{30, 75}, {end, 75}, 0.0}});
        s.push_back({{10, 0}, {30, 0}, 0.0});
      }
      const auto target = TargetProfile::make(std::move(s));
      QVERIFY(bool(target));
      const std::vector<ProfileFeature> all = featuresOf(*target, 1e-4), listed = withCurves(all);
      QVERIFY(all.size() > 90);
      std::size_t curves = 0, tapers = 0;
      for (const ProfileFeature& f : listed) {
        tapers += f.kind == FeatureKind::Taper ? 1 : 0;
        if (f.kind != FeatureKind::Curve) continue;
        ++curves;
        QCOMPARE(f.isInner, isBore);
        QVERIFY((f.low - ProfilePoint(10.0, 20.0)).norm() < 1e-9);
        QVERIFY((f.high - ProfilePoint(end, 60.0)).norm() < 1e-9);
      }
      QCOMPARE(curves, std::size_t{1});
      QCOMPARE(tapers, std::size_t{0});
    }
    const std::vector<ProfileFeature> few = featuresOf(shaft(), 1e-3), same = withCurves(few);
    QCOMPARE(same.size(), few.size());
    for (std::size_t i = 0; i < few.size(); ++i) QCOMPARE(same[i].kind, few[i].kind);
    QVERIFY(withCurves({}).empty());
    QCOMPARE(std::string(nameOf(FeatureKind::Taper)), std::string("taper"));
    QCOMPARE(std::string(nameOf(FeatureKind::Curve)), std::string("curve"));
  }

  void ofABall() {
    // In three pieces, which are one arc.
    const auto ball = TargetProfile::make(
        {arcAround({0, 0}, 5, -M_PI / 2, -0.5), arcAround({0, 0}, 5, -0.5, 1.0), arcAround({0, 0}, 5, 1.0, M_PI / 2)});
    const auto found = featuresOf(*ball, 1e-6);
    QCOMPARE(found.size(), std::size_t{1});
    QCOMPARE(found[0].kind, FeatureKind::Arc);
    QVERIFY(found[0].isConvex && std::abs(found[0].value - 5.0) < 1e-9 && found[0].centre.norm() < 1e-9);
    QVERIFY(std::abs(found[0].length() - 10.0) < 1e-9);
  }

  // A shoulder leans over by 5°, as an insert leaves it: it faces the axis, and is no bore. The wall of a recess in the
  // end is one.
  void ofALeaningShoulder() {
    const double low = 30.0 - 2.0 * std::tan(M_PI / 36);
    const auto shaft = TargetProfile::make({{{0, 0}, {20, 0}, 0.0},
                                            {{20, 0}, {20, 30}, 0.0},
                                            {{20, 30}, {18, low}, 0.0},
                                            {{18, low}, {18, 60}, 0.0},
                                            {{18, 60}, {10, 60}, 0.0},
                                            {{10, 60}, {10, 55}, 0.0},
                                            {{10, 55}, {0, 54}, 0.0}});
    const auto found = featuresOf(*shaft, 1e-6);
    QCOMPARE(found.size(), std::size_t{7});
    QCOMPARE(found[2].kind, FeatureKind::Taper);
    for (std::size_t i = 0; i < found.size(); ++i) QCOMPARE(found[i].isInner, i >= 5);
    QVERIFY(found[2].isDownwards && std::abs(found[2].value - 85.0 * M_PI / 180.0) < 1e-12);
  }

  // An outline that begins within a feature.
  void ofATube() {
    const auto tube = TargetProfile::make({{{20, 15}, {20, 40}, 0.0},
                                           {{20, 40}, {8, 40}, 0.0},
                                           {{8, 40}, {8, 0}, 0.0},
                                           {{8, 0}, {20, 0}, 0.0},
                                           {{20, 0}, {20, 15}, 0.0}});
    const auto found = featuresOf(*tube, 1e-6);
    QCOMPARE(found.size(), std::size_t{4});
    int outside = 0, bores = 0;
    for (const ProfileFeature& f : found) {
      if (f.kind != FeatureKind::Cylinder) continue;
      QCOMPARE(f.length(), 40.0);
      (f.isInner ? bores : outside) += 1;
      QCOMPARE(f.value, f.isInner ? 16.0 : 40.0);
    }
    QCOMPARE(outside + 10 * bores, 11);
  }
};

HANDWHEEL_TEST(ProfileFeaturesTest)
#include "ProfileFeaturesTest.moc"
