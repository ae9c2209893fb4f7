// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "DisplayTestMain.h"
#include "SheetModel.h"
#include "mesh/structure/MeshBuilder.h"
#include "viewport/camera/CameraNavigation.h"

#include <QPointingDevice>
#include <QSignalSpy>
#include <QWheelEvent>

using namespace handwheel;

namespace {

const Vec2 kViewportMouseSize(600, 500);

CameraState mouseCamera(Projection projection = Projection::Parallel) {
  CameraState c;
  c.centre = Vec3(10, 10, 0);
  c.height = 25;
  c.projection = projection;
  return c;
}

}  // namespace

// The mouse over the viewport: the receiver, and the motion of the camera.
class ViewportMouseTest : public ViewportFixture {
  Q_OBJECT

  std::vector<PointerInput> m_heard;

  void showSheet() {
    m_mesh->setMesh(buildMesh(sheet(kCells)).mesh);
    m_view->setCamera(mouseCamera());
    QTRY_VERIFY_WITH_TIMEOUT(m_view->isPickingReady(), 20000);
  }

  // Sets a sink that gets everything and accepts by the result of `take`.
  void listen(std::function<bool(const PointerInput&)> take) {
    m_heard.clear();
    m_view->setPointerSink([this, take = std::move(take)](const PointerInput& input) {
      m_heard.push_back(input);
      return take(input);
    });
  }

  std::vector<PointerInput::Kind> kinds() const {
    std::vector<PointerInput::Kind> kinds;
    for (const PointerInput& input : m_heard) kinds.push_back(input.kind);
    return kinds;
  }

  void send(QEvent::Type type, const QPoint& at, Qt::MouseButton button, Qt::MouseButtons held,
            Qt::KeyboardModifiers keys = Qt::NoModifier) {
    QMouseEvent event(type, at, m_view->mapToGlobal(at), button, held, keys);
    QApplication::sendEvent(m_view.get(), &event);
  }

  void dragWith(Qt::MouseButtons buttons, Qt::KeyboardModifiers keys, const QPoint& from, const QPoint& to) {
    Qt::MouseButtons held;
    const std::array all{Qt::MiddleButton, Qt::LeftButton, Qt::RightButton};
    for (const Qt::MouseButton b : all) {
      if (buttons & b) send(QEvent::MouseButtonPress, from, b, held |= b, keys);
    }
    send(QEvent::MouseMove, (from + to) / 2, Qt::NoButton, held, keys);
    send(QEvent::MouseMove, to, Qt::NoButton, held, keys);
    for (const Qt::MouseButton b : all) {
      if (buttons & b) send(QEvent::MouseButtonRelease, to, b, held &= ~Qt::MouseButtons(b), keys);
    }
  }

  void wheel(const QPoint& at, int eighths) {
    QWheelEvent event(at, m_view->mapToGlobal(at), {}, {0, eighths}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                      false);
    QApplication::sendEvent(m_view.get(), &event);
  }

 private slots:
  void sinkTakesADragAsAWhole() {
    showSheet();
    QSignalSpy clicked(m_view.get(), &Viewport::clicked);
    listen([](const PointerInput& input) { return input.kind == PointerInput::Kind::Press; });
    dragWith(Qt::LeftButton, Qt::ShiftModifier, {300, 250}, {360, 250});
    using enum PointerInput::Kind;
    QCOMPARE(kinds(), (std::vector{Press, Move, Move, Release}));
    QCOMPARE(m_heard[0].position, QPointF(300, 250));
    QCOMPARE(m_heard[0].button, Qt::LeftButton);
    QCOMPARE(m_heard[0].modifiers, Qt::ShiftModifier);
    QCOMPARE(m_heard[1].held, Qt::MouseButtons(Qt::LeftButton));
    QCOMPARE(m_heard[3].button, Qt::LeftButton);
    QCOMPARE(m_heard[3].held, Qt::MouseButtons());
    QCOMPARE(m_view->camera(), mouseCamera());
    QVERIFY(clicked.isEmpty());
  }

  void theCameraGetsWhatTheSinkLeaves() {
    showSheet();
    listen([](const PointerInput& input) { return input.button == Qt::LeftButton; });
    dragWith(Qt::MiddleButton, {}, {300, 250}, {360, 250});
    QCOMPARE(kinds(), std::vector{PointerInput::Kind::Press});
    QVERIFY(!(m_view->camera() == mouseCamera()));
    m_view->setPointerSink({});
    m_view->setCamera(mouseCamera());
    dragWith(Qt::MiddleButton, Qt::ShiftModifier, {300, 250}, {340, 230});
    QVERIFY((m_view->camera().centre - Vec3(8, 9, 0)).norm() < 1e-9);
  }

  // A right button that pans when it is dragged can still end a tool when it is clicked.
  void aClickIsOfferedAlthoughThePressWasNotTaken() {
    showSheet();
    QSignalSpy clicked(m_view.get(), &Viewport::clicked);
    listen([](const PointerInput& input) { return input.kind == PointerInput::Kind::Click; });
    QTest::mouseClick(m_view.get(), Qt::RightButton, {}, {300, 250});
    using enum PointerInput::Kind;
    QCOMPARE(kinds(), (std::vector{Press, Click}));
    QCOMPARE(m_heard[1].button, Qt::RightButton);
    QTest::mouseClick(m_view.get(), Qt::LeftButton, {}, {300, 250});
    QVERIFY(clicked.isEmpty());
    listen([](const PointerInput&) { return false; });
    QTest::mouseClick(m_view.get(), Qt::LeftButton, {}, {300, 250});
    QCOMPARE(clicked.size(), 1);
  }

  void sinkTakesWheelAndHover() {
    showSheet();
    QSignalSpy hovered(m_view.get(), &Viewport::hovered);
    listen([](const PointerInput&) { return true; });
    wheel({300, 250}, 120);
    QCOMPARE(m_heard.back().kind, PointerInput::Kind::Wheel);
    QCOMPARE(m_heard.back().wheel, 15.0);
    QCOMPARE(m_view->camera(), mouseCamera());
    send(QEvent::MouseMove, {200, 200}, Qt::NoButton, {});
    QCOMPARE(m_heard.back().kind, PointerInput::Kind::Move);
    QVERIFY(hovered.isEmpty());
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(m_view.get(), &leave);
    QCOMPARE(m_heard.back().kind, PointerInput::Kind::Leave);
  }

  void wheelZoomsToWhatIsUnderTheCursor_data() {
    QTest::addColumn<int>("projection");
    QTest::newRow("parallel") << 0;
    QTest::newRow("perspective") << 1;
  }

  void wheelZoomsToWhatIsUnderTheCursor() {
    QFETCH(int, projection);
    showSheet();
    CameraState camera = mouseCamera(static_cast<Projection>(projection));
    camera.orientation = Eigen::Quaterniond(Eigen::AngleAxisd(0.9, Vec3::UnitX()));
    m_view->setCamera(camera);
    const QPoint cursor(420, 180);
    const Vec3 under = m_view->pickAt(cursor).point;
    wheel(cursor, 360);
    QVERIFY(m_view->camera().height < 0.7 * camera.height);
    QVERIFY((CameraNavigation(m_view->camera(), kViewportMouseSize).toScreen(under) - Vec2(420, 180)).norm() < 1e-6);
    m_view->setNavigationPreset(NavigationPreset::SolidWorks);
    wheel(cursor, 360);
    QVERIFY(std::abs(m_view->camera().height - camera.height) < 1e-9);
  }

  void presetsReachTheCamera() {
    showSheet();
    m_view->setNavigationPreset(NavigationPreset::FreeCad);
    QCOMPARE(m_view->navigationHints()[0].first, "Left+middle");
    dragWith(Qt::MiddleButton, {}, {300, 250}, {340, 250});
    QVERIFY((m_view->camera().centre - Vec3(8, 10, 0)).norm() < 1e-9);  // pans
    m_view->setCamera(mouseCamera());
    QSignalSpy clicked(m_view.get(), &Viewport::clicked);
    dragWith(Qt::MiddleButton | Qt::LeftButton, {}, {300, 250}, {340, 250});
    QVERIFY(m_view->camera().orientation.angularDistance(mouseCamera().orientation) > 0.1);
    QVERIFY(clicked.isEmpty());
    m_view->setCamera(mouseCamera());
    dragWith(Qt::RightButton, Qt::ControlModifier | Qt::ShiftModifier, {300, 250}, {300, 150});
    QVERIFY(m_view->camera().height < 0.7 * mouseCamera().height);  // upwards enlarges
    QVERIFY((CameraNavigation(m_view->camera(), kViewportMouseSize).toScreen({10, 10, 0}) - Vec2(300, 250)).norm() <
            1e-6);
  }

  // Two drags in quick succession: the second press arrives as a double click.
  void aQuickSecondDragStillOrbits() {
    showSheet();
    send(QEvent::MouseButtonDblClick, {300, 250}, Qt::MiddleButton, Qt::MiddleButton);
    send(QEvent::MouseMove, {360, 250}, Qt::NoButton, Qt::MiddleButton);
    send(QEvent::MouseButtonRelease, {360, 250}, Qt::MiddleButton, {});
    QVERIFY(!(m_view->camera() == mouseCamera()));
  }

  void raysMeetWhatIsPicked() {
    showSheet();
    for (const Projection projection : {Projection::Parallel, Projection::Perspective}) {
      m_view->setProjection(projection);
      for (const QPointF& at : {QPointF(300, 250), QPointF(210.5, 330.25)}) {
        const ViewRay ray = m_view->rayAt(at);
        const Vec3 p = m_view->pickAt(at).point;
        QVERIFY((p - ray.origin).cross(ray.direction).norm() < 1e-9);
        QVERIFY((p - ray.origin).dot(ray.direction) > 0);
        QCOMPARE(ray.eye.has_value(), projection == Projection::Perspective);
        QCOMPARE(ray.pixel, 0.05);
      }
    }
  }

  void projectionBelongsToTheCamera() {
    showSheet();
    QSignalSpy changed(m_view.get(), &Viewport::cameraChanged);
    m_view->setProjection(Projection::Perspective);
    QCOMPARE(changed.size(), 1);
    QCOMPARE(m_view->projection(), Projection::Perspective);
    QVERIFY((m_view->camera().centre - mouseCamera().centre).norm() == 0.0);
    m_view->setCamera(mouseCamera(Projection::Parallel));
    QCOMPARE(m_view->projection(), Projection::Parallel);
  }

  void cubeTurnsTheCamera() {
    showSheet();
    auto* cube = m_view->findChild<QWidget*>("viewCube");
    QVERIFY(cube && cube->isVisible());
    QVERIFY(m_view->rect().contains(cube->geometry()));
    QVERIFY(cube->geometry().center().x() > 500 && cube->geometry().center().y() < 80);
    m_view->setStandardView(StandardView::Front);
    QTRY_COMPARE(m_view->camera().orientation.coeffs(), orientationOf(StandardView::Front).coeffs());
    QTest::qWait(300);
    const double height = m_view->camera().height;
    QTest::mouseClick(cube, Qt::LeftButton, {}, cube->rect().center() + QPoint(26, 0));
    const Vec3 right(1, -1, 0);
    QVERIFY((m_view->camera().towardsViewer() - right.normalized()).norm() < 1e-9);
    QCOMPARE(m_view->camera().height, height);  // the same magnification
    QTest::keyClick(cube, Qt::Key_Up);
    QVERIFY((m_view->camera().towardsViewer() - Vec3(1, -1, 1).normalized()).norm() < 1e-9);
    QTest::qWait(300);
    const QPoint middle = cube->rect().center();
    const CameraState before = m_view->camera();
    QTest::mousePress(cube, Qt::LeftButton, {}, middle);
    QMouseEvent move(QEvent::MouseMove, middle + QPoint(20, 0), cube->mapToGlobal(middle + QPoint(20, 0)), Qt::NoButton,
                     Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(cube, &move);
    QTest::mouseRelease(cube, Qt::LeftButton, {}, middle + QPoint(20, 0));
    QVERIFY(m_view->camera().orientation.angularDistance(before.orientation) > 0.1);
    m_view->setViewCubeVisible(false);
    QVERIFY(!cube->isVisible());
  }

  // A pen works like the mouse, and reports its pressure; the mouse does not, also after a pen.
  void pressureOfAPen() {
    showSheet();
    listen([](const PointerInput& input) { return input.kind == PointerInput::Kind::Press; });
    using Capability = QInputDevice::Capability;
    const QPointingDevice pen("pen", 7, QInputDevice::DeviceType::Stylus, QPointingDevice::PointerType::Pen,
                              Capability::Position | Capability::Pressure, 1, 3);
    const QPoint at(300, 250);
    const auto withPen = [&](QEvent::Type ofPen, QEvent::Type ofMouse, double pressure, Qt::MouseButton button,
                             Qt::MouseButtons held) {
      QTabletEvent reported(ofPen, &pen, at, m_view->mapToGlobal(at), pressure, 0, 0, 0, 0, 0, {}, button, held);
      QApplication::sendEvent(m_view.get(), &reported);
      QVERIFY(!reported.isAccepted());  // so that Qt sends this
      QMouseEvent mouse(ofMouse, at, m_view->mapToGlobal(at), button, held, {}, &pen);
      QApplication::sendEvent(m_view.get(), &mouse);
    };
    withPen(QEvent::TabletPress, QEvent::MouseButtonPress, 0.25, Qt::LeftButton, Qt::LeftButton);
    withPen(QEvent::TabletMove, QEvent::MouseMove, 0.75, Qt::NoButton, Qt::LeftButton);
    withPen(QEvent::TabletRelease, QEvent::MouseButtonRelease, 0.0, Qt::LeftButton, Qt::NoButton);
    QCOMPARE(m_heard.size(), std::size_t{3});
    QCOMPARE(m_heard[0].pressure, std::optional(0.25));
    QCOMPARE(m_heard[1].pressure, std::optional(0.75));
    send(QEvent::MouseButtonPress, at, Qt::LeftButton, Qt::LeftButton);
    QVERIFY(!m_heard.back().pressure);
    send(QEvent::MouseButtonRelease, at, Qt::LeftButton, Qt::NoButton);
  }

  // Beside the cube, the corner of the view belongs to the camera.
  void theCornerAroundTheCubeIsTheViews() {
    showSheet();
    auto* cube = m_view->findChild<QWidget*>("viewCube");
    const QPoint corner(3, 3);
    QTest::mousePress(cube, Qt::MiddleButton, {}, corner);
    QMouseEvent move(QEvent::MouseMove, corner - QPoint(60, 0), cube->mapToGlobal(corner - QPoint(60, 0)), Qt::NoButton,
                     Qt::MiddleButton, Qt::NoModifier);
    QApplication::sendEvent(cube, &move);
    QTest::mouseRelease(cube, Qt::MiddleButton, {}, corner - QPoint(60, 0));
    QVERIFY(!(m_view->camera() == mouseCamera()));
  }
};

HANDWHEEL_DISPLAY_TEST(ViewportMouseTest)

#include "ViewportMouseTest.moc"
