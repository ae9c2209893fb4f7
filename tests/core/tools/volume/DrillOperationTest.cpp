// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/volume/DrillOperation.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "volume/SurfaceToVolume.h"
#include "volume/VolumeErrors.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;

namespace {

constexpr double kThick = 3.0, kVoxelOfPlate = 0.25, kWayDown = 8.0;  // mm

// Its top is at z = 0.
TriangleSoup plateToDrill() {
  return test::box({-6.0, -6.0, -kThick}, {12.0, 12.0, kThick});
}

SparseVolume volumeToDrill() {
  return volumeOfSurface(plateToDrill(), kVoxelOfPlate)->volume;
}

// Straight down through the plate, from 2.5 mm above it, in a second.
PoseTrajectory straightDown(double seconds = 1.0) {
  return PoseTrajectory({{0.0, Vec3(0.03, -0.02, 2.5)}, {seconds, Vec3(0.03, -0.02, 2.5 - kWayDown)}});
}

DrillSetup setupOf(const char* tool) {
  OperationValues values(drillOperation());
  values.setValid("tool", std::string(tool));
  return *drillSetupOf(values);
}

}  // namespace

class DrillOperationTest : public QObject {
  Q_OBJECT

 private slots:
  // The default is a ball of 6 mm at 1000 r/min in the first of the materials, which removes all material in the head.
  void drillOfParameters() {
    OperationValues values(drillOperation());
    const Result<DrillSetup> usual = drillSetupOf(values);
    QVERIFY(usual && usual->tool.shape == DrillShape::Ball && usual->tool.diameter == 6.0);
    QCOMPARE(usual->material.id, drillMaterials().front().id);
    QVERIFY(std::abs(usual->spindle - 104.719755) < 1e-6);
    QVERIFY(std::isinf(usual->erosion));
    values.setValid("tool", std::string("saw:30:0.8"));
    values.setValid("material", std::string("beech"));
    values.setValid("rpm", 30.0);
    values.setValid("erosion", 2.0);
    const Result<DrillSetup> chosen = drillSetupOf(values);
    QVERIFY(chosen && chosen->tool.shape == DrillShape::Saw && chosen->tool.width == 0.8);
    QCOMPARE(chosen->material.id, std::string("beech"));
    QVERIFY(std::abs(chosen->spindle - M_PI) < 1e-12);
    QCOMPARE(chosen->erosion, 2.0);
  }

  // A drill or a material that there is not is refused by its word; all materials that there are are in the meaning.
  void unknownWords() {
    OperationValues values(drillOperation());
    values.setValid("material", std::string("cheese"));
    QVERIFY(drillSetupOf(values).error().code == VolumeErrors::NoSuchDrillMaterial);
    QCOMPARE(drillSetupOf(values).error().arguments, std::vector<std::string>{"cheese"});
    values.setValid("tool", std::string("laser:3"));
    QVERIFY(drillSetupOf(values).error().code == VolumeErrors::NoSuchDrill);
    QCOMPARE(drillSetupOf(values).error().arguments, std::vector<std::string>{"laser:3"});
    const std::string meaning = drillOperation().find("material")->meaning;
    for (const DrillMaterial& material : drillMaterials())
      QVERIFY2(meaning.find(" " + material.id) != std::string::npos, material.id.c_str());
  }

  // Through a plate: a cylinder is gone, and the work is kp times it. The front of the ball meets the plate 0.5 mm
  // below its start and leaves it 3 mm further.
  void aHole() {
    SparseVolume volume = volumeToDrill();
    const double before = countedMaterial(volume);
    const DrillSetup setup = setupOf("ball:4");
    const Result<Drilled> done = drillAlong(volume, setup, straightDown(), 1000.0, {});
    QVERIFY(done.hasValue());
    const double exact = M_PI * 4.0 * kThick;
    QVERIFY2(std::abs(done->removed / exact - 1.0) < 0.01, QByteArray::number(done->removed / exact));
    QVERIFY(std::abs(done->energy / (1e-3 * setup.material.energy * exact) - 1.0) < 0.01);
    QVERIFY(std::abs(before - countedMaterial(done->volume) - done->removed) < 1e-6 * before);
    QVERIFY(done->breakthrough);
    QVERIFY(std::abs(*done->breakthrough - (0.5 + kThick) / kWayDown) < 0.02);
    QCOMPARE(done->seconds, 1.0);
    QCOMPARE(done->hole->poses.size(), std::size_t{1001});
    // Only cycles that took something, and those after them, are kept; the largest of their loads are reported.
    double removed = 0.0, thrust = 0.0, torque = 0.0;
    for (const DrillTick& tick : done->ticks) {
      removed += tick.removed;
      thrust = std::max(thrust, tick.thrust);
      torque = std::max(torque, tick.torque.norm());
    }
    QVERIFY(done->ticks.size() < 850 && done->ticks.front().removed > 0.0 && thrust > 0.0);
    QVERIFY(std::abs(removed - done->removed) < 1e-9 * removed);
    QCOMPARE(done->maxThrust, thrust);
    QVERIFY(std::abs(done->maxTorque - torque) < 1e-9 * torque);
  }

  // By what is kept of it the hole is drilled once more.
  void aHoleOnceMore() {
    const DrillSetup setup = setupOf("twist:4");
    const Result<Drilled> done = drillAlong(volumeToDrill(), setup, straightDown(), 500.0, {});
    QVERIFY(done.hasValue());
    SparseVolume again = volumeToDrill();
    DrillRun run(again, done->hole->setup);
    for (std::size_t i = 0; i < done->hole->poses.size(); ++i) move(run, done->hole->poses[i]);
    QCOMPARE(run.removed(), done->removed);
    QCOMPARE(run.energy(), done->energy);
    QCOMPARE(again.material(), done->volume.material());
  }

  // A part whose voxels are made along the path loses the same material.
  void aHoleInAHybridPart() {
    const DrillSetup setup = setupOf("ball:4");
    HybridPart part = *HybridPart::of(plateToDrill(), kVoxelOfPlate);
    const Result<Drilled> done = drillAlong(part, setup, straightDown(), 500.0, {});
    const Result<Drilled> whole = drillAlong(volumeToDrill(), setup, straightDown(), 500.0, {});
    QVERIFY(done && whole && done->volume.isEmpty());
    QVERIFY(std::abs(done->removed / whole->removed - 1.0) < 1e-9);
    QVERIFY(done->breakthrough && done->breakthrough == whole->breakthrough);
    QVERIFY(!part.cutBlocks().empty());
  }

  // Near overlapping bodies, voxels are not certain: drilling stops.
  void uncertainVoxels() {
    TriangleSoup overlapping = plateToDrill();
    test::append(overlapping, test::box({-2.0, -2.0, -2.0}, {4.0, 4.0, 4.0}));
    HybridPart part = *HybridPart::of(overlapping, kVoxelOfPlate);
    const Result<Drilled> done = drillAlong(part, setupOf("ball:2"), straightDown(), 500.0, {});
    QVERIFY(done.hasValue());
    QVERIFY(!part.isExact());
    QVERIFY2(done->hole->poses.size() < 400, QByteArray::number(static_cast<int>(done->hole->poses.size())));
  }

  // No more poses than an hour has at 1 kHz.
  void pathsThatAreTooLong() {
    for (const double rate : {1000.0, 500.0}) {
      const Result<Drilled> done = drillAlong(volumeToDrill(), DrillSetup(), straightDown(8000.0), rate, {});
      QVERIFY(!done && done.error().code == VolumeErrors::PathTooLong);
      QCOMPARE(done.error().arguments, (std::vector<std::string>{"8000", rate == 500.0 ? "7200" : "3600"}));
    }
  }

  // Beside the plate nothing is taken, and a path without a pose goes nowhere.
  void nothingIsDrilled() {
    const SparseVolume volume = volumeToDrill();
    const PoseTrajectory beside({{0.0, Vec3(20.0, 0.0, 2.0)}, {0.1, Vec3(20.0, 0.0, -5.0)}});
    const Result<Drilled> missed = drillAlong(volume, DrillSetup(), beside, 1000.0, {});
    QVERIFY(missed && missed->removed == 0.0 && missed->ticks.empty() && !missed->breakthrough);
    QCOMPARE(missed->hole->poses.size(), std::size_t{101});
    QCOMPARE(missed->volume.material(), volume.material());
    const Result<Drilled> none = drillAlong(volume, DrillSetup(), PoseTrajectory(), 1000.0, {});
    QVERIFY(none && none->hole->poses.empty() && none->seconds == 0.0 && none->maxThrust == 0.0);
  }

  void cancelledAndFollowed() {
    JobState job;
    QVERIFY(drillAlong(volumeToDrill(), setupOf("ball:4"), straightDown(), 50.0, Progress(job)).hasValue());
    QCOMPARE(job.fraction.load(), 1.0);
    job.cancelled = true;
    const Result<Drilled> cancelled =
        drillAlong(volumeToDrill(), setupOf("ball:4"), straightDown(), 50.0, Progress(job));
    QVERIFY(!cancelled && cancelled.error().code == ErrorCode::Cancelled);
  }
};

HANDWHEEL_TEST(DrillOperationTest)
#include "DrillOperationTest.moc"
