// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/holes/EarClipping.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshBuilder.h"

#include <rapidcheck.h>

#include <QTest>

using namespace handwheel;

namespace {

// The input for filling the first hole of a mesh.
struct EarClippingCase {
  explicit EarClippingCase(const TriangleSoup& soup)
      : mesh(buildMesh(soup).mesh), hole(holeContext(mesh, findBoundaryLoops(mesh).at(0))), obstacles(mesh) {}
  HalfEdgeMesh mesh;
  HoleContext hole;
  Obstacles obstacles;
};

TriangleSoup soupOf(const Patch& patch) {
  return {patch.points, patch.triangles};
}

// The wall under a regular polygon, or any points in convex position, at the height 1.
TriangleSoup tube(const std::vector<double>& angles) {
  return test::grid(static_cast<std::uint32_t>(angles.size()), 2, true, false, [&](std::uint32_t i, std::uint32_t j) {
    return Vec3(std::cos(angles[i]), std::sin(angles[i]), j);
  });
}

}  // namespace

class EarClippingTest : public QObject {
  Q_OBJECT

 private slots:
  void cutThroughLobedPrism();
  void convexPolygons();
  void everyWeight();
  void facesOutward();
  void prefersShortEdges();
  void passesOverTakenEdges();
  void stuckOnAnObstacle();
  void cancels();
};

// n points in convex position: n - 2 triangles over the whole of the polygon, whatever the order of the ears.
void EarClippingTest::convexPolygons() {
  QVERIFY(rc::check("area of random convex polygons", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    std::vector<double> angles(*rc::gen::inRange<std::size_t>(3, 40));
    for (double& u : angles) u = 2.0 * M_PI * (random() / 4294967296.0);
    std::sort(angles.begin(), angles.end());
    for (std::size_t i = 1; i < angles.size(); ++i) RC_PRE(angles[i] - angles[i - 1] > 1e-3);
    double area = 0.0;
    for (std::size_t i = 0; i < angles.size(); ++i)
      area += 0.5 * std::sin((i + 1 < angles.size() ? angles[i + 1] : angles[0] + 2.0 * M_PI) - angles[i]);
    RC_PRE(area > 1e-3);
    const EarClippingCase c(tube(angles));
    const auto patch = clipEars(c.hole, c.obstacles, {});
    RC_ASSERT(patch.has_value());
    RC_ASSERT(patch->triangles.size() == angles.size() - 2);
    RC_ASSERT(patch->points.size() == angles.size());
    RC_ASSERT(patch->loopSize == angles.size());
    RC_ASSERT(std::abs(test::area(soupOf(*patch)) - area) < 1e-12 * area);
  }));
}

void EarClippingTest::everyWeight() {
  const EarClippingCase c(test::withHole(test::icosphere(3), Vec3::UnitZ(), 0.5));
  for (const EarWeights& w : {EarWeights{1, 1, 1}, EarWeights{1, 0, 0}, EarWeights{0, 1, 0}, EarWeights{0, 0, 1}}) {
    const auto patch = clipEars(c.hole, c.obstacles, w);
    QVERIFY(patch.has_value());
    QVERIFY(patch->method == FillMethod::Ear);
    TriangleSoup closed = c.mesh.compact().soup;
    test::append(closed, soupOf(*patch));
    QVERIFY(test::countEdges(closed).sound());
  }
}

// The patch of a convex lid looks away from the part.
void EarClippingTest::facesOutward() {
  const EarClippingCase c(test::withHole(test::icosphere(3), Vec3::UnitZ(), 0.5));
  const auto patch = clipEars(c.hole, c.obstacles, {});
  QVERIFY(patch.has_value());
  QCOMPARE(patch->triangles.size(), c.hole.loopSize - 2);
  for (const Triangle& t : patch->triangles) {
    const TrianglePoints p = corners(*patch, t);
    QVERIFY((p[1] - p[0]).cross(p[2] - p[0]).z() > 0.0);
  }
}

// A square with one corner pulled in: by length alone the short diagonal is the one to cut along.
void EarClippingTest::prefersShortEdges() {
  const TriangleSoup wall = test::grid(4, 2, true, false, [](std::uint32_t i, std::uint32_t j) {
    constexpr double x[] = {2.0, 0.0, -2.0, 0.0}, y[] = {0.0, 0.5, 0.0, -0.5};
    return Vec3(x[i], y[i], j);
  });
  const EarClippingCase c(wall);
  const auto patch = clipEars(c.hole, c.obstacles, {1, 0, 0});
  QVERIFY(patch.has_value());
  QCOMPARE(patch->triangles.size(), std::size_t{2});
  for (const Triangle& t : patch->triangles) {
    const TrianglePoints p = corners(*patch, t);
    int wide = 0;
    for (const Vec3& q : p) wide += std::abs(q.x()) > 1.0;
    QCOMPARE(wide, 1);  // each triangle has one far end
  }
}

void EarClippingTest::passesOverTakenEdges() {
  TriangleSoup soup = test::tetrahedron();
  soup.triangles.resize(2);  // their common edge is a diagonal of the hole
  const EarClippingCase c(soup);
  const auto patch = clipEars(c.hole, c.obstacles, {});
  QVERIFY(patch.has_value());
  TriangleSoup closed = soup;
  test::append(closed, soupOf(*patch));
  QVERIFY(test::countEdges(closed).sound());
}

void EarClippingTest::stuckOnAnObstacle() {
  TriangleSoup soup = test::annulus(12, 2, 1.0, 2.0);
  test::append(soup, test::moved(test::cylinder(6, 1, 0.1, 2.0, true), Vec3(0.03, 0.02, -1.0)));
  const EarClippingCase c(soup);  // its first loop is the inner circle
  QCOMPARE(c.hole.loopSize, std::size_t{12});
  QVERIFY(c.hole.points[0].norm() < 1.5);
  QVERIFY(!clipEars(c.hole, c.obstacles, {}));
}

void EarClippingTest::cancels() {
  const EarClippingCase c(test::withHole(test::icosphere(3), Vec3::UnitZ(), 0.5));
  JobState job;
  job.cancelled = true;
  QVERIFY(!clipEars(c.hole, c.obstacles, {}, Progress(job)));
}

// Walls upright around a flat cut with reflex corners: any triangulation of the cut has exactly its area.
void EarClippingTest::cutThroughLobedPrism() {
  for (double flare : {0.0, 0.5, -0.5}) {
    const std::uint32_t n = 120;
    const TriangleSoup prism = test::grid(5, n, false, true, [&](std::uint32_t i, std::uint32_t j) {
      const double angle = 2.0 * M_PI * j / n, radius = 1.0 + 0.3 * std::cos(7.0 * angle) + flare * 0.05 * i;
      return Vec3(radius * std::cos(angle), radius * std::sin(angle), 0.05 * i);
    });
    const HalfEdgeMesh mesh = buildMesh(prism).mesh;
    const Obstacles obstacles(mesh);
    const std::vector<BoundaryLoop> loops = findBoundaryLoops(mesh);
    QCOMPARE(loops.size(), std::size_t{2});
    for (const BoundaryLoop& loop : loops) {
      const HoleContext hole = holeContext(mesh, loop);
      Vec3 twice = Vec3::Zero();
      for (std::size_t i = 0; i < hole.loopSize; ++i)
        twice += hole.points[i].cross(hole.points[(i + 1) % hole.loopSize]);
      const std::optional<Patch> patch = clipEars(hole, obstacles, {});
      QVERIFY(patch.has_value());
      double area = 0.0;
      for (const Triangle& t : patch->triangles) {
        const TrianglePoints p = corners(*patch, t);
        area += 0.5 * (p[1] - p[0]).cross(p[2] - p[0]).norm();
      }
      QVERIFY(std::abs(area - 0.5 * twice.norm()) < 1e-9);
    }
  }
}

HANDWHEEL_TEST(EarClippingTest)
#include "EarClippingTest.moc"
