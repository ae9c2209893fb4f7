// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/search/FaceOctree.h"

#include "TestClass.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <random>

using namespace handwheel;

namespace {

// Boxes of all sizes between 1e-9 and 100, flat ones and points among them, on both sides of the origin.
Box anyGridBox(std::mt19937& random) {
  std::uniform_real_distribution<double> at(-50.0, 50.0), exponent(-9.0, 2.0), share(0.0, 1.0);
  const double size = std::pow(10.0, exponent(random));
  const Vec3 low(at(random), at(random), at(random));
  Vec3 extent(share(random), share(random), share(random));
  for (Eigen::Index k = 0; k < 3; ++k)
    if (random() % 8 == 0) extent[k] = 0.0;
  return Box(low, low + size * extent);
}

// Returns true if each stored box that meets the query box is visited, no face twice, and no face that is not stored.
bool findsAll(const FaceOctree& grid, const std::vector<Box>& boxes, const std::vector<bool>& isIn, const Box& asked) {
  std::vector<int> visits(boxes.size(), 0);
  const bool ended = grid.forEachNear(asked, [&](Face f) {
    ++visits[f];
    return true;
  });
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (visits[i] > (isIn[i] ? 1 : 0)) return false;
    if (isIn[i] && boxes[i].intersects(asked) && visits[i] == 0) return false;
  }
  return ended;
}

}  // namespace

class FaceOctreeTest : public QObject {
  Q_OBJECT

 private slots:
  // Added in the order of their sizes, up or down, or in none: the largest cells are those of the largest box so far.
  void allNearFacesAreVisited_data() {
    QTest::addColumn<int>("order");
    QTest::newRow("any order") << 0;
    QTest::newRow("smallest first") << 1;
    QTest::newRow("largest first") << -1;
  }
  void allNearFacesAreVisited() {
    QFETCH(int, order);
    std::mt19937 random(5);
    std::vector<Box> boxes;
    for (int i = 0; i < 400; ++i) boxes.push_back(anyGridBox(random));
    const auto isBefore = [&](const Box& a, const Box& b) {
      return order * a.sizes().maxCoeff() < order * b.sizes().maxCoeff();
    };
    std::stable_sort(boxes.begin(), boxes.end(), isBefore);
    FaceOctree grid;
    std::vector<bool> isIn(boxes.size(), false);
    for (Face f = 0; f < boxes.size(); ++f) {
      grid.add(f, boxes[f]);
      isIn[f] = true;
    }
    for (int i = 0; i < 400; ++i) {
      QVERIFY(findsAll(grid, boxes, isIn, anyGridBox(random)));
      QVERIFY(findsAll(grid, boxes, isIn, boxes[random() % boxes.size()]));
      // Some go and others come back.
      const Face f = static_cast<Face>(random() % boxes.size());
      if (isIn[f]) {
        grid.remove(f, boxes[f]);
      } else {
        grid.add(f, boxes[f]);
      }
      isIn[f] = !isIn[f];
    }
    const Box all(Vec3::Constant(-1e9), Vec3::Constant(1e9));
    QVERIFY(findsAll(grid, boxes, isIn, all));
    for (Face f = 0; f < boxes.size(); ++f) {
      if (isIn[f]) grid.remove(f, boxes[f]);
      isIn[f] = false;
    }
    QVERIFY(findsAll(grid, boxes, isIn, all));
    grid.add(0, boxes[0]);
    isIn[0] = true;
    QVERIFY(findsAll(grid, boxes, isIn, boxes[0]));
  }

  // Neighbours that only touch, at corners that are corners of cells, too.
  void touchingBoxes() {
    FaceOctree grid;
    std::vector<Box> boxes;
    for (const double size : {0.25, 0.5, 1.0, 2.0}) {
      for (const double x : {-4.0, -2.0, 0.0, 2.0}) boxes.push_back(Box(Vec3::Constant(x), Vec3::Constant(x + size)));
    }
    for (Face f = 0; f < boxes.size(); ++f) grid.add(f, boxes[f]);
    for (const Box& box : boxes) QVERIFY(findsAll(grid, boxes, std::vector<bool>(boxes.size(), true), box));
  }

  // The smallest sizes and the largest, and all of them at the origin.
  void extremeSizes() {
    FaceOctree grid;
    std::vector<Box> boxes{Box(Vec3::Zero(), Vec3::Zero()), Box(Vec3::Constant(1e100), Vec3::Constant(1e100))};
    for (int exponent = -320; exponent <= 300; exponent += 20) {
      boxes.push_back(Box(Vec3::Zero(), Vec3::Constant(std::pow(10.0, exponent))));
      boxes.push_back(Box(Vec3::Constant(-std::pow(10.0, exponent)), Vec3::Zero()));
    }
    for (Face f = 0; f < boxes.size(); ++f) grid.add(f, boxes[f]);
    for (const Box& box : boxes) QVERIFY(findsAll(grid, boxes, std::vector<bool>(boxes.size(), true), box));
  }

  void aVisitEndsTheSearch() {
    FaceOctree grid;
    QVERIFY(grid.forEachNear(Box(Vec3::Zero(), Vec3::Ones()), [](Face) { return false; }));
    for (Face f = 0; f < 10; ++f) grid.add(f, Box(Vec3::Zero(), Vec3::Constant(1.0 + f)));
    int visits = 0;
    QVERIFY(!grid.forEachNear(Box(Vec3::Zero(), Vec3::Ones()), [&](Face) { return ++visits < 4; }));
    QCOMPARE(visits, 4);
  }
};

HANDWHEEL_TEST(FaceOctreeTest)
#include "FaceOctreeTest.moc"
