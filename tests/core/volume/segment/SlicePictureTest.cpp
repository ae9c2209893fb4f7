// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/segment/SlicePicture.h"

#include "../image/MadeImages.h"
#include "LPhantom.h"
#include "MadeSegments.h"
#include "TestClass.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr std::uint32_t kRed = 0x80ff0000;

// The middle of the picture's edge at a letter, in pixels, and the direction of the patient that it names.
struct Edge {
  char letter;
  double x, y;
};

Vec3 directionOf(char letter) {
  switch (letter) {
    case 'L':
      return {1, 0, 0};
    case 'R':
      return {-1, 0, 0};
    case 'P':
      return {0, 1, 0};
    case 'A':
      return {0, -1, 0};
    case 'H':
      return {0, 0, 1};
    default:
      return {0, 0, -1};
  }
}

}  // namespace

class SlicePictureTest : public QObject {
  Q_OBJECT

 private slots:
  // The direction to each edge is the one that its letter names. Axes are permuted and reversed as scanners store them.
  void orientation_data() {
    QTest::addColumn<Vec3>("x");
    QTest::addColumn<Vec3>("y");
    QTest::addColumn<Vec3>("z");
    QTest::addRow("axial") << Vec3(0.5, 0, 0) << Vec3(0, 0.6, 0) << Vec3(0, 0, 1.5);
    QTest::addRow("from the head") << Vec3(0.5, 0, 0) << Vec3(0, 0.6, 0) << Vec3(0, 0, -1.5);
    QTest::addRow("sagittal") << Vec3(0, 0.5, 0) << Vec3(0, 0, -0.5) << Vec3(1.2, 0, 0);
    QTest::addRow("coronal") << Vec3(-0.5, 0, 0) << Vec3(0, 0, -0.5) << Vec3(0, -1.2, 0);
    QTest::addRow("tilted") << Vec3(0.5, 0, 0) << Vec3(0, 0.5, 0.1) << Vec3(0, 0.3, 1.5);
  }
  void orientation() {
    QFETCH(Vec3, x);
    QFETCH(Vec3, y);
    QFETCH(Vec3, z);
    ImageGrid grid{{10, 12, 14}, Vec3::Zero(), {}};
    grid.steps << x, y, z;
    for (const SlicePlane plane : kSlicePlanes) {
      const SliceView view = sliceView(grid, plane);
      const double mx = 0.5 * (view.width - 1), my = 0.5 * (view.height - 1);
      const Vec3 middle = grid.position(view.indexAt(mx, my, 3));
      for (const Edge& edge : {Edge{view.atLeft, 0, my}, Edge{view.atRight, 2 * mx, my}, Edge{view.atTop, mx, 0},
                               Edge{view.atBottom, mx, 2 * my}}) {
        const Vec3 direction = (grid.position(view.indexAt(edge.x, edge.y, 3)) - middle).normalized();
        QVERIFY(direction.dot(directionOf(edge.letter)) > 0.9);
      }
      const auto back = view.pictureAt(view.indexAt(3.25, 4.5, 2));
      QCOMPARE(back[0], 3.25);
      QCOMPARE(back[1], 4.5);
      // Slices follow one another along the third direction.
      const Vec3 through = (grid.position(view.indexAt(0, 0, 1)) - grid.position(view.indexAt(0, 0, 0))).normalized();
      QVERIFY(std::abs(through[plane == SlicePlane::Axial ? 2 : plane == SlicePlane::Coronal ? 1 : 0]) > 0.9);
    }
  }

  // A phantom whose bars lie to the left, back and head is seen where radiologists expect it: the long bar to the right
  // of the picture, the next one downwards in axial slices, the short one upwards in the others. Turned, it is
  // mirrored.
  void phantom() {
    for (const Eigen::Matrix3d& turn : turnsOfCube()) {
      ImageGrid grid{{50, 50, 50}, Vec3::Zero(), turn};
      grid.origin = Vec3(7, 5, 3) - turn * Vec3(24.5, 24.5, 24.5);
      const ImageVolume image = imageOf<std::int16_t>(grid, lPhantom);
      for (const bool isMirrored : {false, true})
        for (const SlicePlane plane : kSlicePlanes) {
          const SliceView view = sliceView(grid, plane, isMirrored);
          const Vec3 corner = grid.steps.inverse() * (Vec3(4, 4, 4) - grid.origin);
          const int slice = static_cast<int>(std::lround(corner[view.through]));
          const SlicePicture picture =
              pictureOf(image, Segment({500.0, 1e9}), view, slice, {500.0, 1000.0}, 0xffff0000);
          const auto [x, y] = view.pictureAt(corner);
          const auto isIn = [&](double mmRight, double mmDown) {
            const auto column = std::lround(x + mmRight), row = std::lround(y + mmDown);
            return picture.pixels[static_cast<std::size_t>(row * picture.width + column)] == 0xffff0000;
          };
          const double left = isMirrored ? -1.0 : 1.0;  // the direction to the patient's left on the screen
          // From the middle of the corner, bars go 26 mm to the left, 18 to the back and 10 to the head.
          const bool isSagittal = plane == SlicePlane::Sagittal, isAxial = plane == SlicePlane::Axial;
          const double across = isSagittal ? 18.0 : 26.0, along = isAxial ? 18.0 : 10.0;
          const double toRight = isSagittal ? 1.0 : left, toDown = isAxial ? 1.0 : -1.0;
          QVERIFY(isIn(toRight * (across - 2.0), 0) && !isIn(toRight * (across + 2.0), 0) && !isIn(-6.0 * toRight, 0));
          QVERIFY(isIn(0, toDown * (along - 2.0)) && !isIn(0, toDown * (along + 2.0)) && !isIn(0, -6.0 * toDown));
        }
    }
  }

  // Grey by the window, coloured exactly where the value is in the range.
  void overlayIsMembership() {
    const ImageVolume image = noise({23, 18, 31}, 6);
    const Segment segment({30.0, 60.0});
    const GreyWindow window{50.0, 40.0};
    for (const SlicePlane plane : kSlicePlanes) {
      const SliceView view = sliceView(image.grid(), plane);
      for (int slice = 0; slice < view.slices; slice += 5) {
        const SlicePicture picture = pictureOf(image, segment, view, slice, window, kRed);
        QCOMPARE(picture.width, view.width);
        QCOMPARE(picture.height, view.height);
        for (int y = 0; y < picture.height; ++y)
          for (int x = 0; x < picture.width; ++x) {
            const Vec3 at = view.indexAt(x, y, slice);
            const double value = image.value(static_cast<std::size_t>((at.z() * 18 + at.y()) * 23 + at.x()));
            const std::uint32_t pixel = picture.pixels[static_cast<std::size_t>(y * picture.width + x)];
            const int red = pixel >> 16 & 255, green = pixel >> 8 & 255, blue = pixel & 255;
            QCOMPARE(pixel >> 24, 255u);
            QCOMPARE(green, blue);
            const double grey = std::clamp((value - 30.0) / 40.0, 0.0, 1.0) * 255.0;
            const bool isIn = value >= 30.0 && value <= 60.0;
            QCOMPARE(red > green, isIn);
            QVERIFY(std::abs(green - (isIn ? grey * 127.0 / 255.0 : grey)) <= 2.0);
            if (isIn) QVERIFY(std::abs(red - (grey * 127.0 / 255.0 + 128.0)) <= 2.0);
          }
      }
    }
  }

  // A long slice is thinned, not refused.
  void large() {
    const ImageGrid grid{{5000, 3, 2}, Vec3::Zero(), Eigen::Matrix3d::Identity()};
    const ImageVolume image = imageOf<std::int16_t>(grid, [](const Vec3& p) { return p.x(); });
    const SlicePicture picture =
        pictureOf(image, Segment({-2.0, -1.0}), sliceView(grid, SlicePlane::Axial), 1, {2500.0, 5000.0}, kRed);
    QCOMPARE(picture.step, 3);
    QCOMPARE(picture.width, 1667);
    QCOMPARE(picture.height, 1);
    QVERIFY(std::abs(static_cast<int>(picture.pixels[1000] & 255) - 3000.0 / 5000.0 * 255.0) <= 1.0);
  }
};

HANDWHEEL_TEST(SlicePictureTest)
#include "SlicePictureTest.moc"
