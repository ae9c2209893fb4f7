// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "base/PagedArray.h"

#include <rapidcheck.h>

#include <QTest>
#include <random>

using namespace handwheel;

namespace {

using Array = PagedArray<int>;
constexpr std::size_t kPage = Array::kPageSize;

Array counted(std::size_t n) {
  Array a;
  for (std::size_t i = 0; i < n; ++i) a.push_back(static_cast<int>(i));
  return a;
}

std::vector<int> contents(const Array& a) {
  std::vector<int> v;
  for (std::size_t i = 0; i < a.size(); ++i) v.push_back(a[i]);
  return v;
}

}  // namespace

class PagedArrayTest : public QObject {
  Q_OBJECT

 private slots:
  void pages();
  void copiesShareUntilWritten();
  void growingDoesNotTouchCopies();
  void truncating();
  void behavesLikeVectors();
};

void PagedArrayTest::pages() {
  QVERIFY(Array().empty());
  for (std::size_t n : {std::size_t{1}, kPage - 1, kPage, kPage + 1, 3 * kPage}) {
    const Array a = counted(n);
    QCOMPARE(a.size(), n);
    QCOMPARE(a.pageCount(), (n + kPage - 1) / kPage);
    for (std::size_t i = 0; i < n; ++i) QCOMPARE(a[i], static_cast<int>(i));
  }
}

void PagedArrayTest::copiesShareUntilWritten() {
  const Array original = counted(3 * kPage);
  Array copy = original;
  for (std::size_t p = 0; p < 3; ++p) QVERIFY(copy.sharesPage(original, p));
  copy.set(kPage + 5, -1);
  QVERIFY(copy.sharesPage(original, 0));
  QVERIFY(!copy.sharesPage(original, 1));
  QVERIFY(copy.sharesPage(original, 2));
  QVERIFY(!copy.sharesPage(original, 3));
  QCOMPARE(original[kPage + 5], static_cast<int>(kPage) + 5);
  QCOMPARE(copy[kPage + 5], -1);
  // Nobody shares the page any more: it is written without a copy.
  const int* page = &copy[kPage];
  copy.set(kPage + 6, -2);
  QVERIFY(page == &copy[kPage]);
}

void PagedArrayTest::growingDoesNotTouchCopies() {
  Array original = counted(kPage / 2);
  const Array copy = original;
  original.push_back(7);
  QCOMPARE(copy.size(), kPage / 2);
  QCOMPARE(original.size(), kPage / 2 + 1);
  QVERIFY(contents(copy) == contents(counted(kPage / 2)));
}

void PagedArrayTest::truncating() {
  const Array original = counted(2 * kPage + 10);
  for (std::size_t n : {2 * kPage + 10, 2 * kPage, kPage + 3, kPage, std::size_t{1}, std::size_t{0}}) {
    Array a = original;
    a.truncate(n);
    QVERIFY(contents(a) == contents(counted(n)));
    a.push_back(42);
    QCOMPARE(a.size(), n + 1);
    QCOMPARE(a[n], 42);
    QCOMPARE(original.size(), 2 * kPage + 10);
    if (n < original.size()) QCOMPARE(original[n], static_cast<int>(n));
  }
}

void PagedArrayTest::behavesLikeVectors() {
  QVERIFY(rc::check("copies that are changed at random hold what vectors would", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    std::vector<Array> arrays{counted(kPage - 2)};
    std::vector<std::vector<int>> vectors{contents(arrays[0])};
    for (int step = 0; step < 60; ++step) {
      const std::size_t which = random() % arrays.size();
      Array& a = arrays[which];
      std::vector<int>& v = vectors[which];
      switch (random() % 4) {
        case 0:
          for (int i = random() % 5; i >= 0; --i) {
            a.push_back(i);
            v.push_back(i);
          }
          break;
        case 1:
          if (!v.empty()) {
            const std::size_t i = random() % v.size();
            a.set(i, step);
            v[i] = step;
          }
          break;
        case 2: {
          const std::size_t n = v.size() - std::min<std::size_t>(v.size(), random() % 8);
          a.truncate(n);
          v.resize(n);
          break;
        }
        case 3:
          if (arrays.size() < 4) {
            Array copy = a;
            std::vector<int> same = v;
            arrays.push_back(std::move(copy));
            vectors.push_back(std::move(same));
          }
      }
    }
    for (std::size_t i = 0; i < arrays.size(); ++i) RC_ASSERT(contents(arrays[i]) == vectors[i]);
  }));
}

HANDWHEEL_TEST(PagedArrayTest)
#include "PagedArrayTest.moc"
