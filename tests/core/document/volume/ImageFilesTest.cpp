// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/ImageFiles.h"

#include "TestClass.h"
#include "document/Document.h"
#include "document/DocumentErrors.h"
#include "document/volume/VolumeKind.h"
#include "document/volume/VolumeMaking.h"

#include <QTemporaryDir>
#include <QtTest>
#include <cmath>
#include <fstream>

using namespace handwheel;

namespace {

namespace fs = std::filesystem;

void put(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

const std::string kDescribed = R"({"raw": "below/a.bin", "size": [4, 4, 4], "type": "uint8", "spacing": [1, 1, 1]})";

// Half of the samples are 200, the others 0.
std::string halves() {
  return std::string(32, '\0') + std::string(32, '\xc8');
}

}  // namespace

class ImageFilesTest : public QObject {
  Q_OBJECT

 private slots:
  // Data lie in the folder of their header or below it; nothing else is read.
  void dataBeside() {
    const QTemporaryDir folder;
    const fs::path root = folder.path().toStdString();
    fs::create_directory(root / "below");
    put(root / "a.json", kDescribed);
    QVERIFY(readImageFile(root / "a.json", {}).error().code == ErrorCode::FileMissing);
    put(root / "below/a.bin", halves());
    const Result<ImageFile> read = readImageFile(root / "a.json", {});
    QVERIFY(read.hasValue());
    QCOMPARE(read->image.value(63), 200.0);
    put(root / "below/b.nhdr",
        "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 1 1 1\nencoding: raw\ndata file: ../a.json\n");
    QVERIFY(readImageFile(root / "below/b.nhdr", {}).error().code == ErrorCode::Unsupported);
    put(root / "below/c.nhdr",
        "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 1 1 1\nencoding: raw\ndata file: /etc/hostname\n");
    QVERIFY(readImageFile(root / "below/c.nhdr", {}).error().code == ErrorCode::Unsupported);
    put(root / "d.stl", "solid\nendsolid\n");
    QVERIFY(readImageFile(root / "d.stl", {}).error().code == DocumentError::FormatUnknown);
  }

  // A series is called by its folder, whatever its files are called; what is alone in its folder by its own name.
  void titleOfASeries() {
    const QTemporaryDir folder;
    const fs::path root = folder.path().toStdString(), series = root / "CT of the head";
    fs::create_directory(series);
    const std::string head = std::string(128, '\0') + "DICM\x02";
    put(series / "DOE_JOHN_1", head);
    put(series / "readme.txt", "slices");
    QCOMPARE(seriesTitle(series / "DOE_JOHN_1"), std::string());
    put(series / "DOE_JOHN_2", head);
    QCOMPARE(seriesTitle(series / "DOE_JOHN_1"), std::string("CT of the head"));
    QCOMPARE(seriesTitle(series), std::string("CT of the head"));
    QCOMPARE(seriesTitle(series / ""), std::string("CT of the head"));
    QCOMPARE(seriesTitle(series / "readme.txt"), std::string());
    QCOMPARE(seriesTitle(root / "nothing.dcm"), std::string());

    DocumentFile file;
    file.path = (series / "DOE_JOHN_1").string();
    file.title = seriesTitle(file.path);
    const VolumeKind kind;
    OpenedFile opened = DocumentKinds::blank(kind);
    opened.file = file;
    const std::unique_ptr<Document> document = kind.make(std::move(opened));
    QCOMPARE(document->name(), QStringLiteral("CT of the head"));
    document->markSaved(QString::fromStdString((root / "skull.handwheel").string()), true);
    QCOMPARE(document->name(), QStringLiteral("skull.handwheel"));
  }

  // Opened as a document it becomes what is above the threshold between the two values, which is said.
  void opened() {
    const QTemporaryDir folder;
    const fs::path root = folder.path().toStdString();
    fs::create_directory(root / "below");
    put(root / "a.json", kDescribed);
    put(root / "below/a.bin", halves());
    const VolumeKind kind;
    QVERIFY(kind.recognises(kDescribed, "a.json"));
    QVERIFY(!kind.recognises("solid", "a.stl"));
    const Result<OpenedFile> opened = kind.import(root / "a.json", {}, {});
    QVERIFY(opened.hasValue());
    const auto& volume = static_cast<const VolumeSnapshot&>(*opened->content);
    QCOMPARE(volume.volume.material(), 32.0);
    QCOMPARE(volume.source, std::string("Raw image"));
    QCOMPARE(opened->file.notes.size(), std::size_t{1});
    QVERIFY(std::abs(std::stod(opened->file.notes.front().arguments.front()) - 100.0) < 1.0);
  }

  // Every remark has a text with placeholders for all of its figures.
  void remarks() {
    using Kind = ImageRemark::Kind;
    for (const Kind kind :
         {Kind::NoSpacing, Kind::NotNumbers, Kind::FirstOfSeveral, Kind::Tilted, Kind::Uneven, Kind::SpacingAssumed,
          Kind::SlicesMissing, Kind::OtherSeries, Kind::SamePosition, Kind::NotReadable}) {
      const std::vector<ImageRemark> one{{kind, {1.25, 3.0}}};
      const std::vector<Note> notes = notesOn(one);
      QCOMPARE(notes.size(), std::size_t{1});
      QVERIFY(!notes.front().text.empty());
      QCOMPARE(notes.front().arguments.front(), std::string("1.25"));
    }
  }
};

HANDWHEEL_TEST(ImageFilesTest)
#include "ImageFilesTest.moc"
