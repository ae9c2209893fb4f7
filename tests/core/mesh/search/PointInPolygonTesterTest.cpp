// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "mesh/search/PointInPolygonTester.h"

#include <rapidcheck.h>

#include <QTest>
#include <cmath>
#include <random>

using namespace handwheel;

class PointInPolygonTesterTest : public QObject {
  Q_OBJECT

 private slots:
  void agreesWithTheWindingNumber();
  void tilesShareTheirEdges();
  void extremes();
};

namespace {

using Vec2 = Eigen::Vector2d;

// Returns true if the winding number of the polygon around p is odd.
bool windsOddly(const std::vector<Vec2>& polygon, const Vec2& p) {
  double sum = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i] - p, b = polygon[(i + 1) % polygon.size()] - p;
    sum += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  }
  return std::lround(sum / (2.0 * M_PI)) % 2 != 0;
}

}  // namespace

void PointInPolygonTesterTest::agreesWithTheWindingNumber() {
  QVERIFY(rc::check([] {
    std::mt19937 random(*rc::gen::arbitrary<unsigned>());
    std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
    const double scale = *rc::gen::element(1e-100, 1.0, 1e6);
    std::vector<Vec2> polygon(*rc::gen::inRange<std::size_t>(0, 300));
    for (Vec2& p : polygon) p = scale * Vec2(coordinate(random), coordinate(random));
    const PointInPolygonTester rows(polygon);
    for (int i = 0; i < 50; ++i) {
      const Vec2 p = 1.1 * scale * Vec2(coordinate(random), coordinate(random));
      RC_ASSERT(rows.contains(p) == windsOddly(polygon, p));
    }
  }));
}

// Each lattice point, corner of four squares, lies in exactly one of them.
void PointInPolygonTesterTest::tilesShareTheirEdges() {
  std::vector<PointInPolygonTester> tiles;
  for (int x = 0; x < 4; ++x)
    for (int y = 0; y < 4; ++y) tiles.emplace_back(std::vector<Vec2>{{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}});
  for (double x = 0.5; x < 4.0; x += 0.5)
    for (double y = 0.5; y < 4.0; y += 0.5)
      QCOMPARE(std::count_if(tiles.begin(), tiles.end(), [&](const auto& t) { return t.contains(Vec2(x, y)); }), 1);
}

void PointInPolygonTesterTest::extremes() {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  QVERIFY(!PointInPolygonTester({}).contains(Vec2(0, 0)));
  QVERIFY(!PointInPolygonTester(std::vector<Vec2>(5, Vec2(1, 1))).contains(Vec2(1, 1)));
  QVERIFY(!PointInPolygonTester(std::vector<Vec2>{{0, 0}, {1, 0}, {2, 0}}).contains(Vec2(1, 0)));
  const PointInPolygonTester square(std::vector<Vec2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  for (const Vec2& p : {Vec2(nan, 0.5), Vec2(0.5, nan), Vec2(0.5, inf), Vec2(0.5, -inf), Vec2(inf, 0.5)})
    QVERIFY(!square.contains(p));
  const double huge = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  QVERIFY(PointInPolygonTester(std::vector<Vec2>{{-1, -huge}, {1, -huge}, {1, huge}, {-1, huge}}).contains(Vec2(0, 0)));
  QVERIFY(PointInPolygonTester(std::vector<Vec2>{{-1, 0}, {1, 0}, {1, least}, {-1, least}}).contains(Vec2(0, 0)));
}

HANDWHEEL_TEST(PointInPolygonTesterTest)
#include "PointInPolygonTesterTest.moc"
