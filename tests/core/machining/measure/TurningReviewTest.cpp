// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/measure/TurningReview.h"

#include "TestClass.h"
#include "machining/finish/FinishReading.h"
#include "machining/force/ChipGrowth.h"

#include <QtTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

using namespace handwheel;

namespace {

constexpr StockCylinder kReviewedBar{40.0, 100.0, 0.0};
const ReviewedLathe kLathe{600.0, 30.0, 80.0, 1.0};

using PassPointer = std::shared_ptr<const TurningPass>;

// Along the axis at a radius, from one height to another, at a feed in mm per revolution of 600 r/min.
PassPointer along(double radius, double from, double to, double feed, double nose = 0.8) {
  TurningPass pass;
  pass.noseRadius = nose;
  pass.path = {{radius + nose, from}, {radius + nose, to}};
  pass.times = {0.0, std::abs(to - from) / feed / 10.0};
  return std::make_shared<const TurningPass>(pass);
}

std::optional<TurningReview> reviewOf(const std::vector<PassPointer>& passes, const ReviewedLathe& lathe = kLathe) {
  return TurningReview::make(TurnedProfile(kReviewedBar, 0.05), passes, lathe);
}

std::optional<FinishReading> finishOf(const TurningReview& review, TurningSide side, AxisRange range) {
  return readFinish(review.finish(), review.profile(), side, range);
}

}  // namespace

// The results of the passes for the work.
class TurningReviewTest : public QObject {
  Q_OBJECT

 private slots:
  // The finish is that of the last cut; where it does not reach, that of the one before.
  void finishOfTheLastCut() {
    const auto review = reviewOf({along(18, 105, 50, 0.4), along(17.5, 105, 70, 0.1)});
    QVERIFY(review.has_value());
    const auto fine = finishOf(*review, TurningSide::Outside, {75, 95});
    QVERIFY(fine && std::abs(fine->roughness - 1000.0 * 0.01 / 25.6) < 1e-9 &&
            std::abs(fine->largest - fine->roughness) < 1e-9);
    const auto rough = finishOf(*review, TurningSide::Outside, {52, 65});
    QVERIFY(rough && std::abs(rough->roughness - 1000.0 * 0.16 / 25.6) < 1e-9);
    QVERIFY(!finishOf(*review, TurningSide::Outside, {40, 65}));  // the bar is there still
    QVERIFY(!finishOf(*review, TurningSide::Bore, {75, 95}));
    QVERIFY(!finishOf(*review, TurningSide::Outside, {95, 75}));
    QVERIFY(std::abs(review->seconds() - (55 / 4.0 + 35 / 1.0)) < 1e-9);
    QVERIFY(std::abs(review->pathLength() - 90.0) < 1e-9);
    QVERIFY(review->crashes().empty());
  }

  void depthFeedAndSpeed() {
    const auto review = reviewOf({along(18, 100, 50, 0.4)});
    QVERIFY(review && !review->moments().empty());
    const CutMoment& cut = review->moments().front();
    // 2 mm over 50 mm, and the cut of the nose beyond its centre.
    QVERIFY(cut.depth >= 2.0 && cut.depth < 2.0 + 0.8 * 2.0 / 50.0 && std::abs(cut.feed - 0.4) < 1e-9);
    QVERIFY(std::abs(cut.speed - M_PI * 40.0 * 600.0 / 1000.0) < 1e-9);
    // Facing 1 mm off is as deep as longitudinal turning of 1 mm, whatever the radius is.
    TurningPass facing;
    facing.noseRadius = 0.5;  // width of the faced material
    facing.path = {{20.5, 99.5}, {0.0, 99.5}};
    facing.times = {0.0, 10.0};
    const auto faced = reviewOf({std::make_shared<const TurningPass>(facing)});
    QVERIFY(faced && !faced->moments().empty() && std::abs(faced->moments().front().depth - 1.0) < 0.05);
  }

  // Whoever touches the face goes fast, but not far: the chip is no thicker than the 0.02 mm that the edge has gone in
  // the material, and the cut no deeper than the 1.4 mm that the bar stands over the nose there.
  void aTouchIsNoHeavyCut() {
    TurningPass touch;
    touch.noseRadius = 0.8;
    touch.path = {{18.8, 105.0}, {18.8, 100.81}, {18.8, 100.79}};
    touch.times = {0.0, 0.419, 0.421};  // 1 mm per revolution of 600 r/min
    const auto review = reviewOf({std::make_shared<const TurningPass>(touch)});
    QVERIFY(review.has_value());
    QCOMPARE(review->moments().size(), std::size_t{1});
    const CutMoment& cut = review->moments().front();
    QVERIFY(std::abs(cut.feed - 1.0) < 1e-6 && std::abs(cut.chip - 0.02) < 1e-6);
    QVERIFY2(cut.depth > 1.0 && cut.depth < 1.4, qPrintable(QString::number(cut.depth)));
    const CutMoment steady = reviewOf({along(18, 105, 50, 0.4)})->moments().front();
    QVERIFY(std::abs(steady.chip - steady.feed) < 1e-12);
  }

  // By its first turn in the material a chip is as thick as the feed; after a pause it begins anew.
  void aChipGrowsForATurn() {
    ChipGrowth chip;
    for (int i = 0; i < 10; ++i) chip.add(0.01, 0.05);
    QVERIFY(std::abs(chip.thickness() - 0.1) < 1e-12);
    for (int i = 0; i < 30; ++i) chip.add(0.01, 0.05);
    QVERIFY(std::abs(chip.thickness() - 0.2) < 1e-12);
    chip.add(std::nan(""), 1.0);
    chip.add(1.0, std::numeric_limits<double>::infinity());
    QVERIFY(std::abs(chip.thickness() - 0.2) < 1e-12);
    chip.add(0.0, 5.0);
    QCOMPARE(chip.thickness(), 0.0);
    chip.add(0.3, 3.0);
    QVERIFY(std::abs(chip.thickness() - 0.1) < 1e-12);
    chip.end();
    QCOMPARE(chip.thickness(), 0.0);
  }

  // Each time that the tool enters the jaws counts, with the position and the time.
  void theChuckAndRapidMoves() {
    TurningPass twice;
    twice.noseRadius = 0.8;
    twice.path = {{45, 60}, {25, 60}, {25, 20}, {25, 50}, {25, 25}};
    twice.times = {0, 10, 50, 80, 105};
    const auto review = reviewOf({std::make_shared<const TurningPass>(twice)});
    QVERIFY(review && review->crashes().size() == 2);
    QVERIFY(review->crashes()[0].what == CrashMoment::What::Chuck && review->crashes()[0].time == 50.0);
    QCOMPARE(review->crashes()[1].time, 105.0);
    QVERIFY(reviewOf({std::make_shared<const TurningPass>(twice)}, {600.0, 0.0, 80.0, 1.0})->crashes().empty());

    const auto rapid = reviewOf({along(18, 105, 50, 3.0)});
    QVERIFY(rapid && rapid->crashes().size() == 1 && rapid->crashes()[0].what == CrashMoment::What::RapidInMaterial);
    QVERIFY(reviewOf({along(22, 105, 50, 3.0)})->crashes().empty());  // in the air
  }

  // A tool that is wound back at the same X over a shaft that has sprung back by 0.3 µm is not rammed into anything; 3
  // µm are.
  void touchingIsNoCrash() {
    for (const double sprung : {3e-4, 3e-3}) {
      TurningPass back = *along(18.0 - sprung, 50, 105, 8.0);
      const auto review = reviewOf({along(18, 105, 50, 0.1), std::make_shared<const TurningPass>(std::move(back))});
      QCOMPARE(review->crashes().size(), sprung > TurningPass::kTouch ? std::size_t{1} : std::size_t{0});
      const auto finish = finishOf(*review, TurningSide::Outside, {60, 95});
      QCOMPARE(std::isfinite(finish->roughness), sprung < TurningPass::kTouch);
    }
  }

  // The largest feed itself is allowed, in any direction; rounding and a path that yields do not make it more.
  void theLargestFeedIsAllowed() {
    const auto into = [](double feed) {
      TurningPass pass;
      pass.noseRadius = 0.8;
      for (int i = 0; i <= 3000; ++i) {
        const double distance = 0.002 * i;
        pass.path.emplace_back(20.6 - distance * std::sqrt(0.5), 80.0 - distance * std::sqrt(0.5));
        pass.times.push_back(distance / (feed * 10.0));
      }
      return std::make_shared<const TurningPass>(pass);
    };
    QVERIFY(reviewOf({into(kLathe.largestFeed)})->crashes().empty());
    QVERIFY(reviewOf({into(1.005 * kLathe.largestFeed)})->crashes().empty());
    QCOMPARE(reviewOf({into(1.05 * kLathe.largestFeed)})->crashes().size(), std::size_t{1});
  }

  // Pushed into work that does not turn the tool crashes; it cuts no chip there whose force could be known.
  void workAtRestIsNotCut() {
    TurningPass pass = *along(18, 105, 50, 0.4);
    pass.speeds.assign(pass.path.size(), 0.0);
    const auto review = reviewOf({std::make_shared<const TurningPass>(pass)});
    QCOMPARE(review->crashes().size(), std::size_t{1});
    QVERIFY(review->moments().empty());
  }

  // A steady hand whose points come in pairs, two at once, feeds by its travel in a revolution.
  void feedOfAHand() {
    TurningPass pass;
    pass.noseRadius = 0.8;
    for (int i = 0; i <= 4000; ++i) {  // 1 mm/s at 10 revolutions a second
      pass.path.emplace_back(18.8, 105.0 - 0.01 * i);
      pass.times.push_back(0.02 * (i / 2) + (i % 2 == 1 ? 1e-6 : 0.0));
    }
    const auto review = reviewOf({std::make_shared<const TurningPass>(pass)});
    QVERIFY(review && review->crashes().empty());
    const auto finish = finishOf(*review, TurningSide::Outside, {70, 95});
    QVERIFY(finish && std::abs(finish->largest / (1000.0 * 0.01 / 25.6) - 1.0) < 0.5);  // f within a tenth, two points
    QVERIFY(std::abs(finish->roughness / (1000.0 * 0.01 / 25.6) - 1.0) < 0.25);
  }

  // The actual spindle speed counts, not that of the task: 0.12 mm per revolution at 2000 r/min is f²/32R = 0.5625 µm.
  void theSpindleSpeedOfThePass() {
    TurningPass fast = *along(18, 105, 50, 0.4);  // 4 mm/s
    fast.speeds.assign(fast.path.size(), 2000.0);
    const auto review = reviewOf({std::make_shared<const TurningPass>(fast)});
    const auto finish = finishOf(*review, TurningSide::Outside, {60, 95});
    QVERIFY(finish && std::abs(finish->roughness - 1000.0 * 0.12 * 0.12 / 25.6) < 1e-9);
    QVERIFY(std::abs(review->moments().front().feed - 0.12) < 1e-9);
    QVERIFY(std::abs(review->moments().front().speed - M_PI * 40.0 * 2000.0 / 1000.0) < 1e-9);
    TurningPass slow = fast;  // at 150 r/min that is 1.6 mm per revolution: rammed in
    slow.speeds.assign(slow.path.size(), 150.0);
    QCOMPARE(reviewOf({std::make_shared<const TurningPass>(slow)})->crashes().size(), std::size_t{1});
    QVERIFY(review->crashes().empty());
    auto thread = std::make_shared<LatheTool>();
    thread->kind = LatheToolKind::Threading;
    const std::array<ProfilePoint, 3> edge{{{0.0, 0.0}, {2.0, -1.0}, {2.0, 1.0}}};
    thread->cutting = {RoundedPolygon(edge, 0.0)};
    slow.tool = thread;  // at its pitch
    QVERIFY(reviewOf({std::make_shared<const TurningPass>(slow)})->crashes().empty());
  }

  // Half of the surface is rough: then it is rough. A twentieth is a mark that ISO 4288 lets pass.
  void aSixthMayBeRougher() {
    const double fine = 1000.0 * 0.01 / 25.6, rough = 1000.0 * 0.16 / 25.6;
    const auto half = reviewOf({along(18, 105, 75, 0.1), along(18, 75, 50, 0.4)});
    QVERIFY(std::abs(finishOf(*half, TurningSide::Outside, {55, 95})->roughness - rough) < 1e-9);
    const auto twentieth = finishOf(*half, TurningSide::Outside, {73, 95});
    QVERIFY(std::abs(twentieth->roughness - fine) < 1e-9 && std::abs(twentieth->largest - rough) < 1e-9);
  }

  // Paper that takes off 4 µm lowers Ra by 1 µm; no paper is finer than its grain.
  void abrasivesSmooth() {
    auto paper = std::make_shared<LatheTool>();
    paper->kind = LatheToolKind::AbrasivePaper;
    paper->depthPerTurn = 0.01;
    paper->leastRoughness = 0.4;
    const std::array<ProfilePoint, 4> block{{{0.0, -5.0}, {0.0, 5.0}, {5.0, -5.0}, {5.0, 5.0}}};
    paper->cutting = {RoundedPolygon(block, 0.0)};
    const auto polished = [&](double radius) {
      TurningPass pass;
      pass.tool = paper;
      pass.path = {{radius, 90}, {radius, 70}};
      pass.times = {0.0, 10.0};
      const auto review = reviewOf({along(18, 105, 50, 0.4), std::make_shared<const TurningPass>(pass)});
      return finishOf(*review, TurningSide::Outside, {75, 85})->roughness;
    };
    QVERIFY(std::abs(polished(17.996) - (6.25 - 1.0)) < 1e-6);
    QVERIFY(std::abs(polished(17.9) - 0.4) < 1e-6);
  }

  void theSamePartAsTheWorkpiece() {
    const std::vector<PassPointer> passes{along(18, 105, 50, 0.4), along(17.5, 105, 70, 0.1)};
    TurnedProfile expected(kReviewedBar, 0.05);
    for (const auto& pass : passes) cut(expected, *pass);
    QVERIFY(reviewOf(passes)->profile() == expected);
    QVERIFY(reviewOf({})->profile() == TurnedProfile(kReviewedBar, 0.05));
    QCOMPARE(reviewOf({})->seconds(), 0.0);
  }

  // 22 passes of 200 cuts are more than are kept. Of two neighbours the heavier stays: so does the one cut, first of
  // its pair or second, that asked for ten times the speed of all others, at the 40 mm that the bar has.
  void manyMomentsAreJoined() {
    for (const int heavy : {100, 101}) {
      std::vector<PassPointer> passes;
      for (int number = 1; number <= 22; ++number) {
        TurningPass pass;
        pass.noseRadius = 0.8;
        for (int i = 0; i <= 200; ++i) {
          pass.path.emplace_back(20.8 - 0.25 * number, 100.0 - 0.5 * i);
          pass.times.push_back(0.2 * i);
          pass.askedSpeeds.push_back(number == 1 && i == heavy ? 6000.0 : 600.0);
        }
        passes.push_back(std::make_shared<const TurningPass>(pass));
      }
      const auto review = reviewOf(passes, {600.0, 0.0, 80.0, 1.0});
      const std::vector<CutMoment>& moments = review->moments();
      QVERIFY(moments.size() >= TurningReview::kMostMoments && moments.size() < 2 * TurningReview::kMostMoments);
      for (std::size_t i = 1; i < moments.size(); ++i) QVERIFY(moments[i].time > moments[i - 1].time);
      const auto most = std::max_element(moments.begin(), moments.end(),
                                         [](const CutMoment& a, const CutMoment& b) { return a.asked < b.asked; });
      QVERIFY(std::abs(most->asked - M_PI * 40.0 * 6000.0 / 1000.0) < 1e-6);
      QVERIFY(std::abs(most->time - 0.2 * heavy) < 1e-9);
    }
  }

  void extremes() {
    const auto still = reviewOf({along(18, 105, 50, 0.4)}, {0.0, 30.0, 80.0, 1.0});  // the spindle stands
    QVERIFY(still && !still->crashes().empty());
    TurningPass odd;
    odd.path = {{std::nan(""), 50}, {10, std::numeric_limits<double>::infinity()}, {10, 50}};
    odd.times = {0, 0, 0};
    QVERIFY(reviewOf({std::make_shared<const TurningPass>(odd)}).has_value());
    TurningPass endless;  // each move goes over the whole bar
    endless.path.assign(3'000'000, {10, 0});
    for (std::size_t i = 0; i < endless.path.size(); i += 2) endless.path[i].y() = 100;
    endless.times.assign(3'000'000, 0.0);
    QVERIFY(!reviewOf({std::make_shared<const TurningPass>(endless)}).has_value());
    JobState job;
    job.cancelled = true;
    QVERIFY(!TurningReview::make(TurnedProfile(kReviewedBar, 0.05), std::vector{along(18, 105, 50, 0.4)}, kLathe,
                                 Progress(job)));
  }
};

HANDWHEEL_TEST(TurningReviewTest)
#include "TurningReviewTest.moc"
