// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Surfaces.h"
#include "TestClass.h"
#include "proximity/SliverPieces.h"

#include <QTest>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// A slanted disc of sectors.
Surface fan(std::uint32_t n) {
  Surface s;
  s.points.push_back(Vec3::Zero());
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / n;
    s.points.emplace_back(std::cos(angle), std::sin(angle), 0.3 * std::cos(angle));
    s.triangles.push_back({0, i + 1, (i + 1) % n + 1});
  }
  return s;
}

std::vector<BoxedItem> wholeBoxes(const Surface& s, const BoxFrame& frame) {
  return boxedTriangles(s.points, s.triangles, frame, FlatTriangles::Keep);
}

bool holds(const FloatBox& box, const Vec3& p) {
  const Eigen::Array3d low = box.low.head<3>().cast<double>(), high = box.high.head<3>().cast<double>();
  return (low <= p.array()).all() && (p.array() <= high).all();
}

double halfArea(const FloatBox& box) {
  const Eigen::Array3d d = (box.high - box.low).head<3>().cast<double>();
  return d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
}

}  // namespace

class SliverPiecesTest : public QObject {
  Q_OBJECT

 private slots:
  void leavesOrdinarySurfacesAlone();
  void piecesCoverTheTriangle();
  void boxesShrinkAsTheirNumber();
  void keepsItsBudget();
  void oddTriangles();
};

void SliverPiecesTest::leavesOrdinarySurfacesAlone() {
  for (const Surface& s : {sphere(20), fan(12), soup(400, 0.1, 0, 1)}) {
    const BoxFrame frame(s.points);
    const std::vector<BoxedItem> whole = wholeBoxes(s, frame);
    std::vector<BoxedItem> items = whole;
    splitSliverBoxes(items, s.points, s.triangles, frame);
    QCOMPARE(items.size(), whole.size());
    QVERIFY(std::memcmp(items.data(), whole.data(), items.size() * sizeof(BoxedItem)) == 0);
  }
}

// Any point of a triangle lies in a box that has its number.
void SliverPiecesTest::piecesCoverTheTriangle() {
  const Surface s = fan(2000);
  const BoxFrame frame(s.points);
  std::vector<BoxedItem> items = wholeBoxes(s, frame);
  splitSliverBoxes(items, s.points, s.triangles, frame);
  QVERIFY(items.size() > s.triangles.size());
  std::vector<std::vector<FloatBox>> boxesOf(s.triangles.size());
  for (const BoxedItem& item : items) boxesOf[item.id()].push_back(item.box);
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    const auto [a, b, c] = s.corners(t);
    for (int i = 0; i <= 20; ++i) {
      for (int j = 0; j <= 20 - i; ++j) {
        const Vec3 p = frame.toFrame(a + i / 20.0 * (b - a) + j / 20.0 * (c - a));
        QVERIFY(std::any_of(boxesOf[t].begin(), boxesOf[t].end(), [&](const FloatBox& box) { return holds(box, p); }));
      }
    }
  }
}

// A box of a k-th of the length in each direction has a k²-th of the area: all k together, a k-th. The pieces are of
// equal length; 32 of them where a sector is slim enough.
void SliverPiecesTest::boxesShrinkAsTheirNumber() {
  const Surface s = fan(20'000);
  const BoxFrame frame(s.points);
  std::vector<BoxedItem> items = wholeBoxes(s, frame);
  const auto sum = [](const std::vector<BoxedItem>& boxes) {
    double area = 0.0;
    for (const BoxedItem& item : boxes) area += halfArea(item.box);
    return area;
  };
  const double before = sum(items);
  splitSliverBoxes(items, s.points, s.triangles, frame);
  QVERIFY(sum(items) < before / 25.0);
  QVERIFY(items.size() <= 32 * s.triangles.size());
}

void SliverPiecesTest::keepsItsBudget() {
  const Surface s = fan(200'000);
  const BoxFrame frame(s.points);
  std::vector<BoxedItem> items = wholeBoxes(s, frame);
  splitSliverBoxes(items, s.points, s.triangles, frame);
  QVERIFY(items.size() > s.triangles.size());
  QVERIFY(items.size() <= s.triangles.size() + 1'000'000);
}

// Points, segments, and coordinates at the ends of what is representable: every box is one.
void SliverPiecesTest::oddTriangles() {
  for (const double size : {1.0, 1e-300, 1e150, 1e300, std::numeric_limits<double>::max()}) {
    Surface s;
    s.points = {{0, 0, 0}, {size, size, 0}, {size, size, size}, {-size, size, size}, {0.5 * size, 0.5 * size, 0}};
    s.triangles = {{0, 0, 0}, {0, 1, 1}, {0, 2, 0}, {0, 1, 4}, {3, 1, 2}, {4, 0, 1}};
    const BoxFrame frame(s.points);
    std::vector<BoxedItem> items = wholeBoxes(s, frame);
    splitSliverBoxes(items, s.points, s.triangles, frame);
    for (const BoxedItem& item : items) {
      QVERIFY(item.id() < s.triangles.size());
      QVERIFY((item.box.low.head<3>() <= item.box.high.head<3>()).all());
      QVERIFY(item.box.low.head<3>().allFinite() && item.box.high.head<3>().allFinite());
    }
  }
  std::vector<BoxedItem> none;
  splitSliverBoxes(none, {}, {}, BoxFrame());
  QVERIFY(none.empty());
}

HANDWHEEL_TEST(SliverPiecesTest)
#include "SliverPiecesTest.moc"
