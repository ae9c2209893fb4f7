// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/BoundaryLoops.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "OneSidedShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshBuilder.h"

#include <rapidcheck.h>

#include <QTest>
#include <algorithm>

using namespace handwheel;

namespace {

std::vector<BoundaryLoop> loopsOf(const TriangleSoup& soup) {
  return findBoundaryLoops(buildMesh(soup).mesh);
}

std::vector<std::size_t> sortedEdgeCounts(const TriangleSoup& soup) {
  std::vector<std::size_t> counts;
  for (const BoundaryLoop& loop : loopsOf(soup)) counts.push_back(loop.halfEdges.size());
  std::sort(counts.begin(), counts.end());
  return counts;
}

// A fan around the origin whose border goes up and down by h on the unit circle.
TriangleSoup crown(std::uint32_t n, double h) {
  TriangleSoup s;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double u = 2.0 * M_PI * i / n;
    s.points.emplace_back(std::cos(u), std::sin(u), i % 2 ? -h : h);
    s.triangles.push_back({n, i, (i + 1) % n});
  }
  s.points.push_back(Vec3::Zero());
  return s;
}

// A sheet of 6 × 6 unit cells without some of them.
TriangleSoup sheetWithout(const std::vector<std::pair<int, int>>& cells) {
  TriangleSoup s = test::grid(7, 7, false, false, [](std::uint32_t i, std::uint32_t j) { return Vec3(i, j, 0); });
  std::erase_if(s.triangles, [&](const Triangle& t) {
    const Vec3 middle = (s.points[t[0]] + s.points[t[1]] + s.points[t[2]]) / 3.0;
    return std::any_of(cells.begin(), cells.end(), [&](const auto& cell) {
      return int(middle.x()) == cell.first && int(middle.y()) == cell.second;
    });
  });
  return s;
}

// Checks the guarantees of findBoundaryLoops() for any mesh.
std::string broken(const HalfEdgeMesh& mesh, const std::vector<BoundaryLoop>& loops) {
  std::vector<int> uses(mesh.halfEdgeSlots(), 0);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const BoundaryLoop& loop = loops[i];
    if (loop.id != static_cast<int>(i)) return "ids are not 0, 1, 2, ...";
    std::set<test::Coordinates> passed;
    std::size_t border = 0;
    for (std::size_t k = 0; k < loop.halfEdges.size(); ++k) {
      const HalfEdge h = loop.halfEdges[k], after = loop.halfEdges[(k + 1) % loop.halfEdges.size()];
      ++uses[h];
      border += mesh.isBorder(h);
      if (!mesh.isBorder(h) && !mesh.isSeam(h)) return "a half-edge of a loop is not open";
      if (mesh.position(mesh.to(h)) != mesh.position(mesh.from(after))) return "a loop has a gap";
      if (!passed.insert(test::coordinates(mesh.position(mesh.from(h)))).second)
        return "a loop passes a position twice";
    }
    if (border == 0 || border != loop.borderEdges) return "borderEdges is wrong";
  }
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h) {
    if (uses[h] > 1 || (mesh.isBorder(h) && uses[h] != 1)) return "a border half-edge is not in exactly one loop";
  }
  return {};
}

// The smallest number that a loop's positions have after exact welding: those of first appearance.
std::vector<std::uint32_t> smallestWeldedNumbers(const TriangleSoup& soup, const HalfEdgeMesh& mesh,
                                                 const std::vector<BoundaryLoop>& loops) {
  std::map<test::Coordinates, std::uint32_t> number;
  for (const Triangle& t : soup.triangles)
    for (std::uint32_t v : t)
      number.try_emplace(test::coordinates(soup.points[v]), static_cast<std::uint32_t>(number.size()));
  std::vector<std::uint32_t> smallest;
  for (const BoundaryLoop& loop : loops) {
    std::uint32_t least = kNone;
    for (const Vec3& p : loopPoints(mesh, loop)) least = std::min(least, number.at(test::coordinates(p)));
    smallest.push_back(least);
  }
  return smallest;
}

}  // namespace

class BoundaryLoopsTest : public QObject {
  Q_OBJECT

 private slots:
  void countsAndSizes();
  void lengthAndPlanarity();
  void planarityFarFromTheOrigin();
  void centreAndBox();
  void runsAsItsFacesDo();
  void holesThatTouchAtAVertex();
  void ringOfTouchingHoles();
  void bowTie();
  void nonOrientableStrip();
  void wallsAreNoHoles();
  void orderOfIds();
  void promisesOnSoups();
  void promisesOnCutSpheres();
};

void BoundaryLoopsTest::countsAndSizes() {
  using Counts = std::vector<std::size_t>;
  QCOMPARE(sortedEdgeCounts(test::icosphere(2)), Counts());
  QCOMPARE(sortedEdgeCounts({}), Counts());
  QCOMPARE(sortedEdgeCounts(test::disc(16, 4)), Counts({16}));
  QCOMPARE(sortedEdgeCounts(test::annulus(16, 3, 1, 2)), Counts({16, 16}));
  QCOMPARE(sortedEdgeCounts(test::cylinder(12, 4, 1, 3, false)), Counts({12, 12}));
  QCOMPARE(loopsOf(test::sphereWithHoles(4, 5, 0.3)).size(), std::size_t{5});
  TriangleSoup tetrahedron = test::tetrahedron();
  tetrahedron.triangles.pop_back();
  QCOMPARE(sortedEdgeCounts(tetrahedron), Counts({3}));
}

void BoundaryLoopsTest::lengthAndPlanarity() {
  const std::uint32_t n = 20;
  for (double h : {0.0, 0.01, 0.1, 0.5}) {
    const std::vector<BoundaryLoop> loops = loopsOf(crown(n, h));
    QCOMPARE(loops.size(), std::size_t{1});
    QCOMPARE(loops[0].borderEdges, std::size_t{n});
    const double edge = std::hypot(2.0 * std::sin(M_PI / n), 2.0 * h);
    QVERIFY(std::abs(loops[0].length - n * edge) < 1e-12 * n * edge);
    // Each point is h from the plane z = 0, which is the best one: its normal is the direction of least variance.
    QVERIFY(std::abs(loops[0].planarity - h / (n * edge)) < 1e-9);
  }
}

void BoundaryLoopsTest::planarityFarFromTheOrigin() {
  const double shift = 1e6, h = 0.05;
  const std::vector<BoundaryLoop> loops = loopsOf(test::moved(crown(20, h), Vec3(shift, -shift, shift)));
  const double length = 20 * std::hypot(2.0 * std::sin(M_PI / 20), 2.0 * h);
  QVERIFY(std::abs(loops[0].planarity - h / length) < 1e-6);
}

void BoundaryLoopsTest::centreAndBox() {
  const std::vector<BoundaryLoop> loops = loopsOf(test::moved(test::disc(12, 3, 2.0), Vec3(5, 6, 7)));
  QVERIFY((loops[0].centre - Vec3(5, 6, 7)).norm() < 1e-12);
  QVERIFY((loops[0].box.min() - Vec3(3, 4, 7)).norm() < 1e-12);
  QVERIFY((loops[0].box.max() - Vec3(7, 8, 7)).norm() < 1e-12);
}

// A disc that faces +z has its surface to the left of its border, so the loop turns counter-clockwise; the loop of a
// hole turns clockwise.
void BoundaryLoopsTest::runsAsItsFacesDo() {
  const HalfEdgeMesh mesh = buildMesh(test::annulus(16, 3, 1, 2)).mesh;
  const std::vector<BoundaryLoop> loops = findBoundaryLoops(mesh);
  QCOMPARE(loops.size(), std::size_t{2});
  for (const BoundaryLoop& loop : loops) {
    const std::vector<Vec3> p = loopPoints(mesh, loop);
    double twiceArea = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) twiceArea += p[i].cross(p[(i + 1) % p.size()]).z();
    QCOMPARE(twiceArea > 0.0, p[0].norm() > 1.5);
  }
}

void BoundaryLoopsTest::holesThatTouchAtAVertex() {
  using Counts = std::vector<std::size_t>;
  QCOMPARE(sortedEdgeCounts(sheetWithout({{2, 2}, {3, 3}})), Counts({4, 4, 24}));
  QCOMPARE(sortedEdgeCounts(sheetWithout({{2, 2}, {2, 3}})), Counts({6, 24}));
  // A hole that touches the rim at the corner of the cell.
  QCOMPARE(sortedEdgeCounts(sheetWithout({{0, 0}, {1, 1}})), Counts({4, 24}));
}

// Four holes around the cell (2, 2), which hangs on its corners; inside the ring of holes there is an island.
void BoundaryLoopsTest::ringOfTouchingHoles() {
  const TriangleSoup soup = sheetWithout({{1, 2}, {3, 2}, {2, 1}, {2, 3}});
  const HalfEdgeMesh mesh = buildMesh(soup).mesh;
  const std::vector<BoundaryLoop> loops = findBoundaryLoops(mesh);
  QCOMPARE(broken(mesh, loops), std::string());
  std::size_t edges = 0;
  for (const BoundaryLoop& loop : loops) edges += loop.halfEdges.size();
  QCOMPARE(edges, std::size_t{24 + 16});
}

void BoundaryLoopsTest::bowTie() {
  TriangleSoup s;
  s.points = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(-1, 0, 0), Vec3(-1, -1, 0)};
  s.triangles = {{0, 1, 2}, {0, 3, 4}};
  QCOMPARE(sortedEdgeCounts(s), std::vector<std::size_t>({3, 3}));
}

void BoundaryLoopsTest::nonOrientableStrip() {
  const HalfEdgeMesh mesh = buildMesh(test::moebiusStrip(24, 3)).mesh;
  const std::vector<BoundaryLoop> loops = findBoundaryLoops(mesh);
  QCOMPARE(broken(mesh, loops), std::string());
  std::size_t border = 0;
  for (const BoundaryLoop& loop : loops) border += loop.borderEdges;
  QCOMPARE(border, std::size_t{48});
  QVERIFY(loopsOf(test::kleinBottle(20, 8)).empty());
}

void BoundaryLoopsTest::wallsAreNoHoles() {
  QVERIFY(loopsOf(test::boxWithInnerWall()).empty());
  QVERIFY(loopsOf(test::twoCubesSharingAnEdge()).empty());
  QVERIFY(loopsOf(test::twoCubesSharingAVertex()).empty());
}

void BoundaryLoopsTest::orderOfIds() {
  QVERIFY(rc::check("ids run in order of the smallest vertex after welding", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    TriangleSoup soup = test::randomSoup(random, *rc::gen::inRange<std::size_t>(1, 30), 4);
    if (*rc::gen::arbitrary<bool>()) {
      soup = test::sphereWithHoles(3, 5, 0.35);
      std::shuffle(soup.triangles.begin(), soup.triangles.end(), random);
    }
    const HalfEdgeMesh mesh = buildMesh(soup).mesh;
    const std::vector<std::uint32_t> order = smallestWeldedNumbers(soup, mesh, findBoundaryLoops(mesh));
    RC_ASSERT(std::is_sorted(order.begin(), order.end()));
  }));
}

void BoundaryLoopsTest::promisesOnSoups() {
  QVERIFY(rc::check("loops of any soup", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const auto steps = *rc::gen::inRange<std::uint32_t>(2, 6);
    const HalfEdgeMesh mesh = buildMesh(test::randomSoup(random, *rc::gen::inRange<std::size_t>(1, 80), steps)).mesh;
    RC_ASSERT(broken(mesh, findBoundaryLoops(mesh)) == std::string());
  }));
}

void BoundaryLoopsTest::promisesOnCutSpheres() {
  QVERIFY(rc::check("loops of a sphere without random triangles", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    TriangleSoup soup = test::icosphere(2);
    const auto share = *rc::gen::inRange<std::uint32_t>(1, 90);
    std::erase_if(soup.triangles, [&](const Triangle&) { return random() % 100 < share; });
    const HalfEdgeMesh mesh = buildMesh(soup).mesh;
    RC_ASSERT(broken(mesh, findBoundaryLoops(mesh)) == std::string());
  }));
}

HANDWHEEL_TEST(BoundaryLoopsTest)
#include "BoundaryLoopsTest.moc"
