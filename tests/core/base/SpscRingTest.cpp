// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "base/SpscRing.h"

#include <rapidcheck.h>
#include <QtTest>
#include <deque>
#include <thread>

using namespace handwheel;

class SpscRingTest : public QObject {
  Q_OBJECT

 private slots:
  void isABoundedQueue() {
    QVERIFY(rc::check("as a deque", [] {
      SpscRing<int> ring(*rc::gen::inRange<std::size_t>(1, 20));
      std::deque<int> queue;
      std::uint64_t dropped = 0;
      for (int i = 0; i < 200; ++i) {
        if (*rc::gen::inRange(0, 2)) {
          const bool hasRoom = queue.size() < ring.capacity();
          RC_ASSERT(ring.push(i) == hasRoom);
          if (hasRoom) queue.push_back(i);
          if (!hasRoom) ++dropped;
        } else {
          int value = -1;
          RC_ASSERT(ring.pop(value) == !queue.empty());
          if (queue.empty()) continue;
          RC_ASSERT(value == queue.front());
          queue.pop_front();
        }
      }
      RC_ASSERT(ring.dropped() == dropped);
    }));
  }

  void capacityIsRoundedUp() {
    QCOMPARE(SpscRing<int>(1).capacity(), std::size_t{1});
    QCOMPARE(SpscRing<int>(5).capacity(), std::size_t{8});
  }

  // Every value that was not refused arrives once, complete and in order.
  void twoThreads() {
    struct Wide {
      std::uint64_t a = 0, b = 0, c = 0;
    };
    SpscRing<Wide> ring(64);
    const std::uint64_t count = 20'000;
    std::thread writer([&] {
      for (std::uint64_t i = 1; i <= count;) {
        if (ring.push({i, 2 * i, 3 * i}))
          ++i;
        else
          std::this_thread::yield();
      }
    });
    bool isRight = true;
    std::uint64_t next = 1;
    for (Wide value; next <= count;) {
      if (!ring.pop(value)) {
        std::this_thread::yield();
        continue;
      }
      isRight &= value.a == next && value.b == 2 * next && value.c == 3 * next;
      ++next;
    }
    writer.join();
    QVERIFY(isRight);
  }
};

HANDWHEEL_TEST(SpscRingTest)
#include "SpscRingTest.moc"
