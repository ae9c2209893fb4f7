// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "../WindowDriver.h"
#include "MeshShapes.h"
#include "SoupCorners.h"
#include "window/haptics/HapticSession.h"

#include <sstream>

namespace handwheel::test {

// Radius of the ball, which is at the origin; mm.
inline constexpr double kRadius = 50.0;

inline std::vector<Corners> ballOf(int levels, const Vec3& centre, double radius) {
  return cornersOf(moved(icosphere(levels), centre, radius));
}

// Writes the ball as an STL file into a folder, and returns the path.
inline QString ballIn(const QTemporaryDir& folder) {
  const QString path = folder.filePath(QStringLiteral("ball.stl"));
  writeStl(path, ballOf(3, Vec3::Zero(), kRadius));
  return path;
}

// Moves the simulated hand towards a position in the scene, starting from the present position of the tip. Must be
// called repeatedly: after a change of the view, the tip is not at the position that the mapping alone gives. The
// session must have a latest sample.
inline void bringHandTo(HapticSession& session, const Vec3& position, std::uint32_t buttons = 0) {
  const ServoSample& now = *session.latest();
  const WorkspaceMapping mapping = session.mappingInScene();
  const Vec3 inView = mapping.sceneFromView.linear().transpose() * (position - now.tip.position);
  HandPose pose;
  pose.position = now.device.position + mapping.viewFromDevice().transpose() * inView / mapping.scale;
  pose.buttons = buttons;
  session.simulatedHand()->setTarget(pose);
}

// A window with the simulated hand, in which a file is opened.
struct HandFixture {
  WindowDriver driver;
  HapticSession& session;

  HandFixture() : session(*driver.window().findChild<HapticSession*>()) {}
  ~HandFixture() {
    if (QTest::currentTestFailed() && session.latest()) report();
    session.close();
  }

  bool begin(const QString& file) {
    if (!driver.open(file)) return false;
    session.choose("simulated", "hand");
    return QTest::qWaitFor([this] { return session.latest() != nullptr; }, kPatienceMs) && driver.settle();
  }
  // Moves the simulated hand to the position that the mapping gives for a point in the scene.
  void leadTo(const Vec3& position, std::uint32_t buttons = 0) {
    const WorkspaceMapping mapping = session.mappingInScene();
    HandPose pose;
    pose.position = mapping.viewFromDevice().transpose() * (mapping.sceneFromView.inverse() * position) / mapping.scale;
    pose.buttons = buttons;
    session.simulatedHand()->setTarget(pose);
  }
  void bringTo(const Vec3& position) { bringHandTo(session, position); }
  // Waits until the tip rests at a position without contact. A moving hand could pass through an open edge, or touch
  // the inside of the surface.
  bool arrives(const Vec3& position, double within) {
    const auto isThere = [&] {
      bringTo(position);
      return (now().tip.position - position).norm() < within && now().tip.velocity.norm() < 10.0 * within &&
             !now().felt.isContact;
    };
    return QTest::qWaitFor(isThere, kPatienceMs);
  }
  const ServoSample& now() { return *session.latest(); }
  Vec3 towardsViewer() { return driver.find<Viewport>("viewport")->camera().towardsViewer(); }
  // Returns the pixel at which a position appears in the view.
  QPoint pixelOf(const Vec3& position) {
    const auto* view = driver.find<Viewport>("viewport");
    const Vec2 at = CameraNavigation(view->camera(), Vec2(view->width(), view->height())).toScreen(position);
    return {static_cast<int>(at.x()), static_cast<int>(at.y())};
  }
  bool waitForContact() {
    return QTest::qWaitFor([this] { return now().felt.isContact && now().felt.force.norm() > 0.0; }, kPatienceMs);
  }
  // Presses on the ball in this direction from its centre. The tip touches the ball first, and then the first button is
  // held.
  bool pressOnBall(const Vec3& out) {
    leadTo(0.97 * kRadius * out);
    if (!waitForContact()) return false;
    leadTo(0.97 * kRadius * out, 1);
    return QTest::qWaitFor([this] { return now().device.buttons == 1u; }, kPatienceMs);
  }
  // Prints the last haptic state of a failed test.
  void report() {
    const ServoSample& s = now();
    std::ostringstream out;
    out << "tip " << s.tip.position.transpose() << ", " << s.tip.velocity.norm() << " mm/s; proxy "
        << s.felt.proxy.transpose() << "; force " << s.felt.force.transpose() << "; contact " << s.felt.isContact
        << ", held " << s.felt.isHeld << ", scale " << session.mappingInScene().scale << ", tick " << s.tick;
    qInfo("%s", out.str().c_str());
  }
};

}  // namespace handwheel::test
