// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/target/DeviationDisplay.h"

#include "TestClass.h"
#include "document/workpiece/TurnedPartDisplay.h"

#include <QtTest>
#include <algorithm>
#include <cmath>

using namespace handwheel;

namespace {

constexpr std::array<float, 3> kRed{1.0f, 0.0f, 0.0f}, kGreen{0.0f, 1.0f, 0.0f};
constexpr double kBandOfBar = 0.4;  // mm: a 200th of 80

// A bar of ⌀44 × 80 mm from Z 5 on, that is to become ⌀40 up to 30 mm above its end, and ⌀24 from there on.
WorkpieceSnapshot barWithTarget(double lowerEnd = 5.0) {
  WorkpieceSnapshot workpiece;
  workpiece.stock = {44.0, 80.0, 5.0};
  auto target =
      TargetProfile::make({{{20, lowerEnd}, {20, 35}, 0.0}, {{20, 35}, {12, 35}, 0.0}, {{12, 35}, {12, 85}, 0.0}});
  workpiece.target = std::make_shared<const WorkpieceTarget>(WorkpieceTarget{std::move(target.value()), {}});
  return workpiece;
}

// The same bar, turned down to the target except for `off` mm, with samples at this spacing.
WorkpieceSnapshot turnedWithTarget(double off, double spacing) {
  WorkpieceSnapshot workpiece = barWithTarget();
  TurnedProfile profile(workpiece.stock, spacing);
  for (std::size_t i = 0; i < profile.size(); ++i) profile.limitOuter(i, (profile.z(i) <= 30.0 ? 20.0 : 12.0) + off);
  workpiece.part = std::make_shared<const TurnedPart>(TurnedPart::of(std::move(profile), {}, 0.1));
  return workpiece;
}

// Returns the bounds of a part of the model, in the coordinates of the document.
Box boxOfPart(const DisplayPart& part) {
  Box box;
  for (const Vec3& p : part.soup->points) box.extend(part.pose * p);
  return box;
}

// The distances that colours were asked for.
std::vector<double> distancesIn(const WorkpieceSnapshot& workpiece) {
  std::vector<double> all;
  (void)deviationDisplay(workpiece, [&](double distance) {
    all.push_back(distance);
    return kGreen;
  });
  return all;
}

}  // namespace

// A workpiece in the colours of its distance from the target.
class DeviationDisplayTest : public QObject {
  Q_OBJECT

 private slots:
  // For the bar the corner of the shoulder is the nearest point of the target just above it: 5 mm away, at an axial
  // distance of √(5² - 2²) mm. Below that it is green, above it red, and neighbours of one colour are one part.
  void theBarIsColouredByItsDistance() {
    const DisplayModel model =
        deviationDisplay(barWithTarget(), [](double distance) { return distance > 5.0 ? kRed : kGreen; });
    QCOMPARE(model.parts.size(), std::size_t{2});
    QVERIFY(model.parts[0].colour == kGreen && model.parts[1].colour == kRed);
    const Box lower = boxOfPart(model.parts[0]), upper = boxOfPart(model.parts[1]);
    QVERIFY(std::abs(lower.min().z() - 5.0) < 1e-9 && std::abs(upper.max().z() - 85.0) < 1e-9);
    QVERIFY(std::abs(lower.max().z() - (35.0 + std::sqrt(21.0))) < kBandOfBar);
    QCOMPARE(lower.max().z(), upper.min().z());  // no gap
    for (const DisplayPart& part : model.parts) {
      QCOMPARE(part.group, std::string(kStockGroup));
      QVERIFY(std::abs(boxOfPart(part).max().x() - 22.0) < 1e-9);
    }
    QVERIFY(model.parts[0].name != model.parts[1].name);
  }

  // Two millimetres are left on the larger diameter, and ten on the smaller one.
  void aBarHasAllOfItLeft() {
    const std::vector<double> distances = distancesIn(barWithTarget());
    QVERIFY(std::abs(*std::max_element(distances.begin(), distances.end()) - 10.0) < 1e-9);
    QVERIFY(std::abs(*std::min_element(distances.begin(), distances.end()) - 2.0) < 1e-9);
  }

  // A cut below the target has a negative distance of its depth.
  void tooMuchIsBelowZero() {
    for (const double off : {0.3, -0.3}) {
      const std::vector<double> distances = distancesIn(turnedWithTarget(off, 0.1));
      const auto isOff = [&](double d) { return std::abs(d - off) < 1e-9; };
      QVERIFY(std::count_if(distances.begin(), distances.end(), isOff) >
              static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(distances.size())));
    }
  }

  // The bar in the chuck behind the target does not belong to the part, and has no distance.
  void theBarBehindTheTargetDoesNotCount() {
    const DisplayModel model =
        deviationDisplay(barWithTarget(25.0), [](double distance) { return distance == 0.0 ? kGreen : kRed; });
    QCOMPARE(model.parts.size(), std::size_t{2});
    QVERIFY(model.parts[0].colour == kGreen);
    QVERIFY(std::abs(boxOfPart(model.parts[0]).max().z() - 25.0) < 2.0 * kBandOfBar);
  }

  // A bore that no target has: its wall is 8 mm from the outside of ⌀24, in the material, which is worse than 0.3 mm
  // too much outside.
  void aBoreCountsAsTheOutside() {
    WorkpieceSnapshot workpiece = turnedWithTarget(0.3, 0.1);
    TurnedProfile profile = workpiece.part->profile;
    for (std::size_t i = 0; i < profile.size(); ++i)
      if (profile.z(i) >= 60.0) profile.limitInner(i, 4.0);
    workpiece.part = std::make_shared<const TurnedPart>(TurnedPart::of(std::move(profile), {}, 0.1));
    const std::vector<double> distances = distancesIn(workpiece);
    // At the end the flat face is nearer.
    QVERIFY(std::abs(*std::min_element(distances.begin(), distances.end()) + 8.0) < 1e-9);
    const DisplayModel model =
        deviationDisplay(workpiece, [](double distance) { return distance < -1.0 ? kRed : kGreen; });
    QCOMPARE(model.parts.size(), std::size_t{3});  // at the very end it is the face that is near
    QVERIFY(std::abs(boxOfPart(model.parts[1]).min().z() - 65.0) < 2.0 * kBandOfBar);
  }

  // However many samples a part has, colours are asked for some 200 times, and a picture has so many rings.
  void aLongPartIsNotShownInMoreBands() {
    const WorkpieceSnapshot workpiece = turnedWithTarget(0.1, 0.001);
    QVERIFY(workpiece.part->profile.size() > 50'000);
    int asked = 0;
    const DisplayModel model = deviationDisplay(workpiece, [&](double) {
      ++asked;
      return kGreen;
    });
    QVERIFY2(asked > 150 && asked < 250, qPrintable(QString::number(asked)));
    QCOMPARE(model.parts.size(), std::size_t{1});
    QVERIFY(model.parts.front().soup->points.size() < 400'000);
  }

  // Above Z 65 all is cut away, 12 mm too deep; from Z 73.1 on the face of the target is nearer than its side. What is
  // another colour there has no area, and is no part: a view would wait for it.
  void whatIsCutAwayIsNoPart() {
    WorkpieceSnapshot workpiece = turnedWithTarget(0.1, 0.1);
    TurnedProfile profile = workpiece.part->profile;
    for (std::size_t i = 0; i < profile.size(); ++i)
      if (profile.z(i) > 60.0) profile.limitOuter(i, 0.0);
    workpiece.part = std::make_shared<const TurnedPart>(TurnedPart::of(std::move(profile), {}, 0.1));
    const DisplayModel model =
        deviationDisplay(workpiece, [](double distance) { return distance < -11.9 ? kRed : kGreen; });
    QCOMPARE(model.parts.size(), std::size_t{2});
    for (const DisplayPart& part : model.parts)
      QVERIFY(boxOfPart(part).max().x() > 1.0 && boxOfPart(part).max().z() < 73.1 + 2.0 * kBandOfBar);
  }
};

HANDWHEEL_TEST(DeviationDisplayTest)
#include "DeviationDisplayTest.moc"
