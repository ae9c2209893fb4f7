// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "base/TripleBuffer.h"

#include <QtTest>
#include <thread>

using namespace handwheel;

class TripleBufferTest : public QObject {
  Q_OBJECT

 private slots:
  void readsTheNewest() {
    TripleBuffer<int> buffer(7);
    QCOMPARE(buffer.read(), 7);
    for (int i = 0; i < 10; ++i) {
      for (int k = 0; k <= i; ++k) buffer.write(10 * i + k);
      QCOMPARE(buffer.read(), 11 * i);
      QCOMPARE(buffer.read(), 11 * i);
    }
  }

  // Never half a value, never an older one than before, and the last one arrives.
  void twoThreads() {
    struct Wide {
      std::uint64_t a = 0, b = 0, c = 0;
    };
    TripleBuffer<Wide> buffer;
    const std::uint64_t count = 200'000;
    std::thread writer([&] {
      for (std::uint64_t i = 1; i <= count; ++i) buffer.write({i, 2 * i, 3 * i});
    });
    bool isWhole = true, isOrdered = true;
    for (std::uint64_t last = 0; last < count;) {
      const Wide value = buffer.read();
      isWhole &= value.b == 2 * value.a && value.c == 3 * value.a;
      isOrdered &= value.a >= last;
      last = value.a;
    }
    writer.join();
    QVERIFY(isWhole);
    QVERIFY(isOrdered);
  }
};

HANDWHEEL_TEST(TripleBufferTest)
#include "TripleBufferTest.moc"
