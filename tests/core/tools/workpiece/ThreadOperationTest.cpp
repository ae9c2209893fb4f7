// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/workpiece/ThreadOperation.h"

#include "TestClass.h"
#include "machining/thread/ThreadGroove.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;

namespace {

struct ThreadAsked {
  double from = 60.0, to = 90.0, pitch = 1.5, depth = 0.0;  // mm
  double starts = 1.0;
  bool isLeft = false, isInside = false;
};

OperationValues askedValues(const ThreadAsked& asked) {
  OperationValues values(threadOperation());
  const std::pair<const char*, PropertyValue> all[] = {
      {"from", asked.from},     {"to", asked.to},       {"pitch", asked.pitch},    {"depth", asked.depth},
      {"starts", asked.starts}, {"left", asked.isLeft}, {"inside", asked.isInside}};
  for (const auto& [id, value] : all) values.setValid(id, value);
  return values;
}

// A bar of ⌀40 × 100 mm whose lower end is at Z 10.
WorkpieceSnapshot barToThread() {
  WorkpieceSnapshot workpiece;
  workpiece.stock = {40.0, 100.0, 10.0};
  return workpiece;
}

// The same bar, turned to ⌀30 above its middle and bored to ⌀12 there; at its end ⌀28 and ⌀14.
WorkpieceSnapshot turnedAndBored() {
  WorkpieceSnapshot workpiece = barToThread();
  TurnedProfile profile(workpiece.stock, 0.05);
  for (std::size_t i = 0; i < profile.size(); ++i) {
    if (profile.z(i) < 50.0) continue;
    profile.limitOuter(i, profile.z(i) > 95.0 ? 14.0 : 15.0);
    profile.limitInner(i, profile.z(i) > 95.0 ? 7.0 : 6.0);
  }
  workpiece.part = std::make_shared<const TurnedPart>(TurnedPart::of(std::move(profile), {}, 0.1));
  return workpiece;
}

std::string whyNoThread(const WorkpieceSnapshot& workpiece, const ThreadAsked& asked) {
  const auto pass = threadPass(workpiece, askedValues(asked));
  if (pass || pass.error().code != ErrorCode::ElementMalformed || pass.error().arguments.front() != "thread") return {};
  return pass.error().arguments.at(1);
}

}  // namespace

// A thread that is cut at once, by its sizes.
class ThreadOperationTest : public QObject {
  Q_OBJECT

 private slots:
  // M40 × 1.5: the minor diameter at the rounded root is d3 = d - 1.22687 P (DIN 13-1; ISO 68-1 with R = H/6), here
  // 38.160 mm. From the upper end to the lower one, at the heights of the part, which begins at Z 10.
  void anOuterMetricThread() {
    const auto pass = threadPass(barToThread(), askedValues({}));
    QVERIFY(pass.hasValue());
    QVERIFY(pass->side == TurningSide::Outside && !pass->isOfProgram && pass->isOfCommand && !pass->tool);
    const std::vector<ThreadGroove> grooves = ThreadGroove::of(*pass);
    QCOMPARE(grooves.size(), std::size_t{1});
    QVERIFY(std::abs(2.0 * grooves.front().deepest() - (40.0 - 1.22687 * 1.5)) < 1e-4);
    QVERIFY(std::abs(grooves.front().noseRadius() - 0.14434 * 1.5) < 1e-4);  // H/6
    QCOMPARE(grooves.front().from(), 50.0);
    QCOMPARE(grooves.front().to(), 80.0);
    QCOMPARE(pass->times.size(), pass->path.size());
    QVERIFY(*pass->thread == (ThreadCut{.pitch = 1.5, .offset = 80.0}));
  }

  // A nut for M14 has the minor diameter D1 = D - 1.08253 P, so a bore of ⌀12 and a pitch of 1.5 end at 13.624 mm, with
  // a flat root of P/8.
  void anInnerMetricThread() {
    const auto pass = threadPass(turnedAndBored(), askedValues({.isInside = true}));
    QVERIFY(pass.hasValue());
    QVERIFY(pass->side == TurningSide::Bore);
    QCOMPARE(pass->noseRadius, 0.0);
    QCOMPARE(pass->thread->flat, 1.5 / 8.0);
    const std::vector<ThreadGroove> grooves = ThreadGroove::of(*pass);
    QVERIFY(!grooves.empty() && std::abs(2.0 * grooves.front().deepest() - (12.0 + 1.08253 * 1.5)) < 1e-4);
  }

  // The depth counts from the present surface: outside the largest radius of the range, in the bore the least.
  void theDepthCountsFromTheSurface() {
    const auto deepestOf = [](const ThreadAsked& asked) {
      const auto pass = threadPass(turnedAndBored(), askedValues(asked));
      return pass ? ThreadGroove::of(*pass).front().deepest() : -1.0;
    };
    QVERIFY(std::abs(deepestOf({.from = 65.0, .to = 90.0, .depth = 0.7}) - 14.3) < 1e-9);
    QVERIFY(std::abs(deepestOf({.from = 65.0, .to = 109.0, .depth = 0.7}) - 14.3) < 1e-9);
    QVERIFY(std::abs(deepestOf({.from = 106.0, .to = 109.0, .depth = 0.7}) - 13.3) < 1e-9);
    QVERIFY(std::abs(deepestOf({.from = 65.0, .to = 109.0, .depth = 0.7, .isInside = true}) - 6.7) < 1e-9);
    QVERIFY(std::abs(deepestOf({.from = 106.0, .to = 109.0, .depth = 0.7, .isInside = true}) - 7.7) < 1e-9);
  }

  void startsAndHand() {
    const auto pass = threadPass(barToThread(), askedValues({.pitch = 2.0, .starts = 3.0, .isLeft = true}));
    QVERIFY(pass.hasValue() && pass->thread->isSound());
    QCOMPARE(pass->thread->lead(), 6.0);
    QCOMPARE(pass->thread->rise(), -6.0);
  }

  void whatCannotBeCutSaysWhy() {
    const WorkpieceSnapshot bar = barToThread(), part = turnedAndBored();
    QCOMPARE(whyNoThread(bar, {.from = 90.0, .to = 60.0}), std::string("its upper end is not above the lower one"));
    QCOMPARE(whyNoThread(bar, {.from = 60.0, .to = 60.0}), std::string("its upper end is not above the lower one"));
    QCOMPARE(whyNoThread(bar, {.from = 110.5, .to = 120.0}), std::string("it is beside the part"));
    QCOMPARE(whyNoThread(bar, {.from = 0.0, .to = 9.5}), std::string("it is beside the part"));
    QCOMPARE(whyNoThread(bar, {.pitch = 0.05}), std::string("it has more than 500 grooves"));  // 600
    QCOMPARE(whyNoThread(bar, {.isInside = true}), std::string("there is no bore all along it"));
    QCOMPARE(whyNoThread(part, {.from = 30.0, .to = 90.0, .isInside = true}),
             std::string("there is no bore all along it"));
    QCOMPARE(whyNoThread(bar, {.pitch = 30.0, .depth = 20.0}), std::string("it is deeper than the part is thick"));
  }

  // There is no surface in the gap of a part that was parted off, so a thread is refused.
  void aThreadInAGap() {
    WorkpieceSnapshot workpiece = barToThread();
    TurnedProfile profile(workpiece.stock, 0.05);
    for (std::size_t i = 0; i < profile.size(); ++i)
      if (profile.z(i) > 45.0 && profile.z(i) < 55.0) profile.limitOuter(i, 0.0);
    workpiece.part = std::make_shared<const TurnedPart>(TurnedPart::of(std::move(profile), {}, 0.1));
    QCOMPARE(whyNoThread(workpiece, {.from = 56.0, .to = 64.0}), std::string("there is no surface"));
    QVERIFY(threadPass(workpiece, askedValues({.from = 56.0, .to = 90.0})).hasValue());
  }

  // Values that no thread can have are not accepted by the operation.
  void limitsOfTheOptions() {
    OperationValues values(threadOperation());
    for (const auto& [id, wrong] : {std::pair("pitch", 0.04), std::pair("pitch", 101.0), std::pair("starts", 0.0),
                                    std::pair("starts", 65.0), std::pair("starts", 1.5), std::pair("depth", -0.1)})
      QVERIFY2(!values.set(id, wrong).empty(), id);
    QVERIFY(values == OperationValues(threadOperation()));
  }
};

HANDWHEEL_TEST(ThreadOperationTest)
#include "ThreadOperationTest.moc"
