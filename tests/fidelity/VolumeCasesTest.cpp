// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "CaseRuns.h"
#include "TestClass.h"

#include <QTest>
#include <cmath>
#include <limits>

using namespace handwheel;

// The measured settings of volumes except for their reduction, and of drilling in them.
class VolumeCasesTest : public QObject {
  Q_OBJECT

 private slots:
  // The other tests measure the ball with fewer voxels, and the pieces. Holes along the grid are drilled like those
  // across.
  void everyCaseRuns_data() {
    test::addCases(test::CaseGroup::Volume, {{"volume.voxels", 0, 0},
                                             {"volume.method", 0, 1},
                                             {"volume.pieces", 0, 0},
                                             {"volume.pieces", 1, 0},
                                             {"drill.erosion", 0, 0}});
  }
  void everyCaseRuns() { test::runCase(); }
  void fewVoxels();
  void piecesOfAVolume();
};

// A point that is deeper in the ball, or farther outside, than the diagonal of a voxel is between centres of voxels
// that are all on its side: the surface is off by less than that.
void VolumeCasesTest::fewVoxels() {
  const FidelityRegistry::Entry& entry = *test::measured().find("volume.voxels");
  const FidelityCase& ball = entry.cases.front();
  const FidelitySample sample = ball.run(entry.setting.least, 1, {});
  QVERIFY(sample.error > 0.0 && sample.error < 100.0 * std::sqrt(3.0) / entry.setting.least);
  QVERIFY(sample.cost > 0.0);
  QCOMPARE(test::errorAt(ball, entry.setting.least), sample.error);
}

// The larger the pieces, the fewer there are; the eight octants around the middle of a ball are parted at any size. By
// which tool they are renewed does not matter.
void VolumeCasesTest::piecesOfAVolume() {
  const FidelityRegistry::Entry& entry = *test::measured().find("volume.pieces");
  double before = std::numeric_limits<double>::infinity();
  for (double value = entry.setting.least; value <= entry.setting.largest; ++value) {
    const FidelitySample small = entry.cases.front().run(value, 1, {});
    QVERIFY(small.error >= 8.0 && small.error < before);
    QVERIFY(std::isfinite(small.cost) && small.cost > 0.0);
    before = small.error;
    if (value > entry.setting.least && !test::withLargeInputs()) continue;
    const FidelitySample large = entry.cases.back().run(value, 1, {});
    QCOMPARE(large.error, small.error);
    QVERIFY(std::isfinite(large.cost) && large.cost > 0.0);
  }
}

HANDWHEEL_TEST(VolumeCasesTest)
#include "VolumeCasesTest.moc"
