// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "base/WorkBudget.h"

#include <QTest>
#include <thread>
#include <vector>

using namespace handwheel;

class WorkBudgetTest : public QObject {
  Q_OBJECT

 private slots:
  void isSpent();
  void none();
  void wholePaysForItsShares();
  void shareEndsWithTheWhole();
  void threadsGoNoFurther();
  void countsWhatGoesBeyond();
};

void WorkBudgetTest::isSpent() {
  WorkBudget effort(10);
  effort.spend(9);
  QVERIFY(!effort.isSpent());
  QCOMPARE(effort.left(), std::size_t{1});
  QCOMPARE(effort.shareSpent(), 0.9);
  effort.spend(5);
  QVERIFY(effort.isSpent());
  QCOMPARE(effort.spent(), std::size_t{10});
  QCOMPARE(effort.left(), std::size_t{0});
}

void WorkBudgetTest::none() {
  const WorkBudget none(0);
  QVERIFY(none.isSpent());
  QCOMPARE(none.shareSpent(), 1.0);
}

// The whole pays for the limit of a share, not for steps beyond that.
void WorkBudgetTest::wholePaysForItsShares() {
  WorkBudget whole(100);
  {
    WorkBudget share(30, whole);
    share.spend(20);
    QCOMPARE(whole.spent(), std::size_t{20});
    share.spend(20);
    QVERIFY(share.isSpent());
    share.spend(20);
  }
  QCOMPARE(whole.spent(), std::size_t{30});
  QCOMPARE(WorkBudget(90, whole).left(), std::size_t{70});
}

void WorkBudgetTest::shareEndsWithTheWhole() {
  WorkBudget whole(100);
  WorkBudget one(60, whole), other(60, whole);
  one.spend(60);
  QCOMPARE(other.left(), std::size_t{40});
  whole.spend(40);
  QVERIFY(other.isSpent());
}

void WorkBudgetTest::threadsGoNoFurther() {
  WorkBudget whole(100'000);
  WorkBudget share(5'000, whole);
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] {
      for (int k = 0; k < 3'000; ++k) share.spend(3);
    });
  }
  for (std::thread& thread : threads) thread.join();
  QCOMPARE(share.spent(), std::size_t{5'000});
  QCOMPARE(whole.spent(), std::size_t{5'000});
}

// Counts steps beyond a share, or beyond the whole.
void WorkBudgetTest::countsWhatGoesBeyond() {
  WorkBudget whole(100);
  {
    WorkBudget share(30, whole);
    share.spend(45);
    QCOMPARE(share.counted(), std::size_t{45});
  }
  whole.spend(90);
  QCOMPARE(whole.counted(), std::size_t{135});
  QCOMPARE(whole.spent(), std::size_t{100});
}

HANDWHEEL_TEST(WorkBudgetTest)
#include "WorkBudgetTest.moc"
