// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/Latest.h"

#include <QtTest>
#include <thread>

using namespace handwheel;

class LatestTest : public QObject {
  Q_OBJECT

 private slots:
  void theNewestIsTakenAndStays() {
    Latest<int> latest;
    QCOMPARE(latest.take(), 0);
    for (int i = 1; i <= 5; ++i) latest.publish(i);
    QCOMPARE(latest.take(), 5);
    QCOMPARE(latest.take(), 5);
    latest.publish(6);
    QCOMPARE(latest.take(), 6);
  }

  // Between two threads: never half of one value, and never an older one after a newer.
  void valuesAreWholeAndInOrder() {
    struct Wide {
      std::array<std::uint64_t, 32> words{};
    };
    constexpr std::uint64_t kLast = 200'000;
    Latest<Wide> latest;
    std::thread publisher([&] {
      for (std::uint64_t i = 1; i <= kLast; ++i) {
        Wide wide;
        wide.words.fill(i);
        latest.publish(wide);
      }
    });
    bool whole = true;
    bool ordered = true;
    for (std::uint64_t seen = 0; seen != kLast && whole && ordered;) {
      const Wide& wide = latest.take();
      for (const std::uint64_t word : wide.words) whole &= word == wide.words[0];
      ordered &= wide.words[0] >= seen;
      seen = wide.words[0];
    }
    publisher.join();
    QVERIFY(whole);
    QVERIFY(ordered);
  }
};

QTEST_GUILESS_MAIN(LatestTest)
#include "LatestTest.moc"
