// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "collision/ProximityQuery.h"

#include "AnyBodies.h"
#include "TestClass.h"

#include <QtTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

CollisionBody anyBody() {
  std::vector<CollisionPiece> pieces;
  for (int i = *rc::gen::inRange(0, 4); i > 0; --i) {
    if (*rc::gen::inRange(0, 3) > 0) {
      pieces.push_back(anyPiece(20.0));
    } else {
      const auto mesh =
          std::make_shared<const CollisionMesh>(boxSoup({evenly(1.0, 15.0), evenly(1.0, 15.0), evenly(1.0, 15.0)}));
      pieces.push_back(CollisionPiece::ofMesh(anyPose(20.0), mesh));
    }
  }
  return CollisionBody(pieces);
}

// Returns a step of a body that moves smoothly, or leaps now and then.
Pose stepped(const Pose& pose) {
  if (*rc::gen::inRange(0, 10) == 0) return anyPose(60.0);
  const double far = *rc::gen::inRange(0, 2) == 0 ? 0.1 : 5.0;
  Pose next = pose;
  next.rotate(Eigen::AngleAxisd(evenly(0.0, 0.02 * far), (anyPosition(1.0) + Vec3(1e-3, 0, 0)).normalized()));
  next.pretranslate(anyPosition(far));
  return next;
}

}  // namespace

class ProximityQueryTest : public QObject {
  Q_OBJECT

 private slots:
  // The answers in each frame are those of a new query, and agree with the distances of the planners.
  void remembersNothingWrong() {
    QVERIFY(rc::check([] {
      const std::vector<CollisionBody> bodies = {anyBody(), anyBody(), anyBody(), anyBody()};
      const std::vector<BodyPair> pairs = {{0, 2}, {0, 3}, {1, 2}, {1, 3}, {0, 1}};
      ProximityQuery query(bodies, pairs);
      std::vector<Pose> poses = {anyPose(60.0), anyPose(60.0), anyPose(60.0), anyPose(60.0)};
      for (int frame = 0; frame < 25; ++frame) {
        std::vector<bool> isSomewhere(4, true);
        for (std::uint32_t i = 0; i < 4; ++i) {
          if (i < 3) poses[i] = stepped(poses[i]);
          isSomewhere[i] = *rc::gen::inRange(0, 30) > 0;
          Pose placed = poses[i];
          if (!isSomewhere[i]) placed.translation().y() = std::nan("");
          query.place(i, placed);
        }
        double least = std::numeric_limits<double>::infinity();
        std::vector<double> each;
        for (const BodyPair& pair : pairs) {
          const bool isKnown = isSomewhere[pair.first] && isSomewhere[pair.second];
          each.push_back(!isKnown ? 1e300
                                  : distanceBetween(bodies[pair.first], poses[pair.first], bodies[pair.second],
                                                    poses[pair.second], 1e300));
          least = std::min(least, each.back());
        }
        // Any query may come first, or none.
        const int which = *rc::gen::inRange(0, 16);
        const double than = evenly(0.1, 80.0);
        if ((which & 1) && std::abs(least - than) > 2e-3) RC_ASSERT(query.isNearer(than) == (least < than));
        if ((which & 2) && std::abs(least) > 2e-3) RC_ASSERT(query.isOverlapping() == (least <= 0.0));
        if (which & 4) {
          const auto found = query.closest();
          RC_ASSERT(found.has_value() == (least < 1e300));
          if (found && least > 2e-3) RC_ASSERT(std::abs(found->points.distance - least) < 2e-3);
          if (found && least <= 0.0) RC_ASSERT(found->points.distance <= 2e-3);
        }
        if (which & 8) {
          std::vector<NearPair> near;
          query.findNear(than, near);
          std::size_t next = 0;
          for (std::size_t i = 0; i < pairs.size(); ++i) {
            const bool isListed = next < near.size() && near[next].bodies == pairs[i];
            if (std::abs(each[i] - than) > 2e-3) RC_ASSERT(isListed == (each[i] < than));
            if (!isListed) continue;
            const ClosestPoints& points = near[next++].points;
            if (each[i] > 2e-3) RC_ASSERT(std::abs(points.distance - each[i]) < 2e-3);
            RC_ASSERT(points.first.allFinite() && points.second.allFinite());
          }
          RC_ASSERT(next == near.size());
        }
      }
    }));
  }

  // With a tolerance nothing is taken for nearer than it is, nor for further away by more than that.
  void tolerance() {
    QVERIFY(rc::check([] {
      const std::vector<CollisionBody> bodies = {anyBody(), anyBody(), anyBody()};
      const std::vector<BodyPair> pairs = {{0, 1}, {0, 2}};
      ProximityQuery query(bodies, pairs), exact(bodies, pairs);
      const double tolerance = evenly(0.0, 5.0);
      query.setTolerance(tolerance);
      std::vector<Pose> poses = {anyPose(60.0), anyPose(60.0), anyPose(60.0)};
      for (int frame = 0; frame < 15; ++frame) {
        for (std::uint32_t i = 0; i < 3; ++i) {
          if (frame > 0) poses[i] = stepped(poses[i]);
          query.place(i, poses[i]);
          exact.place(i, poses[i]);
        }
        const auto found = query.closest(), nearest = exact.closest();
        RC_ASSERT(found.has_value() == nearest.has_value());
        if (!found || nearest->points.distance <= 2e-3) continue;
        const double more = found->points.distance - nearest->points.distance;
        RC_ASSERT(more >= -2e-3 && more <= tolerance + 2e-3);
        std::vector<NearPair> near, all;
        query.findNear(1e6, near);
        exact.findNear(1e6, all);
        RC_ASSERT(near.size() == all.size());
        for (std::size_t i = 0; i < near.size(); ++i) {
          if (all[i].points.distance <= 2e-3) continue;
          const double further = near[i].points.distance - all[i].points.distance;
          RC_ASSERT(further >= -2e-3 && further <= tolerance + 2e-3);
        }
      }
    }));
  }

  // Bodies that cannot have come near are not tested again; bodies that do not move need the last triangles alone.
  void looksAtWhatMoved() {
    const auto mesh = std::make_shared<const CollisionMesh>(boxSoup({10, 10, 10}));
    const CollisionBody box({CollisionPiece::ofMesh(Pose::Identity(), mesh)});
    ProximityQuery query({box, box}, {{0, 1}});
    query.place(0, Pose(Eigen::Translation3d(40.0, 30.0, 0.0)));
    QVERIFY(!query.isNearer(20.0));  // the spheres around them are
    QVERIFY(query.counts().exact == 1 && query.counts().volumes > 0 && query.counts().pairs > 0);
    for (int i = 1; i <= 20; ++i) {
      query.resetCounts();
      query.place(0, Pose(Eigen::Translation3d(40.0 + 0.01 * i, 30.0, 0.0)));
      QVERIFY(!query.isNearer(20.0));
    }
    query.resetCounts();
    for (int i = 0; i < 20; ++i) {
      query.place(0, Pose(Eigen::Translation3d(40.0, 30.0 + 0.01 * i, 0.0)));
      QVERIFY(!query.isNearer(20.0));
    }
    QVERIFY(query.counts().exact <= 3);
    QVERIFY(query.counts().bounds <= 40);
  }

  void nothing() {
    ProximityQuery none({}, {});
    QVERIFY(!none.isOverlapping() && !none.isNearer(1e9) && !none.closest());
    ProximityQuery query({CollisionBody(), CollisionBody({CollisionPiece::sphere(Vec3::Zero(), 1.0)})}, {{0, 1}});
    std::vector<NearPair> near(3);
    query.findNear(1e9, near);
    QVERIFY(near.empty() && !query.isOverlapping() && !query.isNearer(1e9) && !query.closest());
    QVERIFY(!query.isNearer(std::nan("")) && !query.closest(std::nan("")));
  }
};

HANDWHEEL_TEST(ProximityQueryTest)
#include "ProximityQueryTest.moc"
