// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/BrushStampReader.h"

#include "TestClass.h"
#include "document/DocumentErrors.h"
#include "document/volume/VolumeKind.h"
#include "document/volume/VolumeSnapshot.h"
#include "volume/VolumeErrors.h"
#include "volume/VolumeShapes.h"

#include <zlib.h>
#include <QImage>
#include <QTemporaryDir>
#include <QtEndian>
#include <QtTest>
#include <cmath>
#include <fstream>

using namespace handwheel;

namespace {

namespace fs = std::filesystem;

DocumentKinds volumeKinds() {
  std::vector<std::unique_ptr<DocumentKind>> kinds;
  kinds.push_back(std::make_unique<VolumeKind>());
  return DocumentKinds(std::move(kinds));
}

void writeBytes(const fs::path& path, const QByteArray& bytes) {
  std::ofstream(path, std::ios::binary).write(bytes.constData(), bytes.size());
}

// A PNG that says to be of this size, and ends where its pixels would begin.
QByteArray pngOfSize(quint32 width, quint32 height) {
  QByteArray header("IHDR");
  for (const quint32 side : {width, height}) {
    const quint32 big = qToBigEndian(side);
    header.append(reinterpret_cast<const char*>(&big), 4);
  }
  header.append(QByteArray::fromHex("0800000000"));  // grey, 8 bits
  const auto sum = qToBigEndian(static_cast<quint32>(
      crc32(0, reinterpret_cast<const unsigned char*>(header.constData()), static_cast<uInt>(header.size()))));
  return QByteArray::fromHex("89504e470d0a1a0a0000000d") + header + QByteArray(reinterpret_cast<const char*>(&sum), 4) +
         QByteArray::fromHex("0000ffff49444154");
}

}  // namespace

class BrushStampReaderTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { m_folder = std::make_unique<QTemporaryDir>(); }

  // Brightness is height; the first row is the uppermost; what is transparent is black.
  void aPicture() {
    QImage picture(4, 2, QImage::Format_ARGB32);
    picture.fill(QColor(0, 0, 0));
    picture.setPixelColor(0, 0, QColor(255, 255, 255));
    picture.setPixelColor(3, 1, QColor(128, 128, 128));
    picture.setPixelColor(3, 0, QColor(255, 255, 255, 0));
    for (const char* name : {"a.png", "b.bmp", "no-ending"}) {
      QVERIFY(picture.save(QString::fromStdString(path(name).string()), name[0] == 'b' ? "BMP" : "PNG"));
      const auto stamp = readBrushStamp(path(name), m_kinds);
      QVERIFY(stamp.hasValue());
      QCOMPARE((*stamp)->width(), 4);
      QCOMPARE((*stamp)->height(), 2);
      QVERIFY(std::abs((*stamp)->at(-0.75, 0.25) - 1.0) < 1e-4);
      QVERIFY(std::abs((*stamp)->at(0.75, -0.25) - 128.0 / 255.0) < 1e-3);
      if (name[0] != 'b') QVERIFY(std::abs((*stamp)->at(0.75, 0.25)) < 1e-6);
    }
    QImage large(3000, 30, QImage::Format_Grayscale8);
    large.fill(200);
    QVERIFY(large.save(QString::fromStdString(path("large.png").string())));
    const auto reduced = readBrushStamp(path("large.png"), m_kinds);
    QVERIFY(reduced.hasValue());
    QCOMPARE((*reduced)->width(), ClayStamp::kMostSide);
    QCOMPARE((*reduced)->height(), 5);
  }

  void hostilePictures() {
    const auto code = [&](const char* name) { return readBrushStamp(path(name), m_kinds).error().code; };
    QCOMPARE(code("none.png"), ErrorCode(ErrorCode::FileMissing));
    writeBytes(path("huge.png"), pngOfSize(2'000'000'000, 2'000'000'000));
    const Error huge = readBrushStamp(path("huge.png"), m_kinds).error();
    QVERIFY(huge.code == ErrorCode::FileTooLarge || huge.code == VolumeErrors::PictureUnreadable);
    writeBytes(path("large.png"), pngOfSize(30'000, 30'000));
    QCOMPARE(code("large.png"), ErrorCode(ErrorCode::FileTooLarge));
    writeBytes(path("cut.png"), pngOfSize(30, 30));
    QCOMPARE(code("cut.png"), ErrorCode(VolumeErrors::PictureUnreadable));
    QCOMPARE(readBrushStamp(path("cut.png"), m_kinds).error().subject, path("cut.png").string());
    QImage black(8, 8, QImage::Format_RGB32);
    black.fill(Qt::black);
    QVERIFY(black.save(QString::fromStdString(path("black.png").string())));
    QCOMPARE(code("black.png"), ErrorCode(VolumeErrors::NothingStandsOut));
    // A file that has more bytes than are looked at, after a beginning that is a picture's.
    writeBytes(path("long.png"), pngOfSize(30, 30));
    fs::resize_file(path("long.png"), kMostStampBytes + 1);
    QCOMPARE(code("long.png"), ErrorCode(ErrorCode::FileTooLarge));
    writeBytes(path("a.svg"), "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'/>");
    QCOMPARE(code("a.svg"), ErrorCode(DocumentError::FormatUnknown));
  }

  // The stamp of a volume has its heights along z.
  void ofAVolume() {
    auto ball = std::make_shared<VolumeSnapshot>();
    ball->volume = ballOfVoxels(5.0, 0.1);
    ball->surface = VolumeSurface(ball->volume);
    const VolumeKind kind;
    QVERIFY(kind.exportTo(*ball, path("ball.vdb"), {}).hasValue());
    const auto stamp = readBrushStamp(path("ball.vdb"), m_kinds);
    QVERIFY(stamp.hasValue());
    for (double x = -0.8; x < 0.9; x += 0.2)
      QVERIFY(std::abs((*stamp)->at(x, 0.2) - std::sqrt(std::max(0.0, 1.0 - x * x - 0.04))) < 0.1);
  }

 private:
  fs::path path(const char* name) const { return fs::path(m_folder->path().toStdString()) / name; }

  std::unique_ptr<QTemporaryDir> m_folder;
  DocumentKinds m_kinds = volumeKinds();
};

HANDWHEEL_TEST(BrushStampReaderTest)
#include "BrushStampReaderTest.moc"
