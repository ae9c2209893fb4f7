// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/CellContacts.h"

#include "../../document/cell/Cells.h"
#include "TestClass.h"
#include "scene/PrimitiveGeometry.h"

#include <QTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

Body ballAt(BodyId id, const Vec3& at, double radius) {
  Body body;
  body.id = id;
  body.name = "ball " + std::to_string(id);
  body.pose = Pose(Eigen::Translation3d(at));
  body.geometry = *PrimitiveGeometry::make(Primitive::Sphere, {radius});
  return body;
}

}  // namespace

// Contacts of an arm with its surroundings. The arm is a bar along x, from -250 to 250 mm, 100 mm wide and high.
class CellContactsTest : public QObject {
  Q_OBJECT

  CellCollision collisionWith(const std::vector<Body>& balls) {
    auto cell = std::make_shared<RobotCellSnapshot>(cellIn(importOrThrow(m_package.urdf())));
    for (const Body& ball : balls) cell->bodies = cell->bodies.with(std::make_shared<const Body>(ball));
    Result<CellScene> made = sceneOf(*cell, m_meshes);
    const auto scene = std::make_shared<const CellScene>(std::move(made).value());
    CellCollision found{scene, scene->planned(values({0.0, 0.0, 0.0})), {}};
    found.pairs = scene->scene.allTooNear(found.values, 0.0, 0.0);
    return found;
  }
  static bool isNear(const Vec3& a, const Vec3& b) { return (a - b).norm() < 1e-3; }

 private slots:
  void initTestCase() {
    std::string urdf = kArmUrdf;
    const std::string mimic = "<mimic joint='turn' multiplier='0.5'/>";
    urdf.replace(urdf.find(mimic), mimic.size(), "");
    write(m_package.urdf(), urdf);
  }

  // 10 mm deep in a face, midway between it and the lowest point of the ball.
  void aBallInAFace() {
    const CellCollision found = collisionWith({ballAt(7, {100.0, 90.0, 0.0}, 50.0)});
    QCOMPARE(found.pairs.size(), std::size_t{1});
    const auto contacts = contactsOf({&found, 1}, 100, {});
    QVERIFY(!contacts.empty());
    QVERIFY(isNear(contacts.front().position, {100.0, 45.0, 0.0}));
    QVERIFY(isNear(contacts.front().normal, -Vec3::UnitY()));
    QVERIFY(std::abs(contacts.front().depth - 10.0) < 1e-3);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      QVERIFY(contacts[i].depth <= 10.0 + 1e-3);
      QVERIFY(std::abs(contacts[i].normal.norm() - 1.0) < 1e-9);
      for (std::size_t j = 0; j < i; ++j) QVERIFY((contacts[i].position - contacts[j].position).norm() >= 5.0);
    }
  }

  // The deepest contact of each pair comes before any other one, and the limit holds.
  void eachPairFirst() {
    const CellCollision found =
        collisionWith({ballAt(7, {100.0, 90.0, 0.0}, 50.0), ballAt(8, {-100.0, -75.0, 10.0}, 30.0)});
    QCOMPARE(found.pairs.size(), std::size_t{2});
    const auto contacts = contactsOf({&found, 1}, 2, {});
    QCOMPARE(contacts.size(), std::size_t{2});
    QVERIFY(isNear(contacts[0].position, {100.0, 45.0, 0.0}));
    QVERIFY(isNear(contacts[1].position, {-100.0, -47.5, 10.0}));
    QVERIFY(isNear(contacts[1].normal, Vec3::UnitY()));
    QVERIFY(contactsOf({&found, 1}, 0, {}).empty());
    QVERIFY(contactsOf({}, 100, {}).empty());
    // A contact that is found twice, as by each of two robots, is reported once.
    const std::vector<CellCollision> twice{found, found};
    QCOMPARE(contactsOf(twice, 100, {}).size(), contactsOf({&found, 1}, 100, {}).size());
  }

  // A body in the hand is where the hand is, not where the cell has it.
  void aBodyThatIsMoved() {
    CellCollision found = collisionWith({ballAt(7, {100.0, 900.0, 0.0}, 50.0)});
    QVERIFY(found.pairs.empty());
    found.moved = collisionBodyOf(*found.scene->bodies.withId(7)->geometry, m_meshes);
    found.movedPose.translation() = Vec3(100.0, 95.0, 0.0);
    const auto contacts = contactsOf({&found, 1}, 100, {});
    QVERIFY(!contacts.empty());
    QVERIFY(isNear(contacts.front().position, {100.0, 47.5, 0.0}));
    QVERIFY(std::abs(contacts.front().depth - 5.0) < 1e-3);
    found.movedPose.translation() = Vec3(100.0, 101.0, 0.0);
    QVERIFY(contactsOf({&found, 1}, 100, {}).empty());
    found.movedPose.translation() = Vec3(std::nan(""), 0.0, 0.0);
    QVERIFY(contactsOf({&found, 1}, 100, {}).empty());
  }

  // One that a link carries meets neither that link nor where it was itself while the hand moves it.
  void aCarriedBodyThatIsMoved() {
    Body ball = ballAt(7, {100.0, 90.0, 0.0}, 50.0);
    ball.carrier = "upper";
    CellCollision found = collisionWith({ball, ballAt(8, {100.0, 900.0, 0.0}, 50.0)});
    const CellScene& scene = *found.scene;
    QVERIFY(scene.ownLinksOf(8).empty() && scene.ownLinksOf(9).empty());
    QCOMPARE(scene.ownLinksOf(7).size(), std::size_t{2});
    QVERIFY(scene.bodyOfLink(scene.ownLinksOf(7)[0]) == std::optional<BodyId>(7));
    found.moved = collisionBodyOf(*ball.geometry, m_meshes);
    found.movedPose.translation() = Vec3(100.0, 95.0, 0.0);
    QVERIFY(!contactsOf({&found, 1}, 100, {}).empty());
    found.without = scene.ownLinksOf(7);
    QVERIFY(contactsOf({&found, 1}, 100, {}).empty());
    QVERIFY(scene.scene.nearestTo(found.moved, found.movedPose, found.values, 1.0, found.without).link == kNone);
  }

  // Moved as a whole by 820 mm the robot meets what stood away from it.
  void aRobotThatIsMoved() {
    CellCollision found = collisionWith({ballAt(7, {100.0, 910.0, 0.0}, 50.0)});
    found.displacement.translation() = Vec3(0.0, 820.0, 0.0);
    found.pairs = found.scene->scene.metWhenMoved(found.values, found.displacement);
    QCOMPARE(found.pairs.size(), std::size_t{1});
    const auto contacts = contactsOf({&found, 1}, 100, {});
    QVERIFY(!contacts.empty());
    QVERIFY(isNear(contacts.front().position, {100.0, 865.0, 0.0}));
    QVERIFY(isNear(contacts.front().normal, -Vec3::UnitY()));
  }

 private:
  ArmPackage m_package;
  CollisionMeshes m_meshes;
};

HANDWHEEL_TEST(CellContactsTest)
#include "CellContactsTest.moc"
