// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "mesh/sculpt/TriangleSplit.h"

#include <QTest>
#include <map>
#include <set>

using namespace handwheel;

class TriangleSplitTest : public QObject {
  Q_OBJECT

 private slots:
  // In every case there is one part more than points, each half of an outer edge occurs once, in the triangle's
  // orientation, each inner edge once in both directions, and the areas of the parts sum up to that of the triangle.
  void coversTheTriangle_data() {
    QTest::addColumn<int>("points");
    QTest::addColumn<bool>("isFirstShorter");
    for (int points = 0; points < 8; ++points)
      for (const bool isFirst : {true, false}) QTest::addRow("points %d, %d", points, isFirst) << points << isFirst;
  }
  void coversTheTriangle() {
    QFETCH(int, points);
    QFETCH(bool, isFirstShorter);
    const std::array<bool, 3> hasPoint{(points & 1) != 0, (points & 2) != 0, (points & 4) != 0};
    const TriangleSplit parts = splitOf(hasPoint, [&](auto, auto, auto, auto) { return isFirstShorter; });
    using Edge = std::pair<std::size_t, std::size_t>;
    std::multiset<Edge> edges;
    int doubledArea = 0;
    const std::array<std::array<int, 2>, 6> at = {{{0, 0}, {2, 0}, {0, 2}, {1, 0}, {1, 1}, {0, 1}}};
    for (const auto& [p, q, r] : parts) {
      for (const Edge& edge : {Edge{p, q}, {q, r}, {r, p}}) edges.insert(edge);
      const int area = (at[q][0] - at[p][0]) * (at[r][1] - at[p][1]) - (at[q][1] - at[p][1]) * (at[r][0] - at[p][0]);
      QVERIFY(area > 0);
      doubledArea += area;
    }
    QCOMPARE(doubledArea, 4);
    QCOMPARE(parts.size(), 1 + static_cast<std::size_t>(std::count(hasPoint.begin(), hasPoint.end(), true)));
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      const std::vector<Edge> outer =
          hasPoint[k] ? std::vector<Edge>{{k, 3 + k}, {3 + k, next}} : std::vector<Edge>{{k, next}};
      for (const Edge& edge : outer) QCOMPARE(edges.erase(edge), std::size_t(1));
    }
    for (const auto& [p, q] : edges) QVERIFY(edges.count({p, q}) == 1 && edges.count({q, p}) == 1);
  }

  // The diagonal of the quadrangle that shorter() selects is used.
  void takesTheShorterDiagonal() {
    for (const bool isFirst : {true, false}) {
      Edges asked;
      const TriangleSplit parts =
          splitOf({true, true, false}, [&](std::size_t p, std::size_t q, std::size_t r, std::size_t s) {
            asked = {p, q, r, s};
            return isFirst;
          });
      const std::size_t from = isFirst ? asked[0] : asked[2], to = isFirst ? asked[1] : asked[3];
      QVERIFY(std::any_of(parts.begin(), parts.end(), [&](const auto& part) {
        return std::count(part.begin(), part.end(), from) == 1 && std::count(part.begin(), part.end(), to) == 1;
      }));
    }
  }

 private:
  using Edges = std::array<std::size_t, 4>;
};

HANDWHEEL_TEST(TriangleSplitTest)
#include "TriangleSplitTest.moc"
