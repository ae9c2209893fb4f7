// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Extremes.h"

#include "LargeInputs.h"
#include "TestClass.h"
#include "document/formats/MeshExport.h"
#include "mesh/defects/Defects.h"
#include "mesh/defects/MeshReport.h"
#include "mesh/repair/Repair.h"
#include "mesh/structure/MeshBuilder.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <ctime>

using namespace handwheel;

namespace {

constexpr std::size_t kTriangles = 10'000'000;
constexpr std::size_t kHoles = 50;
constexpr double kMostMemory = 6.0;  // GB
constexpr double kVolume = 2.0 * M_PI * M_PI * 50.0 * 20.0 * 20.0;

// The most memory that this process had at once (GB), since the last reset.
double peakMemory() {
  QFile status(QStringLiteral("/proc/self/status"));
  if (!status.open(QIODevice::ReadOnly)) return 0.0;
  for (const QByteArray& line : status.readAll().split('\n')) {
    if (line.startsWith("VmHWM:")) return line.mid(6).trimmed().split(' ')[0].toDouble() * 1024e-9;
  }
  return 0.0;
}

void resetPeakMemory() {
  QFile file(QStringLiteral("/proc/self/clear_refs"));
  if (file.open(QIODevice::WriteOnly)) file.write("5");
}

// Prints what a stage took when it ends: CPU time of all threads, and memory.
class Stage {
 public:
  explicit Stage(const char* name) : m_name(name), m_start(std::clock()) { resetPeakMemory(); }
  ~Stage() {
    const double seconds = static_cast<double>(std::clock() - m_start) / CLOCKS_PER_SEC;
    qInfo("%-24s %6.1f s CPU  %5.2f GB", m_name, seconds, peakMemory());
    if (peakMemory() > kMostMemory) QTest::qFail("more than 6 GB", __FILE__, __LINE__);
  }

 private:
  const char* m_name;
  std::clock_t m_start;
};

}  // namespace

// Ten million triangles go through everything that a mesh can go through, within 6 GB. Long, so only on demand.
class LargeMeshTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void tenMillionTriangles();
};

void LargeMeshTest::initTestCase() {
  if (!test::withLargeInputs()) QSKIP("HANDWHEEL_LARGE is not set: this test takes minutes.");
}

void LargeMeshTest::tenMillionTriangles() {
  const QTemporaryDir folder;
  const std::filesystem::path in = folder.filePath("in.stl").toStdString(),
                              out = folder.filePath("out.stl").toStdString();
  {
    const Stage stage("write STL");
    const std::string bytes = writeMesh(test::largeTorus(kTriangles, kHoles), MeshFormat::Stl, NumberType::Float32);
    QVERIFY(writeFileAtomically(in, bytes));
  }
  HalfEdgeMesh mesh;
  {
    const Stage stage("read and build");
    Result<MeshFile> file = readMeshFile(in, {});
    QVERIFY(file && file->soup.triangles.size() >= kTriangles);
    mesh = buildMesh(file->soup).mesh;
  }
  {
    const Stage stage("defects");
    const Defects defects = findDefects(mesh);
    QCOMPARE(defects.loops.size(), kHoles);
    QCOMPARE(defects.components.size(), std::size_t{1});
    QVERIFY(defects.degenerateFaces.empty() && defects.nonManifoldEdges.empty());
  }
  {
    const Stage stage("self-intersections");
    const auto pairs = findSelfIntersections(mesh);
    QVERIFY(pairs && pairs->empty());
  }
  {
    const Stage stage("repair");
    const RepairReport report = repair(mesh, {});
    QCOMPARE(report.loops.size(), kHoles);
    for (const LoopResult& loop : report.loops) QVERIFY(loop.outcome == LoopOutcome::Filled);
  }
  {
    const Stage stage("export STL, checked");
    const auto written = exportMesh(mesh, NumberType::Float32, out);
    QVERIFY(written && written->inFile.isSound());
  }
  mesh = {};
  const Stage stage("read again and report");
  const auto file = readMeshFile(out, {});
  QVERIFY(file);
  const MeshReport report = reportOn(file->soup, SelfIntersections::Skip);
  QVERIFY(report.isSound());
  QVERIFY(std::abs(*report.volumeMm3 / kVolume - 1.0) < 1e-5);
}

HANDWHEEL_TEST(LargeMeshTest)
#include "LargeMeshTest.moc"
