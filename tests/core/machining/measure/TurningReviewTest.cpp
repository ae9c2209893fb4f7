// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/measure/TurningReview.h"

#include "TestClass.h"

#include <QtTest>
#include <cmath>
#include <limits>

using namespace handwheel;

namespace {

constexpr StockCylinder kBar{40.0, 100.0, 0.0};
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
  return TurningReview::make(TurnedProfile(kBar, 0.05), passes, lathe);
}

}  // namespace

// What the passes tell about the work.
class TurningReviewTest : public QObject {
  Q_OBJECT

 private slots:
  // The finish is that of the last cut; where it does not reach, that of the one before.
  void finishOfTheLastCut() {
    const auto review = reviewOf({along(18, 105, 50, 0.4), along(17.5, 105, 70, 0.1)});
    QVERIFY(review.has_value());
    const auto fine = review->finish(TurningSide::Outside, {75, 95});
    QVERIFY(fine && std::abs(fine->mean - 1000.0 * 0.01 / 25.6) < 1e-9 && std::abs(fine->largest - fine->mean) < 1e-9);
    const auto rough = review->finish(TurningSide::Outside, {52, 65});
    QVERIFY(rough && std::abs(rough->mean - 1000.0 * 0.16 / 25.6) < 1e-9);
    QVERIFY(!review->finish(TurningSide::Outside, {40, 65}));  // the bar is there still
    QVERIFY(!review->finish(TurningSide::Bore, {75, 95}));
    QVERIFY(!review->finish(TurningSide::Outside, {95, 75}));
    QVERIFY(std::abs(review->seconds() - (55 / 4.0 + 35 / 1.0)) < 1e-9);
    QVERIFY(std::abs(review->pathLength() - 90.0) < 1e-9);
    QVERIFY(review->crashes().empty());
  }

  void depthFeedAndSpeed() {
    const auto review = reviewOf({along(18, 100, 50, 0.4)});
    QVERIFY(review && !review->moments().empty());
    const CutMoment& cut = review->moments().front();
    // 2 mm over 50 mm, and what the nose takes beyond its centre.
    QVERIFY(cut.depth >= 2.0 && cut.depth < 2.0 + 0.8 * 2.0 / 50.0 && std::abs(cut.feed - 0.4) < 1e-9);
    QVERIFY(std::abs(cut.speed - M_PI * 40.0 * 600.0 / 1000.0) < 1e-9);
    // Facing 1 mm off is as deep as longitudinal turning of 1 mm, whatever the radius is.
    TurningPass facing;
    facing.noseRadius = 0.5;  // as wide as what is faced off
    facing.path = {{20.5, 99.5}, {0.0, 99.5}};
    facing.times = {0.0, 10.0};
    const auto faced = reviewOf({std::make_shared<const TurningPass>(facing)});
    QVERIFY(faced && !faced->moments().empty() && std::abs(faced->moments().front().depth - 1.0) < 0.05);
  }

  // Each time that the tool comes into the jaws counts, with the place and the moment.
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

  void theSamePartAsTheWorkpiece() {
    const std::vector<PassPointer> passes{along(18, 105, 50, 0.4), along(17.5, 105, 70, 0.1)};
    TurnedProfile expected(kBar, 0.05);
    for (const auto& pass : passes) cut(expected, *pass);
    QVERIFY(reviewOf(passes)->profile() == expected);
    QVERIFY(reviewOf({})->profile() == TurnedProfile(kBar, 0.05));
    QCOMPARE(reviewOf({})->seconds(), 0.0);
  }

  void manyMomentsAreJoined() {
    TurningPass pass;
    for (int i = 0; i < 20'000; ++i) {
      pass.path.emplace_back(20.0, 100.0 - 0.003 * i);
      pass.times.push_back(0.01 * i);
    }
    const auto review = reviewOf({std::make_shared<const TurningPass>(pass)});
    QVERIFY(review && review->moments().size() < 2 * TurningReview::kMostMoments);
    for (std::size_t i = 1; i < review->moments().size(); ++i)
      QVERIFY(review->moments()[i].time > review->moments()[i - 1].time);
  }

  void extremes() {
    const auto still = reviewOf({along(18, 105, 50, 0.4)}, {0.0, 30.0, 80.0, 1.0});  // the spindle stands
    QVERIFY(still && !still->crashes().empty());
    TurningPass odd;
    odd.path = {{std::nan(""), 50}, {10, std::numeric_limits<double>::infinity()}, {10, 50}};
    odd.times = {0, 0, 0};
    QVERIFY(reviewOf({std::make_shared<const TurningPass>(odd)}).has_value());
    TurningPass endless;  // each move goes over the whole bar
    endless.path.assign(300'000, {10, 0});
    for (std::size_t i = 0; i < endless.path.size(); i += 2) endless.path[i].y() = 100;
    endless.times.assign(300'000, 0.0);
    QVERIFY(!reviewOf({std::make_shared<const TurningPass>(endless)}).has_value());
    JobState job;
    job.cancelled = true;
    QVERIFY(
        !TurningReview::make(TurnedProfile(kBar, 0.05), std::vector{along(18, 105, 50, 0.4)}, kLathe, Progress(job)));
  }
};

HANDWHEEL_TEST(TurningReviewTest)
#include "TurningReviewTest.moc"
