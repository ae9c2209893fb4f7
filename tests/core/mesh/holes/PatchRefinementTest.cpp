// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/holes/PatchRefinement.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "base/WorkBudget.h"
#include "mesh/holes/CgalHoleFilling.h"
#include "mesh/holes/FlatTriangulation.h"
#include "mesh/structure/MeshBuilder.h"

#include <QTest>
#include <algorithm>
#include <map>
#include <random>

using namespace handwheel;

namespace {

HoleContext firstHoleOf(const TriangleSoup& soup) {
  const HalfEdgeMesh mesh = buildMesh(soup).mesh;
  return holeContext(mesh, findBoundaryLoops(mesh).at(0));
}

// A hole without surroundings.
HoleContext holeWithin(const std::vector<Vec3>& points) {
  HoleContext hole;
  hole.points = points;
  hole.loopSize = points.size();
  return hole;
}

bool closesPart(const TriangleSoup& part, const Patch& patch) {
  TriangleSoup closed = part;
  test::append(closed, {patch.points, patch.triangles});
  return test::countEdges(closed).sound();
}

double meanEdgeOf(const TriangleSoup& s) {
  double sum = 0.0;
  for (const Triangle& t : s.triangles)
    for (int k = 0; k < 3; ++k) sum += (s.points[t[k]] - s.points[t[(k + 1) % 3]]).norm();
  return sum / (3.0 * s.triangles.size());
}

// Twice the ratio of inscribed to circumscribed circle: 1 for an equilateral triangle, 0 for a degenerate one.
double roundness(const std::array<Vec3, 3>& t) {
  const double a = (t[1] - t[0]).norm(), b = (t[2] - t[1]).norm(), c = (t[0] - t[2]).norm();
  return (b + c - a) * (c + a - b) * (a + b - c) / (a * b * c);
}

std::vector<double> roundnessesOf(const Patch& patch) {
  std::vector<double> all;
  for (const Triangle& t : patch.triangles)
    all.push_back(roundness({patch.points[t[0]], patch.points[t[1]], patch.points[t[2]]}));
  std::sort(all.begin(), all.end());
  return all;
}

// A polygon with n edges along a circle whose radius varies at random by a share of it.
std::vector<Vec3> raggedPolygon(std::size_t n, double share, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2.0 * M_PI * static_cast<double>(i) / static_cast<double>(n);
    const double radius = 10.0 * (1.0 - share * random() / 4294967296.0);
    points.push_back({radius * std::cos(angle), radius * std::sin(angle), 0.0});
  }
  return points;
}

double areaOf(const Patch& patch) {
  return test::area({patch.points, patch.triangles});
}

}  // namespace

class PatchRefinementTest : public QObject {
  Q_OBJECT

 private slots:
  void refinedHasTheDensityAround();
  void fairBulgesFlatDoesNot();
  void holdsTheNumberOfVertices();
  void evenTriangles_data();
  void evenTriangles();
  void staysInTheOutline();
  void doublesNoEdge();
  void hostileFansAreRefused();
  void givesUpWithinTheEffort();
};

void PatchRefinementTest::refinedHasTheDensityAround() {
  const TriangleSoup soup = test::sphereWithoutCap(4);
  const HoleContext hole = firstHoleOf(soup);
  const auto refined = refinePatch(hole, triangulateMinimal(hole).value());
  QVERIFY(refined && refined->method == FillMethod::Refined && !refined->continuity);
  std::vector<Patch> patches{*refined};
  for (const auto bent : {Continuity::Position, Continuity::Tangent, Continuity::Curvature}) {
    patches.push_back(fairPatch(hole, *refined, bent).value());
    QVERIFY(patches.back().method == FillMethod::Fair && patches.back().continuity == bent);
  }
  for (const Patch& patch : patches) {
    QVERIFY(patch.points.size() > hole.loopSize);
    QVERIFY(closesPart(soup, patch));
    const double ratio = meanEdgeOf({patch.points, patch.triangles}) / meanEdgeOf(soup);
    QVERIFY(ratio > 0.8 && ratio < 1.25);
  }
}

// Refined: the new points are on the triangles of the start. Fair: the middle rises towards the sphere, the further the
// smoother it continues it; a membrane spans the loop.
void PatchRefinementTest::fairBulgesFlatDoesNot() {
  const HoleContext hole = firstHoleOf(test::sphereWithoutCap(4));
  const Patch refined = refinePatch(hole, triangulateMinimal(hole).value()).value();
  double rim = 0.0;
  for (const Vec3& p : hole.loop()) rim = std::max(rim, p.z());
  const auto topOf = [&](const Patch& patch) {
    double z = 0.0;
    for (const Vec3& p : patch.points) z = std::max(z, p.z());
    return z;
  };
  const auto top = [&](Continuity bent) { return topOf(fairPatch(hole, refined, bent).value()); };
  const double fair = top(Continuity::Tangent);
  QVERIFY(topOf(refined) <= rim + 1e-12);
  QVERIFY(top(Continuity::Position) <= rim + 1e-12);
  QVERIFY(std::abs(top(Continuity::Curvature) - 1.0) < std::abs(fair - 1.0));
  QVERIFY(fair > rim + 0.7 * (1.0 - rim));
}

// Tubes whose rims have tiny edges: at their density a lid would need n² / 11 vertices. It gets fewer, which are denser
// at the rim, and every triangle is well shaped all the same.
void PatchRefinementTest::holdsTheNumberOfVertices() {
  for (const std::uint32_t n : {300U, 4000U}) {
    const HoleContext hole = firstHoleOf(test::cylinder(n, 4, 1.0, 0.02, false));
    const auto patch = refinePatch(hole, triangulateMinimal(hole).value());
    QVERIFY(patch.has_value());
    const std::size_t added = patch->points.size() - n;
    const std::size_t most = std::min<std::size_t>(tolerance::kPatchVertices, n * tolerance::kPatchVerticesPerEdge);
    QVERIFY2(added <= most && added >= n / 2, qPrintable(QString::number(added)));
    QVERIFY(roundnessesOf(*patch).front() > 0.3);
  }
}

void PatchRefinementTest::evenTriangles_data() {
  QTest::addColumn<std::vector<Vec3>>("outline");
  for (const std::size_t n : {50, 138, 400, 1186}) {
    QTest::addRow("round, %zu edges", n) << raggedPolygon(n, 0.0, 1);
    QTest::addRow("ragged, %zu edges", n) << raggedPolygon(n, 2.0 * M_PI / static_cast<double>(n), 2);
  }
  std::vector<Vec3> uneven;  // one half has edges that are eight times as long
  for (int i = 0; i < 90; ++i) {
    const double angle = i < 80 ? M_PI * i / 80.0 : M_PI * (1.0 + (i - 80) / 10.0);
    uneven.push_back({10.0 * std::cos(angle), 10.0 * std::sin(angle), 0.0});
  }
  QTest::newRow("edges of several lengths") << uneven;
}

// A triangulation without added points has slivers all over: most of its triangles are less round than the worst ones
// of the refined patch. The area of the polygon stays, as nothing folds.
void PatchRefinementTest::evenTriangles() {
  QFETCH(std::vector<Vec3>, outline);
  const HoleContext hole = holeWithin(outline);
  const Patch start = triangulateFlat(hole).value();
  const Patch patch = refinePatch(hole, start).value();
  for (std::size_t i = 0; i < outline.size(); ++i) QVERIFY(test::sameBits(patch.points[i], outline[i]));
  QVERIFY(std::abs(areaOf(patch) - areaOf(start)) < 1e-9 * areaOf(start));
  const std::vector<double> even = roundnessesOf(patch), before = roundnessesOf(start);
  QVERIFY2(even.front() > 0.2, qPrintable(QString::number(even.front())));
  QVERIFY2(even[even.size() / 20] > 0.7, qPrintable(QString::number(even[even.size() / 20])));
  QVERIFY(before[before.size() / 2] < even.front());
}

// A base whose outline is concave: seen from above, the triangles cover what the outline does, exactly once.
void PatchRefinementTest::staysInTheOutline() {
  std::vector<Vec3> comb;
  const auto walk = [&](const Vec3& to) {
    if (comb.empty()) return comb.push_back(to);
    const Vec3 from = comb.back();
    for (int i = 1; i <= 10; ++i) comb.push_back(from + (to - from) * i / 10.0);
  };
  for (const Vec3& corner : {Vec3(0, 0, 0), Vec3(7, 0, 0), Vec3(7, 4, 0), Vec3(6, 4, 0), Vec3(6, 1, 0), Vec3(5, 1, 0),
                             Vec3(5, 4, 0), Vec3(3, 4, 0), Vec3(3, 1, 0), Vec3(2, 1, 0), Vec3(2, 4, 0), Vec3(0, 4, 0)})
    walk(corner);
  for (int i = 1; i < 10; ++i) comb.push_back({0, 4.0 - 0.4 * i, 0});
  const HoleContext hole = holeWithin(comb);
  const Patch patch = refinePatch(hole, triangulateFlat(hole).value()).value();
  QVERIFY(std::abs(areaOf(patch) - (7.0 * 4.0 - 3.0 - 3.0)) < 1e-9);
  QVERIFY(roundnessesOf(patch).front() > 0.4);
}

// The corners of a zigzag rim are joined by edges of the surface already: no edge of the patch may join them again.
void PatchRefinementTest::doublesNoEdge() {
  const std::vector<Vec3> outline = raggedPolygon(40, 0.2, 3);
  const HoleContext hole = holeWithin(outline);
  JoinedPoints joined;
  for (std::uint32_t i = 0; i < 40; ++i) joined.push_back(std::minmax(i, (i + 2) % 40));
  std::sort(joined.begin(), joined.end());
  const Patch patch = refinePatch(hole, triangulateFlat(hole).value(), tolerance::kPatchDensity, joined).value();
  for (const Triangle& t : patch.triangles) {
    for (int k = 0; k < 3; ++k) {
      const std::pair<std::uint32_t, std::uint32_t> edge = std::minmax(t[k], t[(k + 1) % 3]);
      QVERIFY(!std::binary_search(joined.begin(), joined.end(), edge));
    }
  }
}

// A vertex with thousands of faces would take minutes.
void PatchRefinementTest::hostileFansAreRefused() {
  TriangleSoup cone;  // with one face left out
  const auto n = static_cast<std::uint32_t>(tolerance::kLibraryFanFaces + 2);
  for (std::uint32_t i = 0; i < n; ++i) {
    cone.points.push_back(Vec3(std::cos(2.0 * M_PI * i / n), std::sin(2.0 * M_PI * i / n), 0));
    if (i > 0) cone.triangles.push_back({i, (i + 1) % n, n});
  }
  cone.points.push_back(Vec3(0, 0, 1));
  const HoleContext hole = firstHoleOf(cone);
  QVERIFY(!refinePatch(hole, {3, hole.points, {{0, 2, 1}}, FillMethod::Minimal}));
  // No manifold: two triangles on the same side of an edge.
  const HoleContext square = holeWithin({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)});
  QVERIFY(!refinePatch(square, {4, square.points, {{0, 1, 2}, {0, 1, 3}}, FillMethod::Minimal}));
}

void PatchRefinementTest::givesUpWithinTheEffort() {
  constexpr std::size_t kMost = 20'000;
  const HoleContext hole = holeWithin(raggedPolygon(1000, 0.0, 1));
  const Patch start = triangulateFlat(hole).value();
  const auto spentBy = [&](std::size_t most) {
    WorkBudget effort(most);
    const bool isMade = refinePatch(hole, start, tolerance::kPatchDensity, {}, Progress().within(effort)).has_value();
    return std::pair(isMade, effort.spent());
  };
  const auto [isMade, spent] = spentBy(std::size_t(1) << 40);
  QVERIFY(isMade && spent > kMost);
  QVERIFY(!spentBy(kMost).first);
}

HANDWHEEL_TEST(PatchRefinementTest)
#include "PatchRefinementTest.moc"
