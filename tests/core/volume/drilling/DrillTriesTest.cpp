// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/drilling/DrillTries.h"

#include "TestClass.h"

#include <QtTest>

using namespace handwheel;

namespace {

using TriesHole = std::shared_ptr<const DrillRecord>;

// A hole that differs from others by its depth.
TriesHole holeOfDepth(double depth) {
  auto hole = std::make_shared<DrillRecord>();
  hole->poses.push_back(DrillPose::of(Vec3(0.0, 0.0, 1.0), Vec3::UnitZ(), 0.0));
  hole->poses.push_back(DrillPose::of(Vec3(0.0, 0.0, -depth), Vec3::UnitZ(), depth));
  return hole;
}

}  // namespace

class DrillTriesTest : public QObject {
  Q_OBJECT

 private slots:
  void nothing() {
    QCOMPARE(triesOf(nullptr, {}).count, 0u);
    const std::vector<TriesHole> present = {holeOfDepth(1.0)};
    QCOMPARE(triesOf(nullptr, present).count, 1u);
    const TriedHoles none;
    QCOMPARE(triesOf(&none, present).count, 1u);
  }

  void fingerprints() {
    QCOMPARE(fingerprintOf(*holeOfDepth(2.0)), fingerprintOf(*holeOfDepth(2.0)));
    QVERIFY(fingerprintOf(*holeOfDepth(2.0)) != fingerprintOf(*holeOfDepth(2.000001)));
    auto other = std::make_shared<DrillRecord>(*holeOfDepth(2.0));
    other->setup.tool.diameter *= 2.0;
    QVERIFY(fingerprintOf(*holeOfDepth(2.0)) != fingerprintOf(*other));
  }

  // Holes that stay are of one try; the first one after one was taken back is of the next.
  void anotherTryAfterUndo() {
    const TriesHole a = holeOfDepth(1.0), b = holeOfDepth(2.0), c = holeOfDepth(3.0), d = holeOfDepth(4.0);
    std::vector<TriesHole> present;
    TriedHoles tried = withHole({}, present, *a, 0.0);
    present.push_back(a);
    tried = withHole(tried, present, *b, 1.5);
    present.push_back(b);
    QCOMPARE(triesOf(&tried, present).count, 1u);
    QVERIFY(triesOf(&tried, present).failed.empty());
    present.pop_back();  // b is undone
    QCOMPARE(triesOf(&tried, present).count, 1u);
    QCOMPARE(triesOf(&tried, present).failed.size(), std::size_t{1});
    tried = withHole(tried, present, *c, 0.0);
    present.push_back(c);
    tried = withHole(tried, present, *d, 0.0);
    present.push_back(d);
    const DrillTries tries = triesOf(&tried, present);
    QCOMPARE(tries.count, 2u);
    QCOMPARE(tries.failed.size(), std::size_t{1});
    QCOMPARE(tries.failed[0].number, 1u);
    QCOMPARE(tries.failed[0].forbidden, 1.5);
    // All is undone and drilled once more: the holes of the first try that stayed until then were in no region.
    present.clear();
    tried = withHole(tried, present, *holeOfDepth(5.0), 0.0);
    QCOMPARE(triesOf(&tried, present).count, 3u);
    QCOMPARE(triesOf(&tried, present).failed.size(), std::size_t{1});
  }

  // The deepest hole of a try counts.
  void deepestOfATry() {
    const TriesHole a = holeOfDepth(1.0), b = holeOfDepth(2.0);
    const std::vector<TriesHole> withA = {a};
    TriedHoles tried = withHole({}, {}, *a, 2.0);
    tried = withHole(tried, withA, *b, 0.5);
    const DrillTries tries = triesOf(&tried, {});
    QCOMPARE(tries.failed.size(), std::size_t{1});
    QCOMPARE(tries.failed[0].forbidden, 2.0);
  }
};

HANDWHEEL_TEST(DrillTriesTest)
#include "DrillTriesTest.moc"
