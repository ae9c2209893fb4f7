// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/segment/Segment.h"

#include "MadeSegments.h"
#include "TestClass.h"

#include <QtTest>

using namespace handwheel;
using namespace handwheel::test;

class SegmentBricksTest : public QObject {
  Q_OBJECT

 private slots:
  // Both ends belong to the range.
  void byRange() {
    const ImageVolume image = noise({20, 17, 33}, 1);
    const Segment segment({20.0, 40.0});
    const std::vector<char> flags = flagsOf(image, segment);
    for (std::size_t i = 0; i < flags.size(); ++i)
      QCOMPARE(flags[i] != 0, image.value(i) >= 20.0 && image.value(i) <= 40.0);
    QVERIFY(segment.isByRangeAlone());
    QCOMPARE(segment.bytesBeside({}), std::size_t{0});
  }

  // A brick of what is there changes nothing; one that is changed changes its sample alone, and no copy.
  void bricks() {
    const ImageVolume image = noise({20, 17, 33}, 2);
    const Segment plain({30.0, 60.0});
    const std::vector<char> before = flagsOf(image, plain);
    const VoxelIndex at(18, 16, 32);
    Segment changed = plain;
    SegmentBrick brick = changed.filledBrick(image, at);
    changed.setBrick(image.grid().size, at, std::make_shared<SegmentBrick>(brick));
    QCOMPARE(flagsOf(image, changed), before);
    QVERIFY(!(changed == plain));
    brick.set(at.x() & 15, at.y() & 15, at.z() & 15, before.back() == 0);
    const Segment copy = changed;
    changed.setBrick(image.grid().size, at, std::make_shared<SegmentBrick>(brick));
    QCOMPARE(flagsOf(image, copy), before);
    std::vector<char> expected = before;
    char& flag = expected[static_cast<std::size_t>((at.z() * 17 + at.y()) * 20 + at.x())];
    flag = before.back() == 0 ? 1 : 0;
    QCOMPARE(flagsOf(image, changed), expected);
    QVERIFY(changed.bytesBeside(copy) >= sizeof(SegmentBrick));
    QVERIFY(changed.bytesBeside(copy) < 2 * sizeof(SegmentBrick) + 1000);
  }
};

HANDWHEEL_TEST(SegmentBricksTest)
#include "SegmentBricksTest.moc"
