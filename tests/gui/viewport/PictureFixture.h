// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "DisplayTestMain.h"
#include "ShapeModels.h"
#include "viewport/camera/CameraNavigation.h"

namespace handwheel {

inline const Vec2 kSize(600, 500);  // size of the view, pixels

// Returns a camera that looks at a point from the front right above. height: the height of the view, mm.
inline CameraState around(const Vec3& point, double height, Projection projection) {
  CameraState c;
  c.orientation = orientationOf(StandardView::Isometric);
  c.centre = point;
  c.height = height;
  c.projection = projection;
  return c;
}

inline CameraState fromAbove(Projection projection) {
  CameraState c;
  c.centre = Vec3(10, 10, 0);
  c.height = 25;
  c.projection = projection;
  return c;
}

inline Vec2 middleOf(const Silhouette& s) {
  return {(s.left + s.right + 1) / 2.0, (s.top + s.bottom + 1) / 2.0};
}

inline bool isNear(double a, double b, double share) {
  return std::abs(a - b) <= share * std::abs(b);
}

// A fixture that takes pictures of a viewport, with models or with the background alone.
class PictureFixture : public ViewportFixture {
 protected:
  QImage emptyPicture(const CameraState& camera) {
    clear();
    m_view->setCamera(camera);
    return m_view->grabImage();
  }

  QImage picture(const std::vector<DisplayPart>& parts, const CameraState& camera) {
    m_parts->setParts(parts);
    m_view->setCamera(camera);
    return m_view->grabImage();
  }

  static void addProjections() {
    QTest::addColumn<Projection>("projection");
    QTest::newRow("parallel") << Projection::Parallel;
    QTest::newRow("perspective") << Projection::Perspective;
  }
};

}  // namespace handwheel
