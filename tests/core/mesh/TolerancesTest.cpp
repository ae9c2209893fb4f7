// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/Tolerance.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "OneSidedShapes.h"
#include "TestClass.h"
#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/boundary/BoundaryVertices.h"
#include "mesh/defects/Defects.h"
#include "mesh/holes/Creases.h"
#include "mesh/holes/HoleContext.h"
#include "mesh/holes/HoleFiller.h"
#include "mesh/repair/Cleaning.h"
#include "mesh/repair/Repair.h"
#include "mesh/repair/SheetThickening.h"
#include "mesh/repair/intersections/Autorefinement.h"
#include "mesh/search/SmoothNormal.h"
#include "mesh/structure/FaceNormal.h"
#include "mesh/structure/MeshBounds.h"
#include "mesh/structure/MeshBuilder.h"

#include <QTest>

using namespace handwheel;

namespace {

// Shares of a tolerance just below and just above it.
constexpr double kJustBelow = 0.98, kJustAbove = 1.02;

// Returns true if the longest loop is the rim of a sheet, not a hole.
bool isSheet(const TriangleSoup& soup) {
  const std::vector<BoundaryLoop> loops = findBoundaryLoops(buildMesh(soup).mesh);
  return std::max_element(loops.begin(), loops.end(),
                          [](const BoundaryLoop& a, const BoundaryLoop& b) { return a.length < b.length; })
      ->isSheetBoundary;
}

// The argument from 0 to `most` at which a rising function has this value.
template <class Function>
double whereIs(double value, double most, Function rising) {
  double low = 0.0, high = most;
  if (rising(high) < value) qFatal("the function does not rise so far");
  for (int i = 0; i < 100; ++i) (rising(0.5 * (low + high)) < value ? low : high) = 0.5 * (low + high);
  return low;
}

// The part of the unit sphere above a height, of which the faces look up by (1 + height) / 2: its lid's area, π(1 -
// height²), in areas of its own, 2π(1 - height).
TriangleSoup sphereAbove(double height) {
  TriangleSoup s = test::disc(256, 64);
  for (Vec3& p : s.points) {
    const double z = 1.0 - (1.0 - height) * p.squaredNorm(), r = std::sqrt(1.0 - z * z);
    p = p.norm() > 0.0 ? Vec3(r / p.norm() * p.x(), r / p.norm() * p.y(), z) : Vec3(0, 0, 1);
  }
  return s;
}

// A gutter of three quarters of a tube's round, of this width in lengths.
TriangleSoup gutter(double width) {
  return test::grid(97, 33, false, false, [&](std::uint32_t i, std::uint32_t j) {
    const double u = 1.5 * M_PI * i / 96.0;
    return Vec3(width * std::cos(u), width * std::sin(u), j / 32.0);
  });
}

// A tube whose lower end has teeth.
TriangleSoup toothedTube(double depth) {
  return test::grid(64, 4, true, false, [&](std::uint32_t i, std::uint32_t j) {
    const double u = 2.0 * M_PI * i / 64;
    return Vec3(std::cos(u), std::sin(u), j == 0 ? (i % 2) * depth : 2.0 * j / 3.0);
  });
}

double toothedEnd(double depth) {
  return 64.0 * std::hypot(2.0 * std::sin(M_PI / 64.0), depth);
}

// Two slopes whose normals meet at this angle, over the line x = 0.
TriangleSoup roof(double angle) {
  return test::grid(21, 21, false, false, [&](std::uint32_t i, std::uint32_t j) {
    const double x = i - 10.0;
    return Vec3(x * std::cos(angle / 2), j - 10.0, -std::abs(x) * std::sin(angle / 2));
  });
}

// Two squares of 1 with a gap between them.
TriangleSoup squaresApart(double gap) {
  TriangleSoup s = test::grid(2, 2, false, false, [](std::uint32_t i, std::uint32_t j) { return Vec3(i, j, 0); });
  test::append(s, test::moved(s, Vec3(1.0 + gap, 0, 0)));
  return s;
}

// A ball of 1,280 triangles and, outside of it, a double pyramid over so many corners with this share of its area.
TriangleSoup ballWithCrumb(double share, std::uint32_t corners) {
  TriangleSoup ball = test::icosphere(3), crumb = test::uvSphere(corners, 2);
  const double scale = std::sqrt(share * test::area(ball) / test::area(crumb));
  test::append(ball, test::moved(crumb, Vec3(3, 0, 0), scale));
  return ball;
}

}  // namespace

// The tolerances that decide what becomes of a user's mesh: a case just below and one just above each.
class TolerancesTest : public QObject {
  Q_OBJECT

 private slots:
  void sheetFacingOneDirection();
  void sheetVolume();
  void raggedOutline();
  void debris();
  void flap();
  void nearWeld();
  void nearWeldEdge();
  void creaseAngleOfHoles();
  void creaseAngle();
  void pieceEdges();
  void cutBits();
  void sheetThickness();
  void oneSidedCut();
};

void TolerancesTest::sheetFacingOneDirection() {
  const auto heightOf = [](double share) { return 2.0 * share - 1.0; };
  QVERIFY(!isSheet(sphereAbove(heightOf(kJustBelow * tolerance::kSheetAreaVector))));
  QVERIFY(isSheet(sphereAbove(heightOf(kJustAbove * tolerance::kSheetAreaVector))));
}

// Closed from the centre of its outline.
void TolerancesTest::sheetVolume() {
  const auto share = [](double width) {
    const TriangleSoup s = gutter(width);
    const Vec3 centre = findBoundaryLoops(buildMesh(s).mesh).at(0).centre;
    return std::abs(test::volume(test::moved(s, -centre))) / std::pow(test::area(s), 1.5);
  };
  QVERIFY(isSheet(gutter(whereIs(kJustBelow * tolerance::kSheetVolume, 0.3, share))));
  QVERIFY(!isSheet(gutter(whereIs(kJustAbove * tolerance::kSheetVolume, 0.3, share))));
}

void TolerancesTest::raggedOutline() {
  const auto outline = [](double depth) { return std::pow(toothedEnd(depth), 2) / test::area(toothedTube(depth)); };
  QVERIFY(!isSheet(toothedTube(whereIs(kJustBelow * tolerance::kRaggedOutline, 0.65, outline))));
  QVERIFY(isSheet(toothedTube(whereIs(kJustAbove * tolerance::kRaggedOutline, 0.65, outline))));
}

// 12 triangles are less than that share of 1,280, and 14 are more.
void TolerancesTest::debris() {
  const auto removed = [](const TriangleSoup& soup) {
    HalfEdgeMesh mesh = buildMesh(soup).mesh;
    return removeDebris(mesh);
  };
  QVERIFY(12 < tolerance::kDebrisFaces * 1280 && tolerance::kDebrisFaces * 1280 < 14);
  QCOMPARE(removed(ballWithCrumb(kJustBelow * tolerance::kDebrisArea, 6)), std::size_t{12});
  QCOMPARE(removed(ballWithCrumb(kJustAbove * tolerance::kDebrisArea, 6)), std::size_t{0});
  QCOMPARE(removed(ballWithCrumb(kJustBelow * tolerance::kDebrisArea, 7)), std::size_t{0});
}

// Upright on an edge of a ball, and well within its box; its two free edges are the longest.
void TolerancesTest::flap() {
  const TriangleSoup ball = test::icosphere(6);
  Box box;
  for (const Vec3& p : ball.points) box.extend(p);
  const Triangle at = *std::max_element(ball.triangles.begin(), ball.triangles.end(), [&](auto& a, auto& b) {
    return ball.points[a[0]].sum() < ball.points[b[0]].sum();
  });
  const Vec3 &a = ball.points[at[0]], &b = ball.points[at[1]];
  const auto removed = [&](double longest) {
    TriangleSoup s = ball;
    const double height = std::sqrt(longest * longest - 0.25 * (a - b).squaredNorm());
    s.points.push_back(0.5 * (a + b) + height * (a + b).normalized());
    s.triangles.push_back({at[0], at[1], static_cast<std::uint32_t>(s.points.size() - 1)});
    HalfEdgeMesh mesh = buildMesh(s).mesh;
    return removeFlaps(mesh);
  };
  const double limit = tolerance::kFlap * box.diagonal().norm();
  QVERIFY((a - b).norm() < kJustBelow * limit);
  QCOMPARE(removed(kJustBelow * limit), std::size_t{1});
  QCOMPARE(removed(kJustAbove * limit), std::size_t{0});
}

void TolerancesTest::nearWeld() {
  const double diagonal = std::hypot(2.0, 1.0);
  const auto pairs = [](double gap) { return nearBoundaryVertices(buildMesh(squaresApart(gap)).mesh).size(); };
  QCOMPARE(pairs(kJustBelow * tolerance::kNearWeld * diagonal), std::size_t{2});
  QCOMPARE(pairs(kJustAbove * tolerance::kNearWeld * diagonal), std::size_t{0});
}

// The reach is so wide that only the edges, all of length 1, limit the distance.
void TolerancesTest::nearWeldEdge() {
  const auto pairs = [](double gap) { return nearBoundaryVertices(buildMesh(squaresApart(gap)).mesh, {}, 0.5).size(); };
  QCOMPARE(pairs(kJustBelow * tolerance::kNearWeldEdge), std::size_t{2});
  QCOMPARE(pairs(kJustAbove * tolerance::kNearWeldEdge), std::size_t{0});
}

// A hole across the ridge of a roof has the two ends of the ridge.
void TolerancesTest::creaseAngleOfHoles() {
  const auto ends = [](double angle) {
    const HalfEdgeMesh mesh = buildMesh(test::withHole(roof(angle), Vec3::Zero(), 3.5)).mesh;
    std::vector<BoundaryLoop> loops = findBoundaryLoops(mesh);
    std::erase_if(loops, [](const BoundaryLoop& loop) { return loop.box.contains(Vec3(0, -10, 0)); });
    return findCreaseEnds(holeContext(mesh, loops.at(0)), tolerance::kCreaseAngle).size();
  };
  QCOMPARE(ends(kJustBelow * tolerance::kCreaseAngle), std::size_t{0});
  QCOMPARE(ends(kJustAbove * tolerance::kCreaseAngle), std::size_t{2});
}

// On the ridge of a roof the shading is smooth, straight up, as long as its sides meet at less than 40°; else each side
// has its own.
void TolerancesTest::creaseAngle() {
  const double crease = 40.0 * M_PI / 180.0;
  const auto normals = [](double angle) {
    const TriangleSoup soup = roof(angle);
    const HalfEdgeMesh mesh = buildMesh(soup).mesh;
    const Vec3 p(0, 0.5, 0);
    std::vector<std::array<Vec3, 2>> found;  // shaded, and the face's own
    for (Face f = 0; f < mesh.faceSlots(); ++f) {
      const TrianglePoints t = mesh.points(f);
      const bool isThere =
          std::count(t.begin(), t.end(), Vec3(0, 0, 0)) + std::count(t.begin(), t.end(), Vec3(0, 1, 0)) == 2;
      if (isThere) found.push_back({smoothNormal(mesh, f, p), unitNormal(t)});
    }
    return found;
  };
  const auto below = normals(kJustBelow * crease), above = normals(kJustAbove * crease);
  QCOMPARE(below.size(), std::size_t{2});
  QCOMPARE(above.size(), std::size_t{2});
  for (const auto& [shaded, own] : below) QVERIFY((shaded - Vec3::UnitZ()).norm() < 1e-9);
  for (const auto& [shaded, own] : above) QVERIFY((shaded - own).norm() < 1e-9);
}

void TolerancesTest::pieceEdges() {
  const auto chords = [](std::uint32_t edges) {
    const HalfEdgeMesh mesh = buildMesh(test::cylinder(edges, 2, 1.0, 1.0, false)).mesh;
    return HoleFiller(mesh).proposeHoleBridges(findBoundaryLoops(mesh).at(0)).size();
  };
  QCOMPARE(chords(tolerance::kPieceEdges), std::size_t{0});
  QVERIFY(chords(tolerance::kPieceEdges + 1) > 0);
}

// Two triangles that cross, of coordinates from 1 to a power of two so many bits below.
void TolerancesTest::cutBits() {
  const auto cut = [](int bits) {
    const double small = std::ldexp(1.0, 1 - bits);
    const TriangleSoup s{{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, {0, small, -1}, {0, small, 1}, {0, -0.5, 1}},
                         {{0, 1, 2}, {3, 4, 5}}};
    return !autorefine(s, std::vector<TrianglePair>{{0, 1}}, NumberType::Float64).piecesOf.empty();
  };
  QVERIFY(cut(tolerance::kCutBits));
  QVERIFY(!cut(tolerance::kCutBits + 1));
}

// A sheet thickened by default becomes a body of that thickness.
void TolerancesTest::sheetThickness() {
  const HalfEdgeMesh sheet = buildMesh(test::grid(9, 9, false, false, [](std::uint32_t i, std::uint32_t j) {
                               return Vec3(3.0 * i, 4.0 * j, 0);
                             })).mesh;
  QVERIFY(std::abs(defaultSheetThickness(sheet) - tolerance::kSheetThickness * 40.0) < 1e-12);
}

// A sphere with one side only has to be cut along three edges. A tetrahedron far away makes the diagonal.
void TolerancesTest::oneSidedCut() {
  const auto cuts = [](double share) {
    TriangleSoup s = test::sphereWithCrossCap(2);
    const std::size_t n = s.points.size();
    double length = 0.0;
    for (std::size_t i = 0; i < 3; ++i) length += (s.points[n - 3 + i] - s.points[n - 3 + (i + 1) % 3]).norm();
    const auto with = [&](double x) {
      TriangleSoup both = s;
      test::append(both, test::moved(test::tetrahedron(), Vec3(x, 0, 0)));
      return buildMesh(both).mesh;
    };
    const double diagonal = length / (share * tolerance::kOneSidedCut);
    HalfEdgeMesh mesh = with(whereIs(diagonal, 2.0 * diagonal, [&](double x) { return diagonalOf(with(x)); }));
    return repair(mesh, {}).nonOrientableCuts;
  };
  QCOMPARE(cuts(kJustBelow), std::size_t{1});
  QCOMPARE(cuts(kJustAbove), std::size_t{0});
}

HANDWHEEL_TEST(TolerancesTest)
#include "TolerancesTest.moc"
