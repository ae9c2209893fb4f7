// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/lathe/GrindingContact.h"

#include "TestClass.h"
#include "machining/lathe/LatheJson.h"

#include <QtTest>
#include <array>
#include <cmath>
#include <limits>

using namespace handwheel;

namespace {

constexpr StockCylinder kGround{40.0, 100.0, 0.0};

std::shared_ptr<const LatheTool> disk() {
  return toolNamed(shippedLatheTools(), "disk-100");
}

// A cone whose radius grows by `slope` for each mm away from the chuck.
TurnedProfile cone(double slope) {
  TurnedProfile profile(kGround, 0.05);
  for (std::size_t i = 0; i < profile.size(); ++i) profile.limitOuter(i, 5.0 + slope * profile.z(i));
  return profile;
}

}  // namespace

// Depth, normal and force of grinding tools, He 2008 (5-1) to (5-4).
class GrindingContactTest : public QObject {
  Q_OBJECT

 private slots:
  // On a cylinder the depth along the normal is that along r; the disk's rounded corners are less deep than its face,
  // which is 8 of 10 mm wide: corners of 1 mm that are 0.2 mm deep touch along √(1 - 0.8²) = 0.6 mm each.
  void onACylinder() {
    const TurnedProfile profile(kGround, 0.05);
    const GrindingContact contact = grindingContact(profile, *disk(), {19.8, 50.0});
    const double corner = 0.5 * (std::asin(0.6) + 0.6 * 0.8) - 0.6 * 0.8;  // mm², of each, deeper than 0
    const double expected = (0.2 * 8.0 + 2.0 * corner) / (8.0 + 2.0 * 0.6);
    QVERIFY2(std::abs(contact.depth - expected) < 2e-3, qPrintable(QString::number(contact.depth)));
    QVERIFY((contact.normal - ProfilePoint(1.0, 0.0)).norm() < 1e-12);
    QVERIFY(grindingContact(profile, *disk(), {20.0, 50.0}).isEmpty());
    QVERIFY(grindingContact(profile, *disk(), {19.8, 200.0}).isEmpty());
    QVERIFY(grindingContact(profile, *disk(), {std::nan(""), 50.0}).isEmpty());
  }

  // On a cone of angle a, the depth along the normal is that along r by cos a, and the normal leans back by a.
  void onACone() {
    const double slope = 0.2, length = std::hypot(1.0, slope);
    const TurnedProfile profile = cone(slope);
    // All of the face is in the material: its middle is 3 mm deep, the ends 2.2 and 3.8 mm.
    auto block = std::make_shared<LatheTool>(*disk());
    const std::array<ProfilePoint, 4> corners{{{0.0, -4.0}, {0.0, 4.0}, {90.0, 4.0}, {90.0, -4.0}}};
    block->cutting = {RoundedPolygon(corners, 0.0)};
    const GrindingContact contact = grindingContact(profile, *block, {15.0 - 3.0, 50.0});
    QVERIFY2(std::abs(contact.depth - 3.0 / length) < 0.01, qPrintable(QString::number(contact.depth)));
    QVERIFY((contact.normal - ProfilePoint(1.0, -slope) / length).norm() < 1e-9);
  }

  void inABore() {
    TurnedProfile profile(kGround, 0.05);
    for (std::size_t i = 0; i < profile.size(); ++i) profile.limitInner(i, 15.0);
    LatheTool stone = *disk();
    stone.side = TurningSide::Bore;
    const std::array<ProfilePoint, 4> corners{{{0.0, -4.0}, {0.0, 4.0}, {-8.0, 4.0}, {-8.0, -4.0}}};
    stone.cutting = {RoundedPolygon(corners, 0.0)};
    const GrindingContact contact = grindingContact(profile, stone, {15.1, 50.0});
    QVERIFY(std::abs(contact.depth - 0.1) < 1e-9 && (contact.normal - ProfilePoint(-1.0, 0.0)).norm() < 1e-12);
  }

  // F = k d − ζ V, never below zero, never more than a hand has.
  void force() {
    const GrindingHold hold{100.0, 2.0, 50.0};
    const GrindingContact contact{0.1, {1.0, 0.0}};
    QVERIFY(std::abs(grindingForce(contact, hold, {0.0, 5.0}) - 10.0) < 1e-12);  // along the surface
    QVERIFY(std::abs(grindingForce(contact, hold, {-3.0, 0.0}) - 16.0) < 1e-12);
    QVERIFY(std::abs(grindingForce(contact, hold, {3.0, 0.0}) - 4.0) < 1e-12);
    QCOMPARE(grindingForce(contact, hold, {30.0, 0.0}), 0.0);
    QCOMPARE(grindingForce({10.0, {1.0, 0.0}}, hold, {0.0, 0.0}), 50.0);
    QCOMPARE(grindingForce({}, hold, {-3.0, 0.0}), 0.0);
    QCOMPARE(grindingForce(contact, hold, {std::numeric_limits<double>::infinity(), 0.0}), 0.0);
    QVERIFY(holdOf(*disk()).stiffness > holdOf(*toolNamed(shippedLatheTools(), "paper-240")).stiffness);
  }
};

HANDWHEEL_TEST(GrindingContactTest)
#include "GrindingContactTest.moc"
