// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "DrillInput.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "simulation/drilling/DrillSimulation.h"
#include "volume/SurfaceToVolume.h"
#include "volume/VolumeSampler.h"

#include <QtTest>
#include <cmath>
#include <limits>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kPartEdge = 8.0, kPartVoxel = 0.25;  // mm
constexpr double kPartStep = 1.0 / 60.0;              // s

// A cube whose top is at z = 0, around the z axis.
TriangleSoup drilledCube(double edge = kPartEdge) {
  return moved(cube(edge), Vec3(-0.5 * edge, -0.5 * edge, -edge));
}

DrillSetup ballOfSixteenVoxels() {
  DrillSetup setup;
  setup.tool.diameter = 16.0 * kPartVoxel;
  return setup;
}

// Feeds down from above a position on the top.
void feedFor(DrillSimulation& simulation, int steps) {
  const SimulationInput pressed = test::handAt({0.013, -0.021, 2.5}, 0.0, 1);
  simulation.step(kPartStep, {&pressed, 1});
  for (int i = 1; i < steps; ++i) simulation.step(kPartStep, {});
}

}  // namespace

// Drilling of a part of triangles that gets voxels near the head alone.
class PartDrillingTest : public QObject {
  Q_OBJECT

 private slots:
  // Feeds through a cube, step by step as in a full volume: thrust, torque, removed volume, the breakthrough. The hole
  // is a cylinder. The shown tiles that were cut have the surface of the whole volume, to the last point, and nothing
  // is shown elsewhere.
  void asInTheWholeVolume() {
    const DrillFeed feed{Vec3::UnitZ(), 25.0};
    auto begin = std::make_shared<ClayState>();
    begin->volume = volumeOfSurface(drilledCube(), kPartVoxel)->volume;
    begin->surface = VolumeSurface(begin->volume);
    DrillSimulation whole(begin, ballOfSixteenVoxels(), feed, std::make_shared<ClayChannel>());
    DrillSimulation part(*HybridPart::of(drilledCube(), kPartVoxel), ballOfSixteenVoxels(), feed,
                         std::make_shared<ClayChannel>());
    QVERIFY(whole.part() == nullptr && part.part() != nullptr);
    QVERIFY(test::stateOf(part)->tiles.empty() && test::stateOf(part)->volume.isEmpty());
    feedFor(whole, 40);
    feedFor(part, 40);
    const auto a = test::stateOf(whole), b = test::stateOf(part);
    QVERIFY(b->isExact);
    QVERIFY(std::abs(a->removed - b->removed) < 1e-9 * a->removed);
    QVERIFY(std::abs(a->figures.thrust - b->figures.thrust) < 1e-9 * a->figures.thrust);
    QVERIFY(std::abs(a->figures.torque - b->figures.torque) < 1e-9 * a->figures.torque);
    QVERIFY(a->breakthrough && a->breakthrough == b->breakthrough);
    QCOMPARE(b->changedBlocks, a->changedBlocks);
    QCOMPARE(b->poses.size(), a->poses.size());
    const double radius = 8.0 * kPartVoxel, exact = M_PI * radius * radius * kPartEdge;
    QVERIFY2(std::abs(b->removed / exact - 1.0) < 0.01, QByteArray::number(b->removed / exact));

    const VolumeSurface all(a->volume, {}, HybridPart::kTile);
    QVERIFY(!b->tiles.empty());
    std::size_t shown = 0;
    for (const VolumeSurface::Key& tile : b->tiles) {
      const auto expected = all.pieces().find(tile), made = b->surface.pieces().find(tile);
      QCOMPARE(made == b->surface.pieces().end(), expected == all.pieces().end());
      if (made == b->surface.pieces().end()) continue;
      ++shown;
      QCOMPARE(made->second->origin, expected->second->origin);
      QCOMPARE(made->second->fine.points, expected->second->fine.points);
      QCOMPARE(made->second->fine.normals, expected->second->fine.normals);
      QCOMPARE(made->second->fine.corners, expected->second->fine.corners);
      const Box box = boxOfTile(*b, tile);
      const Vec3 slack = Vec3::Constant(1e-5);
      QVERIFY(Box(box.min() - slack, box.max() + slack).contains(made->second->box));
    }
    QCOMPARE(b->surface.pieces().size(), shown);
    // A tile has 32 cells along each axis.
    QVERIFY((boxOfTile(*b, b->tiles.front()).sizes() - Vec3::Constant(32.0 * kPartVoxel)).norm() < 1e-9);
  }

  // In a part of 80 mm only the neighbourhood of the hole is shown and kept.
  void onlyNearTheDrill() {
    DrillSimulation simulation(*HybridPart::of(drilledCube(80.0), kPartVoxel), ballOfSixteenVoxels(),
                               DrillFeed{Vec3::UnitZ(), 12.0}, std::make_shared<ClayChannel>());
    feedFor(simulation, 40);
    const auto state = test::stateOf(simulation);
    QVERIFY(state->removed > 10.0 && !state->breakthrough);
    const double far = 2.0 * HybridPart::kTile * kPartVoxel;  // no head of 4 mm reaches a tile whose middle is there
    for (const VolumeSurface::Key& tile : state->tiles) {
      const Vec3 middle = boxOfTile(*state, tile).center();
      QVERIFY(std::abs(middle.x()) < far && std::abs(middle.y()) < far && middle.z() > -20.0);
    }
    QVERIFY(state->volume.blockCount() < 2000);  // all of it takes the area by that of a block, 9,600, and more
  }

  // A hand feels the part before it cuts: voxels are there where its tool is, also when it comes fast, and given back
  // when it goes. They are those of the whole volume.
  void felt() {
    const SparseVolume whole = volumeOfSurface(drilledCube(), kPartVoxel)->volume;
    const auto channel = std::make_shared<ClayChannel>();
    DrillSimulation simulation(*HybridPart::of(drilledCube(), kPartVoxel), ballOfSixteenVoxels(), std::nullopt,
                               channel);
    const double radius = 8.0 * kPartVoxel;
    const auto at = [&](const Vec3& foremost) {
      const SimulationInput input = test::handAt(foremost + radius * Vec3::UnitZ(), 0.0, 0);
      simulation.step(kPartStep, {&input, 1});
      return test::stateOf(simulation);
    };
    QVERIFY(at({0.0, 0.0, 60.0})->volume.isEmpty());
    const auto near = at({1.0, 2.0, 0.2});
    for (const Vec3& position : {Vec3(1.0, 2.0, 0.2), Vec3(1.3, 2.1, -0.4), Vec3(0.2, 1.7, -3.0)})
      QCOMPARE(VolumeSampler(near->volume).depthAt(position).depth, VolumeSampler(whole).depthAt(position).depth);
    QVERIFY(VolumeSampler(near->volume).depthAt({1.0, 2.0, -1.0}).depth > 0.0);
    QCOMPARE(near->changedBlocks, std::size_t{0});
    QVERIFY(near->tiles.empty());
    QCOMPARE(channel->patch.read().state.get(), static_cast<const ClayState*>(near.get()));
    QCOMPARE(at({1.01, 2.01, 0.2}).get(), near.get());  // nothing new
    QVERIFY(at({0.0, 0.0, 60.0})->volume.isEmpty());
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(at({kNan, 0.0, 0.0})->volume.isEmpty());
  }

  // By the hand as by DrillRun in such a part, with a hole that stays when the hand has gone.
  void byTheHandInAPart() {
    DrillSimulation simulation(*HybridPart::of(drilledCube(), kPartVoxel), ballOfSixteenVoxels(), std::nullopt,
                               std::make_shared<ClayChannel>());
    HybridPart part = *HybridPart::of(drilledCube(), kPartVoxel);
    DrillRun run(part, ballOfSixteenVoxels());
    for (int i = 0; i < 150; ++i) {
      const Vec3 position(0.3, -0.2, 2.5 - 0.03 * i);
      const SimulationInput input = test::handAt(position, 0.001 * i, 1);
      simulation.step(kPartStep, {&input, 1});
      move(run, DrillPose::of(position, Vec3::UnitZ(), 0.001 * i));
    }
    QVERIFY(run.removed() > 1.0);
    QVERIFY(std::abs(test::stateOf(simulation)->removed - run.removed()) < 1e-9);
    QVERIFY(simulation.part()->cutBlocks() == part.cutBlocks());
    const SimulationInput away = test::handAt({0.0, 0.0, 90.0}, 1.0, 0);
    simulation.step(kPartStep, {&away, 1});
    QVERIFY(simulation.part()->cutBlocks() == part.cutBlocks());
    QVERIFY(VolumeSampler(test::stateOf(simulation)->volume).depthAt({0.3, -0.2, -1.0}).depth < 0.0);
  }
};

HANDWHEEL_TEST(PartDrillingTest)
#include "PartDrillingTest.moc"
