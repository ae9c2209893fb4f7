// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "CaseRuns.h"
#include "TestClass.h"

#include <QTest>
#include <limits>

using namespace handwheel;

// The measured settings of volumes except for their reduction, and of drilling in them.
class VolumeCasesTest : public QObject {
  Q_OBJECT

 private slots:
  void everyCaseRuns_data() { test::addCases(test::CaseGroup::Volume); }
  void everyCaseRuns() { test::runCase(); }
  void piecesOfAVolume();
};

// The larger the pieces, the fewer there are; the eight octants around the middle of a ball are parted at any size. By
// which tool they are renewed does not matter.
void VolumeCasesTest::piecesOfAVolume() {
  const FidelityRegistry::Entry& entry = *test::measured().find("volume.pieces");
  double before = std::numeric_limits<double>::infinity();
  for (double value = entry.setting.least; value <= entry.setting.largest; ++value) {
    const double count = test::errorAt(entry.cases.front(), value);
    QVERIFY(count >= 8.0 && count < before);
    QCOMPARE(test::errorAt(entry.cases.back(), value), count);
    before = count;
  }
}

HANDWHEEL_TEST(VolumeCasesTest)
#include "VolumeCasesTest.moc"
