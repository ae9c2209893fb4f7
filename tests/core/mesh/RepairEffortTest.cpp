// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/RepairEffort.h"

#include "GarbageMeshes.h"
#include "RepairChecks.h"
#include "TestClass.h"
#include "document/formats/MeshFormat.h"
#include "mesh/LoopFilling.h"
#include "mesh/MeshBuilder.h"
#include "mesh/MeshValidator.h"

#include <QDir>
#include <QTest>

using namespace handwheel;

namespace {

// What a repair must be, whatever it could do.
std::string wrong(const HalfEdgeMesh& before, const HalfEdgeMesh& after, const RepairReport& report) {
  if (!validate(after).empty()) return "the mesh is not valid";
  if (report.effort > 2 * repairEffort(before.liveFaceCount())) return "too much effort";
  if (test::countBorder(after) > test::countBorder(before)) return "more open edges";
  return test::inconsistent(before, after, report);
}

std::size_t givenUp(const RepairReport& report) {
  return static_cast<std::size_t>(std::count_if(report.loops.begin(), report.loops.end(), [](const LoopResult& loop) {
    return loop.reason == FillFailure::TooMuchEffort;
  }));
}

}  // namespace

class RepairEffortTest : public QObject {
  Q_OBJECT

 private slots:
  void growsWithNLogN();
  void damagedSpheres();
  void damagedFiles();
  void isTheSameInEveryRun();
  void fillsNothingWithoutEffort();
};

void RepairEffortTest::growsWithNLogN() {
  for (std::size_t n = 1; n < 1'000'000'000; n *= 10) {
    const double nLogN = static_cast<double>(n + 2) * std::log2(static_cast<double>(n + 2));
    QVERIFY(static_cast<double>(repairEffort(n)) <= tolerance::kRepairEffort * nLogN);
  }
}

void RepairEffortTest::damagedSpheres() {
  std::size_t stopped = 0;
  for (std::uint32_t seed = 0; seed < 8; ++seed) {
    std::mt19937 random(seed);
    const HalfEdgeMesh before = buildMesh(test::damagedSphere(random, 2, 10 * (seed + 1))).mesh;
    HalfEdgeMesh after = before;
    const RepairReport report = repair(after, {});
    const std::string problem = wrong(before, after, report);
    QVERIFY2(problem.empty(), problem.c_str());
    stopped += givenUp(report) > 0;
  }
  QVERIFY2(stopped > 0, "none of them was too much");
}

void RepairEffortTest::damagedFiles() {
  const QString folder = qEnvironmentVariable("HANDWHEEL_DATA");
  if (folder.isEmpty()) QSKIP("HANDWHEEL_DATA is not set: no damaged files to repair");
  const QDir garbage(folder + "/garbage-meshes");
  std::size_t files = 0;
  for (const QFileInfo& file : garbage.entryInfoList(QDir::Files)) {
    const auto read = readMeshFile(file.filePath().toStdString(), {.partial = true});
    if (!read) continue;
    const HalfEdgeMesh before = buildMesh(read->soup).mesh;
    HalfEdgeMesh after = before;
    RepairOptions options;
    options.fill.numbers = read->numbers;
    const RepairReport report = repair(after, options);
    const std::string problem = wrong(before, after, report);
    QVERIFY2(problem.empty(), (file.fileName().toStdString() + ": " + problem).c_str());
    ++files;
  }
  QVERIFY(files > 0);
}

void RepairEffortTest::isTheSameInEveryRun() {
  std::mt19937 random(7);
  const HalfEdgeMesh before = buildMesh(test::damagedSphere(random, 2, 80)).mesh;
  HalfEdgeMesh one = before, other = before;
  const RepairReport report = repair(one, {});
  QVERIFY(givenUp(report) > 0);
  QCOMPARE(repair(other, {}).effort, report.effort);
  QVERIFY(test::sameMesh(one, other));
}

void RepairEffortTest::fillsNothingWithoutEffort() {
  HalfEdgeMesh mesh = buildMesh(test::sphereWithHoles(3, 3, 0.3)).mesh;
  const HalfEdgeMesh before = mesh;
  Effort none(0);
  const std::vector<LoopFill> fills = fillLoops(mesh, findBoundaryLoops(mesh), {}, Progress().within(none));
  QCOMPARE(fills.size(), std::size_t{3});
  for (const LoopFill& fill : fills) QVERIFY(fill.attempt.failure == FillFailure::TooMuchEffort);
  QVERIFY(test::sameMesh(mesh, before));
}

HANDWHEEL_TEST(RepairEffortTest)
#include "RepairEffortTest.moc"
