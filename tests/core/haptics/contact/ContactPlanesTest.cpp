// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "haptics/contact/ContactPlanes.h"

#include <QtTest>

using namespace handwheel;

namespace {

constexpr double kSkin = 1e-6;

// The triangle (0, 0), (1, 0), (0, 1) at height 0, from above or, turned over, from its inside.
const TouchedFace kFloor{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, true};
const TouchedFace kTurned{{Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(1, 0, 0)}, false};

ContactPlanes onFloor(const Vec3& position, const TouchedFace& face = kFloor) {
  ContactPlanes planes;
  planes.beginAt(position);
  planes.add({Vec3::UnitZ(), kSkin - position.z()}, face);
  return planes;
}

}  // namespace

class ContactPlanesTest : public QObject {
  Q_OBJECT

 private slots:
  void standWhileTheProxyIsOverTheTriangle() {
    for (const TouchedFace& face : {kFloor, kTurned}) {
      ContactPlanes planes = onFloor({0.2, 0.2, kSkin}, face);
      planes.moveTo({0.6, 0.3, 0.9 * kSkin}, kSkin);
      QCOMPARE(planes.size(), std::size_t{1});
      QCOMPARE(planes.lastFace().wound, face.wound);
      QVERIFY(std::abs(planes.all()[0].least - 0.1 * kSkin) < 1e-20);  // up to the skin again
    }
  }
  void goWhereItLeavesTheTriangle() {
    for (const Vec3& position :
         {Vec3(0.6, 0.6, kSkin), Vec3(-0.1, 0.3, kSkin), Vec3(0.2, 0.2, 3 * kSkin), Vec3(0.2, 0.2, -kSkin)}) {
      ContactPlanes planes = onFloor({0.2, 0.2, kSkin});
      planes.moveTo(position, kSkin);
      QVERIFY(planes.empty());
    }
  }
  // Met obliquely, beside the triangle: the plane does not stay for the next tick, although nothing has moved.
  void goWhereItStandsBesideTheTriangle() {
    ContactPlanes planes = onFloor({0.2, -0.5 * kSkin, kSkin});
    planes.keepBelow(kSkin);
    QVERIFY(planes.empty());
  }
  // The planes are released also if it creeps out slowly.
  void goWhereItCreepsOut() {
    ContactPlanes planes = onFloor({0.2, 10.5 * kSkin, kSkin});
    int kept = 0;
    for (int i = 0; !planes.empty() && i < 100; ++i, ++kept)
      planes.moveTo({0.2, (10.0 - 0.5 * i) * kSkin, kSkin}, kSkin);
    QVERIFY2(kept >= 20 && kept <= 24, qPrintable(QString::number(kept)));
  }
  void areSeenFromTheTip() {
    ContactPlanes planes = onFloor({0.2, 0.2, kSkin});
    planes.moveTo({0.2, 0.2, 1.5 * kSkin}, kSkin);
    QVERIFY(std::abs(planes.all()[0].least + 0.5 * kSkin) < 1e-20);
  }
  void forgetTheFirstWhereThereAreTooMany() {
    ContactPlanes planes;
    planes.beginAt(Vec3::Zero());
    for (int i = 0; i < 20; ++i) planes.add({Vec3(1, i, 0).normalized(), 0.0}, {{}, i == 19});
    QVERIFY(!planes.contains({Vec3(1, 0, 0).normalized(), 0.0}) && planes.contains({Vec3(1, 19, 0).normalized(), 0.0}));
    const std::size_t count = planes.size();
    QVERIFY(planes.contains({Vec3(1, 20 - double(count), 0).normalized(), 0.0}));
    QVERIFY(!planes.contains({Vec3(1, 19 - double(count), 0).normalized(), 0.0}));
    QVERIFY(planes.lastFace().wound);
  }
};

HANDWHEEL_TEST(ContactPlanesTest)
#include "ContactPlanesTest.moc"
