// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "TurnedParts.h"
#include "document/container/Blobs.h"
#include "document/container/Migrations.h"
#include "document/formats/MeshFormat.h"
#include "document/workpiece/WorkpieceErrors.h"
#include "document/workpiece/WorkpieceKind.h"
#include "document/workpiece/target/TargetImport.h"
#include "machining/lathe/LatheJson.h"
#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/structure/MeshBuilder.h"
#include "nurbs/StepWriter.h"

#include <QFile>
#include <QTemporaryDir>
#include <QtTest>
#include <cmath>
#include <nlohmann/json.hpp>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// Bored from the upper end to z = 40, in two passes after the two of the outside.
WorkpieceSnapshot bored() {
  WorkpieceSnapshot workpiece = cutTwice();
  TurningPass pass;
  pass.side = TurningSide::Bore;
  for (const double r : {4.0, 8.0}) {
    pass.path = {{r, 110.0}, {r, 40.0}};
    pass.times = {0.0, 1.0};
    workpiece.part = withPass(workpiece, pass, 0.1);
  }
  return workpiece;
}

// The file of a program of version 3: a blob for each pass.
Container asOfVersion3(const WorkpieceSnapshot& workpiece) {
  Container container;
  WorkpieceKind().save(workpiece, container);
  (*container.manifest)["kind"] = "workpiece";
  container.blobs.erase("workpiece/path/0000");
  for (std::size_t i = 0; i < workpiece.part->passes.size(); ++i) {
    const TurningPass& pass = *workpiece.part->passes[i];
    std::vector<double> points;
    for (std::size_t k = 0; k < pass.path.size(); ++k)
      points.insert(points.end(), {pass.times[k], pass.path[k].x(), pass.path[k].y()});
    const std::string name = QString("workpiece/passes/%1").arg(i, 4, 10, QLatin1Char('0')).toStdString();
    writeArray<double>(container, name, points, 3);
  }
  return container;
}

}  // namespace

// Bores in documents, and passes as an older program saved them.
class BoredPartTest : public QObject {
  Q_OBJECT

 private slots:
  void exportsABore() {
    const QTemporaryDir folder;
    const WorkpieceSnapshot workpiece = bored();
    const TurnedProfile& profile = workpiece.part->profile;
    QVERIFY(profile.isBored());
    const std::filesystem::path step = folder.filePath("a.step").toStdString();
    const auto asStep = m_kind.exportTo(workpiece, step, {});
    QVERIFY(asStep);
    QFile file(QString::fromStdString(step));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const auto report = inspectStep(file.readAll().toStdString());
    QVERIFY(report && report->solids == 1 && report->isValid);
    QVERIFY(std::abs(report->volume / profile.volume() - 1.0) < 1e-3);
    const std::filesystem::path stl = folder.filePath("a.stl").toStdString();
    QVERIFY(m_kind.exportTo(workpiece, stl, {}));
    const auto read = readMeshFile(stl, {});
    QVERIFY(read);
    QVERIFY(findBoundaryLoops(buildMesh(read->soup).mesh).empty());
    double volume = 0.0;
    for (const Triangle& t : read->soup.triangles)
      volume += read->soup.points[t[0]].dot(read->soup.points[t[1]].cross(read->soup.points[t[2]])) / 6.0;
    QVERIFY(std::abs(volume / profile.volume() - 1.0) < 2e-3);
    std::vector<Note> notes;
    QCOMPARE(m_kind.bodyGeometry(workpiece, notes)->kind(), std::string_view("revolution"));
  }

  // Drilled from the right with a point of 118°, and bored above its bottom: a solid whose volume is that of cylinders
  // and a cone; its triangles close, and the finish is that of each tool.
  void aBlindBore() {
    WorkpieceSnapshot workpiece;
    workpiece.stock = {40.0, 100.0, 0.0};
    TurningPass drill, bar;
    drill.side = bar.side = TurningSide::Bore;
    drill.tool = toolNamed(shippedLatheTools(), "drill-12");
    drill.path = {{0.0, 105.0}, {0.0, 50.0}};
    drill.noseRadius = bar.noseRadius = 0.0;
    bar.path = {{8.0, 105.0}, {8.0, 60.0}};
    drill.times = bar.times = {0.0, 1.0};
    for (const TurningPass& pass : {drill, bar}) workpiece.part = withPass(workpiece, pass, 0.05);
    const double point = 6.0 / std::tan(59.0 * M_PI / 180.0);
    const double hole = M_PI * (64.0 * 40.0 + 36.0 * (10.0 - point) + 36.0 * point / 3.0);
    const double expected = M_PI * 400.0 * 100.0 - hole;
    const double step = volumeOfStep(workpiece);
    // At a shoulder the profile is listed from sample to sample.
    QVERIFY2(std::abs(step - expected) < 0.05 * M_PI * 64.0, qPrintable(QString::number(step - expected)));
    QVERIFY(std::abs(workpiece.part->profile.volume() - expected) < 0.05 * M_PI * 64.0);
    const QTemporaryDir folder;
    const std::filesystem::path stl = folder.filePath("a.stl").toStdString();
    QVERIFY(m_kind.exportTo(workpiece, stl, {}));
    const auto read = readMeshFile(stl, {});
    QVERIFY(read && findBoundaryLoops(buildMesh(read->soup).mesh).empty());
    const Result<TargetProfile> section = sectionOf(workpiece);
    QVERIFY(section && !section->isClosed());
    QVERIFY(std::abs(section->extentAt(52.0)->inner - 2.0 * std::tan(59.0 * M_PI / 180.0)) < 0.03);
    QCOMPARE(section->extentAt(45.0)->inner, 0.0);
  }

  // A hollow without an opening is no solid of a STEP file, and the reason is said; triangles have it.
  void aClosedHollowIsNoStepFile() {
    const QTemporaryDir folder;
    WorkpieceSnapshot workpiece;
    TurningPass pass;
    pass.side = TurningSide::Bore;
    pass.path = {{4.0, 30.0}, {4.0, 60.0}};
    pass.times = {0.0, 1.0};
    workpiece.part = withPass(workpiece, pass, 0.1);
    const auto written = m_kind.exportTo(workpiece, folder.filePath("a.step").toStdString(), {});
    QVERIFY(!written && written.error().code == WorkpieceError::ClosedHollow);
    QVERIFY(m_kind.exportTo(workpiece, folder.filePath("a.stl").toStdString(), {}));
  }

  void aLostBoreIsCutOnceMore() {
    const WorkpieceSnapshot workpiece = bored();
    for (const char* lost : {"workpiece/inner/0000", "workpiece/radii/0000"}) {
      Container container;
      m_kind.save(workpiece, container);
      QVERIFY(container.blobs.erase(lost) == 1);
      std::vector<Error> damage;
      const auto loaded = m_kind.load(container, damage, {});
      QVERIFY(loaded && damage.size() == 1);
      QVERIFY(isSame(static_cast<const WorkpieceSnapshot&>(**loaded), workpiece));
    }
    Container container;
    m_kind.save(workpiece, container);
    std::vector<double> inner = fromBlob<double>(container.blobs.at("workpiece/inner/0000"));
    for (const double bad : {-1e-9, 26.0, std::nan("")}) {
      inner[900] = bad;
      container.blobs["workpiece/inner/0000"] = toBlob(inner);
      std::vector<Error> damage;
      const auto loaded = m_kind.load(container, damage, {});
      QVERIFY(loaded && !damage.empty());
      QVERIFY(isSame(static_cast<const WorkpieceSnapshot&>(**loaded), workpiece));
    }
  }

  void passesOfVersion3AreJoined() {
    const WorkpieceSnapshot workpiece = cutTwice();
    Container container = asOfVersion3(workpiece);
    QVERIFY(migrate(container, 3, migrations()));
    QVERIFY(!container.blobs.contains("workpiece/passes/0000/0000"));
    std::vector<Error> damage;
    const auto loaded = m_kind.load(container, damage, {});
    QVERIFY(loaded && damage.empty());
    QVERIFY(isSame(static_cast<const WorkpieceSnapshot&>(**loaded), workpiece));
    // A pass that is lost costs itself alone: the part is whole by its samples.
    container = asOfVersion3(workpiece);
    container.blobs.erase("workpiece/passes/0000/0000");
    QVERIFY(migrate(container, 3, migrations()));
    const auto rest = m_kind.load(container, damage, {});
    QVERIFY(rest && damage.size() == 1);
    const auto& part = *static_cast<const WorkpieceSnapshot&>(**rest).part;
    QVERIFY(part.profile == workpiece.part->profile);
    QCOMPARE(part.passes.size(), std::size_t{1});
    QVERIFY(part.passes[0]->path == workpiece.part->passes[1]->path);
    for (const char* odd : {"3", "{}", "[1, null, {}]", "[{\"points\": -1}]", "[{\"points\": 1e30}]"}) {
      container = asOfVersion3(workpiece);
      (*container.manifest)["document"]["turned"]["passes"] = nlohmann::json::parse(odd);
      QVERIFY(migrate(container, 3, migrations()));
      QVERIFY(m_kind.load(container, damage, {}));
    }
  }

 private:
  // mm³; 0 where it is no valid solid.
  double volumeOfStep(const WorkpieceSnapshot& workpiece) const {
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath("a.step").toStdString();
    if (!m_kind.exportTo(workpiece, path, {})) return 0.0;
    QFile file(QString::fromStdString(path.string()));
    if (!file.open(QIODevice::ReadOnly)) return 0.0;
    const auto report = inspectStep(file.readAll().toStdString());
    return report && report->solids == 1 && report->isValid ? report->volume : 0.0;
  }

  WorkpieceKind m_kind;
};

HANDWHEEL_TEST(BoredPartTest)
#include "BoredPartTest.moc"
