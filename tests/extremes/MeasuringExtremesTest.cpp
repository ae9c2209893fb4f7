// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ExtremeRows.h"
#include "TestClass.h"
#include "mesh/measure/Deviation.h"
#include "mesh/measure/Section.h"
#include "mesh/measure/WallThickness.h"
#include "mesh/search/FaceHierarchy.h"

using namespace handwheel;

// Sections, wall thickness and the deviation map of every extreme mesh, and of shapes whose figures are known.
class MeasuringExtremesTest : public QObject {
  Q_OBJECT

 private slots:
  void sectionsOfEveryMesh_data() { test::everyMesh(); }
  void sectionsOfEveryMesh();
  void sectionsOfBalls_data() { ballRows(); }
  void sectionsOfBalls();
  void knownSections_data();
  void knownSections();
  void sectionsByStrangePlanes();
  void thicknessOfEveryMesh_data() { test::everyMesh(); }
  void thicknessOfEveryMesh();
  void thicknessOfShells_data() { ballRows(); }
  void thicknessOfShells();
  void knownThicknesses_data();
  void knownThicknesses();
  void thicknessAtStrangePositions();
  void deviationOfShells_data() { ballRows(); }
  void deviationOfShells();

 private:
  static void ballRows();
};

namespace {

constexpr double kTooLarge = 1e150;  // mm; more has no square, and less than 1 / this none either

const test::ExtremeMesh& meshNamed(const std::string& name) {
  static const std::vector<test::ExtremeMesh> all = test::allMeshes();
  return *std::find_if(all.begin(), all.end(), [&](const auto& mesh) { return mesh.name == name; });
}

// Returns the length of the plane's path through the triangles, one by one (mm). A triangle in the plane counts as
// below it.
double lengthByFaces(const TriangleSoup& soup, const Vec3& normal, double offset) {
  double sum = 0.0;
  for (const Triangle& t : soup.triangles) {
    std::vector<Vec3> ends;
    for (int k = 0; k < 3; ++k) {
      const Vec3 &a = soup.points[t[k]], &b = soup.points[t[(k + 1) % 3]];
      const double ha = normal.dot(a) - offset, hb = normal.dot(b) - offset;
      if ((ha > 0.0) != (hb > 0.0)) ends.push_back(a + ha / (ha - hb) * (b - a));
    }
    if (ends.size() == 2) sum += (ends[1] - ends[0]).stableNorm();
  }
  return sum;
}

// The unit cube's sides as large as these.
TriangleSoup brick(const Vec3& size) {
  TriangleSoup s = test::cube();
  for (Vec3& p : s.points) p = p.cwiseProduct(size);
  return s;
}

// A ball with a hollow of nine tenths of its radius.
TriangleSoup shell(double radius, double offset) {
  TriangleSoup s = test::icosphere(4);
  test::append(s, test::turnedOver(test::moved(test::icosphere(4), Vec3::Zero(), 0.9)));
  return test::moved(s, Vec3(offset, -offset, offset), radius);
}

}  // namespace

void MeasuringExtremesTest::ballRows() {
  QTest::addColumn<double>("radius");
  QTest::addColumn<double>("offset");
  for (const double scale : test::kScales) QTest::addRow("%g mm", scale) << scale << 0.0;
  for (const double offset : test::kOffsets) QTest::addRow("10 mm, %g mm away", offset) << 10.0 << offset;
}

// Points lie on the plane, its whole path through the triangles is included, and a closed oriented mesh has closed
// curves.
void MeasuringExtremesTest::sectionsOfEveryMesh() {
  QFETCH(test::ExtremeMesh, extreme);
  const TriangleSoup soup = extreme.soup();
  const HalfEdgeMesh mesh = buildMesh(soup).mesh;
  const Box box = test::boxOf(soup);
  const Vec3 middle = box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(box.center());
  const double size = box.isEmpty() ? 0.0 : box.sizes().stableNorm(), rounding = test::rounding(box, 64.0);
  for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(0, 0, 1), Vec3(0.3, 0.5, 0.7)}) {
    const Vec3 normal = direction.normalized();
    for (const double share : {-0.213, 0.0, 0.1137}) {
      const double offset = normal.dot(middle) + share * size;
      const Section section = sectionOf(mesh, normal, offset);
      QVERIFY(std::isfinite(section.length) && section.area >= 0.0);
      double length = 0.0;
      for (const SectionCurve& curve : section.curves) {
        for (std::size_t i = 0; i < curve.points.size(); ++i) {
          QVERIFY(std::abs(normal.dot(curve.points[i]) - offset) <= rounding);
          if (i > 0 || curve.closed)
            length += (curve.points[i] - curve.points[i > 0 ? i - 1 : curve.points.size() - 1]).stableNorm();
        }
        if (extreme.loops == 0 && extreme.oriented) QVERIFY(curve.closed);
      }
      if (size > kTooLarge || size < 1.0 / kTooLarge) continue;
      const double error = 1e-9 * section.length + static_cast<double>(soup.triangles.size()) * rounding;
      QVERIFY(std::abs(section.length - length) <= error);
      QVERIFY(std::abs(section.length - lengthByFaces(soup, normal, offset)) <= error);
    }
  }
}

// At a height h over the middle, a circle of radius sqrt(r² - h²): its area to what flat triangles leave of a ball.
void MeasuringExtremesTest::sectionsOfBalls() {
  QFETCH(double, radius);
  QFETCH(double, offset);
  const Vec3 middle(offset, -offset, offset);
  const HalfEdgeMesh ball = buildMesh(test::moved(test::icosphere(5), middle, radius)).mesh;
  for (const double share : {-0.6, 0.013, 0.5}) {
    const Vec3 normal = Vec3(0.3, 0.5, 0.7).normalized();
    const Section section = sectionOf(ball, normal, normal.dot(middle) + share * radius);
    const double circle = radius * std::sqrt(1.0 - share * share);
    QVERIFY(section.isClosed);
    QCOMPARE(section.curves.size(), std::size_t{1});
    QVERIFY(std::abs(section.area / (M_PI * circle * circle) - 1.0) < 2e-3);
    QVERIFY(std::abs(section.length / (2.0 * M_PI * circle) - 1.0) < 1e-3);
  }
}

void MeasuringExtremesTest::knownSections_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<double>("offset");  // offset of the plane across X, mm
  QTest::addColumn<std::size_t>("curves");
  QTest::addColumn<bool>("closed");
  QTest::addColumn<double>("length");
  QTest::addColumn<double>("area");
  const auto row = [](const char* name, double offset, std::size_t curves, bool closed, double length, double area) {
    QTest::newRow(name) << QString(name) << offset << curves << closed << length << area;
  };
  row("needles", 0.5, 1, true, 4.0, 1.0);
  row("slivers 1e6 : 1", 0.5, 1, true, 2.0 + 2e6, 1e6);
  row("slivers 1 : 1e6", 0.5, 1, true, 2.0 + 2e-6, 1e-6);
  row("coincident points", 1.0, 0, true, 0.0, 0.0);
  row("one triangle", 0.25, 1, false, 0.75, 0.0);
  row("nothing", 0.0, 0, true, 0.0, 0.0);
  // 47 tetrahedra a side of the grid; through the middle of those of the first layer, triangles with legs of 1/2.
  const std::size_t layer = (100'000 + 46) / 47;
  row("100,000 components", 0.5, layer, true, static_cast<double>(layer) * (1.0 + std::sqrt(0.5)),
      static_cast<double>(layer) / 8.0);
  row("open sheet", 0.1, 1, false, 2.0 * std::sqrt(1.0 - 0.01), 0.0);
}

void MeasuringExtremesTest::knownSections() {
  QFETCH(QString, name);
  QFETCH(double, offset);
  QFETCH(std::size_t, curves);
  QFETCH(bool, closed);
  QFETCH(double, length);
  QFETCH(double, area);
  const Section section = sectionOf(buildMesh(meshNamed(name.toStdString()).soup()).mesh, Vec3::UnitX(), offset);
  QCOMPARE(section.curves.size(), curves);
  QCOMPARE(section.isClosed, closed);
  const double error = name == "open sheet" ? 3e-3 : 1e-9;  // 60 straight edges instead of a circle
  QVERIFY(std::abs(section.length - length) <= error * length);
  QVERIFY(std::abs(section.area - area) <= error * area);
}

void MeasuringExtremesTest::sectionsByStrangePlanes() {
  const HalfEdgeMesh mesh = buildMesh(test::cube()).mesh;
  for (const double number : test::strangeNumbers()) {
    for (const auto& [normal, offset] : {std::pair{Vec3(0, 0, 1), number}, {Vec3(number, 0, 1), 0.5}}) {
      const Section section = sectionOf(mesh, normal, offset);
      QVERIFY(std::isfinite(section.length) && std::isfinite(section.area));
      for (const SectionCurve& curve : section.curves)
        for (const Vec3& p : curve.points) QVERIFY(p.allFinite());
    }
  }
}

// None, or lengths that are: the wall behind lies on the surface, so far away, and the ball is no larger than that.
void MeasuringExtremesTest::thicknessOfEveryMesh() {
  QFETCH(test::ExtremeMesh, extreme);
  const HalfEdgeMesh mesh = buildMesh(extreme.soup()).mesh;
  const FaceHierarchy faces(mesh);
  const double rounding = test::rounding(test::boxOf(mesh), 64.0);
  for (Face f = 0; f < mesh.faceSlots(); f += 1 + static_cast<Face>(mesh.faceSlots() / 50)) {
    const TrianglePoints t = mesh.points(f);
    const Vec3 p = t[0] / 3.0 + t[1] / 3.0 + t[2] / 3.0;
    const auto thickness = wallThickness(faces, f, p);
    if (extreme.degenerate == mesh.faceSlots() || extreme.flat) QVERIFY(!thickness);
    if (!thickness) continue;
    QVERIFY(thickness->alongNormal >= 0.0 && std::isfinite(thickness->alongNormal));
    QVERIFY(thickness->ballDiameter >= 0.0 && thickness->ballDiameter <= thickness->alongNormal + rounding);
    QVERIFY(std::abs((thickness->opposite - p).stableNorm() - thickness->alongNormal) <= rounding);
    const auto nearest = faces.nearest(thickness->opposite);
    QVERIFY(nearest && (*nearest - thickness->opposite).stableNorm() <= rounding + 1e-9 * thickness->alongNormal);
  }
}

// A tenth of the radius, but for what flat triangles make of both spheres.
void MeasuringExtremesTest::thicknessOfShells() {
  QFETCH(double, radius);
  QFETCH(double, offset);
  const HalfEdgeMesh mesh = buildMesh(shell(radius, offset)).mesh;
  const FaceHierarchy faces(mesh);
  for (Face f = 0; f < mesh.faceSlots(); f += 97) {
    const TrianglePoints t = mesh.points(f);
    const auto thickness = wallThickness(faces, f, (t[0] + t[1] + t[2]) / 3.0);
    QVERIFY(thickness);
    QVERIFY(std::abs(thickness->alongNormal / radius - 0.1) < 0.003);
    QVERIFY(std::abs(thickness->ballDiameter / radius - 0.1) < 0.005);
  }
}

void MeasuringExtremesTest::knownThicknesses_data() {
  QTest::addColumn<test::ExtremeMesh>("extreme");
  QTest::addColumn<Vec3>("from");  // a ray along -Z from here hits the position first
  QTest::addColumn<double>("thickness");
  QTest::newRow("needles") << meshNamed("needles") << Vec3(0.5, 0.5, 9.0) << 1.0;
  QTest::newRow("bar 1e6 : 1") << meshNamed("slivers 1e6 : 1") << Vec3(0.5, 0.4, 9e6) << 1e6;
  QTest::newRow("plate 1 : 1e6") << meshNamed("slivers 1 : 1e6") << Vec3(0.5, 0.4, 9.0) << 1e-6;
  for (const double scale : test::kScales) {
    QTest::addRow("plate of %g mm", scale)
        << test::ExtremeMesh{"",
                             [=] {
                               return test::moved(brick({10, 8, 0.3}), Vec3::Zero(), scale);
                             }}
        << Vec3(scale * Vec3(5, 4, 9)) << 0.3 * scale;
  }
  for (const double offset : test::kOffsets) {
    QTest::addRow("plate of 10 mm, %g mm away", offset)
        << test::ExtremeMesh{"",
                             [=] {
                               return test::moved(brick({10, 8, 0.3}), Vec3(offset, -offset, offset));
                             }}
        << Vec3(Vec3(offset, -offset, offset) + Vec3(5, 4, 9)) << 0.3;
  }
}

void MeasuringExtremesTest::knownThicknesses() {
  QFETCH(test::ExtremeMesh, extreme);
  QFETCH(Vec3, from);
  QFETCH(double, thickness);
  const HalfEdgeMesh mesh = buildMesh(extreme.soup()).mesh;
  const FaceHierarchy faces(mesh);
  const auto hit = faces.firstHit({from, -Vec3::UnitZ()});
  QVERIFY(hit);
  const auto found = wallThickness(faces, hit->face, hit->point);
  QVERIFY(found);
  const double rounding = test::rounding(test::boxOf(mesh));
  QVERIFY(std::abs(found->alongNormal - thickness) <= rounding);
  // 1 % of the ball may stick out, and no ball is larger than its body is wide.
  const double ball = std::min(thickness, test::boxOf(mesh).sizes().minCoeff());
  QVERIFY(found->ballDiameter <= 1.02 * ball + rounding);
  if (ball == thickness) QVERIFY(found->ballDiameter >= 0.98 * ball - rounding);
}

void MeasuringExtremesTest::thicknessAtStrangePositions() {
  const HalfEdgeMesh mesh = buildMesh(test::cube()).mesh;
  const FaceHierarchy faces(mesh);
  for (const double number : test::strangeNumbers()) {
    const auto thickness = wallThickness(faces, 0, Vec3(0.5, number, 0.0));
    QVERIFY(!thickness || (std::isfinite(thickness->alongNormal) && std::isfinite(thickness->ballDiameter)));
    if (!std::isfinite(number)) QVERIFY(!thickness);
  }
}

// The hollow of a shell, as a ball of its own, is a tenth of the radius inside the outer one, everywhere.
void MeasuringExtremesTest::deviationOfShells() {
  QFETCH(double, radius);
  QFETCH(double, offset);
  const Vec3 middle(offset, -offset, offset);
  const HalfEdgeMesh outer = buildMesh(test::moved(test::icosphere(4), middle, radius)).mesh,
                     inner = buildMesh(test::moved(test::icosphere(4), middle, 0.9 * radius)).mesh;
  const auto found = deviation(inner, outer, {.samples = 20'000});
  QVERIFY(bool(found));
  const SurfaceDeviation& map = found->ofMesh;
  for (const double figure : {-map.mean, map.rms, -map.lowest.distance, -map.highest.distance, map.percentiles[0]})
    QVERIFY(std::abs(figure / radius - 0.1) < 0.003);
  QVERIFY(std::abs(found->ofScan.mean / radius - 0.1) < 0.003);
}

HANDWHEEL_TEST(MeasuringExtremesTest)
#include "MeasuringExtremesTest.moc"
