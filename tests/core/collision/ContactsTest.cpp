// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "collision/ProximityQuery.h"

#include "AnyBodies.h"
#include "TestClass.h"
#include "TriangleOracle.h"
#include "proximity/TriangleIntersection.h"

#include <QtTest>
#include <map>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr std::size_t kAll = 1'000'000;

Pose placedAt(double x, double y, double z) {
  return Pose(Eigen::Translation3d(x, y, z));
}

// Returns triangles that cross each other often, each with its own corners.
TriangleSoup crowdedSoup(int triangles, double far, double size) {
  TriangleSoup soup;
  for (int i = 0; i < triangles; ++i) {
    const Vec3 centre = anyPosition(far);
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    for (int k = 0; k < 3; ++k) soup.points.push_back(centre + anyPosition(size));
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

CollisionPiece crowdedPiece(const TriangleSoup& soup, const Pose& pose = Pose::Identity()) {
  return CollisionPiece::ofMesh(pose, std::make_shared<const CollisionMesh>(soup));
}

std::vector<PieceContact> contactsOf(const CollisionPiece& a, const CollisionPiece& b, double margin,
                                     std::size_t most = kAll) {
  std::vector<PieceContact> contacts;
  QueryCounts counts;
  addContacts(a, a.pose, b, b.pose, margin, most, contacts, counts);
  return contacts;
}

using TrianglePair = std::pair<std::uint32_t, std::uint32_t>;

// Contacts by their triangles; each pair must occur once.
std::map<TrianglePair, ClosestPoints> byTriangles(const std::vector<PieceContact>& contacts) {
  std::map<TrianglePair, ClosestPoints> map;
  for (const PieceContact& each : contacts) map[{each.first, each.second}] = each.points;
  RC_ASSERT(map.size() == contacts.size());
  return map;
}

Corners shrunk(const Corners& t) {
  const Vec3 centre = (t[0] + t[1] + t[2]) / 3.0;
  Corners less = t;
  for (Vec3& corner : less) corner = centre + (1.0 - 1e-6) * (corner - centre);
  return less;
}

// Checks that the depth along the normal separates the two, and that the points lie on both.
void checkMeeting(const ClosestPoints& points, const Corners& s, const Corners& t) {
  RC_ASSERT(points.distance <= 0.0 && std::abs(points.normal.norm() - 1.0) < 1e-9);
  double lowest = 1e300, highest = -1e300;
  for (const Vec3& p : s) lowest = std::min(lowest, points.normal.dot(p));
  for (const Vec3& p : t) highest = std::max(highest, points.normal.dot(p));
  RC_ASSERT(lowest - points.distance >= highest - 1e-9);
  RC_ASSERT(pointDistance(points.first, s) < 1e-6 && pointDistance(points.second, t) < 1e-6);
}

}  // namespace

class ContactsTest : public QObject {
  Q_OBJECT

 private slots:
  // Every pair that meets by exact predicates is there, and no pair that does not.
  void meetingPairsByBruteForce() {
    int most = 0;
    QVERIFY(rc::check([&] {
      const TriangleSoup a = crowdedSoup(static_cast<int>(evenly(1.0, 40.0)), 10.0, 12.0);
      const TriangleSoup b = crowdedSoup(static_cast<int>(evenly(1.0, 40.0)), 10.0, 12.0);
      const auto found = byTriangles(contactsOf(crowdedPiece(a), crowdedPiece(b), 0.0));
      std::size_t listed = 0;
      for (std::uint32_t i = 0; i < a.triangles.size(); ++i) {
        for (std::uint32_t j = 0; j < b.triangles.size(); ++j) {
          const Corners s = cornersOf(a, i, Pose::Identity()), t = cornersOf(b, j, Pose::Identity());
          const auto contact = found.find({i, j});
          if (contact == found.end()) {
            RC_ASSERT(!trianglesMeet(shrunk(s), shrunk(t)));
            continue;
          }
          ++listed;
          RC_ASSERT(trianglesMeet(s, t) || triangleDistance(s, t) < 1e-9);
          checkMeeting(contact->second, s, t);
        }
      }
      RC_ASSERT(listed == found.size());
      most = std::max(most, static_cast<int>(listed));
    }));
    QVERIFY(most > 64);
  }

  // With a margin: every pair nearer than that, with its closest points, and what meets.
  void nearPairsByBruteForce() {
    QVERIFY(rc::check([] {
      const TriangleSoup a = crowdedSoup(*rc::gen::inRange(1, 25), 25.0, 8.0);
      const TriangleSoup b = crowdedSoup(*rc::gen::inRange(1, 25), 25.0, 8.0);
      const Pose poseA = anyPose(10.0), poseB = anyPose(10.0);
      const double margin = evenly(0.01, 15.0);
      const auto found = byTriangles(contactsOf(crowdedPiece(a, poseA), crowdedPiece(b, poseB), margin));
      for (std::uint32_t i = 0; i < a.triangles.size(); ++i) {
        for (std::uint32_t j = 0; j < b.triangles.size(); ++j) {
          const Corners s = cornersOf(a, i, poseA), t = cornersOf(b, j, poseB);
          const double exact = triangleDistance(s, t);
          const auto contact = found.find({i, j});
          if (contact == found.end()) {
            RC_ASSERT(exact >= margin - 1e-7);
            continue;
          }
          RC_ASSERT(exact < margin + 1e-7);
          const ClosestPoints& points = contact->second;
          if (exact < 1e-7) continue;  // the separation is checked above
          RC_ASSERT(std::abs(points.distance - exact) < 1e-7);
          RC_ASSERT(pointDistance(points.first, s) < 1e-7 && pointDistance(points.second, t) < 1e-7);
          RC_ASSERT((points.first - points.second - exact * points.normal).norm() < 1e-6);
        }
      }
    }));
  }

  // The depth of meshes takes all triangles apart that meet, not only the first that are found.
  void depthOfAllTriangles() {
    QVERIFY(rc::check([] {
      const TriangleSoup a = crowdedSoup(*rc::gen::inRange(1, 9), 8.0, 12.0);
      const TriangleSoup b = crowdedSoup(*rc::gen::inRange(1, 9), 8.0, 12.0);  // at most 64 pairs
      PairHint hint;
      QueryCounts counts;
      const auto found =
          closestPoints(crowdedPiece(a), Pose::Identity(), crowdedPiece(b), Pose::Identity(), 1e9, hint, counts);
      RC_ASSERT(found.has_value());
      for (std::uint32_t i = 0; i < a.triangles.size(); ++i) {
        for (std::uint32_t j = 0; j < b.triangles.size(); ++j) {
          const Corners s = cornersOf(a, i, Pose::Identity()), t = cornersOf(b, j, Pose::Identity());
          if (!trianglesMeet(shrunk(s), shrunk(t))) continue;
          double lowest = 1e300, highest = -1e300;
          for (const Vec3& p : s) lowest = std::min(lowest, found->normal.dot(p));
          for (const Vec3& p : t) highest = std::max(highest, found->normal.dot(p));
          RC_ASSERT(lowest - found->distance >= highest - 1e-9);
        }
      }
    }));
  }

  // A box of 2 mm sunk by 0.1 mm into a plate: its sides, of two triangles each, cross one triangle of the plate's top.
  // 0.5 mm above it its underside is near, too.
  void boxOnAPlate() {
    const CollisionPiece plate = crowdedPiece(boxSoup({10, 10, 1}));
    const auto sunk = contactsOf(crowdedPiece(boxSoup({1, 1, 1}), placedAt(3, 2, 1.9)), plate, 0.0);
    QCOMPARE(sunk.size(), std::size_t{8});
    for (const PieceContact& each : sunk) {
      QCOMPARE(each.second, 3u);
      QVERIFY(each.first >= 4u && each.first < 12u);
      QVERIFY(std::abs(each.points.distance + 0.1) < 1e-9 && (each.points.normal - Vec3::UnitZ()).norm() < 1e-9);
      QVERIFY(std::abs(each.points.first.z() - 0.9) < 1e-6 && std::abs(each.points.second.z() - 1.0) < 1e-6);
      QVERIFY((each.points.first - Vec3(3, 2, 0.9)).cwiseAbs().maxCoeff() < 1.0 + 1e-6);
      QVERIFY((each.points.second - Vec3(3, 2, 1.0)).cwiseAbs().maxCoeff() < 1.0 + 1e-6);
    }
    const CollisionPiece above = crowdedPiece(boxSoup({1, 1, 1}), placedAt(3, 2, 2.5));
    QVERIFY(contactsOf(above, plate, 0.0).empty() && contactsOf(above, plate, 0.49).empty());
    const auto near = contactsOf(above, plate, 0.6);
    QCOMPARE(near.size(), std::size_t{10});
    for (const PieceContact& each : near)
      QVERIFY(std::abs(each.points.distance - 0.5) < 1e-9 && (each.points.normal - Vec3::UnitZ()).norm() < 1e-9);
    QCOMPARE(contactsOf(above, plate, 0.6, 3).size(), std::size_t{3});
    QVERIFY(contactsOf(above, plate, 0.6, 0).empty());
    // A piece within it, without meeting its surface.
    QVERIFY(contactsOf(crowdedPiece(boxSoup({0.1, 0.1, 0.1}), placedAt(3, 2, 0)), plate, 0.0).empty());
  }

  void solids() {
    const CollisionPiece ball = CollisionPiece::sphere({3, 2, 2.5}, 2.0);
    const auto onPlate = contactsOf(ball, crowdedPiece(boxSoup({10, 10, 1})), 0.0);
    QCOMPARE(onPlate.size(), std::size_t{1});
    QVERIFY(onPlate.front().first == kNone && onPlate.front().second == 3u);
    QVERIFY(std::abs(onPlate.front().points.distance + 0.5) < 1e-9);
    QVERIFY((onPlate.front().points.first - Vec3(3, 2, 0.5)).norm() < 1e-6);
    QVERIFY((onPlate.front().points.second - Vec3(3, 2, 1.0)).norm() < 1e-6);
    QVERIFY(contactsOf(CollisionPiece::sphere({3, 2, 3.5}, 2.0), crowdedPiece(boxSoup({10, 10, 1})), 0.4).empty());
    const CollisionPiece other = CollisionPiece::sphere({3, 2, 7.0}, 2.0);
    QVERIFY(contactsOf(ball, other, 0.0).empty() && contactsOf(ball, other, 0.5).empty());
    const auto balls = contactsOf(ball, other, 0.6);
    QVERIFY(balls.size() == 1 && balls.front().first == kNone && balls.front().second == kNone);
    QVERIFY(std::abs(balls.front().points.distance - 0.5) < 1e-12);
    // If two boxes lie on each other, the contact is between them, not at a far corner.
    const auto stacked = contactsOf(CollisionPiece::box(placedAt(400, 0, 9.9), {10, 10, 10}),
                                    CollisionPiece::box(Pose::Identity(), {1000, 1000, 10}), 0.0);
    QVERIFY(stacked.size() == 1 && std::abs(stacked.front().points.distance + 0.1) < 1e-9);
    for (const Vec3& p : {stacked.front().points.first, stacked.front().points.second})
      QVERIFY((p - Vec3(400, 0, 5)).cwiseAbs().maxCoeff() < 5.0 + 1e-6);
  }

  // Contacts of several bodies, from frame to frame: those of their pieces.
  void ofBodies() {
    QVERIFY(rc::check([] {
      std::vector<CollisionBody> bodies;
      for (int i = 0; i < 3; ++i) {
        std::vector<CollisionPiece> pieces{anyPiece(15.0)};
        pieces.push_back(crowdedPiece(crowdedSoup(6, 15.0, 8.0), anyPose(10.0)));
        bodies.emplace_back(pieces);
      }
      const std::vector<BodyPair> pairs = {{0, 1}, {2, 0}};
      ProximityQuery query(bodies, pairs);
      std::vector<Pose> poses(3, Pose::Identity());
      std::vector<BodyContact> contacts;
      for (int frame = 0; frame < 8; ++frame) {
        for (std::uint32_t i = 0; i < 3; ++i) {
          poses[i].pretranslate(anyPosition(frame % 4 == 0 ? 20.0 : 0.5));
          query.place(i, poses[i]);
        }
        const double margin = frame % 2 == 0 ? 0.0 : evenly(0.0, 10.0);
        RC_ASSERT(query.findContacts(margin, kAll, contacts));
        std::size_t next = 0;
        for (const BodyPair& pair : pairs) {
          for (std::uint32_t i = 0; i < 2; ++i) {
            for (std::uint32_t j = 0; j < 2; ++j) {
              const CollisionPiece first = bodies[pair.first].pieces()[i].moved(poses[pair.first]);
              const CollisionPiece second = bodies[pair.second].pieces()[j].moved(poses[pair.second]);
              for (const PieceContact& each : contactsOf(first, second, margin)) {
                RC_ASSERT(next < contacts.size());
                const BodyContact& found = contacts[next++];
                RC_ASSERT(found.bodies == pair && found.firstPiece == i && found.secondPiece == j);
                RC_ASSERT(found.contact.first == each.first && found.contact.second == each.second);
                RC_ASSERT(std::abs(found.contact.points.distance - each.points.distance) < 1e-6);
              }
            }
          }
        }
        RC_ASSERT(next == contacts.size());
        if (next == 0) continue;
        std::vector<BodyContact> some;
        const auto most = static_cast<std::size_t>(*rc::gen::inRange(1, static_cast<int>(next) + 1));
        RC_ASSERT(!query.findContacts(margin, most, some) && some.size() == most);
      }
    }));
  }

  void extremes() {
    // Triangles keep their indices in the soup, even if others are left out.
    TriangleSoup soup = boxSoup({10, 10, 1});
    soup.points.emplace_back(std::nan(""), 0, 0);
    soup.triangles.insert(soup.triangles.begin(), {{0, 1, 8}, {2, 2, 3}, {8, 8, 8}});
    const auto found = contactsOf(CollisionPiece::sphere({3, 2, 2.5}, 2.0), crowdedPiece(soup), 0.0);
    QVERIFY(found.size() == 1 && found.front().second == 6u);
    const CollisionPiece none = crowdedPiece({});
    QVERIFY(contactsOf(none, none, 1e9).empty() && contactsOf(none, crowdedPiece(soup), 1e9).empty());

    const CollisionBody ball({CollisionPiece::sphere(Vec3::Zero(), 1.0)});
    ProximityQuery query({ball, ball, CollisionBody()}, {{0, 1}, {0, 2}});
    std::vector<BodyContact> contacts(5);
    QVERIFY(query.findContacts(std::nan(""), kAll, contacts) && contacts.empty());
    QVERIFY(query.findContacts(-1.0, kAll, contacts) && contacts.empty());
    QVERIFY(query.findContacts(0.0, kAll, contacts) && contacts.size() == 1);  // at the same position
    QVERIFY(contacts.front().contact.points.distance == -2.0);
    query.resetCounts();
    query.place(1, placedAt(2.0, 0, 0));  // just touching
    QVERIFY(query.findContacts(0.0, kAll, contacts) && contacts.size() == 1);
    QVERIFY(query.counts().exact == 1 && query.counts().pairs == 1);
    query.place(1, placedAt(std::nan(""), 0, 0));
    QVERIFY(query.findContacts(1e9, kAll, contacts) && contacts.empty());
  }
};

HANDWHEEL_TEST(ContactsTest)
#include "ContactsTest.moc"
