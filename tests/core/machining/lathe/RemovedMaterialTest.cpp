// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/lathe/RemovedMaterial.h"

#include "TestClass.h"

#include <rapidcheck.h>

#include <QtTest>
#include <cmath>
#include <limits>

using namespace handwheel;

namespace {

constexpr StockCylinder kStock{40.0, 100.0, 0.0};

double number(double low, double high) {
  return low + (high - low) * *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 1'000'001)) / 1e6;
}

RoundedPolygon anySection() {
  std::vector<ProfilePoint> corners;
  const int count = *rc::gen::inRange(1, 7);
  for (int i = 0; i < count; ++i) corners.emplace_back(number(0.0, 12.0), number(-6.0, 6.0));
  return RoundedPolygon(corners, number(0.2, 2.0));
}

// Returns the depth of p inside of the widened polygon, by the definition: the nearest point of the hull, found by
// trying very many mixtures of its corners, is too slow; so the distance to each edge, with the sign of the side.
double depthIn(const RoundedPolygon& section, const ProfilePoint& p) {
  const auto corners = section.corners();
  double nearest = std::numeric_limits<double>::infinity();
  bool isInside = corners.size() >= 3;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const ProfilePoint a = corners[i], b = corners[(i + 1) % corners.size()];
    const double length2 = (b - a).squaredNorm();
    const double t = length2 > 0.0 ? std::clamp((p - a).dot(b - a) / length2, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, (p - a - t * (b - a)).norm());
    isInside = isInside && (b.y() - a.y()) * (p.x() - a.x()) - (b.x() - a.x()) * (p.y() - a.y()) >= 0.0;
  }
  return isInside ? section.radius() : section.radius() - nearest;
}

// The least or the largest r at z that dense positions of the section cover, found by halving towards a covered point.
struct Cover {
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
};
Cover coverOf(const RoundedPolygon& section, const ProfilePoint& a, const ProfilePoint& b, double z) {
  Cover cover;
  constexpr int kSteps = 400, kRows = 400;
  for (int i = 0; i <= kSteps; ++i) {
    const ProfilePoint at = a + static_cast<double>(i) / kSteps * (b - a);
    for (int k = 0; k <= kRows; ++k) {
      const double r = -15.0 + 55.0 * k / kRows;
      if (depthIn(section, ProfilePoint(r, z) - at) < 0.0) continue;
      cover.lowest = std::min(cover.lowest, r);
      cover.highest = std::max(cover.highest, r);
    }
  }
  return cover;
}

}  // namespace

class RemovedMaterialTest : public QObject {
  Q_OBJECT

 private slots:
  void theHullOfItsCorners() {
    const std::vector<ProfilePoint> corners{{0, 0}, {2, 0}, {2, 2}, {1, 1}, {0, 2}, {0, 0}, {1, 0}};
    const RoundedPolygon square(corners, 0.5);
    QCOMPARE(square.corners().size(), std::size_t{4});
    QVERIFY(!RoundedPolygon::isSound({}, 1.0));
    const ProfilePoint nan(std::nan(""), 0.0);
    QVERIFY(!RoundedPolygon::isSound({&nan, 1}, 1.0));
    QVERIFY(!RoundedPolygon::isSound(corners, -1.0) && !RoundedPolygon::isSound(corners, std::nan("")));
    const std::vector<ProfilePoint> line = square.outline(4);
    QCOMPARE(line.size(), std::size_t{5});
    QVERIFY(line.front() == line.back());
    for (const ProfilePoint& p : line) QVERIFY(std::abs(depthIn(square, p)) < 1e-12);
  }

  // A sweep covers the same as the section at dense positions of its path.
  void theEnvelopeOfTheSweep() {
    QVERIFY(rc::check("lowest and highest agree with dense samples", [] {
      const RoundedPolygon section = anySection();
      const ProfilePoint a(number(0.0, 20.0), number(0.0, 20.0)), b(number(0.0, 20.0), number(0.0, 20.0));
      const SectionSweep sweep(section, a, b);
      const double z = number(sweep.first() + 0.1, sweep.last() - 0.1);
      const Cover cover = coverOf(section, a, b, z);
      RC_ASSERT(sweep.lowest(z) <= cover.lowest + 1e-9);
      RC_ASSERT(sweep.highest(z) >= cover.highest - 1e-9);
      // Both borders belong to it, and nothing beyond them does.
      for (const double r : {sweep.lowest(z), sweep.highest(z)}) {
        double deepest = -1e9;
        for (int i = 0; i <= 20000; ++i)
          deepest = std::max(deepest, depthIn(section, ProfilePoint(r, z) - (a + i / 20000.0 * (b - a))));
        RC_ASSERT(std::abs(deepest) < 2e-3);
      }
      RC_ASSERT(sweep.least() <= sweep.lowest(z) + 1e-12 && sweep.largest() >= sweep.highest(z) - 1e-12);
    }));
  }

  // A round nose alone cuts like TurnedProfile::cut() and cutBore().
  void aDiscCutsAsARoundNose() {
    QVERIFY(rc::check("the same samples change by the same amount", [] {
      const ProfilePoint a(number(5.0, 30.0), number(-5.0, 105.0)), b(number(5.0, 30.0), number(-5.0, 105.0));
      const double nose = number(0.2, 6.0);
      const ProfilePoint centre(0.0, 0.0);
      const SectionSweep sweep(RoundedPolygon({&centre, 1}, nose), a, b);
      for (const TurningSide side : {TurningSide::Outside, TurningSide::Bore}) {
        TurnedProfile expected(kStock, 0.5), part(kStock, 0.5);
        const double before = part.volume();
        side == TurningSide::Outside ? expected.cut(a, b, nose) : expected.cutBore(a, b, nose);
        const RemovedMaterial preview = previewCut(part, sweep, side), cut = cutSection(part, sweep, side);
        for (std::size_t i = 0; i < part.size(); ++i) {
          RC_ASSERT(std::abs(part.radius(i) - expected.radius(i)) < 1e-9);
          RC_ASSERT(std::abs(part.inner(i) - expected.inner(i)) < 1e-9);
        }
        RC_ASSERT(preview.volume == cut.volume && preview.area == cut.area && preview.depth == cut.depth);
        // Rectangles here, frustums there: they differ at the flanks, by the square of a step of the radius.
        RC_ASSERT(std::abs(before - part.volume() - cut.volume) <= M_PI * 0.5 * 400.0 + 0.02 * cut.volume);
      }
    }));
  }

  void measuresWhatItRemoves() {
    TurnedProfile part(kStock, 0.01);
    const std::vector<ProfilePoint> corners{{0, 0}, {0, 3}, {25, 3}, {25, 0}};
    const SectionSweep plunge(RoundedPolygon(corners, 0.0), {25.0, 50.0}, {15.0, 50.0});
    const RemovedMaterial cut = cutSection(part, plunge, TurningSide::Outside);
    QVERIFY(std::abs(cut.area / (5.0 * 3.0) - 1.0) < 0.005);
    QVERIFY(std::abs(cut.volume / (M_PI * (400.0 - 225.0) * 3.0) - 1.0) < 0.005);
    QCOMPARE(cut.depth, 5.0);
    QVERIFY(std::abs(cut.meanRadius() - 17.5) < 1e-9);
    QCOMPARE(cut.beyond, 0.0);  // the blade is longer than that
    QCOMPARE(part.radius(5150), 15.0);
    QCOMPARE(part.radius(4990), 20.0);
    QVERIFY(cutSection(part, plunge, TurningSide::Outside).isEmpty());
    // A blade of 2 mm reaches 3 mm deep.
    const std::vector<ProfilePoint> low{{0, 0}, {0, 3}, {2, 3}, {2, 0}};
    const SectionSweep deep(RoundedPolygon(low, 0.0), {15.0, 10.0}, {15.0, 10.0});
    QVERIFY(std::abs(previewCut(part, deep, TurningSide::Outside).beyond - 3.0) < 1e-12);
  }

  void overlapsOnBothSidesOfTheAxis() {
    const TurnedProfile ring = TurnedProfile::fromRadii({10, 10, 10, 10}, {6, 6, 6, 6}, 3.0);
    const auto block = [](double low, double high) {
      const std::vector<ProfilePoint> corners{{low, 0.5}, {low, 2.5}, {high, 2.5}, {high, 0.5}};
      return SectionSweep(RoundedPolygon(corners, 0.0), {0, 0}, {0, 0});
    };
    QVERIFY(!(overlapOf(ring, block(-5.9, 5.9), 10.0).depth > 0.0));
    QVERIFY(!(overlapOf(ring, block(10.0, 20.0), 10.0).depth > 0.0));
    QVERIFY(std::abs(overlapOf(ring, block(9.0, 20.0), 10.0).depth - 1.0) < 1e-12);
    const SectionOverlap other = overlapOf(ring, block(-6.5, 5.0), 10.0);
    QVERIFY(std::abs(other.depth - 0.5) < 1e-12 && other.position.x() < 0.0);
    QVERIFY(!(overlapOf(TurnedProfile::fromRadii({0, 0}, 3.0), block(-5.0, 5.0), 10.0).depth > 0.0));
  }

  void distancesOfSections() {
    QVERIFY(rc::check("as of dense points of their borders", [] {
      const RoundedPolygon a = anySection();
      const RoundedPolygon b = anySection().moved({number(-20.0, 20.0), number(-20.0, 20.0)});
      const double distance = distanceBetween(a, b);
      RC_ASSERT(std::abs(distance - distanceBetween(b, a)) < 1e-9);
      double deepest = -1e9;
      const std::vector<ProfilePoint> border = a.outline(720);
      for (std::size_t i = 0; i + 1 < border.size(); ++i) {
        for (int k = 0; k < 50; ++k)
          deepest = std::max(deepest, depthIn(b, border[i] + k / 50.0 * (border[i + 1] - border[i])));
      }
      if (deepest > 1e-3) RC_ASSERT(distance == 0.0);
      if (distance > 0.0) RC_ASSERT(deepest <= 1e-9);
      if (distance > 0.0) RC_ASSERT(std::abs(-deepest - distance) < 0.1);
    }));
  }

  void nothingOfNoNumber() {
    const ProfilePoint corner(0, 0);
    const RoundedPolygon disc({&corner, 1}, 1.0);
    TurnedProfile part(kStock, 1.0);
    const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
    for (const double bad : {nan, inf, -inf}) {
      const SectionSweep sweep(disc, {bad, 50}, {10, 50});
      QVERIFY(sweep.empty());
      QVERIFY(cutSection(part, sweep, TurningSide::Outside).isEmpty());
      QVERIFY(cutSection(part, sweep, TurningSide::Bore).isEmpty());
      QVERIFY(!(overlapOf(part, sweep, 20.0).depth > 0.0));
    }
    QVERIFY(SectionSweep(RoundedPolygon(), {0, 0}, {1, 1}).empty());
    QVERIFY(cutSection(part, SectionSweep(disc, {1e300, 1e300}, {1e301, 1e300}), TurningSide::Outside).isEmpty());
    QVERIFY(part == TurnedProfile(kStock, 1.0));
  }
};

HANDWHEEL_TEST(RemovedMaterialTest)
#include "RemovedMaterialTest.moc"
