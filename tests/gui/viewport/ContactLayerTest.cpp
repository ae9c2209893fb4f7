// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/path/ContactLayer.h"

#include "PictureFixture.h"

#include <cmath>

using namespace handwheel;

// The position of contacts in the picture, compared with geometry.
class ContactLayerTest : public PictureFixture {
  Q_OBJECT

  static bool isMarked(const QImage& image, const CameraState& camera, const Vec3& point) {
    const Vec2 at = CameraNavigation(camera, kSize).toScreen(point);
    const QColor pixel = image.pixelColor(static_cast<int>(std::floor(at.x())), static_cast<int>(std::floor(at.y())));
    const QColor mark = contactColour();
    return std::abs(pixel.red() - mark.red()) + std::abs(pixel.green() - mark.green()) +
               std::abs(pixel.blue() - mark.blue()) <
           90;
  }

 private slots:
  // A dot at each point, a line of 40 mm along its normal, and nothing beyond or behind.
  void dotsAndNormals() {
    CameraState camera = fromAbove(Projection::Parallel);
    camera.centre = Vec3::Zero();
    camera.height = 200.0;
    const QImage empty = emptyPicture(camera);
    const auto layer = std::make_shared<ContactLayer>();
    m_view->addLayer(layer);
    const Vec3 right(-30.0, 20.0, 0.0), down(50.0, 30.0, 0.0);
    layer->setContacts({{right, Vec3::UnitX()}, {down, -Vec3::UnitY()}});
    const QImage marked = m_view->grabImage();
    for (const double distance : {0.0, 15.0, 30.0}) {
      QVERIFY(isMarked(marked, camera, right + distance * Vec3::UnitX()));
      QVERIFY(isMarked(marked, camera, down - distance * Vec3::UnitY()));
    }
    for (const double distance : {-10.0, 50.0}) {
      QVERIFY(!isMarked(marked, camera, right + distance * Vec3::UnitX()));
      QVERIFY(!isMarked(marked, camera, down - distance * Vec3::UnitY()));
    }
    QVERIFY(layer->bounds().isEmpty());  // it is not fitted
    QVERIFY(layer->drawnBounds().contains(Vec3(10.0, 20.0, 0.0)) && layer->drawnBounds().contains(down));
    layer->setContacts({});
    QVERIFY(m_view->grabImage() == empty);
    m_view->removeLayer(*layer);
  }

  // A contact is inside of one of the bodies: that hides neither the point nor the normal.
  void nothingHidesThem() {
    const CameraState camera = around(Vec3::Zero(), 5.0, Projection::Perspective);
    picture({{"ball", shared(sphereSoup(90))}}, camera);
    const auto layer = std::make_shared<ContactLayer>();
    m_view->addLayer(layer);
    layer->setContacts({{Vec3::Zero(), camera.right()}});
    const QImage marked = m_view->grabImage();
    QVERIFY(isMarked(marked, camera, Vec3::Zero()));
    QVERIFY(isMarked(marked, camera, 0.5 * camera.right()));
    layer->setVisible(false);
    QVERIFY(!isMarked(m_view->grabImage(), camera, Vec3::Zero()));
    m_view->removeLayer(*layer);
  }
};

HANDWHEEL_DISPLAY_TEST(ContactLayerTest)
#include "ContactLayerTest.moc"
