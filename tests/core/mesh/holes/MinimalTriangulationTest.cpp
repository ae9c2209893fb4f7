// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/holes/MinimalTriangulation.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "base/Tolerance.h"
#include "mesh/holes/HoleFiller.h"
#include "mesh/structure/MeshBuilder.h"

#include <rapidcheck.h>

#include <QTest>
#include <functional>
#include <limits>

using namespace handwheel;

namespace {

HoleContext contextOf(const TriangleSoup& soup) {
  const HalfEdgeMesh mesh = buildMesh(soup).mesh;
  return holeContext(mesh, findBoundaryLoops(mesh).at(0));
}

// The points of a loop that winds about a circle, each with a face behind it that leans at random.
HoleContext randomHole(std::mt19937& random, std::size_t n, double height) {
  const auto unit = [&] { return random() / 4294967296.0; };
  HoleContext hole;
  hole.loopSize = n;
  for (std::size_t i = 0; i < n; ++i) {
    const double u = -2.0 * M_PI * (static_cast<double>(i) + 0.8 * unit()) / static_cast<double>(n), r = 0.6 + unit();
    hole.points.emplace_back(r * std::cos(u), r * std::sin(u), height * unit());
  }
  for (std::size_t i = 0; i < n; ++i) hole.apexes.push_back(1.7 * hole.points[i] + Vec3(0, 0, height * (unit() - 0.5)));
  hole.edgeLength.assign(n, 1.0);
  return hole;
}

double area(const HoleContext& hole, const Triangle& t) {
  return 0.5 * (hole.points[t[1]] - hole.points[t[0]]).cross(hole.points[t[2]] - hole.points[t[0]]).norm();
}

Vec3 normalOf(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b - a).cross(c - a).normalized();
}

// The largest angle between two triangles of the patch or between one and the face behind the loop.
double largestBend(const HoleContext& hole, const std::vector<Triangle>& triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, Vec3> behind;  // each directed edge
  for (std::uint32_t i = 0; i < hole.loopSize; ++i) {
    const std::uint32_t j = (i + 1) % hole.loopSize;
    behind[{i, j}] = normalOf(hole.points[i], hole.points[j], hole.apexes[i]);
  }
  for (const Triangle& t : triangles)
    for (int k = 0; k < 3; ++k)
      behind[{t[k], t[(k + 1) % 3]}] = normalOf(hole.points[t[0]], hole.points[t[1]], hole.points[t[2]]);
  double largest = 0.0;
  for (const auto& [edge, normal] : behind) {
    const Vec3& other = behind.at({edge.second, edge.first});
    largest = std::max(largest, std::atan2(normal.cross(other).norm(), normal.dot(other)));
  }
  return largest;
}

// Every triangulation of the polygon of points first…last of the loop.
void forEachTriangulation(std::uint32_t first, std::uint32_t last, const std::vector<Triangle>& soFar,
                          const std::function<void(const std::vector<Triangle>&)>& visit) {
  if (last - first < 2) return visit(soFar);
  for (std::uint32_t m = first + 1; m < last; ++m) {
    std::vector<Triangle> with = soFar;
    with.push_back({last, m, first});
    forEachTriangulation(first, m, with,
                         [&](const std::vector<Triangle>& left) { forEachTriangulation(m, last, left, visit); });
  }
}

double totalArea(const HoleContext& hole, const std::vector<Triangle>& triangles) {
  double sum = 0.0;
  for (const Triangle& t : triangles) sum += area(hole, t);
  return sum;
}

}  // namespace

class MinimalTriangulationTest : public QObject {
  Q_OBJECT

 private slots:
  void areaIsTheLeastOfAll();
  void bendIsTheLeastOfQuadrilaterals();
  void bendsLessThanLeastAreaDoes();
  void keepsTheOrientation();
  void flatHolesGetGoodTriangles();
  void anySizeAndPosition();
  void leavesOutTakenEdges();
  void leavesOutFlatTriangles();
  void refusesTheEndless();
};

// Against all triangulations of up to nine points, one by one.
void MinimalTriangulationTest::areaIsTheLeastOfAll() {
  QVERIFY(rc::check("least area", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const HoleContext hole = randomHole(random, 3 + random() % 7, 1.0);
    const auto patch = triangulateOptimal(hole, Criterion::Area);
    RC_ASSERT(patch.has_value());
    RC_ASSERT(patch->method == FillMethod::Area);
    RC_ASSERT(patch->triangles.size() == hole.loopSize - 2);
    double least = std::numeric_limits<double>::infinity();
    forEachTriangulation(0, static_cast<std::uint32_t>(hole.loopSize - 1), {},
                         [&](const std::vector<Triangle>& t) { least = std::min(least, totalArea(hole, t)); });
    RC_ASSERT(std::abs(totalArea(hole, patch->triangles) - least) < 1e-6 * least);
  }));
}

// Four points have two triangulations, so dynamic programming is exact for them.
void MinimalTriangulationTest::bendIsTheLeastOfQuadrilaterals() {
  QVERIFY(rc::check("least bend", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const HoleContext hole = randomHole(random, 4, 1.0);
    const auto patch = triangulateOptimal(hole, Criterion::Dihedral);
    RC_ASSERT(patch.has_value());
    RC_ASSERT(patch->method == FillMethod::Dihedral);
    double least = std::numeric_limits<double>::infinity();
    forEachTriangulation(0, 3, {},
                         [&](const std::vector<Triangle>& t) { least = std::min(least, largestBend(hole, t)); });
    RC_ASSERT(largestBend(hole, patch->triangles) < least + 1e-4);
  }));
}

// A sphere's cap: the least area cuts straight through where the least bend goes round.
void MinimalTriangulationTest::bendsLessThanLeastAreaDoes() {
  double bend[2] = {}, areas[2] = {};
  const HoleContext hole = contextOf(test::withHole(test::bumpySphere(4), Vec3::UnitZ(), 0.5));
  for (Criterion criterion : {Criterion::Area, Criterion::Dihedral}) {
    const auto patch = triangulateOptimal(hole, criterion);
    QVERIFY(patch.has_value());
    const int i = criterion == Criterion::Dihedral;
    bend[i] = largestBend(hole, patch->triangles);
    areas[i] = totalArea(hole, patch->triangles);
  }
  QVERIFY(bend[1] < bend[0]);
  QVERIFY(areas[0] < areas[1]);
}

// The patch runs against the loop, as its only border.
void MinimalTriangulationTest::keepsTheOrientation() {
  const TriangleSoup part = test::withHole(test::icosphere(3), Vec3::UnitZ(), 0.5);
  for (Criterion criterion : {Criterion::Area, Criterion::Dihedral}) {
    const auto patch = triangulateOptimal(contextOf(part), criterion);
    QVERIFY(patch.has_value());
    TriangleSoup closed = part;
    test::append(closed, {patch->points, patch->triangles});
    QVERIFY(test::countEdges(closed).sound());
  }
}

// All triangulations of a flat convex hole have its area; diagonals along the border are shorter than those across.
void MinimalTriangulationTest::flatHolesGetGoodTriangles() {
  const HoleContext hole = contextOf(test::cylinder(40, 2, 1.0, 1.0, false));
  for (Criterion criterion : {Criterion::Area, Criterion::Dihedral}) {
    const auto patch = triangulateOptimal(hole, criterion);
    QVERIFY(patch.has_value());
    QVERIFY(std::abs(totalArea(hole, patch->triangles) - 20.0 * std::sin(M_PI / 20.0)) < 1e-12);
    double squares = 0.0, fan = 0.0;
    for (const Triangle& t : patch->triangles)
      for (int k = 0; k < 3; ++k) squares += (hole.points[t[k]] - hole.points[t[(k + 1) % 3]]).squaredNorm();
    for (std::size_t i = 2; i < 40; ++i)
      fan += (hole.points[0] - hole.points[i]).squaredNorm() + (hole.points[0] - hole.points[i - 1]).squaredNorm();
    QVERIFY(squares < 0.5 * fan);
  }
}

void MinimalTriangulationTest::anySizeAndPosition() {
  const TriangleSoup part = test::withHole(test::bumpySphere(3), Vec3::UnitZ(), 0.5);
  for (Criterion criterion : {Criterion::Area, Criterion::Dihedral}) {
    const HoleContext plain = contextOf(part);
    const double expected = totalArea(plain, triangulateOptimal(plain, criterion)->triangles);
    for (const auto& [scale, shift] : {std::pair{1e-6, 0.0}, {1e6, 0.0}, {1.0, 1e6}, {1e-30, 0.0}}) {
      const HoleContext hole = contextOf(test::moved(part, Vec3::Constant(shift), scale));
      const auto patch = triangulateOptimal(hole, criterion);
      QVERIFY(patch.has_value());
      QVERIFY(std::abs(totalArea(hole, patch->triangles) / (scale * scale) / expected - 1.0) < 1e-8);
    }
  }
}

void MinimalTriangulationTest::leavesOutTakenEdges() {
  const HoleContext hole = contextOf(test::cylinder(6, 2, 1.0, 1.0, false));
  for (Criterion criterion : {Criterion::Area, Criterion::Dihedral}) {
    const auto patch = triangulateOptimal(hole, criterion, {{0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5}});
    QVERIFY(patch.has_value());
    QCOMPARE(std::count_if(patch->triangles.begin(), patch->triangles.end(),
                           [](const Triangle& t) { return std::find(t.begin(), t.end(), 0u) != t.end(); }),
             std::ptrdiff_t{1});  // the ear at point 0
    QVERIFY(!triangulateOptimal(contextOf(test::cylinder(4, 2, 1.0, 1.0, false)), criterion, {{0, 2}, {1, 3}}));
  }
}

// A square with points along its sides: flat triangles would cost nothing.
void MinimalTriangulationTest::leavesOutFlatTriangles() {
  const double x[] = {0, 1, 2, 2, 2, 1, 0, 0}, y[] = {0, 0, 0, 1, 2, 2, 2, 1};
  const HoleContext hole =
      contextOf(test::grid(8, 2, true, false, [&](std::uint32_t i, std::uint32_t j) { return Vec3(x[i], y[i], j); }));
  for (Criterion criterion : {Criterion::Area, Criterion::Dihedral}) {
    const auto patch = triangulateOptimal(hole, criterion);
    QVERIFY(patch.has_value());
    for (const Triangle& t : patch->triangles)
      QVERIFY(!isDegenerate({hole.points[t[0]], hole.points[t[1]], hole.points[t[2]]}));
    QVERIFY(std::abs(totalArea(hole, patch->triangles) - 4.0) < 1e-12);
  }
  HoleContext line;  // all on one line: none has area
  line.loopSize = 5;
  for (int i = 0; i < 5; ++i) line.points.emplace_back(i, 2.0 * i, 0.0);
  line.apexes.assign(5, Vec3::UnitZ());
  QVERIFY(!triangulateOptimal(line, Criterion::Area));
  QVERIFY(!triangulateOptimal(line, Criterion::Dihedral));
}

void MinimalTriangulationTest::refusesTheEndless() {
  QVERIFY(triangulateOptimal(contextOf(test::cylinder(tolerance::kOptimalFillEdges, 1, 1.0, 0.1, false)),
                             Criterion::Dihedral));
  const HoleContext large = contextOf(test::cylinder(tolerance::kOptimalFillEdges + 1, 1, 1.0, 0.1, false));
  QVERIFY(!triangulateOptimal(large, Criterion::Area));
  JobState job;
  job.cancelled = true;
  const HoleContext hole = contextOf(test::cylinder(20, 1, 1.0, 0.1, false));
  QVERIFY(!triangulateOptimal(hole, Criterion::Area, {}, Progress(job)));
  HoleContext wild = hole;
  wild.points[3].x() = std::numeric_limits<double>::quiet_NaN();
  if (const auto patch = triangulateOptimal(wild, Criterion::Dihedral))
    QCOMPARE(patch->triangles.size(), hole.loopSize - 2);

  // Longer holes are cut into pieces first.
  const HalfEdgeMesh mesh = buildMesh(test::cylinder(2000, 2, 10.0, 1.0, false)).mesh;
  for (FillMethod method : {FillMethod::Area, FillMethod::Dihedral}) {
    FillOptions options;
    options.method = method;
    options.tryOthers = false;
    options.pieceEdges = 100'000;
    const FillAttempt attempt = HoleFiller(mesh).propose(findBoundaryLoops(mesh).at(0), options);
    QVERIFY(attempt.failure == FillFailure::None);
    QVERIFY(attempt.patch.method == method);
    QCOMPARE(attempt.patch.triangles.size(), std::size_t{1998});
  }
}

HANDWHEEL_TEST(MinimalTriangulationTest)
#include "MinimalTriangulationTest.moc"
