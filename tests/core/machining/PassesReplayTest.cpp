// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/PassesReplay.h"

#include "TestClass.h"
#include "machining/lathe/LatheJson.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;

namespace {

constexpr StockCylinder kReplayedBar{40.0, 100.0, 0.0};

std::shared_ptr<const TurningPass> replayedPass(double r, double from, double to, double seconds, int steps) {
  TurningPass pass;
  pass.noseRadius = 1.0;
  for (int i = 0; i <= steps; ++i) {
    pass.path.emplace_back(r, from + (to - from) * i / steps);
    pass.times.push_back(seconds * i / steps);
  }
  return std::make_shared<const TurningPass>(pass);
}

// 10 s of a round nose in 1000 points, 4 s of one straight move of a lathe tool, 5 s of a thread.
TurningPasses threePasses() {
  TurningPasses passes{replayedPass(19.0, 110.0, 60.0, 10.0, 1000)};
  TurningPass tooled = *replayedPass(16.0, 105.0, 85.0, 4.0, 1);
  tooled.tool = toolNamed(shippedLatheTools(), "right-roughing");
  passes.push_back(std::make_shared<const TurningPass>(tooled));
  TurningPass thread = *replayedPass(15.0, 103.0, 88.0, 5.0, 1);
  thread.noseRadius = isoMetricNose(2.0);
  thread.thread = ThreadCut{.pitch = 2.0};
  passes.push_back(std::make_shared<const TurningPass>(thread));
  return passes;
}

double radiusOf(const TurnedProfile& profile, double z) {
  return profile.radius(static_cast<std::size_t>(std::lround(z / profile.spacing())));
}

}  // namespace

class PassesReplayTest : public QObject {
  Q_OBJECT

 private slots:
  void theEndIsThePart() {
    const TurnedProfile bar(kReplayedBar, 0.1);
    const auto replay = PassesReplay::make(bar, threePasses());
    QVERIFY(replay);
    QCOMPARE(replay->duration(), 19.0);
    QCOMPARE(replay->begin(2), 14.0);
    TurnedProfile part = bar;
    for (const auto& pass : threePasses()) cut(part, *pass);
    QVERIFY(replay->at(19.0).profile == part);
    QVERIFY(replay->at(1e9).profile == part);
    QVERIFY(replay->at(-1.0).profile == bar);
    QVERIFY(replay->at(19.0).threads && !replay->at(13.9).threads);
  }

  // Between points, too, the tool is at its position of that time, and has cut the material behind it.
  void theWorkAtATime() {
    const auto replay = PassesReplay::make(TurnedProfile(kReplayedBar, 0.1), threePasses());
    const PassesReplay::Moment first = replay->at(5.0);
    QCOMPARE(first.number, std::size_t{0});
    QVERIFY((first.position - ProfilePoint(19.0, 85.0)).norm() < 1e-9);
    QVERIFY(std::abs(radiusOf(first.profile, 95.0) - 18.0) < 1e-9);
    QCOMPARE(radiusOf(first.profile, 80.0), 20.0);
    const PassesReplay::Moment second = replay->at(12.0);
    QCOMPARE(second.number, std::size_t{1});
    QVERIFY((second.position - ProfilePoint(16.0, 95.0)).norm() < 1e-9);
    QVERIFY(std::abs(radiusOf(second.profile, 98.0) - 16.0) < 1e-9);
    QVERIFY(std::abs(radiusOf(second.profile, 90.0) - 18.0) < 1e-9);
    // The groove of the thread is as long as the tool has come.
    const PassesReplay::Moment third = replay->at(16.5);
    QVERIFY((third.position - ProfilePoint(15.0, 95.5)).norm() < 1e-9);
    const auto depthAt = [&](const PassesReplay::Moment& moment, double z) {
      return 16.0 - moment.threads->radius(TurningSide::Outside, 16.0, 0.0, z, 0.0);
    };
    QVERIFY(depthAt(third, 98.0) > 0.5 && depthAt(third, 92.0) == 0.0);
    QVERIFY(depthAt(replay->at(19.0), 92.0) > 0.5);
  }

  // A moment is the same after any other moments were shown.
  void scrubbingBackAndForth() {
    const auto replay = PassesReplay::make(TurnedProfile(kReplayedBar, 0.1), threePasses());
    for (const double time : {17.0, 3.217, 11.5, 0.001, 9.999, 3.217}) {
      TurnedProfile expected(kReplayedBar, 0.1);
      double begin = 0.0;
      for (const auto& pass : threePasses()) {
        for (std::size_t i = 0; i < pass->path.size() && begin + pass->times[i] <= time; ++i)
          cut(expected, *pass, pass->path[i == 0 ? 0 : i - 1], pass->path[i]);
        begin += pass->times.back();
      }
      // The cut after the last point that was passed is within a nose of the position.
      const PassesReplay::Moment moment = replay->at(time);
      for (std::size_t i = 0; i < expected.size(); ++i) {
        if (moment.pass->path.size() > 2 && std::abs(expected.z(i) - moment.position.y()) > 1.1)
          QCOMPARE(moment.profile.radius(i), expected.radius(i));
        QVERIFY(moment.profile.radius(i) <= expected.radius(i));
      }
    }
  }

  void nothingToPlay() {
    const auto replay = PassesReplay::make(TurnedProfile(kReplayedBar, 0.1), {});
    QCOMPARE(replay->duration(), 0.0);
    QVERIFY(!replay->at(1.0).pass);
    JobState state;
    state.cancelled = true;
    QVERIFY(!PassesReplay::make(TurnedProfile(kReplayedBar, 0.1), threePasses(), Progress(state)));
  }
};

HANDWHEEL_TEST(PassesReplayTest)
#include "PassesReplayTest.moc"
