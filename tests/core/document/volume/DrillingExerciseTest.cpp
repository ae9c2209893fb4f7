// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshChecks.h"
#include "TestClass.h"
#include "document/exercise/ExerciseErrors.h"
#include "document/volume/VolumeBlobs.h"
#include "document/volume/exercise/DrillingSubject.h"
#include "volume/VolumeShapes.h"
#include "volume/drilling/DrillBits.h"

#include <QTemporaryDir>
#include <QtTest>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

using namespace handwheel;

namespace {

namespace fs = std::filesystem;

// On a ball of 6 mm, straight down.
DrillingTask ballTask(const char* drill = "ball:3") {
  DrillingTask task;
  task.stock = std::make_shared<const DrillingStock>(stockOf(ballOfVoxels(6.0, 0.5)));
  task.plan = {Vec3(0.0, 0.0, 6.0), -Vec3::UnitZ(), 0.25, {}};
  task.tool = *drillBitOf(drill);
  task.material = "beech";
  task.spindle = 1500.0;
  return task;
}

const SparseVolume& stockIn(const TaskPointer& task) {
  return static_cast<const DrillingTask&>(*task).volume();
}

void putFile(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

// The document of a ball as a file; its first chunk may be lost.
std::string containerOfBall(double radius, bool isWhole) {
  Container container;
  writeVolume(ballOfVoxels(radius, 0.5), container);
  if (!isWhole) container.blobs.erase(container.blobs.begin());
  return *writeContainer(container, Compression::Fast);
}

}  // namespace

// Tests the texts, the display and the stocks of exercises of drilling.
class DrillingExerciseTest : public QObject {
  Q_OBJECT

 private slots:
  // The student reads the drill, the material, the path and what must not be entered.
  void conditions() {
    const auto linesOf = [&](const DrillingTask& task) {
      std::vector<std::string> lines;
      for (const ExerciseText& line : m_subject.conditions(task)) lines.push_back(line.inEnglish());
      return lines;
    };
    DrillingTask task = ballTask();
    QCOMPARE(linesOf(task), (std::vector<std::string>{"Ball head ⌀3 mm, 1500 r/min", "Material: Beech wood",
                                                      "Planned path within 0.25 mm: the green line"}));
    task.plan.forbidden = {{Vec3::Zero(), 1.0}};
    QCOMPARE(linesOf(task).back(), std::string("The head must not enter the forbidden region"));
    QCOMPARE(linesOf(ballTask("twist:3.2")).front(), std::string("Twist drill ⌀3.2 mm, 1500 r/min"));
    QCOMPARE(linesOf(ballTask("burr:4")).front(), std::string("Burr ⌀4 mm, 1500 r/min"));
  }

  // The path is a thin rod from 60 mm before the entry to 15 mm beyond it, no thicker than the tolerance.
  void theShownPath() {
    DrillPlan plan{Vec3(3.0, 4.0, 5.0), Vec3(2.0, -1.0, 2.0) / 3.0, 0.25, {}};
    for (const auto& [tolerance, radius] : {std::pair(0.25, 0.25), std::pair(3.0, 0.5)}) {
      plan.tolerance = tolerance;
      const std::vector<DisplayPart> parts = planParts(plan);
      QCOMPARE(parts.size(), std::size_t{1});
      QVERIFY(!parts.front().isSectioned);  // it stays whole where the view is cut
      const TriangleSoup& rod = *parts.front().soup;
      double least = 0.0, largest = 0.0;
      for (const Vec3& p : rod.points) {
        const double along = (p - plan.entry).dot(plan.direction);
        QVERIFY(std::abs((p - plan.entry - along * plan.direction).norm() - radius) < 1e-9);
        least = std::min(least, along);
        largest = std::max(largest, along);
      }
      QVERIFY(std::abs(least + 60.0) < 1e-9 && std::abs(largest - 15.0) < 1e-9);
      QVERIFY(std::abs(test::area(rod) / (2.0 * M_PI * radius * 75.0) - 1.0) < 0.02);
      for (const Triangle& t : rod.triangles) {
        const Vec3 &a = rod.points[t[0]], &b = rod.points[t[1]], &c = rod.points[t[2]];
        const Vec3 from = (a + b + c) / 3.0 - plan.entry, out = from - from.dot(plan.direction) * plan.direction;
        QVERIFY((b - a).cross(c - a).dot(out) > 0.0);
      }
    }
  }

  // The forbidden region is shown by its balls, closed and outside out.
  void theShownRegion() {
    const DrillPlan plan{Vec3::Zero(), -Vec3::UnitZ(), 1.0, {{Vec3(1.0, 2.0, 3.0), 4.0}, {Vec3(-9.0, 0.0, 0.0), 0.5}}};
    const std::vector<DisplayPart> parts = planParts(plan);
    QCOMPARE(parts.size(), std::size_t{3});
    for (std::size_t i = 0; i < 2; ++i) {
      const SolidBall& ball = plan.forbidden[i];
      QCOMPARE(parts[i + 1].name, "forbidden " + std::to_string(i + 1));
      for (const Vec3& p : parts[i + 1].soup->points) QVERIFY(std::abs((p - ball.centre).norm() - ball.radius) < 1e-9);
      const double exact = 4.0 / 3.0 * M_PI * std::pow(ball.radius, 3);
      QVERIFY(std::abs(test::volume(*parts[i + 1].soup) / exact - 1.0) < 0.015);
    }
  }

  // With the plan the stock is shown, or the skull where there is no other.
  void theShownStock() {
    const DrillingTask task = ballTask();
    const DisplayModel model = m_subject.display(task);
    QCOMPARE(model.parts.size(), std::size_t{2});
    QCOMPARE(model.parts.back().name, std::string("stock"));
    QCOMPARE(model.parts.back().soup, task.stock->shown());
    const DisplayModel skull = m_subject.display(DrillingTask::ofSkull());
    QCOMPARE(skull.parts.size(), 2 + DrillingTask::ofSkull().plan.forbidden.size());
    const Box box = DisplayModel{{skull.parts.back()}}.bounds();
    QVERIFY2(std::abs(box.sizes().x() - 144.0) < 1.5 && std::abs(box.sizes().y() - 180.0) < 1.5,
             QByteArray::number(box.sizes().x()));
  }

  // A drilling has no drawing and no sizes: what a turned part has is refused or empty.
  void whatATurnedPartHas() {
    const DrillingTask task = ballTask();
    QVERIFY(m_subject.withTurnedTarget(task).error().code == ExerciseError::WithoutTarget);
    QVERIFY(m_subject.withRoundedTarget(task, 0.1, 1.0).error().code == ExerciseError::WithoutTarget);
    const auto written = m_subject.exportDrawing(Exercise(), task, "drawing.pdf", {});
    QVERIFY(!written && written.error().code == ExerciseError::WithoutTarget);
    QCOMPARE(written.error().subject, std::string("drawing.pdf"));
    QVERIFY(m_subject.drawingFormats().empty());
    QVERIFY(m_subject.describeWork(task, *m_subject.start(task)).is_null());
    MarkingCriterion criterion;
    criterion.id = "depth";
    const Status refused = m_subject.applyTolerance(criterion);
    QVERIFY(!refused && refused.error().code == ErrorCode::ElementMalformed);
    QVERIFY(m_subject.usualLimit("forbidden", task) == std::optional(0.0) && !m_subject.usualLimit("plunge", task));
    QVERIFY(m_subject.positionProblem(criterion, task).empty());
  }

  // Any volume that can be opened becomes the stock, the path stays; a facing allowance means nothing, which is said.
  void aStockOfAFile_data() {
    QTest::addColumn<QString>("name");
    for (const char* const name : {"ball.nrrd", "ball.handwheel"}) QTest::newRow(name) << QString(name);
  }
  void aStockOfAFile() {
    QFETCH(QString, name);
    const QTemporaryDir folder;
    const fs::path path = folder.filePath(name).toStdString();
    VolumeSnapshot ball;
    ball.volume = ballOfVoxels(4.0, 0.5);
    if (name.endsWith(QStringLiteral("nrrd"))) {
      QVERIFY(VolumeKind().exportTo(ball, path, {}).hasValue());
    } else {
      putFile(path, containerOfBall(4.0, true));
    }
    const auto plain = m_subject.withImportedTarget(ballTask(), path, {}, {});
    QVERIFY(plain.hasValue());
    QCOMPARE(stockIn(plain->task).material(), ball.volume.material());
    QCOMPARE(static_cast<const DrillingTask&>(*plain->task).plan.entry, ballTask().plan.entry);
    QVERIFY(plain->notes.back().text.find("planned path and the forbidden region stay") != std::string::npos);
    const auto faced = m_subject.withImportedTarget(ballTask(), path, 0.5, {});
    QVERIFY(faced && faced->notes.size() == plain->notes.size() + 1);
    QVERIFY(faced->notes.front().text.find("no facing allowance") != std::string::npos);
  }

  // Files that are not a complete volume are refused, and the error names the file.
  void stocksThatAreNotTaken() {
    const QTemporaryDir folder;
    const fs::path root = folder.path().toStdString();
    putFile(root / "text.nrrd", "NRRD0004\n");
    putFile(root / "text.handwheel", "solid\n");
    putFile(root / "lost.handwheel", containerOfBall(4.0, false));
    Container other;
    (*other.manifest)["document"] = {{"kind", "robot"}};
    putFile(root / "other.handwheel", *writeContainer(other, Compression::Fast));
    for (const char* const name :
         {"text.nrrd", "text.handwheel", "lost.handwheel", "other.handwheel", "missing.nrrd", "missing.handwheel"}) {
      const auto imported = m_subject.withImportedTarget(ballTask(), root / name, {}, {});
      QVERIFY2(!imported, name);
      QCOMPARE(imported.error().subject, (root / name).string());
    }
    QVERIFY(m_subject.withImportedTarget(ballTask(), root / "missing.handwheel", {}, {}).error().code ==
            ErrorCode::FileMissing);
  }

  // The file types offered for import can be read as a volume: no meshes, which can only be written.
  void endingsOfStocks() {
    const std::vector<std::string> endings = m_subject.targetEndings();
    const auto has = [&](const char* ending) {
      return std::find(endings.begin(), endings.end(), ending) != endings.end();
    };
    for (const char* const ending : {".handwheel", ".vdb", ".nrrd", ".mha", ".nii.gz", ".dcm"})
      QVERIFY2(has(ending), ending);
    QVERIFY(!has(".stl") && !has(".obj"));
  }

 private:
  DrillingSubject m_subject;
};

HANDWHEEL_TEST(DrillingExerciseTest)
#include "DrillingExerciseTest.moc"
