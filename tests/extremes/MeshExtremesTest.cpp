// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BuildPaths.h"
#include "Extremes.h"

#include "MeshChecks.h"
#include "TestClass.h"
#include "document/formats/MeshExport.h"
#include "document/formats/MeshFileErrors.h"
#include "mesh/defects/Defects.h"
#include "mesh/defects/MeshReport.h"
#include "mesh/repair/Repair.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshErrors.h"
#include "mesh/structure/MeshValidator.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

using namespace handwheel;

namespace {

std::vector<test::ExtremeMesh> meshExtremesAllMeshes() {
  std::vector<test::ExtremeMesh> all = test::scaledMeshes();
  for (const auto& more : {test::oddMeshes(), test::topologicalMeshes()})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

const test::ExtremeMesh& meshOfRow(const QString& name) {
  static const std::vector<test::ExtremeMesh> all = meshExtremesAllMeshes();
  const auto at = std::find_if(all.begin(), all.end(), [&](const auto& m) { return name == m.name.c_str(); });
  return *at;
}

void everyMesh() {
  QTest::addColumn<QString>("name");
  for (const test::ExtremeMesh& mesh : meshExtremesAllMeshes())
    QTest::newRow(mesh.name.c_str()) << QString(mesh.name.c_str());
}

// Chains of open edges by position, counted over the vertices at which they pass: where each vertex of the border has
// two open edges, chains are what hangs together.
std::size_t chainsOfOpenEdges(const TriangleSoup& soup) {
  std::map<std::pair<test::Coordinates, test::Coordinates>, int> uses;
  for (const Triangle& t : soup.triangles) {
    for (int k = 0; k < 3; ++k) {
      const test::Coordinates a = test::coordinates(soup.points[t[k]]),
                              b = test::coordinates(soup.points[t[(k + 1) % 3]]);
      if (a != b) ++uses[std::minmax(a, b)];
    }
  }
  std::map<test::Coordinates, test::Coordinates> parent;
  const std::function<test::Coordinates(test::Coordinates)> root = [&](test::Coordinates p) {
    while (parent.at(p) != p) p = parent.at(p);
    return p;
  };
  for (const auto& [edge, n] : uses) {
    if (n != 1) continue;
    parent.emplace(edge.first, edge.first);
    parent.emplace(edge.second, edge.second);
    parent[root(edge.first)] = root(edge.second);
  }
  return static_cast<std::size_t>(
      std::count_if(parent.begin(), parent.end(), [](const auto& e) { return e.first == e.second; }));
}

TriangleSoup triangle(const Vec3& first) {
  return {{first, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
}

std::string offOf(const std::string& coordinate) {
  return "OFF\n3 1 0\n" + coordinate + " 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
}

}  // namespace

class MeshExtremesTest : public QObject {
  Q_OBJECT

 private slots:
  void build_data() { everyMesh(); }
  void build();
  void defects_data() { everyMesh(); }
  void defects();
  void report_data() { everyMesh(); }
  void report();
  void repairs_data() { everyMesh(); }
  void repairs();
  void sizeChangesNothing_data();
  void sizeChangesNothing();
  void distanceChangesNothing();
  void filesKeepDoubles_data() { everyMesh(); }
  void filesKeepDoubles();
  void filesRoundToSingles_data() { everyMesh(); }
  void filesRoundToSingles();
  void whatIsNoNumberIsRefused();
  void tableNamesEveryRow();
};

// Every triangle becomes a face, every invariant holds.
void MeshExtremesTest::build() {
  QFETCH(QString, name);
  const TriangleSoup soup = meshOfRow(name).soup();
  const BuiltMesh built = buildMesh(soup);
  QCOMPARE(QString::fromStdString(validate(built.mesh)), QString());
  QCOMPARE(built.mesh.liveFaceCount(), soup.triangles.size());
}

void MeshExtremesTest::defects() {
  QFETCH(QString, name);
  const test::ExtremeMesh& extreme = meshOfRow(name);
  const TriangleSoup soup = extreme.soup();
  const Defects found = findDefects(buildMesh(soup).mesh);
  Box box;
  for (const Vec3& p : soup.points) box.extend(p);
  QVERIFY(soup.points.empty() ? found.box.isEmpty() : found.box.min() == box.min() && found.box.max() == box.max());
  QCOMPARE(found.components.size(), extreme.components);
  QCOMPARE(found.degenerateFaces.size(), extreme.degenerate);
  QVERIFY(found.nonManifoldVertices.empty());
  for (const BoundaryLoop& loop : found.loops) QVERIFY(loop.box.isEmpty() || box.contains(loop.box));
  for (const Component& c : found.components) QVERIFY(!std::isnan(c.area) && c.area >= 0.0);
}

void MeshExtremesTest::report() {
  QFETCH(QString, name);
  const test::ExtremeMesh& extreme = meshOfRow(name);
  const TriangleSoup soup = extreme.soup();
  const MeshReport report = reportOn(soup, SelfIntersections::Skip);
  QCOMPARE(report.triangles, soup.triangles.size());
  QCOMPARE(report.degenerateFaces, extreme.degenerate);
  QCOMPARE(report.oriented, extreme.oriented);
  QCOMPARE(chainsOfOpenEdges(soup), extreme.loops);
  QCOMPARE(report.closed, extreme.loops == 0 && !soup.triangles.empty());
  if (extreme.volume && extreme.loops == 0) {
    QVERIFY(std::abs(*report.volumeMm3 / *extreme.volume - 1.0) <= extreme.volumeError);
  }
}

// A repair ends, leaves a valid mesh, makes sound what can be made so, and never opens anything.
void MeshExtremesTest::repairs() {
  QFETCH(QString, name);
  const test::ExtremeMesh& extreme = meshOfRow(name);
  const TriangleSoup soup = extreme.soup();
  HalfEdgeMesh mesh = buildMesh(soup).mesh;
  RepairOptions options;
  options.sheets = SheetHandling::Thicken;
  const RepairReport report = repair(mesh, options);
  QVERIFY(!report.cancelled);
  QCOMPARE(QString::fromStdString(validate(mesh)), QString());
  QVERIFY(findDefects(mesh).degenerateFaces.empty());
  const TriangleSoup result = mesh.compact().soup;
  const test::Edges before = test::countEdges(soup), after = test::countEdges(result);
  QVERIFY(after.border <= before.border);
  QVERIFY(after.nonManifold == 0);
  QCOMPARE(after.sound() && !result.triangles.empty(), extreme.sound);
  for (const LoopResult& loop : report.loops) {
    QCOMPARE(loop.reason == FillFailure::None,
             loop.outcome == LoopOutcome::Filled);  // loops that stay open have a reason
  }
  QCOMPARE(report.removedDegenerate, extreme.degenerate);
  const auto filled = std::count_if(report.loops.begin(), report.loops.end(),
                                    [](const LoopResult& loop) { return loop.outcome == LoopOutcome::Filled; });
  QCOMPARE(static_cast<std::size_t>(filled), extreme.filled);
  if (!extreme.volume) return;
  const MeshReport statistics = reportOn(result, SelfIntersections::Skip);
  QVERIFY(statistics.volumeMm3);
  QVERIFY2(std::abs(*statistics.volumeMm3 / *extreme.volume - 1.0) <= extreme.volumeError,
           qPrintable(QString::number(*statistics.volumeMm3 / *extreme.volume - 1.0)));
}

void MeshExtremesTest::sizeChangesNothing_data() {
  QTest::addColumn<double>("scale");
  for (int power : {-20, -10, 10, 20}) QTest::addRow("2^%d", power) << std::exp2(power);
}

// Scaling by a power of two is exact, so a repair must do the same to the bit: no length that hides in a formula is
// absolute.
void MeshExtremesTest::sizeChangesNothing() {
  QFETCH(double, scale);
  const TriangleSoup soup = test::sphereWithHoles(4, 5, 0.35);
  HalfEdgeMesh plain = buildMesh(soup).mesh, scaled = buildMesh(test::moved(soup, Vec3::Zero(), scale)).mesh;
  repair(plain, {});
  repair(scaled, {});
  const TriangleSoup a = test::moved(plain.compact().soup, Vec3::Zero(), scale), b = scaled.compact().soup;
  QVERIFY(a.triangles == b.triangles);
  std::size_t differing = 0;
  for (std::size_t i = 0; i < a.points.size(); ++i) differing += a.points[i] != b.points[i];
  QCOMPARE(differing, std::size_t{0});
}

// Far from the origin the coordinates themselves are rounded, by at most 1e-9 mm at 1e7 mm; volume and area follow to
// no more than what that makes of a ball of 10 mm: 3 · 1e-9 / 10.
void MeshExtremesTest::distanceChangesNothing() {
  const TriangleSoup ball = test::moved(test::icosphere(4), Vec3::Zero(), 10.0);
  const double volume = *reportOn(ball, SelfIntersections::Skip).volumeMm3;
  const double area = findComponents(buildMesh(ball).mesh)[0].area;
  for (double offset : test::kOffsets) {
    const TriangleSoup far = test::moved(ball, Vec3(offset, -offset, offset));
    QVERIFY(std::abs(*reportOn(far, SelfIntersections::Skip).volumeMm3 / volume - 1.0) < 3e-10);
    QVERIFY(std::abs(findComponents(buildMesh(far).mesh)[0].area / area - 1.0) < 3e-10);
  }
}

// PLY, OBJ and OFF give back every corner of every triangle bit for bit; without triangles there is no file.
void MeshExtremesTest::filesKeepDoubles() {
  QFETCH(QString, name);
  const TriangleSoup soup = meshOfRow(name).soup();
  const HalfEdgeMesh mesh = buildMesh(soup).mesh;
  const QTemporaryDir folder;
  for (const char* ending : {"ply", "obj", "off"}) {
    const std::filesystem::path path = folder.filePath(QString("a.") + ending).toStdString();
    const auto written = exportMesh(mesh, NumberType::Float64, path);
    const auto read = readMeshFile(path, {});
    if (soup.triangles.empty()) {
      QVERIFY(!read && read.error().code == (written ? MeshError::NoTriangles : ErrorCode::FileMissing));
      continue;
    }
    QVERIFY2(written && read, ending);
    QCOMPARE(read->soup.triangles.size(), soup.triangles.size());
    // Turned faces have their corners in another order; nothing else may differ.
    std::size_t differing = 0;
    for (Face f = 0; f < mesh.faceSlots(); ++f) {
      for (int k = 0; k < 3; ++k) {
        differing += read->soup.points[read->soup.triangles[f][k]] != mesh.position(mesh.triangle(f)[k]);
      }
    }
    QVERIFY(written->parted.empty());
    QCOMPARE(differing, std::size_t{0});
  }
}

// STL rounds to single precision: each coordinate to the nearest number there is, or one beside it where vertices would
// fall together; or the file is refused where there is none.
void MeshExtremesTest::filesRoundToSingles() {
  QFETCH(QString, name);
  const TriangleSoup soup = meshOfRow(name).soup();
  const HalfEdgeMesh mesh = buildMesh(soup).mesh;
  const QTemporaryDir folder;
  const std::filesystem::path path = folder.filePath("a.stl").toStdString();
  const auto written = exportMesh(mesh, NumberType::Float64, path);
  const bool fits = std::all_of(soup.points.begin(), soup.points.end(), [](const Vec3& p) {
    return p.cwiseAbs().maxCoeff() <= std::numeric_limits<float>::max();
  });
  if (!fits || soup.triangles.empty()) {
    QVERIFY(!written || soup.triangles.empty());
    return;
  }
  QVERIFY(written);
  const auto read = readMeshFile(path, {});
  QVERIFY(read);
  QCOMPARE(read->soup.triangles.size(), soup.triangles.size());
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const Vec3& exact = mesh.position(mesh.triangle(f)[k]);
      const Vec3& single = read->soup.points[read->soup.triangles[f][k]];
      for (int axis = 0; axis < 3; ++axis) {
        const auto nearest = static_cast<float>(exact[axis]);
        const double step = std::max(std::nextafter(std::abs(nearest), HUGE_VALF) - std::abs(nearest),
                                     std::numeric_limits<float>::denorm_min());
        QVERIFY(std::abs(single[axis] - static_cast<double>(nearest)) <= 1.01 * step);
      }
    }
  }
}

// Files with values that are not numbers are refused, with the position; if read in part, they lose the triangle and
// report it.
void MeshExtremesTest::whatIsNoNumberIsRefused() {
  for (const char* number : {"nan", "NaN", "inf", "-inf", "Infinity", "1e999", "-1e999"}) {
    const auto read = readMesh(offOf(number), "a.off", {});
    QVERIFY2(!read, number);
    QVERIFY2(read.error().code == ErrorCode::NumberNotFinite || read.error().code == ErrorCode::NumberMalformed,
             number);
    QCOMPARE(read.error().position.value, std::uint64_t{3});
    const auto part = readMesh(offOf(number), "a.off", {.partial = true});
    QVERIFY(part ? !part->damage.empty() && part->soup.triangles.empty()
                 : part.error().code == MeshFileError::NothingReadable);
  }
  for (const char* number : {"5e-324", "1e-310", "1e300", "-0", "1.7976931348623157e308"}) {
    const auto read = readMesh(offOf(number), "a.off", {});
    QVERIFY2(read, number);
    QCOMPARE(read->soup.points[0].x(), std::strtod(number, nullptr));
  }
  // The same in binary: a file that holds the bits of NaN or infinity.
  for (double number : test::strangeNumbers()) {
    if (std::isfinite(static_cast<float>(number))) continue;
    std::string stl = writeMesh(triangle(Vec3::Zero()), MeshFormat::Stl, NumberType::Float32);
    const auto bits = static_cast<float>(number);
    std::memcpy(stl.data() + 84 + 12, &bits, sizeof bits);  // header and count, normal, first corner
    const auto read = readMesh(stl, "a.stl", {});
    QVERIFY(!read && read.error().code == ErrorCode::NumberNotFinite);
  }
}

// This test proves the promises of the table.
void MeshExtremesTest::tableNamesEveryRow() {
  QFile file(test::sourcePath("docs/extremes.md"));
  QVERIFY(file.open(QIODevice::ReadOnly));
  const QString table = QString::fromUtf8(file.readAll());
  for (const test::ExtremeMesh& mesh : meshExtremesAllMeshes()) {
    if (mesh.name.starts_with("holed sphere")) continue;  // one row of the table for all of them
    QVERIFY2(table.contains("| " + QString::fromStdString(mesh.name) + " |"), mesh.name.c_str());
  }
}

HANDWHEEL_TEST(MeshExtremesTest)
#include "MeshExtremesTest.moc"
