// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/MeshExport.h"

#include "TestClass.h"
#include "document/DocumentErrors.h"
#include "mesh/defects/MeshReport.h"
#include "mesh/structure/MeshBuilder.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

using namespace handwheel;

namespace {

// Four corners of a tetrahedron with outward faces.
void addTetrahedron(TriangleSoup& soup, const std::array<Vec3, 4>& p) {
  const auto n = static_cast<std::uint32_t>(soup.points.size());
  soup.points.insert(soup.points.end(), p.begin(), p.end());
  for (const Triangle& t : {Triangle{0, 2, 1}, Triangle{0, 1, 3}, Triangle{1, 2, 3}, Triangle{2, 0, 3}}) {
    soup.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  }
}

// Two tetrahedra on either side of an edge from (1, 0, 0) to (1, 0, 1), apart by the gap along x.
TriangleSoup pairAtAnEdge(double gap) {
  TriangleSoup soup;
  addTetrahedron(soup, {Vec3(1 + gap, 0, 0), Vec3(2, 0, 0.5), Vec3(1 + gap, 0, 1), Vec3(1.5, -1, 0.5)});
  addTetrahedron(soup, {Vec3(1, 0, 0), Vec3(1, 0, 1), Vec3(0.5, 1.5, 0.5), Vec3(0, 0.5, 0.5)});
  return soup;
}

MeshReport statistics(const TriangleSoup& soup) {
  return reportOn(soup, SelfIntersections::Skip);
}

struct Exported {
  ExportReport report;
  TriangleSoup file;
};

// An empty file when the export failed, which no expectation allows.
Exported exported(const TriangleSoup& soup, NumberType numbers, const char* name) {
  QTemporaryDir folder;
  const std::filesystem::path path = folder.filePath(name).toStdString();
  const auto report = exportMesh(buildMesh(soup).mesh, numbers, path);
  if (!report) return {};
  const auto file = readMeshFile(path, {});
  if (!file || std::filesystem::file_size(path) != report->bytes) return {};
  return {*report, file->soup};
}

bool sameTriangles(const TriangleSoup& a, const TriangleSoup& b) {
  if (a.triangles.size() != b.triangles.size()) return false;
  for (std::size_t i = 0; i < a.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (a.points[a.triangles[i][k]] != b.points[b.triangles[i][k]]) return false;
    }
  }
  return true;
}

}  // namespace

class MeshExportTest : public QObject {
  Q_OBJECT

 private slots:
  // Two tetrahedra that share an edge: closed, and that one edge has four faces.
  void measuresTheFile() {
    const MeshReport inFile = exported(pairAtAnEdge(0.0), NumberType::Float64, "a.stl").report.inFile;
    QCOMPARE(inFile.triangles, std::size_t{8});
    QVERIFY(inFile.closed && !inFile.manifold && !inFile.isSound());
    QCOMPARE(inFile.nonManifoldEdges, std::size_t{1});
    QVERIFY(inFile.selfIntersectingPairs == std::size_t{0});  // an edge alone is no intersection
  }

  void holdsTheMesh_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"a.stl", "a.ply", "a.obj", "a.off", "A.STL"}) QTest::newRow(name) << name;
  }
  void holdsTheMesh() {
    QFETCH(QString, name);
    const TriangleSoup soup = pairAtAnEdge(0.5);  // all coordinates exact in single precision
    const Exported result = exported(soup, NumberType::Float64, name.toLatin1());
    QVERIFY(sameTriangles(result.file, soup));
    QVERIFY(result.report.parted.empty());
  }

  void removedFacesAreLeftOut() {
    HalfEdgeMesh mesh = buildMesh(pairAtAnEdge(0.5)).mesh;
    for (Face f = 0; f < 4; ++f) mesh.removeFace(f);
    QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath("a.off").toStdString();
    QVERIFY(exportMesh(mesh, NumberType::Float64, path).hasValue());
    const auto file = readMeshFile(path, {});
    QVERIFY(file.hasValue());
    QCOMPARE(file->soup.triangles.size(), std::size_t(4));
    QCOMPARE(file->soup.points.size(), std::size_t(4));
  }

  void doublesStayWhereTheFormatKeepsThem() {
    const TriangleSoup soup = pairAtAnEdge(1e-12);
    for (const char* name : {"a.ply", "a.obj", "a.off"}) {
      const Exported result = exported(soup, NumberType::Float64, name);
      QVERIFY(sameTriangles(result.file, soup));
      QVERIFY(result.report.parted.empty());
    }
  }

  // 0.1 is no number of single precision; 0.5 is.
  void saysHowFarRoundingMoves() {
    for (const auto& [gap, isMoved] : {std::pair(0.5, false), std::pair(0.1, true)}) {
      const ExportReport report = exported(pairAtAnEdge(gap), NumberType::Float64, "a.stl").report;
      QCOMPARE(report.roundingMove > 0.0, isMoved);
      QVERIFY(report.roundingMove <= std::sqrt(3.0) * std::ldexp(1.0, -24));  // half a step below 2 along each axis
      QCOMPARE(exported(pairAtAnEdge(gap), NumberType::Float64, "a.ply").report.roundingMove, 0.0);
    }
  }

  // Two triangles one above the other, nearer than a step of single precision at 1: in an STL file they lie in one
  // plane.
  void saysWhatIntersectsInTheFileOnly() {
    const double gap = 1e-9;
    const TriangleSoup soup{
        {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {0.125, 0.125, 1 + gap}, {0.75, 0.125, 1 + gap}, {0.125, 0.75, 1 + gap}},
        {{0, 1, 2}, {3, 4, 5}}};
    const ExportReport report = exported(soup, NumberType::Float64, "a.stl").report;
    QCOMPARE(report.roundingPairs, std::size_t{1});
    QCOMPARE(report.inFile.selfIntersectingPairs.value_or(0), std::size_t{1});
    const std::vector<Note> notes = notesOn(report);
    QVERIFY(std::any_of(notes.begin(), notes.end(), [](const Note& note) { return note.isLoss; }));
    QCOMPARE(exported(soup, NumberType::Float64, "a.ply").report.roundingPairs, std::size_t{0});
    QCOMPARE(exported(pairAtAnEdge(0.5), NumberType::Float64, "a.stl").report.roundingPairs, std::size_t{0});
  }

  // A triangle less high than a step of single precision has no area in an STL file. One that had none before does not
  // count.
  void saysWhatLosesItsAreaInTheFile() {
    const TriangleSoup thin{{{0, 0, 1}, {1, 0, 1}, {0.5, 0, 1 + 1e-9}}, {{0, 1, 2}}};
    const ExportReport report = exported(thin, NumberType::Float64, "a.stl").report;
    QCOMPARE(report.inFile.degenerateFaces, std::size_t{1});
    QCOMPARE(report.roundingDegenerate, std::size_t{1});
    const std::vector<Note> notes = notesOn(report);
    QVERIFY(std::any_of(notes.begin(), notes.end(), [](const Note& note) { return note.isLoss; }));
    QCOMPARE(exported(thin, NumberType::Float64, "a.ply").report.roundingDegenerate, std::size_t{0});
    const TriangleSoup flat{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0.1, 1, 0}, {1, 1, 0}, {0, 2, 0}},
                            {{0, 1, 2}, {3, 4, 5}}};
    const ExportReport moved = exported(flat, NumberType::Float64, "a.stl").report;
    QVERIFY(moved.roundingMove > 0.0);
    QCOMPARE(moved.inFile.degenerateFaces, std::size_t{1});
    QCOMPARE(moved.roundingDegenerate, std::size_t{0});
  }

  // 1e-12 is far below a step of single precision at 1: both edges would become one with four faces.
  void partsWhatRoundingWouldWeld() {
    const TriangleSoup soup = pairAtAnEdge(1e-12);
    const Exported result = exported(soup, NumberType::Float64, "a.stl");
    const MeshReport after = statistics(result.file);
    QCOMPARE(after.triangles, std::size_t(8));
    QVERIFY(after.isSound());
    QCOMPARE(after.components, std::size_t(2));
    QVERIFY(!result.report.parted.empty());
    // Nothing moved by more than a rounding and one step (2^-23 at 1) along each axis.
    for (std::size_t i = 0; i < 8; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 shift = result.file.points[result.file.triangles[i][k]] - soup.points[soup.triangles[i][k]];
        QVERIFY(shift.cwiseAbs().maxCoeff() <= 1.5 * std::ldexp(1.0, -23));
      }
    }
  }

  // So would the tips of two pyramids, which stand on each other, become one vertex of both.
  void partsVerticesThatRoundingWouldWeld() {
    TriangleSoup soup;
    addTetrahedron(soup, {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 2, 0), Vec3(1, 1, 1)});
    addTetrahedron(soup, {Vec3(0, 0, 2), Vec3(0, 2, 2), Vec3(2, 0, 2), Vec3(1, 1, 1 + 1e-12)});
    QCOMPARE(statistics(soup).nonManifoldVertices, std::size_t(0));
    const Exported result = exported(soup, NumberType::Float64, "a.stl");
    QCOMPARE(result.report.parted.size(), std::size_t(1));
    QVERIFY(statistics(result.file).isSound());
    QCOMPARE(statistics(result.file).components, std::size_t(2));
    QVERIFY(exported(soup, NumberType::Float64, "a.ply").report.parted.empty());
  }

  // One edge with four faces in the mesh itself is the user's: it is written as it is.
  void leavesWhatTheMeshItselfWelds() {
    const TriangleSoup soup = pairAtAnEdge(0.0);
    QCOMPARE(statistics(soup).nonManifoldEdges, std::size_t(1));
    const Exported result = exported(soup, NumberType::Float64, "a.stl");
    QVERIFY(sameTriangles(result.file, soup));
    QVERIFY(result.report.parted.empty());
  }

  // A slit narrower than single precision closes in the file; nothing is wrong with that.
  void harmlessWeldingIsLeft() {
    TriangleSoup soup;
    soup.points = {{1, 0, 0}, {1, 1, 0}, {0, 0.5, 0}, {1 + 1e-12, 0, 0}, {1 + 1e-12, 1, 0}, {2, 0.5, 0}};
    soup.triangles = {{0, 1, 2}, {4, 3, 5}};
    const Exported result = exported(soup, NumberType::Float64, "a.stl");
    QVERIFY(result.report.parted.empty());
    QCOMPARE(statistics(result.file).boundaryEdges, std::size_t(4));
  }

  void unknownEnding() {
    const auto result = exportMesh(buildMesh(pairAtAnEdge(1)).mesh, NumberType::Float64, "a.docx");
    QVERIFY(!result);
    QCOMPARE(result.error().code, DocumentError::ExtensionUnknown);
    QCOMPARE(result.error().arguments.at(0), std::string(".docx"));
  }

  void cancelWritesNothing() {
    QTemporaryDir folder;
    JobState state;
    state.cancelled = true;
    const auto result = exportMesh(buildMesh(pairAtAnEdge(1)).mesh, NumberType::Float64,
                                   folder.filePath("a.stl").toStdString(), Progress(state));
    QVERIFY(!result);
    QCOMPARE(result.error().code, ErrorCode::Cancelled);
    QVERIFY(QDir(folder.path()).isEmpty());
  }
};

HANDWHEEL_TEST(MeshExportTest)
#include "MeshExportTest.moc"
