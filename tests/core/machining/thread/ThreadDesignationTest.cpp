// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/thread/ThreadDesignation.h"

#include "TestClass.h"

#include <QtTest>

using namespace handwheel;

namespace {

ThreadCut designatedThread(double pitch, double degrees = 60.0, int starts = 1, bool isLeft = false) {
  ThreadCut cut;
  cut.pitch = pitch;
  cut.angle = degrees * M_PI / 180.0;
  cut.starts = starts;
  cut.isLeft = isLeft;
  return cut;
}

}  // namespace

// Examples of ISO 965-1 and ISO 2904.
class ThreadDesignationTest : public QObject {
  Q_OBJECT

 private slots:
  void metric() {
    QCOMPARE(threadDesignation(designatedThread(2.5), 20.0, false), std::string("M20×2.5"));
    QCOMPARE(threadDesignation(designatedThread(1.0, 60.0, 1, true), 8.0, false), std::string("M8×1-LH"));
    QCOMPARE(threadDesignation(designatedThread(1.5, 60.0, 2), 16.0, false), std::string("M16×L3P1.5"));
  }

  void trapezoidal() {
    QCOMPARE(threadDesignation(designatedThread(7.0, 30.0), 40.0, false), std::string("Tr40×7"));
    QCOMPARE(threadDesignation(designatedThread(7.0, 30.0, 2, true), 40.0, false), std::string("Tr40×14P7LH"));
  }

  // Crests within 6g of ISO 965-1 have the nominal diameter: for M20×2.5 from 19.623 to 19.958 mm.
  void theNominalDiameter() {
    for (const double crest : {19.623, 19.8, 19.958, 20.0})
      QCOMPARE(threadDesignation(designatedThread(2.5), crest, false), std::string("M20×2.5"));
    QCOMPARE(threadDesignation(designatedThread(1.5), 19.2, false), std::string("M19.2×1.5"));
    QCOMPARE(threadDesignation(designatedThread(2.5), 20.2, true), std::string("M20×2.5"));  // roots of a nut
  }

  void otherProfiles() {
    QCOMPARE(threadDesignation(designatedThread(1.814, 55.0), 25.4, false), std::string("Ø25.4 thread 1.81 55°"));
  }
};

HANDWHEEL_TEST(ThreadDesignationTest)
#include "ThreadDesignationTest.moc"
