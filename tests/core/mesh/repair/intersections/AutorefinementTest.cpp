// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/intersections/Autorefinement.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/structure/EdgeTable.h"
#include "mesh/structure/Weld.h"

#include <rapidcheck.h>

#include <QTest>
#include <random>
#include <set>

using namespace handwheel;

namespace {

double area(const std::vector<Vec3>& points, const Triangle& t) {
  return 0.5 * (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]).norm();
}

Autorefinement cut(const TriangleSoup& soup) {
  return autorefine(soup, selfIntersections(soup.points, soup.triangles).value(), NumberType::Float64);
}

// Returns the soup with cut triangles replaced by their pieces.
TriangleSoup pieces(const TriangleSoup& soup, const Autorefinement& cuts) {
  TriangleSoup result{cuts.points, {}};
  for (std::uint32_t t = 0; t < soup.triangles.size(); ++t) {
    const auto at = cuts.piecesOf.find(t);
    if (at == cuts.piecesOf.end()) {
      result.triangles.push_back(soup.triangles[t]);
    } else {
      result.triangles.insert(result.triangles.end(), at->second.begin(), at->second.end());
    }
  }
  return result;
}

std::size_t crossings(const TriangleSoup& soup) {
  return selfIntersections(soup.points, soup.triangles).value().size();
}

// Every triangle's pieces have its area and its normal.
std::string unlike(const TriangleSoup& soup, const Autorefinement& cuts, double tolerance) {
  for (const auto& [t, parts] : cuts.piecesOf) {
    const Triangle& c = soup.triangles[t];
    const Vec3 normal = (soup.points[c[1]] - soup.points[c[0]]).cross(soup.points[c[2]] - soup.points[c[0]]);
    double sum = 0.0;
    for (const Triangle& p : parts) {
      sum += area(cuts.points, p);
      const Vec3 n = (cuts.points[p[1]] - cuts.points[p[0]]).cross(cuts.points[p[2]] - cuts.points[p[0]]);
      if (n.norm() > tolerance && n.dot(normal) <= 0.0) return "turned";
    }
    if (std::abs(sum - area(soup.points, c)) > tolerance) return "area of triangle " + std::to_string(t);
  }
  return {};
}

}  // namespace

class AutorefinementTest : public QObject {
  Q_OBJECT

 private slots:
  void twoCrossing();
  void neighboursAreCutToo();
  void cornersStay();
  void coplanar();
  void nothingToCut();
  void randomSoups();
  void closedStaysClosed();
};

// An upright triangle through a lying one, along x from -1 to 1 at y = 0: each falls into pieces at the common segment.
void AutorefinementTest::twoCrossing() {
  const TriangleSoup soup{{{-3, -3, 0}, {3, -3, 0}, {0, 3, 0}, {-1, 0, -1}, {1, 0, -1}, {0, 0, 3}},
                          {{0, 1, 2}, {3, 4, 5}}};
  const Autorefinement cuts = cut(soup);
  QCOMPARE(cuts.piecesOf.size(), std::size_t{2});
  QCOMPARE(unlike(soup, cuts, 1e-12), std::string());
  QCOMPARE(crossings(pieces(soup, cuts)), std::size_t{0});
  // Both ends of the segment are where the upright one's sides pass z = 0.
  std::vector<Vec3> added(cuts.points.begin() + 6, cuts.points.end());
  QCOMPARE(added.size(), std::size_t{2});
  for (const Vec3& p : added) {
    QCOMPARE(p.y(), 0.0);
    QCOMPARE(p.z(), 0.0);
    QVERIFY(std::abs(std::abs(p.x()) - 0.75) < 1e-15);
  }
}

// A spike through the common edge of two faces: each gets the points on it, and so does a third face at that edge that
// the spike does not meet elsewhere.
void AutorefinementTest::neighboursAreCutToo() {
  const TriangleSoup soup{
      {{0, -1, 0}, {0, 1, 0}, {-2, 0, 0}, {2, 0, 0}, {0, 0, -5}, {0, 0, 3}, {0.5, 0, 3}, {0, 0.5, 3}},
      {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {5, 6, 7}}};
  TriangleSoup pierced = soup;
  pierced.points.push_back({0, 0, -1});
  pierced.points.push_back({0.5, 0.1, 1});
  pierced.points.push_back({-0.5, 0.1, 1});
  pierced.triangles.push_back({8, 9, 10});
  const Autorefinement cuts = cut(pierced);
  for (std::uint32_t t : {0u, 1u, 2u}) QVERIFY(cuts.piecesOf.contains(t));
  QVERIFY(!cuts.piecesOf.contains(3));
  QCOMPARE(unlike(pierced, cuts, 1e-12), std::string());
  QCOMPARE(crossings(pieces(pierced, cuts)), std::size_t{0});
}

// A tip that touches a face in one point becomes a corner of the face's pieces, by the number it has.
void AutorefinementTest::cornersStay() {
  const TriangleSoup soup{{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 1}, {-1, 0, 1}},
                          {{0, 1, 2}, {3, 4, 5}}};
  const Autorefinement cuts = cut(soup);
  QCOMPARE(cuts.points.size(), soup.points.size());
  QCOMPARE(cuts.piecesOf.at(0).size(), std::size_t{3});
  QCOMPARE(crossings(pieces(soup, cuts)), std::size_t{0});
}

// Two that overlap in their plane: the common area becomes the same pieces of both.
void AutorefinementTest::coplanar() {
  const TriangleSoup soup{{{0, 0, 1}, {4, 0, 1}, {0, 4, 1}, {1, 1, 1}, {5, 1, 1}, {1, 5, 1}}, {{0, 1, 2}, {3, 4, 5}}};
  const Autorefinement cuts = cut(soup);
  QCOMPARE(unlike(soup, cuts, 1e-12), std::string());
  std::set<std::set<std::uint32_t>> first, both;
  for (const Triangle& t : cuts.piecesOf.at(0)) first.insert({t[0], t[1], t[2]});
  double common = 0.0;
  for (const Triangle& t : cuts.piecesOf.at(1)) {
    if (first.contains({t[0], t[1], t[2]})) common += area(cuts.points, t);
  }
  QVERIFY(std::abs(common - 2.0) < 1e-12);  // a right triangle with sides of 2
}

void AutorefinementTest::nothingToCut() {
  QVERIFY(cut({}).piecesOf.empty());
  const TriangleSoup ball = test::icosphere(2);
  const Autorefinement cuts = cut(ball);
  QVERIFY(cuts.piecesOf.empty());
  QCOMPARE(cuts.points.size(), ball.points.size());
}

// In general position nothing is left crossing but what rounding the last digit makes so.
void AutorefinementTest::randomSoups() {
  QVERIFY(rc::check("areas stay, crossings go", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    std::uniform_real_distribution<double> within(-1.0, 1.0);
    TriangleSoup soup;
    for (int i = 0; i < 3 * *rc::gen::inRange(2, 9); ++i)
      soup.points.push_back({within(random), within(random), within(random)});
    for (std::uint32_t i = 0; i + 2 < soup.points.size(); i += 3) soup.triangles.push_back({i, i + 1, i + 2});
    const Autorefinement cuts = cut(soup);
    RC_ASSERT(unlike(soup, cuts, 1e-9) == std::string());
    RC_ASSERT(crossings(pieces(soup, cuts)) <= crossings(soup) / 4);
  }));
}

// Two closed balls cross: each edge still has equally many faces in both directions.
void AutorefinementTest::closedStaysClosed() {
  for (NumberType numbers : {NumberType::Float64, NumberType::Float32}) {
    TriangleSoup soup = test::icosphere(2);
    test::append(soup, test::moved(test::icosphere(2), {0.61, 0.23, 0.17}));
    roundPoints(soup, numbers);
    const auto pairs = selfIntersections(soup.points, soup.triangles).value();
    const TriangleSoup result = pieces(soup, autorefine(soup, pairs, numbers));
    const EdgeTable edges(result.triangles, result.points.size());
    int unbalanced = 0, crowded = 0;
    edges.forEachEdge([&](std::uint32_t low, std::uint32_t, std::span<const EdgeTable::Entry> run) {
      int balance = 0;
      for (const auto& e : run) balance += result.triangles[e.halfEdge / 3][e.halfEdge % 3] == low ? 1 : -1;
      unbalanced += balance != 0;
      crowded += run.size() == 4;
    });
    QCOMPARE(unbalanced, 0);
    QVERIFY(crowded > 20);  // the circle where they cross
  }
}

HANDWHEEL_TEST(AutorefinementTest)
#include "AutorefinementTest.moc"
