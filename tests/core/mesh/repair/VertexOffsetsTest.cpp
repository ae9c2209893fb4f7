// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/VertexOffsets.h"

#include "MeshChecks.h"
#include "TestClass.h"
#include "mesh/defects/NonManifoldVertices.h"
#include "mesh/repair/SheetThickening.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <QTest>
#include <random>

using namespace handwheel;

namespace {

using Corner = std::pair<double, double>;

// The cone over a polygon, with the apex in the origin; seen from above, the polygon is counter-clockwise.
TriangleSoup coneOver(const std::vector<Corner>& polygon) {
  TriangleSoup soup;
  for (const auto& [x, y] : polygon) soup.points.emplace_back(x, y, -1.0);
  const auto n = static_cast<std::uint32_t>(polygon.size());
  soup.points.emplace_back(0, 0, 0);
  for (std::uint32_t i = 0; i < n; ++i) soup.triangles.push_back({n, i, (i + 1) % n});
  return soup;
}

// Returns the same with another ring of points around the apex, at this share of the distance to the polygon.
TriangleSoup coneWithRing(const std::vector<Corner>& polygon, double ring) {
  TriangleSoup soup = coneOver(polygon);
  const auto n = static_cast<std::uint32_t>(polygon.size());
  soup.triangles.clear();
  for (std::uint32_t i = 0; i < n; ++i) soup.points.emplace_back(ring * soup.points[i]);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t k = (i + 1) % n, inner = n + 1 + i, innerNext = n + 1 + k;
    soup.triangles.insert(soup.triangles.end(), {{n, inner, innerNext}, {inner, i, k}, {inner, k, innerNext}});
  }
  return soup;
}

std::vector<FanFace> fanOf(const std::vector<Corner>& polygon) {
  std::vector<FanFace> fan;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto& [x, y] = polygon[i];
    const auto& [u, v] = polygon[(i + 1) % polygon.size()];
    const Vec3 a = Vec3(x, y, -1).normalized(), b = Vec3(u, v, -1).normalized();
    fan.push_back({{a.cross(b).normalized(), std::acos(a.dot(b))}, a});
  }
  return fan;
}

// A point sees all edges of the L from its inner corner, and from no point all those of the U.
const std::vector<Corner> kL = {{-1, -1}, {1, -1}, {1, 0}, {0, 0}, {0, 1}, {-1, 1}};
const std::vector<Corner> kU = {{-3, -1}, {3, -1}, {3, 3}, {2, 3}, {2, 0}, {-2, 0}, {-2, 3}, {-3, 3}};

double leastMargin(const std::vector<Vec3>& normals, const Vec3& direction) {
  double least = 2.0;
  for (const Vec3& n : normals) least = std::min(least, -n.dot(direction));
  return least;
}

// Returns the largest margin of the directions that are equally far behind one, two or three of the planes.
double largestMargin(const std::vector<Vec3>& normals) {
  std::vector<Vec3> candidates;
  for (const Vec3& a : normals) {
    candidates.push_back(-a);
    for (const Vec3& b : normals) {
      candidates.push_back(-(a + b).stableNormalized());
      for (const Vec3& c : normals) {
        const Vec3 middle = (b - a).cross(c - a).stableNormalized();
        candidates.push_back(middle);
        candidates.push_back(-middle);
      }
    }
  }
  double most = -1.0;
  for (const Vec3& d : candidates)
    if (d.norm() > 0.5) most = std::max(most, leastMargin(normals, d));
  return most;
}

HalfEdgeMesh thickened(const TriangleSoup& soup, double thickness) {
  HalfEdgeMesh mesh = buildMesh(soup).mesh;
  const std::vector<OpenSheet> sheets{{sheetOf(mesh, 0), thickness}};
  thickenSheets(mesh, sheets, NumberType::Float64);
  relink(mesh);
  return mesh;
}

}  // namespace

class VertexOffsetsTest : public QObject {
  Q_OBJECT

 private slots:
  void noDirectionHasALargerMargin();
  void narrow_data();
  void narrow();
  void noneWithoutRoom();
  void oneOffsetWhereThereIsOne();
  void twoWhereThereIsNone();
  void noneAtAnOutline();
  void bodyOfADividedFan_data();
  void bodyOfADividedFan();
  void gapsAtShortEdges_data();
  void gapsAtShortEdges();
};

// Compared with all candidates for it.
void VertexOffsetsTest::noDirectionHasALargerMargin() {
  std::mt19937 random(3);
  std::normal_distribution<double> number;
  int found = 0;
  for (int run = 0; run < 400; ++run) {
    std::vector<Vec3> normals;
    const double lean = 0.1 * (run % 20);  // from every direction to nearly one
    for (int i = 3 + run % 7; i > 0; --i)
      normals.push_back(Vec3(number(random), number(random), number(random) + 2.0 * lean).normalized());
    const DirectionBehind behind = widestBehind(normals);
    const double most = largestMargin(normals);
    if (most < 2e-3) continue;
    ++found;
    QVERIFY(std::abs(behind.margin - most) < 1e-9);
    QVERIFY(std::abs(leastMargin(normals, behind.direction) - most) < 1e-9);
    QVERIFY(std::abs(behind.direction.norm() - 1.0) < 1e-12);
  }
  QVERIFY(found > 100);
}

void VertexOffsetsTest::narrow_data() {
  QTest::addColumn<double>("degrees");
  for (const double degrees : {30.0, 3.0, 0.3, 0.1}) QTest::newRow(qPrintable(QString::number(degrees))) << degrees;
}

// A needle of this half angle: all normals lean against its axis by it, and only directions near the axis are within.
void VertexOffsetsTest::narrow() {
  QFETCH(double, degrees);
  const double angle = degrees * M_PI / 180.0;
  std::vector<Vec3> normals;
  for (int i = 0; i < 9; ++i) {
    const double turn = 2.0 * M_PI * i / 9.0;
    normals.emplace_back(std::cos(angle) * std::cos(turn), std::cos(angle) * std::sin(turn), std::sin(angle));
  }
  const DirectionBehind behind = widestBehind(normals);
  QVERIFY(std::abs(behind.margin - std::sin(angle)) < 1e-9);
  QVERIFY((behind.direction - Vec3(0, 0, -1)).norm() < 1e-6);
}

void VertexOffsetsTest::noneWithoutRoom() {
  QCOMPARE(widestBehind({}).margin, 0.0);
  QCOMPARE(widestBehind({Vec3::Zero()}).margin, 0.0);
  QCOMPARE(widestBehind({Vec3(1, 0, 0), Vec3(-1, 0, 0)}).margin, 0.0);
  QCOMPARE(widestBehind({Vec3(1, 1, 1).normalized(), Vec3(-1, -1, 1).normalized(), Vec3(-1, 1, -1).normalized(),
                         Vec3(1, -1, -1).normalized()})
               .margin,
           0.0);
  QCOMPARE(widestBehind({Vec3(0, 0, 1)}).direction, Vec3(0, 0, -1));
  // A sharp edge: the margin behind its two planes is the sine of half of its angle, and at least a thousandth.
  const auto behindEdge = [](double sine) {
    const double cosine = std::sqrt(1.0 - sine * sine);
    return widestBehind({Vec3(cosine, 0, sine), Vec3(-cosine, 0, sine)});
  };
  QCOMPARE(behindEdge(0.98e-3).margin, 0.0);
  QVERIFY(std::abs(behindEdge(1.02e-3).margin - 1.02e-3) < 1e-12);
  QVERIFY((behindEdge(1.02e-3).direction - Vec3(0, 0, -1)).norm() < 1e-9);
}

void VertexOffsetsTest::oneOffsetWhereThereIsOne() {
  const std::vector<FanFace> fan = fanOf(kL);
  const VertexOffsets back = vertexOffsets(fan, true);
  QCOMPARE(back.offsets.size(), std::size_t{1});
  for (std::size_t i = 0; i < fan.size(); ++i) QVERIFY(fan[i].face.normal.dot(back.offsets[back.offsetOf(i)]) < 0.0);
}

// However the faces are numbered.
void VertexOffsetsTest::twoWhereThereIsNone() {
  for (std::size_t first = 0; first < kU.size(); ++first) {
    std::vector<Corner> polygon = kU;
    std::rotate(polygon.begin(), polygon.begin() + std::ptrdiff_t(first), polygon.end());
    const std::vector<FanFace> fan = fanOf(polygon);
    const VertexOffsets back = vertexOffsets(fan, true);
    QCOMPARE(back.offsets.size(), std::size_t{2});
    std::size_t ofFirst = 0;
    for (std::size_t i = 0; i < fan.size(); ++i) {
      QVERIFY(fan[i].face.normal.dot(back.offsets[back.offsetOf(i)]) < 0.0);
      ofFirst += back.offsetOf(i) == 0;
    }
    QVERIFY(ofFirst >= 2 && ofFirst + 2 <= fan.size());
  }
}

void VertexOffsetsTest::noneAtAnOutline() {
  QVERIFY(vertexOffsets(fanOf(kU), false).offsets.empty());
}

void VertexOffsetsTest::bodyOfADividedFan_data() {
  QTest::addColumn<double>("thickness");
  QTest::addColumn<bool>("isMirrored");
  for (const double thickness : {1e-4, 0.02, 0.1}) {
    QTest::newRow(qPrintable(QString::number(thickness))) << thickness << false;
    QTest::newRow(qPrintable(QString::number(thickness) + ", mirrored")) << thickness << true;
  }
}

// It is closed, does not meet itself, and touches itself nowhere.
void VertexOffsetsTest::bodyOfADividedFan() {
  QFETCH(double, thickness);
  QFETCH(bool, isMirrored);
  std::vector<Corner> polygon = kU;
  if (isMirrored) {
    for (auto& [x, y] : polygon) x = 0.5 - x;
    std::reverse(polygon.begin(), polygon.end());
  }
  const HalfEdgeMesh before = buildMesh(coneOver(polygon)).mesh;
  const HalfEdgeMesh mesh = thickened(coneOver(polygon), thickness);
  QVERIFY(test::countEdges(mesh).sound());
  QCOMPARE(validate(mesh), std::string());
  QVERIFY(findNonManifoldVertices(mesh).empty());
  QCOMPARE(test::meetingPairs(mesh), std::size_t{0});
  QCOMPARE(test::eulerCharacteristic(mesh), 2L);
  QVERIFY(test::volume(mesh.compact().soup) > 0.0);
  for (Face f = 0; f < before.faceSlots(); ++f) QVERIFY(mesh.points(f) == before.points(f));
}

void VertexOffsetsTest::gapsAtShortEdges_data() {
  QTest::addColumn<double>("ring");
  QTest::addColumn<double>("thickness");
  for (const double ring : {0.3, 0.1, 0.03, 0.01})
    for (const double thickness : {0.01, 0.03, 0.1, 0.3})
      QTest::addRow("ring %g, thickness %g", ring, thickness) << ring << thickness;
}

// The edges that divide the fan end at a ring near the apex, much nearer than the back would be. The triangles between
// the parts of the back, which have no face in front of them, are not turned over all the same.
void VertexOffsetsTest::gapsAtShortEdges() {
  QFETCH(double, ring);
  QFETCH(double, thickness);
  const HalfEdgeMesh mesh = thickened(coneWithRing(kU, ring), thickness);
  QVERIFY(test::countEdges(mesh).sound());
  QCOMPARE(validate(mesh), std::string());
  QCOMPARE(test::meetingPairs(mesh), std::size_t{0});
  QCOMPARE(test::eulerCharacteristic(mesh), 2L);
  QVERIFY(test::volume(mesh.compact().soup) > 0.0);
}

HANDWHEEL_TEST(VertexOffsetsTest)
#include "VertexOffsetsTest.moc"
