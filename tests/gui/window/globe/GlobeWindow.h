// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "PointsLayer.h"
#include "WindowDriver.h"
#include "WindowTestMain.h"
#include "globe/GlobeRegistration.h"
#include "globe/tools/DentTool.h"
#include "globe/window/GlobeUi.h"
#include "viewport/camera/CameraNavigation.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/haptics/HapticSession.h"
#include "window/tools/ToolHost.h"

namespace handwheel::test {

// A window of the program with globes as an additional kind of document.
struct GlobeWindow {
  WindowDriver driver{kindsWithGlobe()};
  HapticSession& session = *driver.window().findChild<HapticSession*>();
  Viewport* view = driver.find<Viewport>("viewport");

  ~GlobeWindow() { session.close(); }

  // Shows a new globe with a radius of 10 mm from one of the standard views.
  bool begin(StandardView side = StandardView::Front) {
    driver.choose("newGlobe");
    return look(side);
  }
  bool look(StandardView side) {
    if (!driver.settle()) return false;
    view->setStandardView(side);
    const auto isThere = [this] {  // waits for the end of the camera's movement
      const ViewRay ray = view->rayAt(pixelOf(Vec3(1, 2, 3)));
      return view->isPickingReady() && (Vec3(1, 2, 3) - ray.origin).cross(ray.direction).norm() < 1e-6;
    };
    return QTest::qWaitFor(isThere, kPatienceMs) && !view->grabImage().isNull();
  }
  bool begin(const char* tool, StandardView side) {
    if (!begin(side)) return false;
    driver.find<QAction>(tool)->trigger();
    return driver.find<QAction>(tool)->isChecked();
  }

  GlobeDocument& document() {
    return static_cast<GlobeDocument&>(driver.window().findChild<DocumentTabs*>()->current()->document);
  }
  ToolHost& tools() { return *driver.window().findChild<ToolHost*>(); }
  const PointsLayer& layer() {
    const GlobeUi* found = nullptr;
    for (const KindUi* each : driver.window().findChildren<KindUi*>()) {
      if (const auto* own = dynamic_cast<const GlobeUi*>(each)) found = own;
    }
    return found->layer();
  }
  // Returns the distance of the lowest displayed point of the globe from its centre, mm.
  double lowestShown() {
    double lowest = 1e300;
    for (std::size_t i = 0; i < kGlobePoints; ++i)
      lowest = std::min(lowest, (layer().points()[i] - document().pose().translation()).norm());
    return lowest;
  }

  QPointF pixelOf(const Vec3& p) const {
    const Vec2 at = CameraNavigation(view->camera(), {view->width(), view->height()}).toScreen(p);
    return {at.x(), at.y()};
  }
  void moveTo(const QPoint& at, Qt::MouseButtons held) {
    QMouseEvent move(QEvent::MouseMove, at, view->mapToGlobal(at), Qt::NoButton, held, {});
    QApplication::sendEvent(view, &move);
  }

  // Opens the simulated hand and moves it out of reach of the globe.
  bool takeHand() {
    session.choose("simulated", "hand");
    if (!QTest::qWaitFor([this] { return session.latest() != nullptr; }, kPatienceMs)) return false;
    leadTo({0, 0, 16}, 0);
    return QTest::qWaitFor([this] { return tip().z() > 14.0; }, kPatienceMs);
  }
  void leadTo(const Vec3& position, std::uint32_t buttons) {
    const WorkspaceMapping mapping = session.mappingInScene();
    HandPose pose;
    pose.position = mapping.viewFromDevice().transpose() * (mapping.sceneFromView.inverse() * position) / mapping.scale;
    pose.buttons = buttons;
    session.simulatedHand()->setTarget(pose);
  }
  // Moves the simulated hand towards a position in the scene, starting from the present position of the tip. Must be
  // called repeatedly: after a change of the view, the tip is not at the position that the mapping alone gives.
  void bringTo(const Vec3& position) {
    const WorkspaceMapping mapping = session.mappingInScene();
    const Vec3 inView = mapping.sceneFromView.linear().transpose() * (position - tip());
    HandPose pose;
    pose.position = session.latest()->device.position + mapping.viewFromDevice().transpose() * inView / mapping.scale;
    session.simulatedHand()->setTarget(pose);
  }
  Vec3 tip() const { return session.latest()->tip.position; }
  const ForceOut& felt() const { return session.latest()->felt; }
};

}  // namespace handwheel::test
