// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/SheetThickening.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "base/Tolerance.h"
#include "mesh/repair/SheetClosing.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <QTest>

using namespace handwheel;

namespace {

double volume(const HalfEdgeMesh& mesh) {
  return test::volume(mesh.compact().soup);
}

ThickenedSheets thickened(HalfEdgeMesh& mesh, std::vector<Face> sheet, double thickness,
                          NumberType numbers = NumberType::Float64) {
  const std::vector<OpenSheet> sheets{{std::move(sheet), thickness}};
  return thickenSheets(mesh, sheets, numbers);
}

HalfEdgeMesh backed(const TriangleSoup& soup, double thickness) {
  HalfEdgeMesh mesh = buildMesh(soup).mesh;
  thickened(mesh, sheetOf(mesh, 0), thickness);
  relink(mesh);
  return mesh;
}

// No two faces meet at an edge with less than 60° of the body between them.
bool isBlunt(const HalfEdgeMesh& mesh) {
  const auto normal = [&](Face f) {
    const TrianglePoints p = mesh.points(f);
    return Vec3((p[1] - p[0]).cross(p[2] - p[0]).stableNormalized());
  };
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    for (HalfEdge h = 3 * f; mesh.isLive(f) && h < 3 * f + 3; ++h)
      if (!mesh.hasOpposite(h) || normal(f).dot(normal(HalfEdgeMesh::face(mesh.opposite(h)))) < -0.5) return false;
  }
  return true;
}

TriangleSoup rectangle(double a, double b) {
  return test::grid(7, 5, false, false,
                    [&](std::uint32_t i, std::uint32_t j) { return Vec3(a * i / 6.0, b * j / 4.0, 0.0); });
}

bool isNearlyThatShare(double value, double expected, double tolerance = 1e-9) {
  return std::abs(value - expected) <= tolerance * std::abs(expected);
}

}  // namespace

class SheetThickeningTest : public QObject {
  Q_OBJECT

 private slots:
  void oneTriangle();
  void sheets_data();
  void sheets();
  void box_data();
  void box();
  void annulus();
  void tube();
  void openBox();
  void shellOfABall();
  void wavySheet();
  void tipOfANeedle();
  void severalSheets();
  void pinchedOutline();
  void sharpWhereNoSideFits();
  void onlyThisSheet();
  void backOnAnotherSheet();
  void thinnerBeforeAnObstacle();
  void fold();
  void saysWhatWasReached();
  void noRoomForTheThickness();
  void flakesNobodyAskedFor();
  void proposals();
};

// A prism under the triangle.
void SheetThickeningTest::oneTriangle() {
  const HalfEdgeMesh mesh = backed({{{0, 0, 5}, {2, 0, 5}, {0, 2, 5}}, {{0, 1, 2}}}, 0.25);
  QCOMPARE(mesh.liveFaceCount(), std::size_t{8});
  QVERIFY(test::countEdges(mesh).sound());
  QVERIFY(isNearlyThatShare(volume(mesh), 2.0 * 0.25));
}

void SheetThickeningTest::sheets_data() {
  QTest::addColumn<TriangleSoup>("soup");
  QTest::newRow("two triangles") << TriangleSoup{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  QTest::newRow("strip") << test::cylinder(12, 1, 1.0, 0.3, false);
  QTest::newRow("fan of one inner face") << TriangleSoup{
      {{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, -1, 0}, {1.5, 1, 0}, {-0.5, 1, 0}},
      {{0, 1, 2}, {1, 0, 3}, {2, 1, 4}, {0, 2, 5}}};
  QTest::newRow("annulus") << test::annulus(24, 3, 1.0, 2.0);
  QTest::newRow("ball without a cap") << test::sphereWithoutCap(3);
  QTest::newRow("ball with holes") << test::sphereWithHoles(4, 5, 0.3);
}

void SheetThickeningTest::sheets() {
  QFETCH(TriangleSoup, soup);
  for (const Vec3& shift : {Vec3(0, 0, 0), Vec3(1e5, -1e5, 1e5)}) {
    const HalfEdgeMesh before = buildMesh(test::moved(soup, shift)).mesh;
    const HalfEdgeMesh mesh = backed(test::moved(soup, shift), 0.01);
    QVERIFY(test::countEdges(mesh).sound());
    QCOMPARE(test::meetingPairs(mesh), std::size_t{0});
    QCOMPARE(validate(mesh), std::string());
    QVERIFY(test::volume(test::moved(mesh.compact().soup, -shift)) > 0.0);
    for (Face f = 0; f < before.faceSlots(); ++f) QVERIFY(mesh.points(f) == before.points(f));
  }
}

void SheetThickeningTest::box_data() {
  QTest::addColumn<double>("scale");
  QTest::addColumn<double>("thickness");
  QTest::addColumn<Vec3>("at");
  const Vec3 origin = Vec3::Zero();
  QTest::newRow("thin") << 1.0 << 0.01 << origin;
  QTest::newRow("thicker than its edges are long") << 1.0 << 5.0 << origin;
  QTest::newRow("tiny") << 1e-7 << 0.1 << origin;
  QTest::newRow("huge") << 1e7 << 0.1 << origin;
  QTest::newRow("far from the origin") << 1.0 << 0.25 << Vec3(4096.0, -4096.0, 8192.0);
}

// A flat rectangle becomes a box, of which it is the upper side, and no edge is sharp.
void SheetThickeningTest::box() {
  QFETCH(double, scale);
  QFETCH(double, thickness);
  QFETCH(Vec3, at);
  const double a = 3.0 * scale, b = 2.0 * scale, t = thickness * scale;
  const HalfEdgeMesh mesh = backed(test::moved(rectangle(a, b), at), t);
  QVERIFY(test::countEdges(mesh).sound());
  QCOMPARE(test::meetingPairs(mesh), std::size_t{0});
  QVERIFY(isBlunt(mesh));
  const TriangleSoup box = test::moved(mesh.compact().soup, -at);
  QVERIFY(isNearlyThatShare(test::volume(box), a * b * t));
  QVERIFY(isNearlyThatShare(test::area(box), 2.0 * a * b + 2.0 * (a + b) * t));
  for (const Vec3& p : box.points) QVERIFY(p.z() == 0.0 || isNearlyThatShare(p.z(), -t));
}

// Side faces along both outlines. The area of a ring between two regular polygons, and their edges, times the
// thickness.
void SheetThickeningTest::annulus() {
  const double n = 24.0, t = 0.3, ring = 0.5 * n * std::sin(2.0 * M_PI / n) * (4.0 - 1.0);
  const double edges = 2.0 * n * std::sin(M_PI / n) * (2.0 + 1.0);
  const HalfEdgeMesh mesh = backed(test::annulus(24, 3, 1.0, 2.0), t);
  QVERIFY(test::countEdges(mesh).sound() && isBlunt(mesh));
  QVERIFY(isNearlyThatShare(volume(mesh), ring * t));
  QVERIFY(isNearlyThatShare(test::area(mesh.compact().soup), 2.0 * ring + edges * t));
}

// All flat sides move back by the thickness: the body lies between two regular prisms. The normals of the tube point
// outwards, so the body grows inwards; reversed, outwards.
void SheetThickeningTest::tube() {
  for (const std::uint32_t n : {6u, 12u}) {
    const double inner = std::cos(M_PI / n), t = 0.2, height = 2.0;
    const auto prism = [&](double apothem) { return height * n * apothem * apothem * std::tan(M_PI / n); };
    const TriangleSoup soup = test::cylinder(n, 4, 1.0, height, false);
    for (const bool isTurned : {false, true}) {
      const HalfEdgeMesh mesh = backed(isTurned ? test::turnedOver(soup) : soup, t);
      QVERIFY(test::countEdges(mesh).sound() && isBlunt(mesh));
      const double other = prism(isTurned ? inner + t : inner - t);
      QVERIFY(isNearlyThatShare(volume(mesh), std::abs(prism(inner) - other)));
    }
  }
}

// A cube without its lid: all of its walls and its bottom get the thickness.
void SheetThickeningTest::openBox() {
  TriangleSoup soup = test::cube();
  std::erase_if(soup.triangles, [&](const Triangle& t) {
    return soup.points[t[0]].z() + soup.points[t[1]].z() + soup.points[t[2]].z() == 3.0;
  });
  QCOMPARE(soup.triangles.size(), std::size_t{10});
  const double t = 0.1;
  const HalfEdgeMesh mesh = backed(soup, t);
  QVERIFY(test::countEdges(mesh).sound() && isBlunt(mesh));
  QVERIFY(isNearlyThatShare(volume(mesh), 1.0 - (1.0 - 2.0 * t) * (1.0 - 2.0 * t) * (1.0 - t)));
}

// A zone of a ball from near its pole to its equator, as a shell of which the ball is the outer side or the inner one.
void SheetThickeningTest::shellOfABall() {
  const double r = 2.0, t = 0.3, pole = 0.2;
  const TriangleSoup soup = test::grid(60, 25, true, false, [&](std::uint32_t i, std::uint32_t j) {
    const double u = 2.0 * M_PI * i / 60.0, v = 0.5 * M_PI + (pole - 0.5 * M_PI) * j / 24.0;
    return Vec3(r * std::sin(v) * std::cos(u), r * std::sin(v) * std::sin(u), r * std::cos(v));
  });
  const auto zone = [&](double radius) { return 2.0 * M_PI / 3.0 * std::pow(radius, 3) * std::cos(pole); };
  for (const bool isTurned : {false, true}) {
    const HalfEdgeMesh mesh = backed(isTurned ? test::turnedOver(soup) : soup, t);
    QVERIFY(test::countEdges(mesh).sound() && isBlunt(mesh));
    QCOMPARE(test::meetingPairs(mesh), std::size_t{0});
    QVERIFY(isNearlyThatShare(volume(mesh), std::abs(zone(r) - zone(isTurned ? r + t : r - t)), 0.02));
  }
}

// The radius of its waves is some 0.6: the body is of one thickness, and its volume near that times the area.
void SheetThickeningTest::wavySheet() {
  const TriangleSoup soup = test::grid(41, 31, false, false, [](std::uint32_t i, std::uint32_t j) {
    const double x = i / 10.0, y = j / 10.0;
    return Vec3(x, y, 0.2 * std::sin(2.0 * x) * std::cos(2.0 * y));
  });
  const double t = 0.1;
  HalfEdgeMesh mesh = buildMesh(soup).mesh;
  const SheetThickness reached = thickened(mesh, sheetOf(mesh, 0), t).thickness;
  relink(mesh);
  QVERIFY(test::countEdges(mesh).sound() && isBlunt(mesh));
  QCOMPARE(test::meetingPairs(mesh), std::size_t{0});
  // No offset is behind more than three planes by the same distance; they differ by a few degrees here.
  QVERIFY(isNearlyThatShare(reached.least, t, 0.05) && isNearlyThatShare(reached.largest, t));
  QCOMPARE(reached.thinVertices, std::size_t{0});
  QVERIFY(isNearlyThatShare(volume(mesh), test::area(soup) * t, 0.05));
}

// Behind the tip of a needle its axis is nearly parallel to its faces: the body is thinner there by the sine of their
// slope.
void SheetThickeningTest::tipOfANeedle() {
  const int sides = 8;
  const double height = 10.0, radius = 0.5, t = 0.01;
  TriangleSoup soup{{Vec3(0, 0, height)}, {}};
  for (std::uint32_t i = 0; i < sides; ++i) {
    const double u = 2.0 * M_PI * i / sides;
    soup.points.push_back(Vec3(radius * std::cos(u), radius * std::sin(u), 0));
    soup.triangles.push_back({0, i + 1, (i + 1) % sides + 1});
  }
  HalfEdgeMesh mesh = buildMesh(soup).mesh;
  const SheetThickness reached = thickened(mesh, sheetOf(mesh, 0), t).thickness;
  const double apothem = radius * std::cos(M_PI / sides);
  QVERIFY2(isNearlyThatShare(reached.least, t * apothem / std::hypot(height, apothem), 1e-6),
           qPrintable(QString::number(reached.least)));
  QVERIFY(isNearlyThatShare(reached.largest, t, 1e-6));
  QCOMPARE(reached.thinVertices, std::size_t{1});
}

void SheetThickeningTest::severalSheets() {
  TriangleSoup soup = rectangle(1.0, 2.0);
  test::append(soup, test::moved(rectangle(1.0, 2.0), {0, 0, 1}));
  HalfEdgeMesh mesh = buildMesh(soup).mesh;
  const std::vector<OpenSheet> sheets{{sheetOf(mesh, 0), 0.1},
                                      {sheetOf(mesh, static_cast<Face>(mesh.faceSlots() - 1)), 0.2}};
  const ThickenedSheets made = thickenSheets(mesh, sheets, NumberType::Float64);
  relink(mesh);
  QCOMPARE(made.isThickened, std::vector<bool>({true, true}));
  QVERIFY(test::countEdges(mesh).sound() && isBlunt(mesh));
  QVERIFY(isNearlyThatShare(made.thickness.least, 0.1) && isNearlyThatShare(made.thickness.largest, 0.2));
  QVERIFY(isNearlyThatShare(volume(mesh), 2.0 * 0.1 + 2.0 * 0.2));
}

// Two squares that touch in a corner: their side faces there would share an edge, so there the bodies touch in one
// vertex, as the squares do.
void SheetThickeningTest::pinchedOutline() {
  HalfEdgeMesh mesh = buildMesh({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}},
                                 {{0, 1, 2}, {0, 2, 3}, {2, 4, 5}, {2, 5, 6}}})
                          .mesh;
  const std::vector<OpenSheet> sheets{{sheetOf(mesh, 0), 0.1}, {sheetOf(mesh, 2), 0.1}};
  thickenSheets(mesh, sheets, NumberType::Float64);
  relink(mesh);
  QVERIFY(test::countEdges(mesh).sound());
  QCOMPARE(validate(mesh), std::string());
}

// A closed body stands just below an edge of the rectangle, in the plane in which its side faces would lie: there both
// sides meet in the edge, and elsewhere the side faces stand.
void SheetThickeningTest::sharpWhereNoSideFits() {
  TriangleSoup soup = rectangle(6.0, 4.0);
  const std::size_t own = soup.triangles.size();
  test::append(soup, test::moved(test::cube(), {2.25, -1.0, -1.001}));
  HalfEdgeMesh mesh = buildMesh(soup).mesh;
  const ThickenedSheets made =
      thickenSheets(mesh, std::vector<OpenSheet>{{sheetOf(mesh, 0), 0.5}}, NumberType::Float64);
  relink(mesh);
  QCOMPARE(test::meetingPairs(mesh), std::size_t{0});
  QVERIFY(test::countEdges(mesh).sound());
  QCOMPARE(made.thickness.least, 0.0);
  QVERIFY(isNearlyThatShare(made.thickness.largest, 0.5));
  for (Face f = 0; f < own; ++f) QVERIFY(mesh.isLive(f));
}

void SheetThickeningTest::onlyThisSheet() {
  TriangleSoup two = test::disc(12, 3);
  const std::size_t one = two.triangles.size();
  test::append(two, test::moved(test::disc(12, 3), {0, 0, 9}));
  HalfEdgeMesh mesh = buildMesh(two).mesh;
  const std::vector<Face> sheet = sheetOf(mesh, 0);
  QCOMPARE(sheet.size(), one);
  thickened(mesh, sheet, 0.01);
  relink(mesh);
  QCOMPARE(test::countBorder(mesh), std::size_t{12});
}

// The back of the first would lie exactly on the second, which gets a back, too.
void SheetThickeningTest::backOnAnotherSheet() {
  TriangleSoup soup;
  soup.points = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, -1}, {4, 0, -1}, {0, 4, -1}};
  soup.triangles = {{0, 1, 2}, {3, 4, 5}};
  HalfEdgeMesh mesh = buildMesh(soup).mesh;
  const std::vector<OpenSheet> sheets{{{0}, 1.0}, {{1}, 1.0}};
  thickenSheets(mesh, sheets, NumberType::Float64);
  relink(mesh);
  QCOMPARE(validate(mesh), std::string());
  QVERIFY(mesh.isLive(0) && mesh.isLive(1));
  QVERIFY(test::countEdges(mesh).sound());
  // Two prisms over a triangle of 8 mm²: of the first the depth was halved, once.
  QVERIFY(isNearlyThatShare(volume(mesh), 8.0 * 0.5 + 8.0 * 1.0));
}

// A flake behind the middle of a square comes nearer than the thickness: there the body is thinner, and as thick as it
// may be elsewhere.
void SheetThickeningTest::thinnerBeforeAnObstacle() {
  const double thickness = 0.04;
  TriangleSoup soup = test::grid(
      13, 13, false, false, [](std::uint32_t i, std::uint32_t j) { return Vec3(i / 6.0 - 1.0, j / 6.0 - 1.0, 0.0); });
  const double alone = volume(backed(soup, thickness));
  test::append(soup, TriangleSoup{{{0.01, 0.01, -0.011}, {0.06, 0.01, -0.1}, {0.01, 0.06, -0.1}}, {{0, 1, 2}}});
  HalfEdgeMesh mesh = buildMesh(soup).mesh;
  const std::vector<Face> sheet = sheetOf(mesh, 0);
  thickened(mesh, sheet, thickness);
  relink(mesh);
  QCOMPARE(test::meetingPairs(mesh), std::size_t{0});
  QCOMPARE(test::countBorder(mesh), std::size_t{3});  // the flake's
  QCOMPARE(validate(mesh), std::string());
  mesh.removeFace(static_cast<Face>(soup.triangles.size() - 1));
  QVERIFY(volume(mesh) < alone && volume(mesh) > 0.8 * alone);
}

// The fold of a sheet that comes back over itself at a distance of less than twice the thickness.
void SheetThickeningTest::fold() {
  const double gap = 0.02;
  const TriangleSoup soup = test::grid(41, 9, false, false, [&](std::uint32_t i, std::uint32_t j) {
    const double s = (i - 20.0) / 10.0, turn = 0.5 * M_PI * gap;  // half a circle as wide as the gap
    if (s < 0) return Vec3(-s, j / 8.0, 0.0);
    if (i == 20) return Vec3(-turn, j / 8.0, 0.5 * gap);
    return Vec3(s, j / 8.0, gap);
  });
  for (const TriangleSoup& side : {soup, test::turnedOver(soup)}) {
    const HalfEdgeMesh mesh = backed(side, 0.05);
    QCOMPARE(test::meetingPairs(mesh), std::size_t{0});
    QVERIFY(test::countEdges(mesh).sound());
  }
}

// Not more than there is room for: a flake stands behind the middle of the sheet.
void SheetThickeningTest::saysWhatWasReached() {
  TriangleSoup soup =
      test::grid(9, 9, false, false, [](std::uint32_t i, std::uint32_t j) { return Vec3(0.2 * i, 0.2 * j, 0.0); });
  test::append(soup, TriangleSoup{{{0.7, 0.7, -0.5}, {0.9, 0.7, -3.0}, {0.7, 0.9, -3.0}}, {{0, 1, 2}}});
  for (const double thickness : {0.01, 2.0}) {
    HalfEdgeMesh mesh = buildMesh(soup).mesh;
    const auto front = static_cast<Vertex>(mesh.vertexSlots());
    const SheetThickness reached = thickened(mesh, sheetOf(mesh, 0), thickness).thickness;
    double least = 1e9, largest = 0.0;
    for (Vertex v = front; v < mesh.vertexSlots(); ++v) {
      least = std::min(least, std::abs(mesh.position(v).z()));
      largest = std::max(largest, std::abs(mesh.position(v).z()));
    }
    QVERIFY(isNearlyThatShare(reached.least, least) && isNearlyThatShare(reached.largest, largest));
    QVERIFY(isNearlyThatShare(largest, thickness));
    std::size_t thin = 0;  // those behind it follow the others
    for (Vertex v = front; v < mesh.vertexSlots(); ++v)
      thin += !isNearlyThatShare(std::abs(mesh.position(v).z()), thickness);
    QCOMPARE(reached.vertices, std::size_t{9 * 9});
    QCOMPARE(reached.thinVertices, thin);
    QCOMPARE(thin > 0, thickness > 0.5);
    QVERIFY(thickness < 0.5 ? isNearlyThatShare(least, thickness) : least < 0.5);
  }
}

// So far from the origin, single precision has no room for the thickness: its back would be the sheet itself.
void SheetThickeningTest::noRoomForTheThickness() {
  const TriangleSoup soup =
      test::grid(9, 9, false, false, [&](std::uint32_t i, std::uint32_t j) { return Vec3(i / 8.0, j / 8.0, 1e5); });
  const HalfEdgeMesh before = buildMesh(soup).mesh;
  HalfEdgeMesh mesh = before;
  QCOMPARE(thickened(mesh, sheetOf(mesh, 0), 1e-3, NumberType::Float32).isThickened, std::vector<bool>{false});
  QVERIFY(test::sameMesh(mesh, before));
  QCOMPARE(thickened(mesh, sheetOf(mesh, 0), 1.0, NumberType::Float32).isThickened, std::vector<bool>{true});
}

// A flake that nobody asked to thicken gets a quarter of its shortest edge at most; who asks gets what was asked for.
void SheetThickeningTest::flakesNobodyAskedFor() {
  for (const double side : {2.0, 3.0, 5.0, 8.0}) {
    for (const bool isWanted : {false, true}) {
      HalfEdgeMesh mesh = buildMesh({{{0, 0, 0}, {side, 0, 0}, {0, 10, 0}}, {{0, 1, 2}}}).mesh;
      const LoopOfSheet loop{0, isWanted};
      const SheetTrial trial = thickenAt(mesh, {&loop, 1}, 1.0, NumberType::Float64, {});
      QCOMPARE(trial.isThickened, std::vector<bool>{true});
      const double expected = isWanted ? 1.0 : std::min(1.0, tolerance::kSheetOffsetEdge * side);
      QVERIFY(std::abs(trial.thickness.largest - expected) < 1e-12);
    }
  }
}

// A hundredth of 500 mm; of 13 mm to one digit, in millimetres and in inches; and never what near vertices are merged
// by.
void SheetThickeningTest::proposals() {
  const auto boxOf = [](double x, double y) { return Box(Vec3::Zero(), Vec3(x, y, 0)); };
  const auto proposed = [](const Box& outline, const Box& part, double unit = 1.0) {
    return proposedSheetThickness({&outline, 1}, part, unit);
  };
  QCOMPARE(proposed(boxOf(300, 400), boxOf(300, 400)), 5.0);
  QCOMPARE(proposed(boxOf(5, 12), boxOf(300, 400)), 0.1);
  QCOMPARE(proposed(boxOf(0.03, 0.04), boxOf(0.03, 0.04)), 0.0005);
  QCOMPARE(proposed(boxOf(3e5, 4e5), boxOf(3e5, 4e5)), 5000.0);
  QVERIFY(isNearlyThatShare(proposed(boxOf(9.6, 0), boxOf(9.6, 0)), 0.1));
  QVERIFY(isNearlyThatShare(proposed(boxOf(300, 400), boxOf(300, 400), 25.4), 0.2 * 25.4));  // 0.197"
  QVERIFY(isNearlyThatShare(proposed(boxOf(1e-3, 0), boxOf(300, 400)), 0.05));               // 10 times 1e-5 of 500 mm
  const std::vector<Box> two{boxOf(5, 12), boxOf(300, 400)};
  QCOMPARE(proposedSheetThickness(two, boxOf(300, 400), 1.0), 5.0);
  QCOMPARE(proposedSheetThickness({}, boxOf(300, 400), 1.0), defaultSheetThickness(boxOf(300, 400)));
  QCOMPARE(proposed(boxOf(0, 0), boxOf(300, 400)), defaultSheetThickness(boxOf(300, 400)));
  QCOMPARE(proposed(Box(), Box()), 0.0);
  QVERIFY(proposed(boxOf(5e-310, 0), boxOf(5e-310, 0)) >= 0.0);
}

HANDWHEEL_TEST(SheetThickeningTest)
#include "SheetThickeningTest.moc"
