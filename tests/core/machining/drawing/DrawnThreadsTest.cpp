// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/drawing/DrawnThreads.h"

#include "TestClass.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;

namespace {

constexpr double kThreadedLength = 60.0, kThreadedSpacing = 0.05;  // mm

// A pass of a thread with a sharp point, whose bottom is at this radius.
TurningPass threadPass(double bottom, double from, double to, double pitch, double offset = 0.0) {
  TurningPass pass;
  pass.noseRadius = 0.0;
  pass.path = {{bottom, to}, {bottom, from}};
  pass.times = {0.0, 1.0};
  pass.thread = ThreadCut();
  pass.thread->pitch = pitch;
  pass.thread->offset = offset;
  return pass;
}

// On a part of 60 mm whose lower end is at -60 of the drawing.
std::vector<DrawnThread> drawnOn(const TurnedProfile& part, const std::vector<TurningPass>& passes) {
  TurningPasses all;
  for (const TurningPass& pass : passes) all.push_back(std::make_shared<const TurningPass>(pass));
  const auto threads = PartThreads::of(all);
  return threads ? drawnThreads(part, *threads, -kThreadedLength) : std::vector<DrawnThread>();
}

bool isBetween(const DrawnThread& thread, double low, double high) {
  return std::abs(thread.low - low) <= kThreadedSpacing && std::abs(thread.high - high) <= kThreadedSpacing;
}

}  // namespace

// The threads of a part on a drawing: ISO 6410-1.
class DrawnThreadsTest : public QObject {
  Q_OBJECT

 private slots:
  // M20×2.5, 1.5 mm deep, over the upper half of a bar of 20 mm: the pass begins beyond its end.
  void onAShaft() {
    const TurnedProfile bar({20.0, kThreadedLength, 0.0}, kThreadedSpacing);
    const auto drawn = drawnOn(bar, {threadPass(8.5, 30.0, 65.0, 2.5)});
    QCOMPARE(drawn.size(), std::size_t{1});
    QCOMPARE(drawn[0].designation, std::string("M20×2.5"));
    QVERIFY(!drawn[0].isInner && isBetween(drawn[0], -30.0, 0.0));
    QVERIFY(std::abs(drawn[0].major - 20.0) < 1e-9 && std::abs(drawn[0].minor - 17.0) < 1e-9);
  }

  // The size is that of most of it: not that of the chamfer at its end, nor of a relief that is deeper than the thread.
  void beyondChamferAndRelief() {
    TurnedProfile bar({20.0, kThreadedLength, 0.0}, kThreadedSpacing);
    for (std::size_t i = 0; i < bar.size(); ++i) {
      if (bar.z(i) > 58.0) bar.limitOuter(i, 68.0 - bar.z(i));
      if (bar.z(i) < 33.0 && bar.z(i) > 29.0) bar.limitOuter(i, 8.0);
    }
    const auto drawn = drawnOn(bar, {threadPass(8.5, 30.0, 65.0, 2.5)});
    QCOMPARE(drawn.size(), std::size_t{1});
    QVERIFY(std::abs(drawn[0].major - 20.0) < 1e-9 && isBetween(drawn[0], -27.0, -0.5));
  }

  // In a tube of 17 mm the roots are the major diameter.
  void inABore() {
    TurnedProfile tube({40.0, kThreadedLength, 0.0}, kThreadedSpacing);
    for (std::size_t i = 0; i < tube.size(); ++i) tube.limitInner(i, 8.5);
    TurningPass pass = threadPass(10.0, 20.0, 40.0, 2.5);
    pass.side = TurningSide::Bore;
    const auto drawn = drawnOn(tube, {pass});
    QCOMPARE(drawn.size(), std::size_t{1});
    QCOMPARE(drawn[0].designation, std::string("M20×2.5"));
    QVERIFY(drawn[0].isInner && isBetween(drawn[0], -40.0, -20.0));
    QVERIFY(std::abs(drawn[0].major - 20.0) < 1e-9 && std::abs(drawn[0].minor - 17.0) < 1e-9);
  }

  // Grooves side by side are one thread, from the lowest to the highest; another pitch is another one.
  void startsAreOneThread() {
    const TurnedProfile bar({20.0, kThreadedLength, 0.0}, kThreadedSpacing);
    const TurningPass one = threadPass(8.5, 30.0, 50.0, 2.5), beside = threadPass(8.5, 25.0, 45.0, 2.5, 1.25),
                      apart = threadPass(9.2, 5.0, 15.0, 1.5);
    const auto drawn = drawnOn(bar, {one, beside, apart});
    QCOMPARE(drawn.size(), std::size_t{2});
    QVERIFY(isBetween(drawn[0], -35.0, -10.0) && isBetween(drawn[1], -55.0, -45.0));
    QCOMPARE(drawn[1].designation, std::string("M20×1.5"));
  }

  void besideThePartIsNone() {
    const TurnedProfile bar({20.0, kThreadedLength, 0.0}, kThreadedSpacing);
    QVERIFY(drawnOn(bar, {threadPass(8.5, 61.0, 80.0, 2.5)}).empty());
    QVERIFY(drawnOn(bar, {threadPass(10.5, 30.0, 50.0, 2.5)}).empty());
  }
};

HANDWHEEL_TEST(DrawnThreadsTest)
#include "DrawnThreadsTest.moc"
