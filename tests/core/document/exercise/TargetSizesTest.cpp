// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/exercise/TargetSizes.h"

#include "TestClass.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;

namespace {

// A bar of 40 × 103 mm, held up to 25 mm, and a target in it along these points (r, z).
TurningTask taskWith(const std::vector<ProfilePoint>& points) {
  std::vector<ProfileSegment> segments;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) segments.push_back({points[i], points[i + 1], 0.0});
  TurningTask task;
  task.stock = {40.0, 103.0, 0.0};
  task.target = *TargetProfile::make(std::move(segments));
  return task;
}

const MarkingCriterion* sizeOf(const std::vector<MarkingCriterion>& sizes, const std::string& figure, double nominal) {
  for (const MarkingCriterion& c : sizes)
    if (c.figure == figure && std::abs(*c.nominal - nominal) < 1e-9) return &c;
  return nullptr;
}

}  // namespace

// What a teacher finds of a target whose sizes are known.
class TargetSizesTest : public QObject {
  Q_OBJECT

 private slots:
  // 30 mm over 40 mm with a chamfer of 1 × 45°; what has the diameter of the bar is not turned.
  void aShoulder() {
    const auto sizes = sizesOfTarget(taskWith({{0, 0}, {20, 0}, {20, 60}, {15, 60}, {15, 99}, {14, 100}, {0, 100}}));
    QCOMPARE(sizes.size(), std::size_t(3));
    const MarkingCriterion* diameter = sizeOf(sizes, "diameter", 30.0);
    QVERIFY(diameter);
    QCOMPARE(diameter->name, std::string("⌀30"));
    QCOMPARE(diameter->arguments, std::vector<double>({61.0, 98.0}));
    QVERIFY(std::abs(*diameter->lower - 29.8) < 1e-9 && std::abs(*diameter->upper - 30.2) < 1e-9);  // 6 to 30: ±0.2
    const MarkingCriterion* length = sizeOf(sizes, "length", 40.0);
    QVERIFY(length);
    QCOMPARE(length->arguments, std::vector<double>({17.5, 60.0, 7.0, 100.0}));
    QVERIFY(std::abs(*length->upper - 40.3) < 1e-9);  // 30 to 120: ±0.3
    const MarkingCriterion* taper = sizeOf(sizes, "taper", 45.0);
    QVERIFY(taper);
    QVERIFY(std::abs(*taper->lower - 44.0) < 1e-9);  // up to 10 mm: ±1°
  }

  // A groove has two faces, and the bar beside it none of its sizes. A blind bore has a diameter and a depth.
  void aGrooveAndABore() {
    const auto sizes = sizesOfTarget(
        taskWith({{0, 0}, {20, 0}, {20, 60}, {12, 60}, {12, 65}, {20, 65}, {20, 100}, {8, 100}, {8, 80}, {0, 80}}));
    QCOMPARE(sizes.size(), std::size_t(5));
    QVERIFY(sizeOf(sizes, "diameter", 24.0) && sizeOf(sizes, "bore", 16.0) && sizeOf(sizes, "depth", 20.0));
    QVERIFY(sizeOf(sizes, "length", 40.0) && sizeOf(sizes, "length", 35.0));
    QCOMPARE(sizeOf(sizes, "depth", 20.0)->arguments, std::vector<double>({4.0, 80.0, 14.0, 100.0}));
  }

  // Held in the chuck: not measured there.
  void whatTheChuckHolds() {
    const auto sizes = sizesOfTarget(taskWith({{0, 0}, {15, 0}, {15, 20}, {18, 20}, {18, 100}, {0, 100}}));
    QCOMPARE(sizes.size(), std::size_t(1));
    QCOMPARE(sizes[0].arguments, std::vector<double>({26.0, 99.0}));  // from the chuck on, a millimetre in
    QVERIFY(sizesOfTarget(TurningTask()).empty());
  }
};

HANDWHEEL_TEST(TargetSizesTest)
#include "TargetSizesTest.moc"
