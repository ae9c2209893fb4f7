// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "collision/ObstacleSet.h"

#include "AnyBodies.h"
#include "TestClass.h"

#include <QtTest>

using namespace handwheel;
using namespace handwheel::test;

class ObstacleSetTest : public QObject {
  Q_OBJECT

 private slots:
  // Compares the set with all bodies one by one.
  void asOneByOne() {
    QVERIFY(rc::check([] {
      ObstacleSet set;
      std::vector<CollisionBody> obstacles;
      std::vector<Pose> poses;
      for (int i = *rc::gen::inRange(0, 8); i > 0; --i) {
        obstacles.push_back(CollisionBody({anyPiece(20.0), anyPiece(20.0)}));
        poses.push_back(anyPose(100.0));
        set.add(obstacles.back(), poses.back(), static_cast<std::uint32_t>(poses.size()));
      }
      const CollisionBody body({anyPiece(10.0), anyPiece(10.0)});
      const Pose pose = anyPose(100.0);
      const std::uint32_t leftOut = 2;
      double least = 1e9;
      for (std::size_t i = 0; i < obstacles.size(); ++i) {
        if (i + 1 != leftOut) least = std::min(least, distanceBetween(body, pose, obstacles[i], poses[i]));
      }
      const auto found = set.distance(body, pose, 1e9, std::span(&leftOut, 1));
      if (least <= 0.0)
        RC_ASSERT(found.distance <= 0.0 && found.owner != leftOut);
      else
        RC_ASSERT(std::abs(found.distance - least) < 1e-3);
      const double enough = evenly(0.1, 100.0);
      const auto bounded = set.distance(body, pose, enough, std::span(&leftOut, 1));
      RC_ASSERT((bounded.owner == kNone) == (bounded.distance >= enough));
      if (least > 0.0 && std::abs(least - enough) > 1e-3) RC_ASSERT((least < enough) == (bounded.distance < enough));
    }));
  }
};

HANDWHEEL_TEST(ObstacleSetTest)
#include "ObstacleSetTest.moc"
