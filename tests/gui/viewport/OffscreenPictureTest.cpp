// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ShapeModels.h"
#include "SheetModel.h"
#include "TestClass.h"
#include "mesh/structure/MeshBuilder.h"
#include "viewport/OffscreenPicture.h"

#include <sys/stat.h>
#include <QTemporaryDir>
#include <QtTest>

using namespace handwheel;

class OffscreenPictureTest : public QObject {
  Q_OBJECT
 private slots:
  void pictureToFile() {
    if (qEnvironmentVariableIsEmpty("DISPLAY")) QSKIP("DISPLAY is not set: nothing can be rendered");
    const QTemporaryDir folder;
    const std::filesystem::path png = folder.filePath("sheet.png").toStdString();
    const QColor colour(0x00, 0x72, 0xb2);
    const HalfEdgeMesh mesh = buildMesh(sheet(kCells)).mesh;
    const Result<QImage> picture = renderPicture(mesh, {squareLoop(0, colour)}, {400, 300});
    QVERIFY(picture.hasValue());
    QVERIFY(savePng(*picture, png).hasValue());
    const QImage image(QString::fromStdString(png.string()));
    QCOMPARE(image.size(), QSize(400, 300));
    QVERIFY(pixelsNear(image, colour) > 300);

    const Status failed = savePng(*picture, folder.filePath("no/such/folder.png").toStdString());
    QVERIFY(!failed);
    QCOMPARE(failed.error().code, ErrorCode::WriteFailed);

    // Anything but a regular file is left alone, also behind a link.
    const std::filesystem::path pipe = folder.filePath("pipe").toStdString();
    const std::filesystem::path link = folder.filePath("link.png").toStdString();
    QCOMPARE(mkfifo(pipe.c_str(), 0600), 0);
    std::filesystem::create_symlink("pipe", link);
    const Status noFile = savePng(*picture, link);
    QVERIFY(!noFile);
    QCOMPARE(noFile.error().code, ErrorCode::WriteFailed);
    QVERIFY(std::filesystem::is_fifo(pipe) && std::filesystem::is_symlink(link));
  }

  // A sheet, blue from above zero value downwards and red upwards, from above and from below.
  void severalSidesInColours() {
    if (qEnvironmentVariableIsEmpty("DISPLAY")) QSKIP("DISPLAY is not set: nothing can be rendered");
    const HalfEdgeMesh mesh = buildMesh(sheet(kCells)).mesh;
    std::vector<double> values(mesh.vertexSlots());
    for (Vertex v = 0; v < mesh.vertexSlots(); ++v) values[v] = mesh.position(v).x() - kCells / 2;
    const auto shared = std::make_shared<const std::vector<double>>(values);
    const Vec3 sides[] = {Vec3::UnitZ(), -Vec3::UnitZ()};
    const auto pictures = renderSides(mesh, shared, {2.0}, sides, {400, 300});
    QVERIFY(pictures.hasValue());
    QCOMPARE(pictures.value().size(), std::size_t{2});
    const auto isBlue = [](const QColor& c) { return c.blue() > c.red() + 60; };
    const auto isRed = [](const QColor& c) { return c.red() > c.blue() + 60; };
    QVERIFY(isBlue(pictures.value()[0].pixelColor(150, 150)) && isRed(pictures.value()[0].pixelColor(250, 150)));
    JobState job;
    job.cancelled = true;
    QCOMPARE(renderSides(mesh, shared, {2.0}, sides, {400, 300}, Progress(job)).error().code, ErrorCode::Cancelled);
  }

  // Before and after a repair a part is seen from the same side.
  void loopsDoNotTurnThePicture() {
    if (qEnvironmentVariableIsEmpty("DISPLAY")) QSKIP("DISPLAY is not set: nothing can be rendered");
    const HalfEdgeMesh mesh = buildMesh(sheet(kCells)).mesh;
    const Result<QImage> with = renderPicture(mesh, {squareLoop(0, Qt::blue)}, {400, 300});
    const Result<QImage> without = renderPicture(mesh, {}, {400, 300});
    QVERIFY(with && without);
    for (const QPoint& corner : {QPoint(0, 0), QPoint(200, 20), QPoint(20, 150), QPoint(380, 150), QPoint(200, 280)}) {
      QCOMPARE(with->pixelColor(corner), without->pixelColor(corner));
    }
  }

  // A red box above, a green one before: from the top and from the front they hide each other, so that the colour in
  // the middle tells from where the picture was taken.
  void pictureOfParts() {
    if (qEnvironmentVariableIsEmpty("DISPLAY")) QSKIP("DISPLAY is not set: nothing can be rendered");
    const auto box = shared(boxSoup({2, 2, 2}, {-1, -1, -1}));
    DisplayModel model{{{"high", box, Pose::Identity(), {0.9f, 0.1f, 0.1f}},
                        {"front", box, Pose::Identity(), {0.1f, 0.8f, 0.1f}},
                        {"middle", box}}};
    model.parts[0].pose.translation().z() = 2.5;
    model.parts[1].pose.translation().y() = -2.5;
    const auto colourFrom = [&](const Vec3& outward, int x, int y) {
      const Result<QImage> picture = renderPicture(model, {400, 300}, outward);
      return picture ? picture->pixelColor(x, y) : QColor();
    };
    // Along z the picture spans y from -3.5 to 1: the red box covers its upper end. Likewise from the front.
    QVERIFY(colourFrom(Vec3(0, 0, 5), 200, 80).red() > 100);
    QVERIFY(colourFrom(Vec3(0, 0, 5), 200, 80).green() < 80);
    QVERIFY(colourFrom(Vec3(0, 0, 5), 200, 230).green() > 100);
    QVERIFY(colourFrom(-Vec3::UnitY(), 200, 230).green() > 100);
    QVERIFY(colourFrom(-Vec3::UnitY(), 200, 80).red() > 100);
    const QColor behind = colourFrom(Vec3::UnitY(), 200, 230);
    QVERIFY(std::abs(behind.red() - behind.green()) < 20);  // the grey one hides the green one
  }

  // The triad at the lower left and the scale bar at the lower right, without an application object that has fonts.
  void pictureHasAxesAndScale() {
    if (qEnvironmentVariableIsEmpty("DISPLAY")) QSKIP("DISPLAY is not set: nothing can be rendered");
    const Vec3 outward(1, 1, 1);  // all three axes point towards the viewer, and are drawn in full colour
    const Result<QImage> picture = renderPicture({{{"box", shared(boxSoup({1, 1, 1}))}}}, {600, 400}, outward);
    QVERIFY(picture.hasValue());
    const QImage& image = *picture;
    for (const QColor& axis : {QColor(0xe0, 0x4b, 0x43), QColor(0x4c, 0xa8, 0x4f), QColor(0x3f, 0x7f, 0xe0)}) {
      QVERIFY(pixelsNear(image.copy(0, 280, 120, 120), axis) > 30);
    }
    // The bar is a dark line between two ticks, 16 pixels above the lower edge.
    int longest = 0, run = 0;
    for (int x = 400; x < 600; ++x) {
      run = qGray(image.pixel(x, 383)) < 130 ? run + 1 : 0;
      longest = std::max(longest, run);
    }
    QVERIFY(longest > 60 && longest <= 161);
  }

  void pictureWithoutDisplayIsAnError() {
    const QByteArray display = qgetenv("DISPLAY");
    qunsetenv("DISPLAY");
    const Result<QImage> unset = renderPicture(buildMesh(sheet(2)).mesh, {}, {40, 30});
    qputenv("DISPLAY", ":9999");
    const Result<QImage> dead = renderPicture(buildMesh(sheet(2)).mesh, {}, {40, 30});
    if (!display.isEmpty()) qputenv("DISPLAY", display);
    QVERIFY(!unset && !dead);
    QCOMPARE(unset.error().code, ErrorCode::WriteFailed);
  }
};

HANDWHEEL_TEST(OffscreenPictureTest)
#include "OffscreenPictureTest.moc"
