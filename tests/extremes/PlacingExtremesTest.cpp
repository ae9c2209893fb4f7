// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ExtremeRows.h"
#include "MeshChecks.h"
#include "TestClass.h"
#include "base/Tolerance.h"
#include "mesh/structure/MeshValidator.h"
#include "mesh/structure/Shells.h"
#include "mesh/structure/Transforming.h"

using namespace handwheel;

// Turning, mirroring, standing on a flat face, aligning, splitting and joining of every extreme mesh.
class PlacingExtremesTest : public QObject {
  Q_OBJECT

 private slots:
  void turnsAndMirrors_data() { test::everyMesh(); }
  void turnsAndMirrors();
  void strangePlacements();
  void stands_data();
  void stands();
  void whatStandsStandsFlat_data() { test::everyMesh(); }
  void whatStandsStandsFlat();
  void ballsDoNotStand_data();
  void ballsDoNotStand();
  void aligns_data() { test::everyMesh(); }
  void aligns();
  void boxes_data() { test::everyMesh(); }
  void boxes();
  void splitsAndJoins_data() { test::everyMesh(); }
  void splitsAndJoins();
};

namespace {

constexpr double kLargest = 1e60;  // mm; beyond, nothing is aligned: fourth powers of lengths overflow
constexpr double kSmallest = 1e-70;

Eigen::Affine3d about(const Vec3& middle, const Eigen::Matrix3d& by) {
  return Eigen::Translation3d(middle) * Eigen::Affine3d(by) * Eigen::Translation3d(-middle);
}

Eigen::Matrix3d someTurn() {
  return Eigen::AngleAxisd(1.1, Vec3(1, 2, 3).normalized()).toRotationMatrix();
}

// Between the surface and a point, in cubes of this length; for a closed surface the volume.
double coneVolume(const HalfEdgeMesh& mesh, const Vec3& apex, double length) {
  double sum = 0.0;
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    const TrianglePoints p = mesh.points(f);
    const Vec3 a = (p[0] - apex) / length, b = (p[1] - apex) / length, c = (p[2] - apex) / length;
    sum += a.dot(b.cross(c)) / 6.0;
  }
  return sum;
}

double largestChangeOfAnEdge(const HalfEdgeMesh& a, const HalfEdgeMesh& b) {
  double largest = 0.0;
  for (HalfEdge h = 0; h < a.halfEdgeSlots(); ++h) {
    const auto length = [](const HalfEdgeMesh& m, Vertex u, Vertex v) {
      return (m.position(u) - m.position(v)).stableNorm();
    };
    largest = std::max(largest, std::abs(length(a, a.from(h), a.to(h)) - length(b, a.from(h), a.to(h))));
  }
  return largest;
}

// Has area that can be determined, and numbers that can be squared twice.
bool isUsable(const test::ExtremeMesh& extreme, const Box& box) {
  return extreme.degenerate < extreme.soup().triangles.size() && !box.isEmpty() && test::reachOf(box) < kLargest &&
         box.sizes().maxCoeff() > kSmallest;
}

// The area that looks down and is no higher than this, over the whole (mm²).
std::pair<double, double> areaBelow(const TriangleSoup& soup, double height) {
  double below = 0.0, whole = 0.0;
  for (const Triangle& t : soup.triangles) {
    const Vec3 a = soup.points[t[0]], b = soup.points[t[1]], c = soup.points[t[2]], n = 0.5 * (b - a).cross(c - a);
    whole += n.norm();
    if (n.z() < 0.0 && std::max({a.z(), b.z(), c.z()}) <= height) below += n.norm();
  }
  return {below, whole};
}

void stand(HalfEdgeMesh& mesh) {
  const auto pose = ontoLargestFlatFace(mesh);
  QVERIFY(pose);
  QVERIFY(bool(transform(mesh, Eigen::Affine3d(*pose))));
}

}  // namespace

// Every edge keeps its length, and what the surface encloses with the point it is turned about keeps its volume.
void PlacingExtremesTest::turnsAndMirrors() {
  QFETCH(test::ExtremeMesh, extreme);
  const HalfEdgeMesh before = buildMesh(extreme.soup()).mesh;
  const Box box = test::boxOf(before);
  const Vec3 middle = box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(box.center());
  const double size = box.isEmpty() ? 1.0 : std::max(box.sizes().maxCoeff(), test::rounding(box));
  const Eigen::Matrix3d mirror = Vec3(-1, 1, 1).asDiagonal();
  for (const Eigen::Matrix3d& by : {someTurn(), Eigen::Matrix3d(someTurn() * mirror)}) {
    HalfEdgeMesh mesh = before;
    QVERIFY(bool(transform(mesh, about(middle, by))));
    QCOMPARE(QString::fromStdString(validate(mesh)), QString());
    QVERIFY(largestChangeOfAnEdge(mesh, before) <= test::rounding(box, 64.0));
    QCOMPARE(test::countBorder(mesh), test::countBorder(before));
    QCOMPARE(test::countSeams(mesh), test::countSeams(before));
    const double volume = coneVolume(before, middle, size);
    const double share =
        test::rounding(box, 256.0) / size;  // rounding as a fraction of the part's size; each face has its own
    const auto faces = static_cast<double>(before.faceSlots());
    QVERIFY(std::abs(coneVolume(mesh, middle, size) - volume) <= faces * share);
    QVERIFY(bool(transform(mesh, about(middle, by).inverse())));
    for (Vertex v = 0; v < before.vertexSlots(); ++v)
      QVERIFY((mesh.position(v) - before.position(v)).stableNorm() <= test::rounding(box, 64.0));
  }
}

// A placement with a number that no formula expects is refused and changes nothing, or leaves finite numbers.
void PlacingExtremesTest::strangePlacements() {
  const HalfEdgeMesh before = buildMesh(test::cube()).mesh;
  for (const double number : test::strangeNumbers()) {
    for (Eigen::Index i = 0; i < 12; ++i) {
      Eigen::Affine3d by = Eigen::Affine3d::Identity();
      by.matrix()(i / 4, i % 4) = number;
      HalfEdgeMesh mesh = before;
      if (!transform(mesh, by)) {
        QVERIFY(test::sameMesh(mesh, before));
        continue;
      }
      for (Vertex v = 0; v < mesh.vertexSlots(); ++v) QVERIFY(mesh.position(v).allFinite());
      QCOMPARE(validate(mesh), std::string());
    }
  }
}

void PlacingExtremesTest::stands_data() {
  QTest::addColumn<test::ExtremeMesh>("extreme");
  QTest::addColumn<double>("height");  // mm
  for (const double scale : test::kScales) {
    QTest::addRow("cube of %g mm", scale)
        << test::ExtremeMesh{"", [=] { return test::moved(test::cube(), Vec3::Zero(), scale); }} << scale;
  }
  for (const double offset : test::kOffsets) {
    QTest::addRow("cube of 10 mm, %g mm away", offset)
        << test::ExtremeMesh{"", [=] { return test::moved(test::cube(), Vec3(offset, -offset, offset), 10.0); }}
        << 10.0;
  }
  const std::map<std::string, double> heights{{"needles", 1.0},          {"slivers 1e6 : 1", 1.0},
                                              {"slivers 1 : 1e6", 1e-6}, {"one triangle", 0.0},
                                              {"open sheet", 0.0},       {"open sheet with a hole", 0.0}};
  for (const test::ExtremeMesh& mesh : test::allMeshes()) {
    if (const auto at = heights.find(mesh.name); at != heights.end())
      QTest::newRow(mesh.name.c_str()) << mesh << at->second;
  }
}

// However it lay: the face is on z = 0 and the part as high as it is thick.
void PlacingExtremesTest::stands() {
  QFETCH(test::ExtremeMesh, extreme);
  QFETCH(double, height);
  const TriangleSoup soup = extreme.soup();
  HalfEdgeMesh mesh = buildMesh(soup).mesh;
  const Box box = test::boxOf(soup);
  QVERIFY(bool(transform(mesh, about(box.center(), someTurn()))));
  stand(mesh);
  const Box stood = test::boxOf(mesh);
  const double rounding = test::rounding(box, 64.0);
  QVERIFY(std::abs(stood.min().z()) <= rounding);
  QVERIFY2(std::abs(stood.max().z() - height) <= rounding, qPrintable(QString::number(stood.max().z())));
  QVERIFY(stood.center().head<2>().norm() <= rounding);
}

// Wherever a flat face is found, the part stands on it: nothing below, and as much of it down there as is promised.
void PlacingExtremesTest::whatStandsStandsFlat() {
  QFETCH(test::ExtremeMesh, extreme);
  HalfEdgeMesh mesh = buildMesh(extreme.soup()).mesh;
  const Box box = test::boxOf(mesh);
  const auto pose = ontoLargestFlatFace(mesh);
  if (!isUsable(extreme, box)) QVERIFY(!pose);
  if (!pose) return;
  QVERIFY(bool(transform(mesh, Eigen::Affine3d(*pose))));
  const double flatness = tolerance::kFlatBaseFlatness * box.diagonal().norm() + test::rounding(box, 64.0);
  QVERIFY(test::boxOf(mesh).min().z() >= -flatness);
  const auto [below, whole] = areaBelow(mesh.compact().soup, flatness);
  QVERIFY(below >= 0.999 * tolerance::kFlatBaseShare * whole);
}

void PlacingExtremesTest::ballsDoNotStand_data() {
  QTest::addColumn<double>("radius");
  QTest::addColumn<double>("offset");
  for (const double scale : test::kScales) QTest::addRow("%g mm", scale) << scale << 0.0;
  for (const double offset : test::kOffsets) QTest::addRow("10 mm, %g mm away", offset) << 10.0 << offset;
}

// No cap of a ball as low as a flat face may be has the area of one, and no facet either.
void PlacingExtremesTest::ballsDoNotStand() {
  QFETCH(double, radius);
  QFETCH(double, offset);
  const TriangleSoup ball = test::moved(test::icosphere(5), Vec3(offset, -offset, offset), radius);
  QVERIFY(!ontoLargestFlatFace(buildMesh(ball).mesh));
}

// A right-handed turn that puts the centre of area into the origin and the second moments of area in falling order
// onto the axes; both summed here from the corners and middles of the triangles.
void PlacingExtremesTest::aligns() {
  QFETCH(test::ExtremeMesh, extreme);
  HalfEdgeMesh mesh = buildMesh(extreme.soup()).mesh;
  const Box box = test::boxOf(mesh);
  const auto pose = ontoPrincipalAxes(mesh);
  QCOMPARE(bool(pose), isUsable(extreme, box));
  if (!pose) return;
  QVERIFY((pose->linear().transpose() * pose->linear() - Eigen::Matrix3d::Identity()).norm() < 1e-12);
  QVERIFY(pose->linear().determinant() > 0.0);
  QVERIFY(bool(transform(mesh, Eigen::Affine3d(*pose))));
  const double size = box.diagonal().norm();
  double area = 0.0;
  Vec3 first = Vec3::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    const TrianglePoints p = mesh.points(f);
    const Vec3 a = p[0] / size, b = p[1] / size, c = p[2] / size, m = (a + b + c) / 3.0;
    const double part = 0.5 * (b - a).cross(c - a).norm();
    area += part;
    first += part * m;
    second +=
        part / 12.0 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + 9.0 * m * m.transpose());  // exact
  }
  const double error = 1e-9 + test::rounding(box, 256.0) / size;
  QVERIFY((first / area).norm() < error);
  second /= area;
  QVERIFY(second(0, 0) >= second(1, 1) - error && second(1, 1) >= second(2, 2) - error);
  QVERIFY(std::abs(second(0, 1)) + std::abs(second(1, 2)) + std::abs(second(2, 0)) < error);
}

void PlacingExtremesTest::boxes() {
  QFETCH(test::ExtremeMesh, extreme);
  HalfEdgeMesh mesh = buildMesh(extreme.soup()).mesh;
  const Box box = test::boxOf(mesh);
  for (const Vec3& anchor : {Vec3(0, 0, 0), Vec3(0.5, 0.5, 0.5), Vec3(1, 0, 0.25)}) {
    const auto pose = boxToOrigin(mesh, anchor);
    QCOMPARE(bool(pose), !box.isEmpty() && test::reachOf(box) < kLargest);
    if (!pose) return;
    HalfEdgeMesh moved = mesh;
    QVERIFY(bool(transform(moved, Eigen::Affine3d(*pose))));
    const Box after = test::boxOf(moved);
    QVERIFY((after.min() + anchor.cwiseProduct(after.sizes())).stableNorm() <= test::rounding(box));
  }
}

// There are as many shells as the mesh has parts by construction; each is whole, and together they are the mesh that
// was split.
void PlacingExtremesTest::splitsAndJoins() {
  QFETCH(test::ExtremeMesh, extreme);
  const HalfEdgeMesh mesh = buildMesh(extreme.soup()).mesh;
  const std::vector<HalfEdgeMesh> shells = splitIntoShells(mesh);
  // Triangles whose corners are one point have no edges to hang together by.
  const bool isOnePoint = test::boxOf(mesh).sizes().isZero(0.0);
  QCOMPARE(shells.size(), isOnePoint ? mesh.faceSlots() : extreme.components);
  HalfEdgeMesh joined;
  std::multiset<std::array<test::Coordinates, 3>> left;
  const auto cornersOf = [](const HalfEdgeMesh& m, Face f) {
    const TrianglePoints p = m.points(f);
    return std::array<test::Coordinates, 3>{test::coordinates(p[0]), test::coordinates(p[1]), test::coordinates(p[2])};
  };
  for (Face f = 0; f < mesh.faceSlots(); ++f) left.insert(cornersOf(mesh, f));
  std::size_t border = 0, seams = 0;
  for (const HalfEdgeMesh& shell : shells) {
    if (shells.size() < 100) QCOMPARE(QString::fromStdString(validate(shell)), QString());
    border += test::countBorder(shell);
    seams += test::countSeams(shell);
    append(joined, shell);
  }
  QCOMPARE(QString::fromStdString(validate(joined)), QString());
  QCOMPARE(border, test::countBorder(mesh));
  QCOMPARE(seams, test::countSeams(mesh));
  QCOMPARE(joined.faceSlots(), mesh.faceSlots());
  for (Face f = 0; f < joined.faceSlots(); ++f) {
    const auto at = left.find(cornersOf(joined, f));
    QVERIFY(at != left.end());
    left.erase(at);
  }
}

HANDWHEEL_TEST(PlacingExtremesTest)
#include "PlacingExtremesTest.moc"
