// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/RepairBudget.h"

#include "GarbageMeshes.h"
#include "LargeInputs.h"
#include "RepairChecks.h"
#include "TestClass.h"
#include "document/formats/MeshFormat.h"
#include "mesh/holes/HoleSequence.h"
#include "mesh/repair/ObstructedHoles.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <QDir>
#include <QTest>

using namespace handwheel;

namespace {

// Returns the first violation of a condition that every repair must meet; empty: none.
std::string wrong(const HalfEdgeMesh& before, const HalfEdgeMesh& after, const RepairReport& report) {
  if (!validate(after).empty()) return "the mesh is not valid";
  const std::size_t most = 2 * repairBudget(before.liveFaceCount());
  if (report.effort > most) return "too much effort";
  if (report.countedEffort > most + most / 10) return "effort was spent, and not looked at";
  if (test::countBorder(after) > test::countBorder(before)) return "more open edges";
  return test::inconsistent(before, after, report);
}

// An open sheet, bent so that it is not flat.
TriangleSoup bowl(std::uint32_t n) {
  return test::grid(n, n, false, false, [&](std::uint32_t i, std::uint32_t j) {
    const double x = double(i) / n - 0.5, y = double(j) / n - 0.5;
    return Vec3(x, y, 0.1 * (x * x + y * y));
  });
}

std::size_t givenUp(const RepairReport& report) {
  return static_cast<std::size_t>(std::count_if(report.loops.begin(), report.loops.end(), [](const LoopResult& loop) {
    return loop.reason == FillFailure::TooMuchEffort;
  }));
}

// A damaged sphere and what a repair makes of it. The last of them, the most damaged, takes several seconds.
struct RepairedSphere {
  explicit RepairedSphere(std::uint32_t seed) {
    std::mt19937 random(seed);
    before = buildMesh(test::damagedSphere(random, 2, 10 * (seed + 1))).mesh;
    after = before;
    report = repair(after, {});
  }

  HalfEdgeMesh before, after;
  RepairReport report;
};

constexpr std::uint32_t kSpheres = 8;

// Made once.
const RepairedSphere& lastSphere() {
  static const RepairedSphere last(kSpheres - 1);
  return last;
}

}  // namespace

class RepairBudgetTest : public QObject {
  Q_OBJECT

 private slots:
  void growsWithTheMesh_data();
  void growsWithTheMesh();
  void bothBounds();
  void passesOverAnyMeshAreAllowed();
  void damagedSpheres();
  void damagedFiles();
  void isTheSameInEveryRun();
  void fillsNothingWithoutEffort();
};

void RepairBudgetTest::growsWithTheMesh_data() {
  QTest::addColumn<bool>("isFan");
  QTest::addColumn<std::uint32_t>("size");
  QTest::newRow("a sheet gets a back") << false << 60u;
  QTest::newRow("fans that touch are parted") << true << 1'000u;
}

// n log2 n thousand steps, and two million where that is less: from 243 + 2 faces on, as 245 · log2 245 = 1944.5 and
// 251 · log2 251 = 2000.9.
void RepairBudgetTest::bothBounds() {
  QCOMPARE(repairBudget(0), std::size_t{2'000'000});
  QCOMPARE(repairBudget(243), std::size_t{2'000'000});
  QCOMPARE(repairBudget(248), std::size_t{2'000'000});
  QVERIFY(repairBudget(249) > 2'000'000 && repairBudget(249) < 2'002'000);
  QCOMPARE(repairBudget(1022), std::size_t{10'240'000});  // 1024 · 10 thousand
  // One kind of work gets half of that, or a fixed number and forty steps per face.
  QCOMPARE(repairBudget(1022, 0.5, 10'000'000), std::size_t{5'120'000});
  QCOMPARE(repairBudget(1022, 0.5, 1'000), std::size_t{1'000 + 40 * 1022});
}

// Compares the work for a mesh and for one twice as fine: a sheet then has four times the triangles, and the rest is
// O(n log n). In a fan with twice the triangles all pairs meet, so there are four times as many.
void RepairBudgetTest::growsWithTheMesh() {
  QFETCH(bool, isFan);
  QFETCH(std::uint32_t, size);
  std::vector<double> steps;
  for (const std::uint32_t n : {size, 2 * size}) {
    HalfEdgeMesh mesh = buildMesh(isFan ? test::twoConesSharingAnEdge(n) : bowl(n)).mesh;
    const std::size_t faces = mesh.liveFaceCount();
    RepairOptions options;
    options.sheets = SheetHandling::Thicken;
    const RepairReport report = repair(mesh, options);
    QVERIFY(test::countEdges(mesh.compact().soup).sound());
    QVERIFY(isFan || report.loops.size() == 1);
    for (const LoopResult& loop : report.loops) QVERIFY(loop.method == FillMethod::ThickenedSheet);
    QVERIFY(report.countedEffort <= repairBudget(faces));
    steps.push_back(static_cast<double>(report.countedEffort));
  }
  QVERIFY2(steps[1] < 5 * steps[0], qPrintable(QString("%1, %2 steps").arg(steps[0]).arg(steps[1])));
}

// A mesh of any size is closed where a small one is: what its passes take for each face is allowed for each face.
void RepairBudgetTest::passesOverAnyMeshAreAllowed() {
  HalfEdgeMesh mesh = buildMesh(bowl(60)).mesh;
  const std::size_t most = tolerance::kPassBudget * mesh.liveFaceCount() / 2;
  WorkBudget effort(most);
  const ObstructedClosings closings = closeObstructedHoles(
      mesh, std::vector{ObstructedHole{findBoundaryLoops(mesh).front(), true}}, {}, 0.01, Progress().within(effort));
  QVERIFY(closings.holes[0].closed);
  QVERIFY(effort.counted() <= most);
  for (std::size_t n = 1'000; n < 1'000'000'000; n *= 10)
    QVERIFY(repairBudget(n, tolerance::kObstructedHoleShare, tolerance::kObstructedHoleBudget) >=
            tolerance::kPassBudget * n);
}

void RepairBudgetTest::damagedSpheres() {
  for (std::uint32_t seed = 0; seed < test::sized(kSpheres / 2, kSpheres - 1); ++seed) {
    const RepairedSphere sphere(seed);
    const std::string problem = wrong(sphere.before, sphere.after, sphere.report);
    QVERIFY2(problem.empty(), problem.c_str());
  }
  const std::string problem = wrong(lastSphere().before, lastSphere().after, lastSphere().report);
  QVERIFY2(problem.empty(), problem.c_str());
  QVERIFY2(givenUp(lastSphere().report) > 0, "the most damaged was not too much");
}

void RepairBudgetTest::damagedFiles() {
  const QString folder = qEnvironmentVariable("HANDWHEEL_DATA");
  if (folder.isEmpty()) QSKIP("HANDWHEEL_DATA is not set: no damaged files to repair");
  const QDir garbage(folder + "/garbage-meshes");
  // In the first of these, all holes are filled; in the second, all are given up; in the third, some of both.
  const QStringList usual{"532_be.ply", "1908_be.ply", "400_b.stl"};
  std::size_t files = 0;
  for (const QFileInfo& file : garbage.entryInfoList(test::sized(usual, QStringList{"*"}), QDir::Files)) {
    const auto read = readMeshFile(file.filePath().toStdString(), {.partial = true});
    if (!read) continue;
    const HalfEdgeMesh before = buildMesh(read->soup).mesh;
    HalfEdgeMesh after = before;
    RepairOptions options;
    options.sheets = SheetHandling::Thicken;
    options.fill.numbers = read->numbers;
    const RepairReport report = repair(after, options);
    const std::string problem = wrong(before, after, report);
    QVERIFY2(problem.empty(), (file.fileName().toStdString() + ": " + problem).c_str());
    ++files;
  }
  QVERIFY(files >= 3);
}

void RepairBudgetTest::isTheSameInEveryRun() {
  const RepairedSphere& one = lastSphere();
  const RepairedSphere other(kSpheres - 1);
  QVERIFY(givenUp(one.report) > 0);
  QCOMPARE(other.report.effort, one.report.effort);
  QVERIFY(test::sameMesh(one.after, other.after));
}

void RepairBudgetTest::fillsNothingWithoutEffort() {
  HalfEdgeMesh mesh = buildMesh(test::sphereWithHoles(3, 3, 0.3)).mesh;
  const HalfEdgeMesh before = mesh;
  WorkBudget none(0);
  const std::vector<HoleFill> fills = fillHoles(mesh, findBoundaryLoops(mesh), {}, Progress().within(none));
  QCOMPARE(fills.size(), std::size_t{3});
  for (const HoleFill& fill : fills) QVERIFY(fill.attempt.failure == FillFailure::TooMuchEffort);
  QVERIFY(test::sameMesh(mesh, before));
}

HANDWHEEL_TEST(RepairBudgetTest)
#include "RepairBudgetTest.moc"
