// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PictureFixture.h"
#include "SheetModel.h"
#include "mesh/structure/MeshBuilder.h"
#include "viewport/Lighting.h"

using namespace handwheel;

// Pictures of objects on a model, or of a cut model, compared with geometry.
class ViewportLayersTest : public PictureFixture {
  Q_OBJECT

  // Returns true if so many pixels are an upright rectangle of this width and height. A pixel counts when its middle is
  // covered, so each side is exact to half a pixel. corners: pixels that may be missing there.
  static bool isRectangle(double pixels, double width, double height, double corners) {
    const double most = (width + 1) * (height + 1), least = (width - 1) * (height - 1) - corners;
    if (pixels < least || pixels > most) qWarning("%g pixels, not between %g and %g", pixels, least, most);
    return pixels >= least && pixels <= most;
  }

 private slots:
  void clipPlaneHalvesTheSilhouette_data() { addProjections(); }

  void clipPlaneHalvesTheSilhouette() {
    QFETCH(Projection, projection);
    const CameraState camera = around(Vec3(5, 5, 5), 3, projection);
    const QImage empty = emptyPicture(camera);
    DisplayPart ball{"ball", shared(sphereSoup(90))};
    ball.pose.translation() = Vec3(5, 5, 5);
    const double whole = silhouette(picture({ball}, camera), empty).area;
    const Vec3 right = camera.right();
    ClipPlane plane{right, right.dot(Vec3(5, 5, 5)), true};
    m_view->setClipPlane(plane);
    const Silhouette left = silhouette(m_view->grabImage(), empty);
    QVERIFY(isNear(left.area, whole / 2, 0.01));
    QVERIFY(std::abs(left.right - 299) <= 1);
    m_view->setClipPlane(plane.flipped());
    const Silhouette other = silhouette(m_view->grabImage(), empty);
    QVERIFY(isNear(other.area, whole / 2, 0.01));
    QVERIFY(std::abs(other.left - 300) <= 1);
    plane.offset -= 2;
    m_view->setClipPlane(plane);
    QCOMPARE(silhouette(m_view->grabImage(), empty).area, 0.0);
    plane.on = false;
    m_view->setClipPlane(plane);
    QCOMPARE(silhouette(m_view->grabImage(), empty).area, whole);
  }

  // Cut open towards the viewer, a ball shows its inner side, flat in the colour of the cut and hatched at 45 degrees.
  void theCutIsFlatAndHatched() {
    const CameraState camera = around(Vec3::Zero(), 3, Projection::Parallel);
    const QImage empty = emptyPicture(camera);
    const Silhouette whole = silhouette(picture({{"ball", shared(sphereSoup(90))}}, camera), empty);
    m_view->setClipPlane({camera.towardsViewer(), 0.0, true});
    const QImage section = m_view->grabImage();
    // Shade of the lines and their share of the area; pixels at the edges of lines are mixtures.
    constexpr double kShade = 0.62, kLines = 1.6 / 9.0;
    const QRgb cut = sceneColours(false).cut.rgb();
    double brightness = 0.0;
    const auto isSection = [&](QRgb colour) {
      const double share = static_cast<double>(qRed(colour)) / qRed(cut);
      const QRgb mixed = qRgb(qRed(colour), qRound(share * qGreen(cut)), qRound(share * qBlue(cut)));
      const bool isIt = share > kShade - 0.01 && share < 1.01 && difference(colour, mixed) <= 2;
      if (isIt) brightness += share;
      return isIt;
    };
    const double area = silhouette(section, empty, isSection).area;
    QVERIFY(isNear(area, whole.area, 0.02));
    QVERIFY(std::abs(brightness / area - (1.0 - (1.0 - kShade) * kLines)) < 0.02);  // lines to a third of a pixel
    const QPoint middle = section.rect().center();
    for (int d = -30; d <= 30; ++d) {
      const QRgb here = section.pixel(middle + QPoint(d, 0));
      QCOMPARE(section.pixel(middle + QPoint(d + 20, 20)), here);  // image rows go down: x - y is constant
      QCOMPARE(section.pixel(middle + QPoint(d + 9, 0)), here);
    }
  }

  void meshAndMarksAreClippedToo() {
    const CameraState camera = fromAbove(Projection::Perspective);
    const QImage empty = emptyPicture(camera);
    m_mesh->setMesh(buildMesh(sheet(kCells)).mesh);
    const QColor blue(0x00, 0x72, 0xb2);
    m_mesh->setLoops({squareLoop(0, blue)});
    const QImage whole = m_view->grabImage();
    m_view->setClipPlane({Vec3::UnitX(), 10, true});
    const QImage half = m_view->grabImage();
    QVERIFY(isNear(silhouette(half, empty).area, silhouette(whole, empty).area / 2, 0.01));
    QVERIFY(isNear(pixelsNear(half, blue), pixelsNear(whole, blue) / 2.0, 0.05));
    // A loop in the plane itself stays, as it is lifted together with it.
    m_view->setClipPlane({Vec3::UnitZ(), 1e-6, true});
    QVERIFY(isNear(pixelsNear(m_view->grabImage(), blue), pixelsNear(whole, blue), 0.05));
  }

  // Loops are lifted off the surface, but only by pixels: before the sheet they are visible, behind it they are not.
  void loopsShowUnderBothProjections_data() { addProjections(); }

  void loopsShowUnderBothProjections() {
    QFETCH(Projection, projection);
    CameraState camera = fromAbove(projection);
    camera.orientation = Eigen::Quaterniond(Eigen::AngleAxisd(0.8, Vec3::UnitX()));
    const QColor blue(0x00, 0x72, 0xb2);
    m_mesh->setMesh(buildMesh(sheet(kCells)).mesh);
    m_view->setCamera(camera);
    m_mesh->setLoops({squareLoop(0, blue)});
    const CameraNavigation view(camera, kSize);
    double perimeter = 0;
    const auto corners = squareLoop(0, blue).points;
    for (int i = 0; i < 4; ++i) perimeter += (view.toScreen(corners[i]) - view.toScreen(corners[(i + 1) % 4])).norm();
    const QImage image = m_view->grabImage();
    QVERIFY(isNear(pixelsNear(image, blue), 3 * perimeter, 0.25));  // three pixels wide
    m_mesh->setLoops({squareLoop(-1, blue)});
    QVERIFY(pixelsNear(m_view->grabImage(), blue) < perimeter / 20);
  }

  void selectedFacesAreTinted() {
    m_mesh->setMesh(buildMesh(sheet(kCells)).mesh);
    m_view->setCamera(fromAbove(Projection::Parallel));
    const QImage plain = m_view->grabImage();
    std::vector<Face> faces;
    for (int j = 4; j < 9; ++j) {
      for (int i = 2; i < 12; ++i) {
        faces.push_back(static_cast<Face>(2 * (j * kCells + i)));
        faces.push_back(static_cast<Face>(2 * (j * kCells + i) + 1));
      }
    }
    m_mesh->setSelectedFaces(FaceSelection(faces));
    const Silhouette selected = silhouette(m_view->grabImage(), plain);
    // The outline, 6 pixels wide with its rim, reaches 3 pixels beyond the faces, but perhaps not into the corners.
    constexpr double kWidth = 10 * 20, kHeight = 5 * 20, kOut = 3;
    QVERIFY(isRectangle(selected.area, kWidth + 2 * kOut, kHeight + 2 * kOut, 4 * kOut * kOut));
    QVERIFY(
        (selected.centroid - CameraNavigation(fromAbove(Projection::Parallel), kSize).toScreen({7, 6.5, 0})).norm() <
        0.5);
    m_mesh->setSelectedFaces({});
    m_mesh->setHighlightedFaces(FaceSelection(faces));
    QVERIFY(isRectangle(silhouette(m_view->grabImage(), plain).area, kWidth, kHeight, 0));
    m_mesh->setHighlightedFaces({});
    QCOMPARE(silhouette(m_view->grabImage(), plain).area, 0.0);
  }

  void toolsDrawOverTheModel() {
    m_mesh->setMesh(buildMesh(sheet(kCells)).mesh);
    m_view->setCamera(fromAbove(Projection::Parallel));
    QTRY_VERIFY(m_view->isPickingReady());
    const QImage plain = m_view->grabImage();
    m_view->setBrush(BrushCircle{Vec3(8, 12, 0), 3.0});
    const Silhouette circle = silhouette(m_view->grabImage(), plain);
    QVERIFY((middleOf(circle) - Vec2(260, 210)).norm() < 1.0);
    QVERIFY(std::abs(circle.right + 1 - circle.left - 2 * 3 * 20) <= 6);  // and the width of the line
    QVERIFY(circle.area < 2 * std::numbers::pi * 60 * 6);
    m_view->setBrush(std::nullopt);
    m_view->setPolylines({{{5, 5, -3}, {15, 5, -3}}});  // behind the sheet, yet over everything
    const Silhouette line = silhouette(m_view->grabImage(), plain);
    QVERIFY((middleOf(line) - Vec2(300, 350)).norm() < 1.0);
    QVERIFY(std::abs(line.right + 1 - line.left - 200) <= 6);
    m_view->setPolylines({});
    QCOMPARE(silhouette(m_view->grabImage(), plain).area, 0.0);
  }

  // A tool sets all that it shows with each move of the mouse.
  void whatStaysTheSameCostsNoFrame() {
    m_mesh->setMesh(buildMesh(sheet(kCells)).mesh);
    m_view->setCamera(fromAbove(Projection::Parallel));
    QTRY_VERIFY(m_view->isPickingReady());
    const auto proposed = std::make_shared<PartsLayer>(PartsLayer::Role::Proposed);
    m_view->addLayer(proposed);
    const auto showAll = [&](Face face) {
      proposed->setParts({});
      m_mesh->setSelectedFaces({face, 7});
      m_mesh->setHighlightedFaces({3});
      m_view->setPolylines({{{1, 1, 0}, {2, 2, 0}}});
      m_view->setBrush(BrushCircle{Vec3(5, 5, 0), 2});
      m_mesh->setHighlightedLoop(4);
    };
    showAll(1);
    settle();
    const int frames = m_view->framesDrawn();
    showAll(1);
    QTest::qWait(200);
    QCOMPARE(m_view->framesDrawn(), frames);
    showAll(2);
    QTRY_COMPARE(m_view->framesDrawn(), frames + 1);
  }
};

HANDWHEEL_DISPLAY_TEST(ViewportLayersTest)

#include "ViewportLayersTest.moc"
