// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../WindowTestMain.h"
#include "CapFixture.h"
#include "tools/workpiece/ManualLatheTool.h"
#include "window/tools/ToolHost.h"

using namespace handwheel;
using namespace handwheel::test;

namespace {

// The manual lathe with a new bar, seen as it begins: the axis to the right, the operator's side towards the viewer.
struct CapAtTheLathe : CapFixture {
  const ManualLatheTool* lathe() {
    return dynamic_cast<const ManualLatheTool*>(driver.window().findChild<ToolHost*>()->runner().tool());
  }
  bool beginLathe() {
    return begin([this] {
      driver.choose("newWorkpiece");
      if (!driver.settle()) return false;
      driver.find<QAction>("latheTool")->trigger();
      return driver.settle() && lathe() &&
             QTest::qWaitFor([this] { return view.camera().right().z() > 0.9; }, kPatienceMs);
    });
  }
  LatheState machine() { return lathe()->moment()->machine; }
  double slide(LatheAxis axis) { return machine().slides[static_cast<std::size_t>(axis)]; }
  // The cap is let go, and the slides have come to rest.
  bool restSlides() {
    rest();
    return QTest::qWaitFor([this] { return machine().demands == std::array<double, kLatheAxes>{}; }, kPatienceMs);
  }
  // Pushes the cap until a slide has gone some millimetres; then no other one has.
  bool pushes(const std::array<int, 3>& cap, LatheAxis axis, int sign) {
    if (!restSlides()) return false;
    const auto before = machine().slides;
    translation = cap;
    const auto index = static_cast<std::size_t>(axis);
    const bool isMoved =
        QTest::qWaitFor([&] { return sign * (machine().slides[index] - before[index]) > 3.0; }, kPatienceMs);
    if (!restSlides()) return false;
    auto others = machine().slides;
    others[index] = before[index];
    return isMoved && others == before;
  }
};

}  // namespace

// A SpaceMouse turns the handwheels of the manual lathe instead of moving the view.
class SpaceMouseSlidesTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { QSettings().clear(); }

  void oneSlideAtATime() {
    CapAtTheLathe b;
    QVERIFY(b.beginLathe());
    QTest::qWait(500);  // all camera motion has ended
    const CameraState seen = b.rest();
    QVERIFY(b.pushes({350, 0, 0}, LatheAxis::Carriage, 1));
    QVERIFY(b.pushes({-350, 0, 0}, LatheAxis::Carriage, -1));
    QVERIFY(b.pushes({0, 350, 0}, LatheAxis::Cross, 1));  // towards the user
    QVERIFY(b.pushes({0, -350, 0}, LatheAxis::Cross, -1));
    // A small motion along the other axis is ignored.
    QVERIFY(b.pushes({-350, 150, 0}, LatheAxis::Carriage, -1));
    QVERIFY(b.pushes({150, 350, 0}, LatheAxis::Cross, 1));
    QVERIFY(b.view.camera() == seen);
    // Rotation about them does not affect the slides.
    const auto slides = b.machine().slides;
    b.rotation = {0, 0, 350};
    QTest::qWait(300);
    QVERIFY(b.restSlides() && b.machine().slides == slides);
    QVERIFY(b.view.camera() == seen);
  }

  // With another tool the cap moves the view again.
  void theViewGetsItBack() {
    CapAtTheLathe b;
    QVERIFY(b.beginLathe());
    QVERIFY(b.pushes({350, 0, 0}, LatheAxis::Carriage, 1));
    b.driver.find<QAction>("turnTool")->trigger();
    QVERIFY(b.driver.settle() && !b.lathe());
    QTest::qWait(500);
    const CameraState seen = b.rest();
    b.translation = {350, 0, 0};
    QTRY_VERIFY_WITH_TIMEOUT((b.view.camera().centre - seen.centre).norm() > 0.1 * seen.height, kPatienceMs);
  }
};

HANDWHEEL_WINDOW_TEST(SpaceMouseSlidesTest)
#include "SpaceMouseSlidesTest.moc"
