// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/intersections/FoldedRegionRemoval.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TangledBall.h"
#include "TestClass.h"
#include "base/Tolerance.h"
#include "mesh/repair/intersections/SelfIntersectionRemoval.h"
#include "mesh/search/SurfaceDistance.h"
#include "mesh/structure/MeshBounds.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"
#include "mesh/structure/Shells.h"

#include <QTest>
#include <cmath>
#include <tuple>

using namespace handwheel;

namespace {

constexpr double kUpper = 0.9;  // above it, faces are near the tangled hole

// A ball with a tangled hole above and a clean one below.
HalfEdgeMesh tangledBall(const Vec3& shift = Vec3::Zero(), double scale = 1.0) {
  const TriangleSoup holed = test::withHole(test::sphereWithoutCap(4, 0.12), -Vec3::UnitZ(), 0.3);
  return buildMesh(test::moved(test::withFoldedBorder(holed), shift, scale)).mesh;
}

std::vector<BoundaryLoop> upperLoops(const HalfEdgeMesh& mesh, const Vec3& middle = Vec3::Zero()) {
  std::vector<BoundaryLoop> loops = findBoundaryLoops(mesh);
  std::erase_if(loops, [&](const BoundaryLoop& loop) { return loop.centre.z() < middle.z(); });
  return loops;
}

// With a part far away, so that the box of both has this diagonal.
HalfEdgeMesh withDiagonal(const HalfEdgeMesh& mesh, double diagonal) {
  TriangleSoup s = mesh.compact().soup;
  Box box;
  for (const Vec3& p : s.points) box.extend(p);
  const double length = std::sqrt(diagonal * diagonal - std::pow(box.sizes().y(), 2) - std::pow(box.sizes().z(), 2));
  test::append(s, test::moved(test::tetrahedron(), Vec3(box.min().x() + length - 0.1, 0, 0), 0.1));
  return buildMesh(s).mesh;
}

// Returns the largest distance of a vertex of one mesh from the surface of the other.
double farthestFromSurface(const HalfEdgeMesh& from, const HalfEdgeMesh& to) {
  const SurfaceDistance surface(to);
  double most = 0.0;
  for (const Vec3& p : from.compact().soup.points) most = std::max(most, std::abs(surface.from(p)->distance));
  return most;
}

// Returns the distance by which replacing the folded region above moves the surface of a model with this diagonal;
// nothing if it is not replaced.
std::optional<double> moveIn(const HalfEdgeMesh& folded, double diagonal) {
  const HalfEdgeMesh before = withDiagonal(folded, diagonal);
  HalfEdgeMesh after = before;
  if (replaceFoldedRegions(after, upperLoops(after), {}) == 0) return {};
  return farthestFromSurface(before, after);
}

}  // namespace

class FoldedRegionRemovalTest : public QObject {
  Q_OBJECT

 private slots:
  void tangleGoes();
  void anywhereAndOfAnySize_data();
  void anywhereAndOfAnySize();
  void bodyStays();
  void whatIsToStayOpenStays();
  void farFromTheSurfaceNothingGoes();
  void movesUpToTheTolerance();
  void bodiesGoUpToTheirTolerance();
  void noWorkAllowed();
  void cancelled();
};

// The ball is a ball again above; below it is open as before, and what is not near the tangle is bit for bit the same.
void FoldedRegionRemovalTest::tangleGoes() {
  const HalfEdgeMesh before = tangledBall();
  QVERIFY(countSelfIntersections(before, NumberType::Float64) > 0);
  for (const NumberType numbers : {NumberType::Float64, NumberType::Float32}) {
    HalfEdgeMesh mesh = before;
    FillOptions options;
    options.numbers = numbers;
    const std::size_t gone = replaceFoldedRegions(mesh, upperLoops(mesh), options);
    QVERIFY(gone > 0);
    QVERIFY(gone < before.faceSlots() / 10);
    QCOMPARE(validate(mesh), std::string());
    QCOMPARE(countSelfIntersections(mesh, numbers), std::size_t{0});
    const std::vector<BoundaryLoop> left = findBoundaryLoops(mesh);
    QCOMPARE(left.size(), std::size_t{1});
    QVERIFY(left[0].centre.z() < 0);
    for (Face f = 0; f < before.faceSlots(); ++f) {
      const TrianglePoints was = before.points(f);
      const bool isFar = std::all_of(was.begin(), was.end(), [](const Vec3& p) { return p.z() < kUpper; });
      if (isFar) QVERIFY(mesh.isLive(f) && mesh.points(f) == was);
    }
    // The limits are the distance of the flat triangles from the sphere, and twice that for the patch.
    for (Face f = 0; f < mesh.faceSlots(); ++f) {
      if (!mesh.isLive(f)) continue;
      for (const Vec3& p : mesh.points(f)) QVERIFY(std::abs(p.norm() - 1.0) < 0.01);
    }
  }
}

void FoldedRegionRemovalTest::anywhereAndOfAnySize_data() {
  QTest::addColumn<double>("shift");
  QTest::addColumn<double>("scale");
  QTest::newRow("tiny") << 0.0 << 1e-6;
  QTest::newRow("huge") << 0.0 << 1e6;
  QTest::newRow("far off") << 1e7 << 10.0;
}

void FoldedRegionRemovalTest::anywhereAndOfAnySize() {
  QFETCH(double, shift);
  QFETCH(double, scale);
  const Vec3 middle = Vec3::Constant(shift);
  HalfEdgeMesh mesh = tangledBall(middle, scale);
  QVERIFY(replaceFoldedRegions(mesh, upperLoops(mesh, middle), {}) > 0);
  QCOMPARE(validate(mesh), std::string());
  QVERIFY(upperLoops(mesh, middle).empty());
  QCOMPARE(countSelfIntersections(mesh, NumberType::Float64), std::size_t{0});
}

// A point of the tangle belongs to a loop that is to stay open.
void FoldedRegionRemovalTest::whatIsToStayOpenStays() {
  HalfEdgeMesh mesh = tangledBall();
  const HalfEdgeMesh before = mesh;
  FillOptions options;
  options.keptCorners = {positionKey(loopPoints(mesh, upperLoops(mesh).at(0)).front())};
  QCOMPARE(replaceFoldedRegions(mesh, upperLoops(mesh), options), std::size_t{0});
  QVERIFY(test::sameMesh(mesh, before));
}

// A nail through the border is part of the tangle, but no part of the ball: it is not to be lost.
void FoldedRegionRemovalTest::bodyStays() {
  TriangleSoup s = test::sphereWithoutCap(4, 0.12);
  const HalfEdgeMesh ball = buildMesh(s).mesh;
  const Vec3 border = ball.position(ball.from(findBoundaryLoops(ball)[0].halfEdges[0]));
  test::append(s, test::moved(test::cylinder(8, 1, 0.02, 0.4, true), border - Vec3(0.005, 0.003, 0.2)));
  HalfEdgeMesh mesh = buildMesh(s).mesh;
  replaceFoldedRegions(mesh, findBoundaryLoops(mesh), {});
  QCOMPARE(validate(mesh), std::string());
  QCOMPARE(findShells(mesh).size(), std::size_t{2});
}

// If the surface would move by more than allowed, it stays with its hole.
void FoldedRegionRemovalTest::farFromTheSurfaceNothingGoes() {
  HalfEdgeMesh mesh = tangledBall();
  const BoundaryLoop loop = upperLoops(mesh).at(0);
  mesh.setPosition(mesh.from(loop.halfEdges[0]), Vec3(0.3, 0.2, 2.5));
  const HalfEdgeMesh before = mesh;
  QCOMPARE(replaceFoldedRegions(mesh, upperLoops(mesh), {}), std::size_t{0});
  QVERIFY(test::sameMesh(mesh, before));
}

// The replacement is the same however large the model is.
void FoldedRegionRemovalTest::movesUpToTheTolerance() {
  HalfEdgeMesh folded = tangledBall();
  const BoundaryLoop loop = upperLoops(folded).at(0);
  folded.setPosition(folded.from(loop.halfEdges[0]), Vec3(0.02, 0.01, 1.3));
  const auto move = moveIn(folded, 1e4);
  QVERIFY(move && *move > 0.1);
  const double diagonal = *move / tolerance::kFoldedRegionMove;
  QVERIFY(moveIn(folded, diagonal / 0.98).has_value());
  QVERIFY(!moveIn(folded, diagonal / 1.02).has_value());
}

// A wedge through a folded face, all of whose faces cross it, belongs to the folded region as a whole. Its edge outside
// is much farther from any patch than patches are from each other.
void FoldedRegionRemovalTest::bodiesGoUpToTheirTolerance() {
  const HalfEdgeMesh ball = tangledBall();
  TrianglePoints widest{};
  double inner = 0.0;  // radius of its inscribed circle
  const BoundaryLoop loop = upperLoops(ball).at(0);
  for (const HalfEdge h : loop.halfEdges) {
    const TrianglePoints p = ball.points(HalfEdgeMesh::face(h));
    const double around = (p[1] - p[0]).norm() + (p[2] - p[1]).norm() + (p[0] - p[2]).norm();
    const double radius = (p[1] - p[0]).cross(p[2] - p[0]).norm() / around;
    if (radius > inner) std::tie(inner, widest) = std::tie(radius, p);
  }
  const Vec3 middle = (widest[0] + widest[1] + widest[2]) / 3.0;
  Vec3 out = (widest[1] - widest[0]).cross(widest[2] - widest[0]).normalized();
  if (out.dot(middle) < 0.0) out = -out;
  const double size = 0.2 * inner, length = 5.0;
  const Vec3 u = size * (widest[1] - widest[0]).normalized(), v = u.cross(out), outer = middle + length * out;
  TriangleSoup soup = ball.compact().soup;
  test::append(soup, {{middle - size * out - u, middle - size * out + u, outer - v, outer + v},
                      {{0, 2, 1}, {1, 3, 0}, {2, 0, 3}, {3, 1, 2}}});
  const HalfEdgeMesh folded = buildMesh(soup).mesh;
  const auto move = moveIn(folded, 1e4);
  QVERIFY(move && *move > 0.6 * length);
  const double diagonal = *move / tolerance::kFoldedRegionBodyMove;
  QVERIFY(moveIn(folded, diagonal / 0.98).has_value());
  QVERIFY(!moveIn(folded, diagonal / 1.02).has_value());
}

void FoldedRegionRemovalTest::noWorkAllowed() {
  WorkBudget none(0);
  HalfEdgeMesh mesh = tangledBall();
  const HalfEdgeMesh before = mesh;
  QCOMPARE(replaceFoldedRegions(mesh, {}, {}), std::size_t{0});
  QCOMPARE(replaceFoldedRegions(mesh, upperLoops(mesh), {}, Progress().within(none)), std::size_t{0});
  QVERIFY(test::sameMesh(mesh, before));
}

void FoldedRegionRemovalTest::cancelled() {
  HalfEdgeMesh mesh = tangledBall();
  JobState state;
  state.cancelled = true;
  QCOMPARE(replaceFoldedRegions(mesh, upperLoops(mesh), {}, Progress(state)), std::size_t{0});
}

HANDWHEEL_TEST(FoldedRegionRemovalTest)
#include "FoldedRegionRemovalTest.moc"
