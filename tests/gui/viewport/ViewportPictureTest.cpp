// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PictureFixture.h"
#include "mesh/structure/MeshBuilder.h"

using namespace handwheel;

namespace {

constexpr double kTwelfth = std::numbers::pi / 6;

}  // namespace

// Pictures compared with geometry.
class ViewportPictureTest : public PictureFixture {
  Q_OBJECT

 private slots:
  void sphereCoversItsDisc_data() {
    QTest::addColumn<Projection>("projection");
    QTest::addColumn<double>("radius");
    QTest::addColumn<double>("offset");
    for (const auto& [p, name] :
         {std::pair(Projection::Parallel, "parallel"), std::pair(Projection::Perspective, "perspective")}) {
      for (const double radius : {1e-6, 1.0, 1e6}) QTest::addRow("%s, radius %g", name, radius) << p << radius << 0.0;
      QTest::addRow("%s, far away", name) << p << 1.0 << 1e7;
    }
  }

  // The outline of a sphere in the middle of the view is a circle. Under perspective the lines of sight that touch it
  // have the angle asin(r / distance) with the one through its middle.
  void sphereCoversItsDisc() {
    QFETCH(Projection, projection);
    QFETCH(double, radius);
    QFETCH(double, offset);
    const Vec3 centre(offset, -offset, offset);
    const CameraState camera = around(centre, 2.5 * radius, projection);
    const QImage empty = emptyPicture(camera);
    const Silhouette s = silhouette(picture({{"sphere", shared(sphereSoup(90, radius, centre))}}, camera), empty);
    const double focal = camera.eyeDistance() / camera.height * kSize.y();  // pixels
    const double pixels = projection == Projection::Parallel
                              ? radius / camera.height * kSize.y()
                              : std::tan(std::asin(radius / camera.eyeDistance())) * focal;
    QVERIFY2(isNear(s.area, std::numbers::pi * pixels * pixels, 0.01), qPrintable(QString::number(s.area)));
    QVERIFY((s.centroid - kSize / 2).norm() < 0.5);
    QVERIFY((middleOf(s) - kSize / 2).norm() < 1.5);
  }

  void sphereAsMeshLooksTheSame() {
    const CameraState camera = around(Vec3::Zero(), 3, Projection::Perspective);
    const QImage empty = emptyPicture(camera);
    const QImage asPart = picture({{"sphere", shared(sphereSoup(40))}}, camera);
    m_parts->setParts({});
    m_mesh->setMesh(buildMesh(sphereSoup(40)).mesh);
    QCOMPARE(silhouette(m_view->grabImage(), empty).area, silhouette(asPart, empty).area);
  }

  void nearerPartHidesTheOther_data() { addProjections(); }

  void nearerPartHidesTheOther() {
    QFETCH(Projection, projection);
    const CameraState camera = fromAbove(projection);
    const auto slab = shared(boxSoup({20, 20, 0.5}));
    Pose above = Pose::Identity();
    above.translation() = Vec3(10, 0, 1);
    const QImage image = picture({{"red", slab, Pose::Identity(), {0.9f, 0.1f, 0.1f}},
                                  {"green", shared(boxSoup({8, 8, 0.5})), above, {0.1f, 0.8f, 0.1f}}},
                                 camera);
    const CameraNavigation view(camera, kSize);
    const auto colourAt = [&](const Vec3& p) {
      const Vec2 s = view.toScreen(p);
      return image.pixelColor(static_cast<int>(s.x()), static_cast<int>(s.y()));
    };
    for (const Vec3& p : {Vec3(1, 1, 0.5), Vec3(9.5, 4, 0.5), Vec3(15, 9, 0.5)}) {
      QVERIFY(colourAt(p).red() > 2 * colourAt(p).green());
    }
    for (const Vec3& p : {Vec3(10.5, 0.5, 1.5), Vec3(17.5, 7.5, 1.5)}) {
      QVERIFY(colourAt(p).green() > 2 * colourAt(p).red());
    }
  }

  void posesMoveThePicture_data() { addProjections(); }

  // In the plane through the focus a shift of a mm is a shift of one over unitsPerPixel. Nothing is built for it.
  void posesMoveThePicture() {
    QFETCH(Projection, projection);
    const CameraState camera = fromAbove(projection);
    const QImage empty = emptyPicture(camera);
    const auto ball = shared(sphereSoup(60));
    DisplayPart part{"ball", ball};
    part.pose.translation() = Vec3(10, 10, 0);
    const Silhouette before = silhouette(picture({part}, camera), empty);
    const int built = m_view->blocksBuilt();
    part.pose.translation() += Vec3(3, -2, 0);
    part.pose.linear() = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    const Silhouette after = silhouette(picture({part}, camera), empty);
    const Vec2 expected = Vec2(3, 2) * kSize.y() / camera.height;
    // Under perspective a sphere beside the middle appears as an ellipse that reaches outwards a little farther.
    const double tolerance = projection == Projection::Parallel ? 0.3 : 1.0;
    QVERIFY((after.centroid - before.centroid - expected).norm() < tolerance);
    QCOMPARE(m_view->blocksBuilt(), built);
  }

  void partsRotateAboutTheirOwnFrame() {
    const CameraState camera = fromAbove(Projection::Parallel);
    const QImage empty = emptyPicture(camera);
    DisplayPart rod{"rod", shared(boxSoup({8, 1, 1}, {0, -0.5, -0.5}))};
    rod.pose.translation() = Vec3(10, 10, 0);
    rod.pose.linear() = Eigen::AngleAxisd(kTwelfth, Vec3::UnitZ()).toRotationMatrix();
    const Silhouette s = silhouette(picture({rod}, camera), empty);
    const Vec2 expected = CameraNavigation(camera, kSize).toScreen(rod.pose * Vec3(4, 0, 0));
    QVERIFY((s.centroid - expected).norm() < 0.5);
    QVERIFY(std::abs(s.area - 8 * 20 * 20) < 0.5 * (8 + 1) * 2 * 20);  // half a pixel along the outline
  }

  // Each side of a box has one colour: its corners have not been rounded. The facets of a ball shade into each other,
  // unless it is to be flat.
  void sharpEdgesStaySharp() {
    const CameraState camera = around(Vec3(1, 1, 1), 5, Projection::Parallel);
    const auto grey = [&](const QImage& image, const Vec3& p) {
      const Vec2 s = CameraNavigation(camera, kSize).toScreen(p);
      return qGray(image.pixel(static_cast<int>(s.x()), static_cast<int>(s.y())));
    };
    const QImage box = picture({{"box", shared(boxSoup({2, 2, 2}))}}, camera);
    QVERIFY(std::abs(grey(box, {0.2, 0, 0.2}) - grey(box, {1.8, 0, 1.8})) <= 1);
    QVERIFY(std::abs(grey(box, {0.2, 0.2, 2}) - grey(box, {1.8, 1.8, 2})) <= 1);
    QVERIFY(std::abs(grey(box, {1, 0, 1}) - grey(box, {1, 1, 2})) > 10);

    DisplayPart ball{"ball", shared(sphereSoup(6, 1.0, {1, 1, 1}))};
    const Vec3 a = ball.soup->points[ball.soup->triangles[20][0]];  // two points of one facet
    const auto inFacet = [&](double u, double v) {
      const Vec3 towards = camera.towardsViewer();
      for (const Triangle& t : ball.soup->triangles) {
        const Vec3 p = ball.soup->points[t[0]], q = ball.soup->points[t[1]], r = ball.soup->points[t[2]];
        if ((q - p).cross(r - p).normalized().dot(towards) < 0.97) continue;
        return Vec3(p + u * (q - p) + v * (r - p));
      }
      return a;
    };
    const QImage smooth = picture({ball}, camera);
    ball.smooth = false;
    const QImage flat = picture({ball}, camera);
    const Vec3 p = inFacet(0.15, 0.15), q = inFacet(0.7, 0.15);
    QVERIFY(std::abs(grey(smooth, p) - grey(smooth, q)) > 2);
    QVERIFY(std::abs(grey(flat, p) - grey(flat, q)) <= 1);
  }

  // Nothing to show: exactly the background. Nothing changed: no frame.
  void hiddenThingsDrawNothing() {
    const CameraState camera = around(Vec3::Zero(), 3, Projection::Perspective);
    const QImage empty = emptyPicture(camera);
    picture({{"ball", shared(sphereSoup(20))}}, camera);
    m_parts->setParts({});
    QCOMPARE(m_view->grabImage(), empty);
    settle();
    const int frames = m_view->framesDrawn();
    QTest::qWait(300);
    QCOMPARE(m_view->framesDrawn(), frames);
    m_view->hide();
    m_parts->setParts({{"ball", shared(sphereSoup(20))}});
    QTest::qWait(200);
    QCOMPARE(m_view->framesDrawn(), frames);
  }
};

HANDWHEEL_DISPLAY_TEST(ViewportPictureTest)

#include "ViewportPictureTest.moc"
