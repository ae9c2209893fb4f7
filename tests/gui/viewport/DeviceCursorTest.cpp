// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/DeviceCursor.h"

#include "PictureFixture.h"
#include "SheetModel.h"
#include "mesh/structure/MeshBuilder.h"

using namespace handwheel;

namespace {

DeviceCursor cursorAt(const Vec3& position) {
  DeviceCursor cursor;
  cursor.tip = cursor.proxy = position;
  return cursor;
}

double spread(const QImage& a, const QImage& b, const Vec2& at, double radius) {
  int changed = 0, all = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      if ((Vec2(x + 0.5, y + 0.5) - at).norm() > radius) continue;
      ++all;
      changed += difference(a.pixel(x, y), b.pixel(x, y)) > 8 ? 1 : 0;
    }
  return static_cast<double>(changed) / all;
}

}  // namespace

// The visible position of a device's cursor, by geometry and in pictures.
class DeviceCursorTest : public PictureFixture {
  Q_OBJECT

 private slots:
  void theArrowIsAsLongAsTheForce() {
    const CameraNavigation view(fromAbove(Projection::Parallel), kSize);
    DeviceCursor cursor = cursorAt(Vec3(10, 10, 0));
    cursor.limit = 8.0;
    QVERIFY(!lookOf(cursor, view).arrow);
    double full = 0.0;
    for (const double force : {8.0, 4.0, 2.0, 80.0}) {
      cursor.force = Vec3(0, force, 0);
      const CursorLook look = lookOf(cursor, view);
      const Vec2 shaft = *look.arrow - *look.proxy;
      QVERIFY(shaft.y() < 0.0 && std::abs(shaft.x()) < 1e-9);  // up on the screen
      if (force == 8.0) full = shaft.norm();
      QVERIFY(isNear(shaft.norm(), full * std::min(1.0, force / 8.0), 1e-9));
      QCOMPARE(look.load, std::min(1.0, force / 8.0));
    }
  }

  void numbersThatAreNone() {
    const CameraNavigation view(fromAbove(Projection::Perspective), kSize);
    DeviceCursor cursor = cursorAt(Vec3(NAN, 0, 0));
    cursor.force = Vec3(INFINITY, 0, 0);
    const CursorLook look = lookOf(cursor, view);
    QVERIFY(!look.proxy && !look.tip && !look.arrow);
    cursor = cursorAt(Vec3(10, 10, 1e9));  // behind the eye
    QVERIFY(!lookOf(cursor, view).proxy);
    cursor = cursorAt(Vec3(10, 10, 0));
    cursor.limit = 0.0;
    cursor.force = Vec3(1, 0, 0);
    QVERIFY(!lookOf(cursor, view).arrow);
  }

  void nearerIsLarger_data() { addProjections(); }
  void nearerIsLarger() {
    QFETCH(Projection, projection);
    const CameraNavigation view(fromAbove(projection), kSize);
    double before = 0.0;
    for (const double z : {-8.0, -4.0, 0.0, 4.0, 8.0}) {
      const double radius = lookOf(cursorAt(Vec3(10, 10, z)), view).radius;
      QVERIFY(radius > before);
      before = radius;
    }
  }

  // On the screen, the shadow is below the cursor by as much as the cursor is before the surface (parallel projection,
  // light at 45°).
  void theShadowTellsTheDepth() {
    const CameraState camera = fromAbove(Projection::Parallel);
    const CameraNavigation view(camera, kSize);
    const double height = 3.0;
    DeviceCursor cursor = cursorAt(Vec3(10, 10, height));
    cursor.shadow = cursor.proxy + height * std::sqrt(2.0) * shadowDirection(camera);
    QVERIFY(std::abs(cursor.shadow->z()) < 1e-9);
    const CursorLook look = lookOf(cursor, view);
    QVERIFY(std::abs((*look.shadow - *look.proxy).y() - height / view.unitsPerPixel()) < 1e-6);
  }

  // Ball, shadow and ring are at the computed positions; without a cursor the picture is unchanged.
  void seenInThePicture() {
    const CameraState camera = fromAbove(Projection::Parallel);
    const CameraNavigation view(camera, kSize);
    m_mesh->setMesh(buildMesh(sheet(kCells)).mesh);
    m_view->setCamera(camera);
    QTRY_VERIFY(m_view->isPickingReady());
    const QImage bare = m_view->grabImage();
    DeviceCursor cursor = cursorAt(Vec3(10, 12, 4));
    m_view->setDeviceCursor(cursor);
    const QImage hovering = m_view->grabImage();
    QVERIFY(spread(bare, hovering, view.toScreen(cursor.proxy), 5.0) > 0.99);
    QVERIFY(spread(bare, hovering, view.toScreen(Vec3(10, 8, 0)), 3.0) > 0.9);  // its shadow
    cursor.proxy = Vec3(10, 12, 0);
    cursor.tip = Vec3(13, 12, -2);
    cursor.force = Vec3(-5, 0, 0);
    cursor.limit = 5.0;
    m_view->setDeviceCursor(cursor);
    const QImage touching = m_view->grabImage();
    QVERIFY(spread(bare, touching, view.toScreen(cursor.proxy), 5.0) > 0.99);
    QVERIFY(spread(bare, touching, view.toScreen(cursor.tip), 9.0) > 0.1);
    QVERIFY(spread(bare, touching, *lookOf(cursor, view).arrow + Vec2(4, 0), 1.0) > 0.9);
    // Straight towards the viewer no arrow is visible, but a ring that is closed at the limit, and half of it at half.
    cursor = cursorAt(Vec3(10, 12, 0));
    cursor.limit = 5.0;
    cursor.force = Vec3(0, 0, 5);
    const CursorLook look = lookOf(cursor, view);
    const Vec2 left = *look.proxy - Vec2(look.radius + 5.0, 0), right = *look.proxy + Vec2(look.radius + 5.0, 0);
    m_view->setDeviceCursor(cursor);
    const QImage full = m_view->grabImage();
    QVERIFY(spread(bare, full, left, 1.0) > 0.9 && spread(bare, full, right, 1.0) > 0.9);
    cursor.force = Vec3(0, 0, 2.5);
    m_view->setDeviceCursor(cursor);
    const QImage half = m_view->grabImage();
    QVERIFY(spread(bare, half, left, 1.0) < 0.1 && spread(bare, half, right, 1.0) > 0.9);
    m_view->setDeviceCursor({});
    QVERIFY(m_view->grabImage() == bare);
  }

  // Sixty cursors a second must not cost sixty pictures of the model.
  void theModelIsNotDrawnForIt() {
    m_mesh->setMesh(buildMesh(sheet(kCells)).mesh);
    m_view->setCamera(fromAbove(Projection::Parallel));
    m_view->grabImage();
    settle();
    const int frames = m_view->framesDrawn();
    for (int i = 0; i < 10; ++i) {
      m_view->setDeviceCursor(cursorAt(Vec3(i, i, 1)));
      QTest::qWait(20);
    }
    QCOMPARE(m_view->framesDrawn(), frames);
    m_view->setDarkTheme(true);
    QTRY_VERIFY(m_view->framesDrawn() > frames);
    m_view->setDarkTheme(false);
  }
};

HANDWHEEL_DISPLAY_TEST(DeviceCursorTest)

#include "DeviceCursorTest.moc"
