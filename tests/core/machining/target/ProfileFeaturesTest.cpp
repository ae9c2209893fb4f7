// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/ProfileFeatures.h"

#include "TestClass.h"
#include "machining/refit/SampledProfile.h"

#include <QtTest>

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
