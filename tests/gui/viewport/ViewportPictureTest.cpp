// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "DisplayTestMain.h"
#include "ShapeModels.h"
#include "SheetModel.h"
#include "mesh/MeshBuilder.h"
#include "viewport/CameraNavigation.h"
#include "viewport/Lighting.h"

using namespace handwheel;

namespace {

const Vec2 kSize(600, 500);
constexpr double kTwelfth = std::numbers::pi / 6;

// A view of this height about the point, from the front right above.
CameraState around(const Vec3& point, double height, Projection projection) {
  CameraState c;
  c.orientation = orientationOf(StandardView::Isometric);
  c.centre = point;
  c.height = height;
  c.projection = projection;
  return c;
}

CameraState fromAbove(Projection projection) {
  CameraState c;
  c.centre = Vec3(10, 10, 0);
  c.height = 25;
  c.projection = projection;
  return c;
}

Vec2 middleOf(const Silhouette& s) {
  return {(s.left + s.right + 1) / 2.0, (s.top + s.bottom + 1) / 2.0};
}

bool isNear(double a, double b, double share) {
  return std::abs(a - b) <= share * std::abs(b);
}

}  // namespace

Q_DECLARE_METATYPE(handwheel::Projection)

// Pictures compared with what geometry says they must show.
class ViewportPictureTest : public ViewportFixture {
  Q_OBJECT

  QImage emptyPicture(const CameraState& camera) {
    m_view->clear();
    m_view->setCamera(camera);
    return m_view->grabImage();
  }

  QImage picture(const std::vector<DisplayPart>& parts, const CameraState& camera) {
    m_view->setParts({parts});
    m_view->setCamera(camera);
    return m_view->grabImage();
  }

  static void addProjections() {
    QTest::addColumn<Projection>("projection");
    QTest::newRow("parallel") << Projection::Parallel;
    QTest::newRow("perspective") << Projection::Perspective;
  }

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
    m_view->setParts({});
    m_view->setMesh(buildMesh(sphereSoup(40)).mesh);
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

  // Cut open towards the viewer, a ball shows its inner side, flat in the colour of the cut.
  void theCutIsFlat() {
    const CameraState camera = around(Vec3::Zero(), 3, Projection::Parallel);
    const QImage empty = emptyPicture(camera);
    const Silhouette whole = silhouette(picture({{"ball", shared(sphereSoup(90))}}, camera), empty);
    m_view->setClipPlane({camera.towardsViewer(), 0.0, true});
    const QRgb cut = sceneColours(false).cut.rgb();
    const auto isCut = [cut](QRgb colour) { return difference(colour, cut) <= 2; };
    QVERIFY(isNear(silhouette(m_view->grabImage(), empty, isCut).area, whole.area, 0.02));
  }

  void meshAndMarksAreClippedToo() {
    const CameraState camera = fromAbove(Projection::Perspective);
    const QImage empty = emptyPicture(camera);
    m_view->setMesh(buildMesh(sheet(kCells)).mesh);
    const QColor blue(0x00, 0x72, 0xb2);
    m_view->setLoops({squareLoop(0, blue)});
    const QImage whole = m_view->grabImage();
    m_view->setClipPlane({Vec3::UnitX(), 10, true});
    const QImage half = m_view->grabImage();
    QVERIFY(isNear(silhouette(half, empty).area, silhouette(whole, empty).area / 2, 0.01));
    QVERIFY(isNear(pixelsNear(half, blue), pixelsNear(whole, blue) / 2.0, 0.05));
    // A loop in the plane itself stays, as it is lifted together with it.
    m_view->setClipPlane({Vec3::UnitZ(), 1e-6, true});
    QVERIFY(isNear(pixelsNear(m_view->grabImage(), blue), pixelsNear(whole, blue), 0.05));
  }

  // Loops are lifted off the surface, but only by pixels: before the sheet they show, behind it they do not.
  void loopsShowUnderBothProjections_data() { addProjections(); }

  void loopsShowUnderBothProjections() {
    QFETCH(Projection, projection);
    CameraState camera = fromAbove(projection);
    camera.orientation = Eigen::Quaterniond(Eigen::AngleAxisd(0.8, Vec3::UnitX()));
    const QColor blue(0x00, 0x72, 0xb2);
    m_view->setMesh(buildMesh(sheet(kCells)).mesh);
    m_view->setCamera(camera);
    m_view->setLoops({squareLoop(0, blue)});
    const CameraNavigation view(camera, kSize);
    double perimeter = 0;
    const auto corners = squareLoop(0, blue).points;
    for (int i = 0; i < 4; ++i) perimeter += (view.toScreen(corners[i]) - view.toScreen(corners[(i + 1) % 4])).norm();
    const QImage image = m_view->grabImage();
    QVERIFY(isNear(pixelsNear(image, blue), 3 * perimeter, 0.25));  // three pixels wide
    m_view->setLoops({squareLoop(-1, blue)});
    QVERIFY(pixelsNear(m_view->grabImage(), blue) < perimeter / 20);
  }

  void selectedFacesAreTinted() {
    m_view->setMesh(buildMesh(sheet(kCells)).mesh);
    m_view->setCamera(fromAbove(Projection::Parallel));
    const QImage plain = m_view->grabImage();
    std::vector<Face> faces;
    for (int j = 4; j < 9; ++j) {
      for (int i = 2; i < 12; ++i) {
        faces.push_back(static_cast<Face>(2 * (j * kCells + i)));
        faces.push_back(static_cast<Face>(2 * (j * kCells + i) + 1));
      }
    }
    m_view->setSelectedFaces(faces);
    const Silhouette selected = silhouette(m_view->grabImage(), plain);
    QVERIFY(isNear(selected.area, 50 * 20 * 20, 0.02));
    QVERIFY(
        (selected.centroid - CameraNavigation(fromAbove(Projection::Parallel), kSize).toScreen({7, 6.5, 0})).norm() <
        0.5);
    m_view->setSelectedFaces({});
    m_view->setHighlightedFaces(faces);
    QVERIFY(isNear(silhouette(m_view->grabImage(), plain).area, 50 * 20 * 20, 0.02));
    m_view->setHighlightedFaces({});
    QCOMPARE(silhouette(m_view->grabImage(), plain).area, 0.0);
  }

  void toolsDrawOverTheModel() {
    m_view->setMesh(buildMesh(sheet(kCells)).mesh);
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
    m_view->setParts({});
    QCOMPARE(m_view->grabImage(), empty);
    QTest::qWait(300);
    const int frames = m_view->framesDrawn();
    QTest::qWait(300);
    QCOMPARE(m_view->framesDrawn(), frames);
    m_view->hide();
    m_view->setParts({{{"ball", shared(sphereSoup(20))}}});
    QTest::qWait(200);
    QCOMPARE(m_view->framesDrawn(), frames);
  }
};

int main(int argc, char** argv) {
  return runOnDisplay<ViewportPictureTest>(argc, argv);
}

#include "ViewportPictureTest.moc"
#include "moc_DisplayTestMain.cpp"
