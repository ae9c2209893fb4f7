// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/clay/ClayLayers.h"

#include "../SolidShapes.h"
#include "ClosedSurface.h"
#include "TestClass.h"
#include "volume/VolumeDifference.h"
#include "volume/VolumeSampler.h"
#include "volume/VolumeShapes.h"
#include "volume/surface/VolumeToSurface.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kLayerVoxel = 0.25;  // mm

bool isSame(const SparseVolume& a, const SparseVolume& b) {
  return differingBlocks(a, b).empty() && a.material() == b.material();
}

// A layer that makes one volume of another.
ClayLayers layered(const SparseVolume& base, const SparseVolume& top) {
  ClayLayers layers(base);
  layers.add("first", base);
  layers.record(base, top);
  return layers;
}

SparseVolume carved(SparseVolume volume, const Vec3& centre, double radius) {
  ClayDab dab;
  dab.action = ClayAction::Carve;
  dab.centre = centre;
  dab.radius = radius;
  applyDab(volume, dab);
  return volume;
}

double depthOf(const SparseVolume& volume, const Vec3& point) {
  return VolumeSampler(volume).depthAt(point).depth;
}

}  // namespace

class ClayLayersTest : public QObject {
  Q_OBJECT

 private slots:
  // A block grows by 4 mm, 16 voxels, which is far beyond the stored depths: at a share of the layer the face has moved
  // by that share of the distance.
  void shareOfAFace() {
    const SparseVolume low = boxOfVoxels(Vec3(12, 12, 4), Vec3::Zero(), kLayerVoxel);
    const SparseVolume high = boxOfVoxels(Vec3(12, 12, 8), Vec3::Zero(), kLayerVoxel);
    for (const bool grows : {true, false}) {
      ClayLayers layers = grows ? layered(low, high) : layered(high, low);
      for (const double share : {0.25, 0.5, 0.75}) {
        layers.setShare(0, share, true);
        const SparseVolume visible = layers.visible();
        const double height = grows ? 4.0 + 4.0 * share : 8.0 - 4.0 * share;
        for (const double below : {0.5, 0.25, 0.0, -0.25, -0.5}) {
          const double depth = depthOf(visible, Vec3(6.0, 6.0, height - below));
          QVERIFY2(std::abs(depth - below) < 0.01 * kLayerVoxel, QByteArray::number(depth - below));
        }
        // Far from the face nothing seems near.
        for (const double away : {1.25, 1.5, 2.0, 2.5, 3.0})
          for (const double side : {-away, away})
            QVERIFY(std::abs(depthOf(visible, Vec3(6.0, 6.0, height + side))) > 3.5 * kLayerVoxel);
        QVERIFY(isClosedManifold(surfaceOf(visible)));
      }
    }
  }

  // With next to no share the samples near the surface are next to those below, and with nearly all of it next to those
  // of the layer: also in a wall two voxels thick, and where surfaces meet at edges.
  void nearEnds() {
    const SparseVolume wall = boxOfVoxels(Vec3(8, 8, 2.0 * kLayerVoxel), Vec3::Zero(), kLayerVoxel);
    const SparseVolume top = withBall(wall, Vec3(4, 4, kLayerVoxel), 1.5);
    ClayLayers layers = layered(wall, top);
    for (const double share : {0.001, 0.999}) {
      layers.setShare(0, share, true);
      const SparseVolume visible = layers.visible();
      const SparseVolume& end = share < 0.5 ? wall : top;
      for (const VoxelIndex& block : layers.all()[0].change->blocks())
        for (int i = 0; i < 512; ++i) {
          const VoxelIndex voxel = 8 * block + VoxelIndex(i & 7, i >> 3 & 7, i >> 6);
          const double wanted = end.sample(voxel) / VolumeBlock::kUnit;
          if (std::abs(wanted) > 1.0) continue;
          const double found = visible.sample(voxel) / VolumeBlock::kUnit;
          QVERIFY2(std::abs(found - wanted) < 0.25, QByteArray::number(found - wanted));
        }
    }
  }

  // Strokes over a weak layer share all blocks of what is below that they leave alone: the blocks of the volume itself
  // and, where the layer has changed it before, those that it was made on.
  void strokesShareBlocks() {
    const SparseVolume ball = ballOfVoxels(6.0, kLayerVoxel);
    ClayLayers layers = layered(ball, withBall(ball, Vec3(0, 0, 6), 3.0));
    layers.setShare(0, 0.5, true);
    const SparseVolume weak = layers.visible();
    layers.add("second", weak);
    const SparseVolume once = carved(weak, Vec3(0, 1, 7), 1.0);
    layers.record(weak, once);
    const auto first = layers.all()[1].change;
    QVERIFY(!first->blocks().empty());
    for (const VoxelIndex& block : first->blocks()) QVERIFY(first->base().content(block) == weak.content(block));
    layers.record(once, carved(once, Vec3(0, -1, 7), 1.0));
    const auto second = layers.all()[1].change;
    QVERIFY(second->blocks().size() >= first->blocks().size());
    for (const VoxelIndex& block : second->blocks()) QVERIFY(second->base().content(block) == weak.content(block));
    layers.setShare(1, 0.0, true);
    QVERIFY(isSame(layers.visible(), weak));
  }

  // A share between two balls is a ball whose radius is at that share between the two.
  void shareOfABall() {
    constexpr double kSmall = 5.0, kLarge = 8.0;
    const SparseVolume small = ballOfVoxels(kSmall, kLayerVoxel), large = ballOfVoxels(kLarge, kLayerVoxel);
    ClayLayers layers = layered(small, large);
    for (const double share : {0.1, 0.5, 0.8}) {
      layers.setShare(0, share, true);
      const double radius = kSmall + share * (kLarge - kSmall);
      const double material = layers.visible().material();
      QVERIFY2(std::abs(material / ballVolume(radius) - 1.0) < 0.02, QByteArray::number(material / ballVolume(radius)));
    }
  }

  // A share of 0, or a layer that is off, leaves what is below, and one of 1 gives what was recorded: bit for bit.
  void ends() {
    const SparseVolume ball = ballOfVoxels(6.0, kLayerVoxel);
    const SparseVolume top = carved(withBall(ball, Vec3(0, 0, 6), 3.0), Vec3(5, 0, 0), 2.0);
    ClayLayers layers = layered(ball, top);
    QVERIFY(isSame(layers.visible(), top));
    SparseVolume shown = top;
    for (const double share : {0.5, 0.0, 0.3, 1.0}) {
      layers.setShare(0, share, true);
      layers.show(layers.all()[0].change->blocks(), shown);
      QVERIFY(isSame(shown, layers.visible()));
      if (share == 0.0) QVERIFY(isSame(shown, ball));
      if (share == 1.0) QVERIFY(isSame(shown, top));
    }
    layers.setShare(0, 0.7, false);
    QVERIFY(!layers.canBeSculpted());
    QVERIFY(isSame(layers.visible(), ball));
    layers.remove(0);
    QVERIFY(isSame(layers.visible(), ball));
  }

  // Layers that do not come near each other do not know of each other.
  void apart() {
    const SparseVolume block = boxOfVoxels(Vec3(20, 8, 8), Vec3::Zero(), kLayerVoxel);
    ClayLayers layers(block);
    layers.add("left", block);
    const SparseVolume left = carved(block, Vec3(4, 4, 8), 2.0);
    layers.record(block, left);
    layers.add("right", left);
    const SparseVolume both = carved(left, Vec3(16, 4, 8), 2.0);
    layers.record(left, both);
    QVERIFY(isSame(layers.visible(), both));
    layers.setShare(0, 1.0, false);
    QVERIFY(isSame(layers.visible(), carved(block, Vec3(16, 4, 8), 2.0)));
    layers.setShare(0, 1.0, true);
    layers.setShare(1, 0.0, true);
    QVERIFY(isSame(layers.visible(), left));
  }

  // A layer takes half a millimetre off a face that the layer below it has lifted by as much: without that one it takes
  // as much off the face where it was.
  void onOneAnother() {
    const SparseVolume low = boxOfVoxels(Vec3(12, 12, 6), Vec3::Zero(), kLayerVoxel);
    const SparseVolume lifted = boxOfVoxels(Vec3(12, 12, 6.5), Vec3::Zero(), kLayerVoxel);
    ClayLayers layers = layered(low, lifted);
    layers.add("second", lifted);
    const SparseVolume both = boxOfVoxels(Vec3(12, 12, 6), Vec3::Zero(), kLayerVoxel);
    layers.record(lifted, both);
    layers.setShare(0, 1.0, false);
    const SparseVolume visible = layers.visible();
    QVERIFY(std::abs(depthOf(visible, Vec3(6, 6, 5.5))) < 0.01 * kLayerVoxel);
    QVERIFY(isClosedManifold(surfaceOf(visible)));
  }

  // Merging keeps the visible volume in each block, for all shares, and at either end of the stack.
  void merged() {
    for (const double share : {0.0, 0.4, 1.0}) {
      for (std::size_t which = 0; which < 3; ++which) {
        SparseVolume now = ballOfVoxels(6.0, kLayerVoxel);
        ClayLayers layers(now);
        for (int i = 0; i < 3; ++i) {
          layers.add("a", now);
          const SparseVolume below = now;
          now = i == 1 ? carved(now, Vec3(0, 1, 6), 2.0) : withBall(now, Vec3(0, i, 6), 1.5);
          layers.record(below, now);
        }
        layers.setShare(1, share, true);
        const SparseVolume before = layers.visible();
        layers.mergeDown(which);
        QCOMPARE(layers.all().size(), std::size_t{2});
        QVERIFY(isSame(layers.visible(), before));
      }
    }
  }

  // A layer takes the memory of the blocks that it changes, and an empty one none; a ball in the air is smaller at a
  // share of it.
  void extremes() {
    const SparseVolume ball = ballOfVoxels(10.0, kLayerVoxel);
    ClayLayers layers(ball);
    QVERIFY(layers.all().empty());
    QVERIFY(isSame(layers.visible(), ball));
    layers.add("empty", ball);
    QVERIFY(layers.all()[0].change->blocks().empty());
    layers.setShare(0, 0.5, true);
    QVERIFY(isSame(layers.visible(), ball));
    QVERIFY(layers.bytes() < 2000);
    layers.mergeDown(0);
    QVERIFY(isSame(layers.root(), ball));

    layers.add("dab", ball);
    layers.record(ball, withBall(ball, Vec3(0, 0, 10), 1.0));
    const std::size_t changed = layers.all()[0].change->blocks().size();
    QVERIFY(changed > 0 && changed < 100);
    QVERIFY(layers.bytes() < 2000 + changed * 2 * (sizeof(VolumeBlock) + 100));

    const SparseVolume nothing(Vec3::Zero(), kLayerVoxel);
    ClayLayers inAir = layered(nothing, withBall(nothing, Vec3::Zero(), 3.0));
    inAir.setShare(0, 0.8, true);
    const double material = inAir.visible().material();
    QVERIFY(material > 0.0 && material < ballVolume(3.0));
    ClayLayers gone = layered(ball, nothing);
    QVERIFY(gone.visible().isEmpty());
    gone.setShare(0, 0.0, true);
    QVERIFY(isSame(gone.visible(), ball));
  }
};

HANDWHEEL_TEST(ClayLayersTest)
#include "ClayLayersTest.moc"
