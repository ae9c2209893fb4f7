// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "document/container/Blobs.h"

#include <rapidcheck.h>
#include <QTest>
#include <numeric>

using namespace handwheel;

namespace {

std::vector<std::uint32_t> numbersTo(std::size_t count) {
  std::vector<std::uint32_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 1u);
  return numbers;
}

using Ranges = std::vector<IndexRange>;

}  // namespace

class ContainerBlobsTest : public QObject {
  Q_OBJECT

 private slots:
  void chunks() {
    Container container;
    writeArray<std::uint32_t>(container, "mesh/faces", numbersTo(3 * 65'537), 3);
    QCOMPARE(container.blobs.size(), std::size_t{2});
    QCOMPARE(container.blobs.at("mesh/faces/0000").size(), std::size_t{12 * 65'536});
    QCOMPARE(container.blobs.at("mesh/faces/0001").size(), std::size_t{12});
    const auto read = readArray<std::uint32_t>(container, "mesh/faces", 65'537, 3);
    QVERIFY(read.values == numbersTo(3 * 65'537));
    QVERIFY(read.lost.empty());
  }

  // Chunks are removed; the values of the others are unchanged, and the lost ranges are exactly the gaps.
  void lostChunks() {
    QVERIFY(rc::check([] {
      const auto count = *rc::gen::inRange<std::size_t>(0, 5 * kChunkElements);
      const std::vector<std::uint32_t> numbers = numbersTo(count);
      Container container;
      writeArray<std::uint32_t>(container, "a", numbers);
      container.blobs["a/9999x"] = container.blobs["a/17"] = container.blobs["a/000"] = "foreign";
      std::vector<bool> isLost(count, false);
      for (std::size_t i = 0; i * kChunkElements < count; ++i) {
        const std::string name = "a/000" + std::to_string(i);
        const int fate = *rc::gen::inRange(0, 4);
        if (fate == 0) container.blobs.erase(name);
        if (fate == 1) container.blobs[name].pop_back();
        if (fate > 1) continue;
        const std::size_t end = std::min(count, (i + 1) * kChunkElements);
        std::fill(isLost.begin() + i * kChunkElements, isLost.begin() + end, true);
      }
      const auto read = readArray<std::uint32_t>(container, "a", count);
      std::vector<bool> reported(count, false);
      std::size_t before = 0;
      for (const IndexRange& range : read.lost) {
        RC_ASSERT(range.begin < range.end && range.end <= count);
        RC_ASSERT(before == 0 || range.begin > before);  // in order and joined
        before = range.end;
        std::fill(reported.begin() + range.begin, reported.begin() + range.end, true);
      }
      RC_ASSERT(reported == isLost);
      for (std::size_t i = 0; i < read.values.size(); ++i) RC_ASSERT(read.values[i] == (isLost[i] ? 0 : numbers[i]));
      for (std::size_t i = read.values.size(); i < count; ++i) RC_ASSERT(isLost[i]);
    }));
  }

  void countsOutOfThisWorld() {
    Container container;
    writeArray<double>(container, "a", std::vector<double>(3 * 65'536, 1.0), 3);
    const auto read = readArray<double>(container, "a", ~std::uint64_t{0}, 3);
    QCOMPARE(read.values.size(), std::size_t{3 * 65'536});
    QVERIFY(read.lost == (Ranges{{65'536, kLargestContainer}}));
    // A single chunk far out would need gigabytes of zeros.
    container.blobs["a/9999"] = container.blobs["a/0000"];
    const auto sparse = readArray<double>(container, "a", ~std::uint64_t{0}, 3);
    QVERIFY(sparse.values.empty());
    QVERIFY(sparse.lost == (Ranges{{0, kLargestContainer}}));
  }

  void moreThanAsked() {
    Container container;
    writeArray<std::uint8_t>(container, "a", std::vector<std::uint8_t>(70'000, 7));
    const auto read = readArray<std::uint8_t>(container, "a", 65'536);
    QCOMPARE(read.values.size(), std::size_t{65'536});
    QVERIFY(read.lost.empty());
    QVERIFY(readArray<std::uint8_t>(container, "a", 0).lost.empty());
    QVERIFY(readArray<std::uint8_t>(container, "b", 10).lost == (Ranges{{0, 10}}));
  }

  void tenThousandChunks() {
    Container container;
    writeArray<std::uint8_t>(container, "a", std::vector<std::uint8_t>(10'001 * kChunkElements, 3));
    QVERIFY(container.blobs.contains("a/10000"));
    const auto read = readArray<std::uint8_t>(container, "a", 10'001 * kChunkElements);
    QVERIFY(read.lost.empty());
    QCOMPARE(read.values.size(), 10'001 * kChunkElements);
  }
};

HANDWHEEL_TEST(ContainerBlobsTest)
#include "ContainerBlobsTest.moc"
