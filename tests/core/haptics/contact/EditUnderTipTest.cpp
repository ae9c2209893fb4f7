// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The surface is edited under the pressed tip, through the whole loop: the sent force never changes faster than the
// slew limit, for any edit.
#include <QtTest>
#include <random>

#include "HapticDevices.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "haptics/scene/MeshHaptics.h"
#include "haptics/scene/SceneForces.h"
#include "haptics/servo/ServoLoop.h"

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr std::uint32_t kTop = 100'000;  // first number of the triangles laid over the cube

// A plate of 40 mm at this height in the middle of a cube of 100, turned up.
std::vector<ContactTriangle> plateAt(double z) {
  const Vec3 a(30, 30, z), b(70, 30, z), c(70, 70, z), d(30, 70, z);
  return {{{a, b, c}, kTop}, {{a, c, d}, kTop + 1}};
}

// A device of 8 N and 2 N/mm: 2 N a tick are its limit.
DeviceCapabilities device() {
  DeviceCapabilities all = forceDevice();
  all.maxStiffness = 2.0;
  return all;
}

struct Fixture {
  std::shared_ptr<ScriptedDevice::Log> log = std::make_shared<ScriptedDevice::Log>();
  VirtualClock clock;
  Service service{"servo"};
  ServoLoop loop{std::make_unique<ScriptedDevice>(log, device()), {}, clock, service};
  ContactSurface surface;
  double slew = safetySettingsFor(device(), 1000.0).slewRate * 0.001;  // N a tick
  double most = 0.0;                                                   // N, the largest change of a tick
  Vec3 last = Vec3::Zero();

  Fixture() {
    const TriangleSoup soup = cube(100.0);
    surface = ContactSurface(soup.points, soup.triangles);
  }
  void feel(bool isDiscontinuous) {
    MeshHaptics feel;
    feel.surface = TouchedSurface{surface, 0.8, 0.0, {}};
    auto scene = std::make_unique<HapticScene>();
    scene->renderer = std::make_unique<SceneForces>(forceSources(std::move(feel)));
    scene->isDiscontinuous = isDiscontinuous;
    loop.setScene(std::move(scene));
  }
  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) {
      loop.runTicks(1);
      const Vec3 sent = log->last.force;
      most = std::max(most, (sent - last).norm());
      last = sent;
    }
  }
  void moveTo(double z) {
    for (double& at = log->state.position.z(); std::abs(at - z) > 1e-9; run(1)) at += std::clamp(z - at, -0.1, 0.1);
    run(100);
  }
  void begin(double depth) {
    log->state.position = {50, 50, 105};
    feel(true);
    run(1500);
    moveTo(100.0 - depth);
    most = 0.0;
  }
  void edit(std::span<const std::uint32_t> removed, std::span<const ContactTriangle> added) {
    surface.update(removed, added);
    feel(false);
    run(50);
  }
};

}  // namespace

class EditUnderTipTest : public QObject {
  Q_OBJECT

 private slots:
  // At 5 mm, 4 N: the whole cube is removed, and comes back around the tip; the supporting plate is laid 1 mm higher
  // and taken away.
  void noForceChangesFasterThanTheLimit() {
    Fixture fixture;
    fixture.begin(5.0);
    QVERIFY((fixture.last - Vec3(0, 0, 4)).norm() < 1e-4);
    std::vector<std::uint32_t> all;
    for (std::uint32_t i = 0; i < 12; ++i) all.push_back(i);
    const TriangleSoup soup = cube(100.0);
    std::vector<ContactTriangle> cubes;
    for (const std::uint32_t i : all) {
      const Triangle& t = soup.triangles[i];
      cubes.push_back({{soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]}, i});
    }
    const std::vector<std::uint32_t> plate{kTop, kTop + 1};
    fixture.edit({}, plateAt(101.0));  // over the proxy: it is lifted
    QVERIFY((fixture.last - Vec3(0, 0, 4.8)).norm() < 1e-3);
    QVERIFY2(fixture.most <= fixture.slew + 1e-9, qPrintable(QString::number(fixture.most)));
    fixture.edit(plate, {});
    fixture.edit(all, {});
    QVERIFY(fixture.last.isZero());
    fixture.edit({}, cubes);
    QVERIFY2(fixture.most <= fixture.slew + 1e-9, qPrintable(QString::number(fixture.most)));
    QVERIFY(fixture.most > 0.9 * fixture.slew);  // the limit was reached
  }

  // A face lowered and raised by a brush, a hundred times by up to 4 mm, while the hand goes up and down.
  void aBrushUnderTheTip() {
    Fixture fixture;
    fixture.begin(5.0);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> height(100.5, 104.0), tip(96.0, 102.0);
    const std::vector<std::uint32_t> plate{kTop, kTop + 1};
    for (int i = 0; i < 100; ++i) {
      fixture.edit(plate, plateAt(height(random)));
      if (i % 10 == 9) fixture.moveTo(tip(random));
      QVERIFY(fixture.last.allFinite());
    }
    QVERIFY2(fixture.most <= fixture.slew + 1e-9, qPrintable(QString::number(fixture.most)));
  }
};

HANDWHEEL_TEST(EditUnderTipTest)
#include "EditUnderTipTest.moc"
