// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "base/JobClock.h"
#include "base/Progress.h"

#include <QTest>

using namespace handwheel;

class ProgressTest : public QObject {
  Q_OBJECT

 private slots:
  void unwatched();
  void partsOfParts();
  void cancelReachesEveryPart();
  void givenUpWhenTheEffortIsSpent();
  void measuredByTheEffort();
  void sharesOfTheEffort();
  void theTimeStandsStillWithoutPolls();
};

void ProgressTest::unwatched() {
  const Progress progress;
  progress.set(0.5);
  QVERIFY(!progress.part(0.1, 0.2).cancelled());
}

void ProgressTest::partsOfParts() {
  JobState job;
  const Progress whole(job);
  whole.set(0.25);
  QCOMPARE(job.fraction.load(), 0.25);
  const Progress half = whole.part(0.5, 1.0);
  half.set(0.0);
  QCOMPARE(job.fraction.load(), 0.5);
  half.part(0.5, 1.0).set(0.5);
  QCOMPARE(job.fraction.load(), 0.875);
  half.set(1.0);
  QCOMPARE(job.fraction.load(), 1.0);
}

void ProgressTest::cancelReachesEveryPart() {
  JobState job;
  const Progress part = Progress(job).part(0.2, 0.3).part(0.0, 0.5);
  QVERIFY(!part.cancelled());
  job.cancelled = true;
  QVERIFY(part.cancelled());
}

void ProgressTest::givenUpWhenTheEffortIsSpent() {
  JobState job;
  WorkBudget effort(5);
  const Progress whole(job), limited = whole.part(0.5, 1.0).within(effort);
  limited.spend(4);
  QVERIFY(!limited.cancelled());
  limited.spend(1);
  QVERIFY(limited.cancelled() && limited.part(0.0, 0.5).cancelled());
  QVERIFY(!whole.cancelled());
  QVERIFY(!limited.unlimited().cancelled());
  job.cancelled = true;
  QVERIFY(limited.unlimited().cancelled());
}

void ProgressTest::measuredByTheEffort() {
  JobState job;
  WorkBudget effort(16), share(8, effort);
  const Progress measured = Progress(job).part(0.5, 1.0).measuredBy(effort);
  measured.spend(4);
  QCOMPARE(job.fraction.load(), 0.75);
  measured.set(1.0);
  measured.part(0.0, 0.1).set(0.0);
  QCOMPARE(job.fraction.load(), 0.75);
  measured.within(share).spend(5);
  QCOMPARE(job.fraction.load(), 0.875);
}

void ProgressTest::sharesOfTheEffort() {
  WorkBudget effort(8);
  QCOMPARE(Progress().share(20).left(), std::size_t{20});
  QCOMPARE(Progress().within(effort).share(20).left(), std::size_t{8});
}

void ProgressTest::theTimeStandsStillWithoutPolls() {
  using std::chrono::seconds;
  JobState job;
  JobClock clock;
  const auto start = JobClock::Clock::now();
  QCOMPARE(clock.seconds(job, start + seconds(2)), 0);
  QVERIFY(!Progress(job).cancelled());
  QVERIFY(clock.seconds(job, start + seconds(65)) >= 64);
  QCOMPARE(clock.seconds(job, start + seconds(90)), clock.seconds(job, start + seconds(70)));
  QCOMPARE(elapsedText(2), std::string());
  QCOMPARE(elapsedText(65), std::string("1:05"));
}

HANDWHEEL_TEST(ProgressTest)

#include "ProgressTest.moc"
