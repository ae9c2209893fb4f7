// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/measure/Deviation.h"
#include "mesh/simplify/Decimation.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <QElapsedTimer>
#include <QFile>
#include <QTest>
#include <QTextStream>

using namespace handwheel;

// At the same number of faces the result is about as near to the original as that of CGAL's edge collapse, which
// follows Lindstrom and Turk.
class DecimationQualityTest : public QObject {
  Q_OBJECT

 private slots:
  void againstCgal_data();
  void againstCgal();
  void scans_data();
  void scans();
  void withinAnError();
};

namespace {

constexpr double kMost = 1.1;  // times CGAL's error

using Point = CGAL::Simple_cartesian<double>::Point_3;

TriangleSoup byCgal(const TriangleSoup& soup, std::size_t faces) {
  CGAL::Surface_mesh<Point> mesh;
  for (const Vec3& p : soup.points) mesh.add_vertex(Point(p.x(), p.y(), p.z()));
  using Index = CGAL::Surface_mesh<Point>::Vertex_index;
  for (const Triangle& t : soup.triangles) mesh.add_face(Index(t[0]), Index(t[1]), Index(t[2]));
  // Three edges for two faces, as closed surfaces have it.
  const CGAL::Surface_mesh_simplification::Count_stop_predicate<CGAL::Surface_mesh<Point>> stop(faces * 3 / 2 + 1);
  CGAL::Surface_mesh_simplification::edge_collapse(mesh, stop);
  mesh.collect_garbage();
  TriangleSoup result;
  for (const auto v : mesh.vertices()) {
    const Point& p = mesh.point(v);
    result.points.emplace_back(p.x(), p.y(), p.z());
  }
  for (const auto f : mesh.faces()) {
    Triangle t{};
    std::size_t k = 0;
    for (const auto v : vertices_around_face(mesh.halfedge(f), mesh)) t[k++] = static_cast<std::uint32_t>(v);
    result.triangles.push_back(t);
  }
  return result;
}

struct Errors {
  double rms = 0.0, largest = 0.0;
};

// Returns the errors in both directions.
Errors errorsOf(const HalfEdgeMesh& mesh, const HalfEdgeMesh& original) {
  const auto d = deviation(mesh, original, {.samples = 30'000, .bins = 1});
  if (!d) qFatal("no deviation");
  return {std::hypot(d->ofMesh.rms, d->ofScan.rms) / std::sqrt(2.0), d->hausdorff()};
}

void compare(const TriangleSoup& soup, std::size_t faces) {
  const HalfEdgeMesh original = buildMesh(soup).mesh;
  HalfEdgeMesh mesh = original;
  QElapsedTimer timer;
  timer.start();
  const TriangleSoup theirs = byCgal(soup, faces);
  const qint64 cgals = timer.restart();
  const DecimationReport report = decimate(mesh, {.faces = theirs.triangles.size()});
  const qint64 ours = timer.elapsed();
  const Errors a = errorsOf(mesh, original), b = errorsOf(buildMesh(theirs).mesh, original);
  qInfo("%zu faces to %zu, RMS %.3g, largest %.3g, %lld ms; CGAL to %zu, RMS %.3g, largest %.3g, %lld ms; ratio %.3f",
        report.facesBefore, report.facesAfter, a.rms, a.largest, ours, theirs.triangles.size(), b.rms, b.largest, cgals,
        a.rms / b.rms);
  QCOMPARE(validate(mesh), std::string());
  QVERIFY(report.facesAfter <= theirs.triangles.size());
  QVERIFY(report.facesAfter + 2 >= theirs.triangles.size());
  QVERIFY(a.rms <= kMost * b.rms);
}

// The lines "v x y z" and "f a b c" of an OBJ file; with other corners cut off.
TriangleSoup readObj(const QString& path) {
  TriangleSoup soup;
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return soup;
  for (QByteArray line = file.readLine(); !line.isEmpty(); line = file.readLine()) {
    const QList<QByteArray> words = line.simplified().split(' ');
    if (words[0] == "v") soup.points.emplace_back(words[1].toDouble(), words[2].toDouble(), words[3].toDouble());
    if (words[0] != "f") continue;
    Triangle t{};
    for (int k = 0; k < 3; ++k) t[k] = words[k + 1].split('/')[0].toUInt() - 1;
    soup.triangles.push_back(t);
  }
  return soup;
}

}  // namespace

void DecimationQualityTest::againstCgal_data() {
  QTest::addColumn<int>("shape");
  QTest::addColumn<int>("faces");
  QTest::newRow("sphere") << 0 << 500;
  QTest::newRow("torus") << 1 << 1000;
  QTest::newRow("bumpy sphere") << 2 << 1000;
  QTest::newRow("bumpy sphere, few") << 2 << 200;
}

void DecimationQualityTest::againstCgal() {
  QFETCH(int, shape);
  QFETCH(int, faces);
  compare(shape == 0   ? test::icosphere(5)
          : shape == 1 ? test::torus(160, 80)
                       : test::bumpySphere(5),
          static_cast<std::size_t>(faces));
}

void DecimationQualityTest::scans_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<int>("faces");
  QTest::newRow("bunny") << "scans/common-3d-test-models/stanford-bunny.obj" << 3000;
}

void DecimationQualityTest::scans() {
  QFETCH(QString, file);
  QFETCH(int, faces);
  const QString folder = qEnvironmentVariable("HANDWHEEL_DATA");
  if (folder.isEmpty()) QSKIP("HANDWHEEL_DATA is not set: no scans to reduce");
  const TriangleSoup soup = readObj(folder + "/" + file);
  if (soup.triangles.empty()) QSKIP("the scan is not there");
  compare(soup, static_cast<std::size_t>(faces));
}

// A third of the mean edge: most vertices of a scan are worth less.
void DecimationQualityTest::withinAnError() {
  const HalfEdgeMesh original = buildMesh(test::bumpySphere(5)).mesh;
  double length = 0.0;
  std::size_t edges = 0;
  for (HalfEdge h = 0; h < 3 * original.faceSlots(); ++h, ++edges)
    length += (original.position(original.to(h)) - original.position(original.from(h))).norm();
  const double error = length / static_cast<double>(edges) / 3.0;
  HalfEdgeMesh mesh = original;
  QElapsedTimer timer;
  timer.start();
  const DecimationReport report = decimate(mesh, {.error = error});
  qInfo("%zu faces to %zu, largest %.3g of %.3g, %lld ms", report.facesBefore, report.facesAfter,
        report.largestDistance.value_or(-1.0), error, timer.elapsed());
  QVERIFY(report.largestDistance && *report.largestDistance <= error);
  QVERIFY(errorsOf(mesh, original).largest <= error);
  QVERIFY(report.facesAfter < report.facesBefore / 4);
}

HANDWHEEL_TEST(DecimationQualityTest)
#include "DecimationQualityTest.moc"
