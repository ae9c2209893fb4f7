// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "haptics/servo/SnapshotSlot.h"

#include <QtTest>
#include <atomic>
#include <thread>

using namespace handwheel;

namespace {

std::atomic<int> alive{0};

// An object that records whether it was freed, and has its number twice, so that half a value would show.
struct Counted {
  explicit Counted(int n) : number(n), again(n) { ++alive; }
  ~Counted() {
    number = -1;
    --alive;
  }
  int number;
  int again;
};

}  // namespace

class SnapshotSlotTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { QCOMPARE(alive.load(), 0); }

  void handsOverTheNewestAndThePrevious() {
    SnapshotSlot<Counted> slot;
    QCOMPARE(slot.take().current, nullptr);
    slot.publish(std::make_unique<Counted>(1));
    slot.publish(std::make_unique<Counted>(2));  // the first was never taken
    QCOMPARE(alive.load(), 1);
    auto taken = slot.take();
    QVERIFY(taken.isNew);
    QCOMPARE(taken.current->number, 2);
    QCOMPARE(taken.previous, nullptr);
    taken = slot.take();
    QVERIFY(!taken.isNew);
    QCOMPARE(taken.current->number, 2);

    slot.publish(std::make_unique<Counted>(3));
    taken = slot.take();
    QVERIFY(taken.isNew);
    QCOMPARE(taken.current->number, 3);
    QCOMPARE(taken.previous->number, 2);
  }

  // The previous snapshot lives through the tick that took the new one, and is freed by the thread that made it.
  void whatIsLeftIsFreedByTheMaker() {
    {
      SnapshotSlot<Counted> slot;
      slot.publish(std::make_unique<Counted>(1));
      slot.take();
      slot.publish(std::make_unique<Counted>(2));
      slot.take();
      QVERIFY(!slot.collect());
      QCOMPARE(alive.load(), 2);
      slot.take();
      QCOMPARE(alive.load(), 2);
      QVERIFY(slot.collect());
      QCOMPARE(alive.load(), 1);
      slot.publish(std::make_unique<Counted>(3));
    }
    QCOMPARE(alive.load(), 0);
  }

  // Nobody collects: the taker keeps its snapshot and never loses the newest.
  void withoutCollectingTheNewestStillArrives() {
    SnapshotSlot<Counted> slot;
    for (int i = 1; i <= 10; ++i) {
      slot.publish(std::make_unique<Counted>(i));
      slot.take();
      slot.take();
      QCOMPARE(slot.take().current->number, i);
    }
    QVERIFY(alive.load() <= 3);
  }

  void twoThreads() {
    {
      SnapshotSlot<Counted> slot;
      std::atomic<bool> isDone{false};
      int last = 0;
      bool isOrdered = true, isWhole = true;
      std::thread taker([&] {
        bool isLast = false;
        while (!isLast) {
          isLast = isDone.load();
          const auto taken = slot.take();
          if (!taken.current) continue;
          isWhole &= taken.current->number == taken.current->again && taken.current->number > 0;
          if (taken.previous) isWhole &= taken.previous->number > 0;
          isOrdered &= taken.current->number >= last;
          last = taken.current->number;
        }
        slot.take();
        last = slot.take().current->number;
      });
      const int count = 100'000;
      for (int i = 1; i <= count; ++i) slot.publish(std::make_unique<Counted>(i));
      slot.collect();
      isDone.store(true);
      taker.join();
      QVERIFY(isOrdered);
      QVERIFY(isWhole);
      QCOMPARE(last, count);
    }
    QCOMPARE(alive.load(), 0);
  }
};

HANDWHEEL_TEST(SnapshotSlotTest)
#include "SnapshotSlotTest.moc"
