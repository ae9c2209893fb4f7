// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PictureFixture.h"
#include "SheetModel.h"
#include "mesh/structure/MeshBuilder.h"
#include "viewport/Lighting.h"

using namespace handwheel;

// A sheet coloured by the distance from its middle line, compared with the colours of the scale.
class ViewportColoursTest : public PictureFixture {
  Q_OBJECT

 private:
  const CameraState m_camera = fromAbove(Projection::Parallel);

  static VertexValues offsets(const HalfEdgeMesh& mesh) {
    std::vector<double> values(mesh.vertexSlots());
    for (Vertex v = 0; v < mesh.vertexSlots(); ++v) values[v] = mesh.position(v).x() - 10.0;
    return std::make_shared<const std::vector<double>>(std::move(values));
  }

  QColor at(const QImage& image, double x, double y = 10.3) const {
    const Vec2 s = CameraNavigation(m_camera, kSize).toScreen(Vec3(x, y, 0.0));
    return image.pixelColor(static_cast<int>(s.x()), static_cast<int>(s.y()));
  }

  // Hue and chroma are those of the scale; light makes it lighter or darker.
  static bool isLit(const QColor& shown, const QColor& pure) {
    const auto chroma = [](const QColor& c) {
      const double sum = c.red() + c.green() + c.blue();
      return Vec3(c.red() / sum, c.green() / sum, c.blue() / sum);
    };
    return (chroma(shown) - chroma(pure)).cwiseAbs().maxCoeff() < 0.06;
  }

  HalfEdgeMesh show() {
    const HalfEdgeMesh mesh = buildMesh(sheet(kCells)).mesh;
    m_mesh->setMesh(mesh);
    m_view->setCamera(m_camera);
    return mesh;
  }

 private slots:
  void surfaceHasTheColoursOfTheScale_data() {
    QTest::addColumn<bool>("dark");
    QTest::newRow("light") << false;
    QTest::newRow("dark") << true;
  }

  void surfaceHasTheColoursOfTheScale() {
    QFETCH(bool, dark);
    m_view->setDarkTheme(dark);
    const HalfEdgeMesh mesh = show();
    const ColourScale scale{8.0};
    m_mesh->setSurfaceValues(offsets(mesh), scale);
    const QImage image = m_view->grabImage();
    for (const double x : {1.0, 4.5, 8.3, 10.0, 12.6, 15.0, 19.0}) {
      QVERIFY2(isLit(at(image, x), scale.at(x - 10.0)), qPrintable(at(image, x).name()));
    }
  }

  // Within a triangle the value counts, not the colours of its corners: the middle of one from end to end is white.
  void valuesAreInterpolatedNotColours() {
    const HalfEdgeMesh mesh = buildMesh(sheet(1)).mesh;
    m_mesh->setMesh(mesh);
    m_view->setCamera(m_camera);
    m_mesh->setSurfaceValues(offsets(mesh), {10.0});
    const QImage image = m_view->grabImage();
    QVERIFY(isLit(at(image, 10.0, 4.0), ColourScale{10.0}.at(0.0)));
    QVERIFY(isLit(at(image, 15.0, 4.0), ColourScale{10.0}.at(5.0)));
  }

  void anotherScaleBuildsNothing() {
    const HalfEdgeMesh mesh = show();
    m_mesh->setSurfaceValues(offsets(mesh), {100.0});
    QVERIFY(isLit(at(m_view->grabImage(), 12.0), ColourScale{100.0}.at(2.0)));
    const int built = m_view->blocksBuilt();
    m_mesh->setColourScale({2.0});
    QVERIFY(isLit(at(m_view->grabImage(), 12.0), ColourScale{2.0}.at(2.0)));
    QCOMPARE(m_view->blocksBuilt(), built);
  }

  void theyGoWithoutATrace() {
    const HalfEdgeMesh mesh = show();
    const QImage plain = m_view->grabImage();
    m_mesh->setSurfaceValues(offsets(mesh), {5.0});
    QVERIFY(m_view->grabImage() != plain);
    m_mesh->setSurfaceValues(nullptr, {});
    QCOMPARE(m_view->grabImage(), plain);
    m_mesh->setSurfaceValues(offsets(mesh), {5.0});
    m_view->grabImage();
    m_mesh->updateMesh(mesh, {0});
    QCOMPARE(m_view->grabImage(), plain);
    m_mesh->setSurfaceValues(offsets(mesh), {5.0});
    m_mesh->setMesh(mesh);
    QCOMPARE(m_view->grabImage(), plain);
  }

  // Values are set and removed before the first block was built.
  void takenBackAtOnce() {
    const HalfEdgeMesh mesh = show();
    m_mesh->setSurfaceValues(offsets(mesh), {5.0});
    m_mesh->setSurfaceValues(nullptr, {});
    const QImage image = m_view->grabImage();
    QVERIFY(isLit(at(image, 2.0), at(image, 18.0)));
  }

  // The legend stands at the right edge, red above.
  void legendShowsTheScale() {
    const HalfEdgeMesh mesh = show();
    const QImage plain = m_view->grabImage();
    const ColourScale scale{0.25};
    m_mesh->setSurfaceValues(std::make_shared<const std::vector<double>>(mesh.vertexSlots(), 0.0), scale);
    const QImage image = m_view->grabImage();
    const int x = image.width() - 16 - 7, middle = image.height() / 2;
    QVERIFY(difference(image.pixel(x, middle), scale.at(0.0).rgb()) < 8);
    QVERIFY(difference(image.pixel(x, middle - 105), scale.at(0.24).rgb()) < 8);
    QVERIFY(difference(image.pixel(x, middle + 105), scale.at(-0.24).rgb()) < 8);
    QVERIFY(difference(plain.pixel(x, middle - 105), scale.at(0.24).rgb()) > 40);
  }

  // Vertices without a value are grey; nothing else is.
  void unknownValues() {
    const HalfEdgeMesh mesh = show();
    auto values = *offsets(mesh);
    for (Vertex v = 0; v < mesh.vertexSlots(); ++v) {
      if (mesh.position(v).y() > 9.5) values[v] = std::nan("");
    }
    m_mesh->setSurfaceValues(std::make_shared<const std::vector<double>>(values), {5.0});
    const QImage image = m_view->grabImage();
    QVERIFY(isLit(at(image, 18.0, 15.0), ColourScale().at(std::nan(""))));
    QVERIFY(isLit(at(image, 18.0, 5.0), ColourScale{5.0}.at(5.0)));
  }

  // Cut open, a coloured ball shows its inner side like any other.
  void theCutStaysFlat() {
    const CameraState camera = around(Vec3::Zero(), 3, Projection::Parallel);
    const HalfEdgeMesh ball = buildMesh(sphereSoup(60)).mesh;
    m_mesh->setMesh(ball);
    m_view->setCamera(camera);
    m_mesh->setSurfaceValues(std::make_shared<const std::vector<double>>(ball.vertexSlots(), 1.0), {1.0});
    m_view->setClipPlane({camera.towardsViewer(), 0.0, true});
    const QImage image = m_view->grabImage();
    const QColor middle = image.pixelColor(image.width() / 2, image.height() / 2);
    QVERIFY2(difference(middle.rgb(), sceneColours(false).cut.rgb()) <= 2, qPrintable(middle.name()));
  }
};

HANDWHEEL_DISPLAY_TEST(ViewportColoursTest)

#include "ViewportColoursTest.moc"
