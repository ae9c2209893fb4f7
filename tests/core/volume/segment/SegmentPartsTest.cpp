// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/segment/SegmentParts.h"

#include "MadeSegments.h"
#include "TestClass.h"

#include <QtTest>
#include <algorithm>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// Returns the region filled from a sample over faces; the oracle of parts and of growing.
std::vector<char> flooded(const std::vector<char>& flags, const std::array<int, 3>& size, const VoxelIndex& seed) {
  const auto at = [&](const VoxelIndex& i) {
    return static_cast<std::size_t>((i.z() * size[1] + i.y()) * size[0] + i.x());
  };
  std::vector<char> filled(flags.size(), 0);
  std::vector<VoxelIndex> waiting;
  const auto visit = [&](const VoxelIndex& i) {
    for (int k = 0; k < 3; ++k)
      if (i[k] < 0 || i[k] >= size[static_cast<std::size_t>(k)]) return;
    if (!flags[at(i)] || filled[at(i)]) return;
    filled[at(i)] = 1;
    waiting.push_back(i);
  };
  visit(seed);
  while (!waiting.empty()) {
    const VoxelIndex i = waiting.back();
    waiting.pop_back();
    for (int k = 0; k < 3; ++k)
      for (const int step : {-1, 1}) visit(i + step * VoxelIndex::Unit(k));
  }
  return filled;
}

}  // namespace

class SegmentPartsTest : public QObject {
  Q_OBJECT

 private slots:
  // Noise near the threshold where parts percolate: the part of every sample is what is flooded from it.
  void floods_data() {
    QTest::addColumn<int>("least");
    for (const int least : {0, 50, 68, 90, 99}) QTest::addRow("%d", least) << least;
  }
  void floods() {
    QFETCH(int, least);
    const std::array<int, 3> size{37, 21, 18};
    const ImageVolume image = noise(size, 7u + static_cast<unsigned>(least));
    const Segment segment({static_cast<double>(least), 99.0});
    const std::vector<char> flags = flagsOf(image, segment);
    const SegmentParts parts(image, segment);
    QCOMPARE(parts.total(), static_cast<std::size_t>(std::count(flags.begin(), flags.end(), 1)));
    QVERIFY(std::is_sorted(parts.samples().rbegin(), parts.samples().rend()));
    std::vector<char> seen(flags.size(), 0);
    std::size_t found = 0, i = 0;
    for (int z = 0; z < size[2]; ++z)
      for (int y = 0; y < size[1]; ++y)
        for (int x = 0; x < size[0]; ++x, ++i) {
          const auto part = parts.partAt({x, y, z});
          QCOMPARE(part.has_value(), flags[i] != 0);
          if (!part || seen[i]) continue;
          ++found;
          const std::vector<char> expected = flooded(flags, size, {x, y, z});
          QCOMPARE(parts.samples()[*part], static_cast<std::size_t>(std::count(expected.begin(), expected.end(), 1)));
          if (found < 20) QCOMPARE(flagsOf(image, parts.only(*part, *part + 1)), expected);
          std::transform(seen.begin(), seen.end(), expected.begin(), seen.begin(),
                         [](char a, char b) { return std::max(a, b); });
        }
    QCOMPARE(parts.samples().size(), found);
    QCOMPARE(flagsOf(image, parts.only(0, found)), flags);
  }

  // The number of parts of at least a size is compared with counting them.
  void sizes() {
    const ImageVolume image = noise({30, 30, 30}, 3);
    const SegmentParts parts(image, Segment({75.0, 99.0}));
    for (const std::size_t n : {1u, 2u, 5u, 100u, 1'000'000u})
      QCOMPARE(parts.countFrom(n),
               static_cast<std::size_t>(std::count_if(parts.samples().begin(), parts.samples().end(),
                                                      [&](std::size_t s) { return s >= n; })));
  }

  void nothing() {
    const ImageVolume image = noise({5, 5, 5}, 1);
    const SegmentParts parts(image, Segment({200.0, 300.0}));
    QVERIFY(parts.samples().empty());
    QVERIFY(!parts.partAt({2, 2, 2}));
    const std::vector<char> flags = flagsOf(image, parts.only(0, 5));
    QVERIFY(std::none_of(flags.begin(), flags.end(), [](char flag) { return flag != 0; }));
  }
};

HANDWHEEL_TEST(SegmentPartsTest)
#include "SegmentPartsTest.moc"
