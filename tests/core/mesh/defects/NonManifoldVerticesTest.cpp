// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/defects/NonManifoldVertices.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "OneSidedShapes.h"
#include "TestClass.h"
#include "mesh/structure/Weld.h"

#include <rapidcheck.h>

#include <QTest>

using namespace handwheel;

namespace {

// A vertex is manifold when one can walk from any of its triangles to any other across edges that touch it.
std::vector<std::uint32_t> byWalking(const TriangleSoup& s) {
  std::vector<std::uint32_t> bad;
  for (std::uint32_t v = 0; v < s.points.size(); ++v) {
    std::vector<Triangle> around;
    for (const Triangle& t : s.triangles)
      if (std::set<std::uint32_t>(t.begin(), t.end()).size() == 3 && std::count(t.begin(), t.end(), v))
        around.push_back(t);
    if (around.empty()) continue;
    std::set<std::uint32_t> reached(around[0].begin(), around[0].end());
    std::set<std::size_t> left;
    for (std::size_t i = 1; i < around.size(); ++i) left.insert(i);
    for (bool more = true; more;) {
      more = false;
      for (std::size_t i : std::set<std::size_t>(left)) {
        if (std::none_of(around[i].begin(), around[i].end(), [&](auto u) { return u != v && reached.contains(u); }))
          continue;
        reached.insert(around[i].begin(), around[i].end());
        left.erase(i);
        more = true;
      }
    }
    if (!left.empty()) bad.push_back(v);
  }
  return bad;
}

std::vector<std::uint32_t> found(const TriangleSoup& s) {
  return findNonManifoldVertices(s.triangles, s.points.size());
}

}  // namespace

class NonManifoldVerticesTest : public QObject {
  Q_OBJECT

 private slots:
  void manifolds();
  void touchingCubes();
  void soups();
};

void NonManifoldVerticesTest::manifolds() {
  for (const TriangleSoup& s : {test::cube(), test::disc(8, 3), test::moebiusStrip(12, 2), test::kleinBottle(12, 6),
                                test::boxWithInnerWall(), TriangleSoup()})
    QVERIFY(found(s).empty());
}

void NonManifoldVerticesTest::touchingCubes() {
  const TriangleSoup vertex = weld(test::twoCubesSharingAVertex());
  QCOMPARE(found(vertex).size(), std::size_t{1});
  QVERIFY(vertex.points[found(vertex)[0]] == Vec3(1, 1, 1));
  QVERIFY(found(weld(test::twoCubesSharingAnEdge())).empty());
}

void NonManifoldVerticesTest::soups() {
  QVERIFY(rc::check("the same as by walking around each vertex", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const auto steps = *rc::gen::inRange<std::uint32_t>(2, 5);
    const TriangleSoup s = weld(test::randomSoup(random, *rc::gen::inRange<std::size_t>(1, 40), steps));
    RC_ASSERT(found(s) == byWalking(s));
  }));
}

HANDWHEEL_TEST(NonManifoldVerticesTest)
#include "NonManifoldVerticesTest.moc"
