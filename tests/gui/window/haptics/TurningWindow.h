// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "../WindowDriver.h"
#include "document/workpiece/WorkpieceDocument.h"
#include "viewport/camera/CameraNavigation.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/haptics/HapticSession.h"

#include <QElapsedTimer>
#include <cmath>

namespace handwheel::test {

// A window with a new workpiece, seen from the front, and the active turning tool. The workpiece measures 50 × 100 mm.
struct TurningWindow {
  WindowDriver driver;
  HapticSession& session;
  Viewport* view;

  explicit TurningWindow(const QSize& size = kUsualWindow)
      : driver(size), session(*driver.window().findChild<HapticSession*>()), view(driver.find<Viewport>("viewport")) {}
  ~TurningWindow() { session.close(); }

  bool begin() {
    driver.choose("newWorkpiece");
    if (!driver.settle()) return false;
    view->setStandardView(StandardView::Top);  // in this view, the plane y = 0 faces the viewer
    if (!driver.settle() || !QTest::qWaitFor([this] { return view->isPickingReady(); }, kPatienceMs)) return false;
    driver.find<QAction>("turnTool")->trigger();
    if (!driver.settle()) return false;
    return rests() && driver.find<QAction>("turnTool")->isChecked();
  }
  // Waits until the view is stable: the settings of the tool take space from it, and the camera moves.
  bool rests() {
    constexpr int kRestMs = 150, kLooks = 6;  // both are required, as one look may exceed kRestMs
    QSize size;
    CameraState goal;
    QElapsedTimer since;
    int looks = 0;
    const auto isStable = [&] {
      if (size != view->size() || goal != view->camera() || !hasArrived()) {
        size = view->size();
        goal = view->camera();
        since.start();
        looks = 0;
      }
      return ++looks > kLooks && since.elapsed() > kRestMs;
    };
    return QTest::qWaitFor(isStable, kPatienceMs);
  }
  // Returns false while the camera flies to its goal.
  bool hasArrived() const {
    const CameraNavigation goal(view->camera(), Vec2(view->width(), view->height()));
    const ViewRay now = view->rayAt({0, 0}), then = goal.rayAt({0, 0}, view->bounds());
    return now.origin == then.origin && now.direction == then.direction;
  }
  WorkpieceDocument& document() {
    return static_cast<WorkpieceDocument&>(driver.window().findChild<DocumentTabs*>()->current()->document);
  }
  const WorkpieceSnapshot& workpiece() { return document().workpiece(); }
  bool openHand() {
    session.choose("simulated", "hand");
    return QTest::qWaitFor([this] { return session.latest() != nullptr; }, kPatienceMs);
  }
  bool takeHand() { return openHand() && driver.settle() && leadOut(); }
  // Waits until the view is stable, and the servo loop and the session use the mapping of this view.
  bool restsWithHand() {
    constexpr std::uint64_t kTicks = 50;
    if (!rests()) return false;
    const std::uint64_t before = session.latest()->tick;
    return QTest::qWaitFor([this, before] { return session.latest()->tick > before + kTicks; }, kPatienceMs);
  }
  // Moves the hand beside the bar, with the button released.
  bool leadOut() {
    leadTo({32.0, 0.0, 50.0}, 0);
    const auto isOut = [this] { return std::abs(session.latest()->tip.position.x() - 32.0) < 1.0; };
    return QTest::qWaitFor(isOut, kPatienceMs);
  }
  double radiusAt(double z) {
    const TurnedProfile& profile = workpiece().part->profile;
    return profile.radius(static_cast<std::size_t>(std::lround(z / profile.spacing())));
  }
  // Returns the pixel of this point of the plane y = 0.
  QPoint pixelOf(double x, double z) const {
    QPoint best;
    double nearest = 1e300;
    for (int v = 0; v < view->height(); ++v) {
      for (int u = 0; u < view->width(); u += 1) {
        const ViewRay ray = view->rayAt(QPointF(u, v));
        const Vec3 p = ray.origin - ray.origin.y() / ray.direction.y() * ray.direction;
        const double distance = std::hypot(p.x() - x, p.z() - z);
        if (distance < nearest) nearest = distance, best = {u, v};
      }
    }
    return best;
  }
  Vec3 positionOf(const QPoint& pixel) const {
    const ViewRay ray = view->rayAt(pixel);
    return ray.origin - ray.origin.y() / ray.direction.y() * ray.direction;
  }
  void moveTo(const QPoint& at) {
    QMouseEvent move(QEvent::MouseMove, at, view->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(view, &move);
  }
  void drag(const QPoint& from, const QPoint& to) {
    QTest::mousePress(view, Qt::LeftButton, {}, pixelOf(28.0, 30.0));  // beside the bar
    for (int i = 0; i <= 10; ++i) {
      moveTo(from + (to - from) * i / 10);
      QTest::qWait(5);
    }
    QTest::mouseRelease(view, Qt::LeftButton, {}, to);
  }
  // Presses the first button where the hand is led to, until the window has seen it.
  bool pressAt(const Vec3& position) {
    leadTo(position, 1);
    return QTest::qWaitFor([this] { return session.latest()->device.buttons == 1u; }, kPatienceMs);
  }
  void leadTo(const Vec3& position, std::uint32_t buttons) {
    const WorkspaceMapping mapping = session.mappingInScene();
    HandPose pose;
    pose.position = mapping.viewFromDevice().transpose() * (mapping.sceneFromView.inverse() * position) / mapping.scale;
    pose.buttons = buttons;
    session.simulatedHand()->setTarget(pose);
  }
};

}  // namespace handwheel::test
