// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/structure/EdgeTable.h"

#include "MeshShapes.h"
#include "TestClass.h"

#include <rapidcheck.h>

#include <QTest>

using namespace handwheel;

class EdgeTableTest : public QObject {
  Q_OBJECT

 private slots:
  void empty();
  void againstAMap();
};

void EdgeTableTest::empty() {
  int visits = 0;
  EdgeTable({}, 0).forEachEdge([&](auto...) { ++visits; });
  const std::vector<Triangle> withoutExtent = {{1, 1, 2}, {0, 0, 0}};
  EdgeTable(withoutExtent, 3).forEachEdge([&](auto...) { ++visits; });
  QCOMPARE(visits, 0);
}

void EdgeTableTest::againstAMap() {
  QVERIFY(rc::check("every half-edge is at its edge, once, in order", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const auto vertices = *rc::gen::inRange<std::uint32_t>(1, 20);
    std::vector<Triangle> triangles(*rc::gen::inRange<std::size_t>(0, 60));
    for (Triangle& t : triangles)
      t = {std::uint32_t(random() % vertices), std::uint32_t(random() % vertices), std::uint32_t(random() % vertices)};
    using Edge = std::pair<std::uint32_t, std::uint32_t>;
    std::map<Edge, std::vector<std::uint32_t>> expected;
    for (std::uint32_t h = 0; h < 3 * triangles.size(); ++h) {
      const Triangle& t = triangles[h / 3];
      if (hasRepeatedVertex(t)) continue;
      expected[std::minmax(t[h % 3], t[(h + 1) % 3])].push_back(h);
    }
    std::vector<Edge> order;
    EdgeTable(triangles, vertices).forEachEdge([&](std::uint32_t low, std::uint32_t high, auto run) {
      order.emplace_back(low, high);
      std::vector<std::uint32_t> halfEdges;
      for (const EdgeTable::Entry& e : run) {
        RC_ASSERT(e.high == high);
        halfEdges.push_back(e.halfEdge);
      }
      RC_ASSERT(halfEdges == expected.at({low, high}));
    });
    RC_ASSERT(order.size() == expected.size());
    RC_ASSERT(std::is_sorted(order.begin(), order.end()));
  }));
}

HANDWHEEL_TEST(EdgeTableTest)
#include "EdgeTableTest.moc"
