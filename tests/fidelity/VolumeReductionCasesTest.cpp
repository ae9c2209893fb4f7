// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "CaseRuns.h"
#include "TestClass.h"

#include <QTest>

using namespace handwheel;

// The measurements of the reduction of a volume's surface, which take longer than all others of volumes.
class VolumeReductionCasesTest : public QObject {
  Q_OBJECT

 private slots:
  void everyCaseRuns_data() { test::addCases(test::CaseGroup::VolumeReduction); }
  void everyCaseRuns() { test::runCase(); }
};

HANDWHEEL_TEST(VolumeReductionCasesTest)
#include "VolumeReductionCasesTest.moc"
