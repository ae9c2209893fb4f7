// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SheetModel.h"
#include "mesh/MeshBuilder.h"
#include "viewport/Snapshot.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace handwheel;

class SnapshotTest : public QObject {
  Q_OBJECT
 private slots:
  void pictureToFile() {
    if (qEnvironmentVariableIsEmpty("DISPLAY")) QSKIP("DISPLAY is not set: nothing can be rendered");
    const QTemporaryDir folder;
    const std::filesystem::path png = folder.filePath("sheet.png").toStdString();
    const QColor colour(0x00, 0x72, 0xb2);
    const HalfEdgeMesh mesh = buildMesh(sheet(kCells)).mesh;
    QVERIFY(renderToFile(mesh, {squareLoop(0, colour)}, png, 400, 300).hasValue());
    const QImage image(QString::fromStdString(png.string()));
    QCOMPARE(image.size(), QSize(400, 300));
    QVERIFY(pixelsNear(image, colour) > 300);

    const Status failed = renderToFile(mesh, {}, folder.filePath("no/such/folder.png").toStdString(), 40, 30);
    QVERIFY(!failed);
    QCOMPARE(failed.error().code, ErrorCode::WriteFailed);
  }

  // Before and after a repair a part is seen from the same side.
  void loopsDoNotTurnThePicture() {
    if (qEnvironmentVariableIsEmpty("DISPLAY")) QSKIP("DISPLAY is not set: nothing can be rendered");
    const QTemporaryDir folder;
    const QString with = folder.filePath("with.png"), without = folder.filePath("without.png");
    const HalfEdgeMesh mesh = buildMesh(sheet(kCells)).mesh;
    QVERIFY(renderToFile(mesh, {squareLoop(0, Qt::blue)}, with.toStdString(), 400, 300).hasValue());
    QVERIFY(renderToFile(mesh, {}, without.toStdString(), 400, 300).hasValue());
    const QImage a(with), b(without);
    for (const QPoint& corner : {QPoint(0, 0), QPoint(200, 20), QPoint(20, 150), QPoint(380, 150), QPoint(200, 280)}) {
      QCOMPARE(a.pixelColor(corner), b.pixelColor(corner));
    }
  }

  void pictureWithoutDisplayIsAnError() {
    const QByteArray display = qgetenv("DISPLAY");
    const QTemporaryDir folder;
    const std::string png = folder.filePath("none.png").toStdString();
    qunsetenv("DISPLAY");
    const Status unset = renderToFile(buildMesh(sheet(2)).mesh, {}, png, 40, 30);
    qputenv("DISPLAY", ":9999");
    const Status dead = renderToFile(buildMesh(sheet(2)).mesh, {}, png, 40, 30);
    if (!display.isEmpty()) qputenv("DISPLAY", display);
    QVERIFY(!unset && !dead);
    QCOMPARE(unset.error().code, ErrorCode::WriteFailed);
    QVERIFY(!std::filesystem::exists(png));
  }
};

QTEST_GUILESS_MAIN(SnapshotTest)
#include "SnapshotTest.moc"
