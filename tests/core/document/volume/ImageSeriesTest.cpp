// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MadeDicom.h"
#include "TestClass.h"
#include "document/DocumentErrors.h"
#include "document/volume/ImageFiles.h"
#include "document/volume/VolumeKind.h"
#include "document/volume/VolumeMaking.h"
#include "volume/VolumeErrors.h"

#include <QTemporaryDir>
#include <QtTest>
#include <cmath>
#include <fstream>

using namespace handwheel;

namespace {

namespace fs = std::filesystem;

// A series of slices of 2 mm one above the other, in files whose names are in no order.
void putSeries(const fs::path& folder, const std::string& name, const std::string& series, int slices) {
  for (int i = 0; i < slices; ++i) {
    test::MadeSlice slice;
    slice.series = series;
    slice.origin.z() = 2.0 * i;
    std::ofstream(folder / (name + std::to_string(7 * i % slices)), std::ios::binary) << test::dicomOf(slice);
  }
}

DocumentKinds kindsOfVolumes() {
  std::vector<std::unique_ptr<DocumentKind>> kinds;
  kinds.push_back(std::make_unique<VolumeKind>());
  return DocumentKinds(std::move(kinds));
}

}  // namespace

// Series of DICOM as they lie in folders, beside one another and beside other files.
class ImageSeriesTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    m_root = m_folder.path().toStdString();
    putSeries(m_root, "long", "1.2.3.5", 5);
    putSeries(m_root, "short", "1.2.3.4", 3);
    std::ofstream(m_root / "readme.txt") << "two series";
    fs::create_directory(m_root / "empty");
    std::ofstream(m_root / "empty" / "readme.txt") << "no slices";
  }

  // Reading a folder reads its largest series, and reports the others.
  void ofAFolder() {
    const Result<ImageFile> read = readImageFile(m_root, {});
    QVERIFY(read.hasValue());
    QCOMPARE(read->image.grid().size, (std::array<int, 3>{8, 6, 5}));
    const std::vector<Note> notes = notesOn(read->remarks);
    QCOMPARE(notes.size(), std::size_t{1});
    QCOMPARE(notes.front().text, std::string("Slices of other series were ignored (%1)."));
    QCOMPARE(notes.front().arguments, std::vector<std::string>{"3"});
    for (int z = 0; z < 5; ++z) QCOMPARE(read->image.value(static_cast<std::size_t>(48 * z)), std::round(2.0 * z));
  }

  // Reading a file reads its own series, regardless of the others.
  void ofAFile() {
    for (const auto& [name, slices] : {std::pair("short1", 3), std::pair("long4", 5)}) {
      const Result<ImageFile> read = readImageFile(m_root / name, {});
      QVERIFY(read.hasValue());
      QCOMPARE(read->image.grid().size[2], slices);
    }
  }

  // On a medium the files of a series are deep in folders, beside a directory. Files may have no preamble, and no
  // header.
  void mediaAndPlainFiles() {
    const fs::path medium = m_root / "empty" / "medium";
    const fs::path series = medium / "IMAGES" / "PAT0" / "ST0" / "SE0";
    fs::create_directories(series);
    fs::create_directories(medium / "IMAGES" / "PAT0" / "ST0" / "SE1");
    std::ofstream(medium / "DICOMDIR") << std::string(128, '\0') << "DICMwithout an image";
    putSeries(medium / "IMAGES" / "PAT0" / "ST0" / "SE1", "other", "1.2.3.9", 2);
    for (int i = 0; i < 5; ++i) {
      test::MadeSlice slice;
      slice.series = "1.2.3.7";
      slice.origin.z() = 2.0 * i;
      if (i % 2 == 1) slice.syntax = gdcm::TransferSyntax::ImplicitVRLittleEndian;
      std::string bytes = test::dicomOf(slice);
      if (i < 2) bytes.erase(0, 132);
      // The data set alone: the header is the group of number 2, whose length is its first element.
      if (i >= 2 && i < 4) bytes.erase(0, 132 + 12 + static_cast<unsigned char>(bytes[140]));
      std::ofstream(series / std::to_string(i), std::ios::binary) << bytes;
    }
    for (const fs::path& path : {medium, medium / "DICOMDIR", series / "0", series / "3"}) {
      const Result<ImageFile> read = readImageFile(path, {});
      QVERIFY(read.hasValue());
      QCOMPARE(read->image.grid().size, (std::array<int, 3>{8, 6, 5}));
      QCOMPARE(read->remarks.size(), std::size_t{path.parent_path() == series ? 0u : 1u});  // the other series
      for (int z = 0; z < 5; ++z) QCOMPARE(read->image.value(static_cast<std::size_t>(48 * z)), std::round(2.0 * z));
    }
    fs::remove_all(medium);
  }

  // Names of files are often the patient's: they are not kept.
  void namesAreNotKept() {
    QCOMPARE(sourceName(m_root), std::string("DICOM"));
    QCOMPARE(sourceName(m_root / "long0"), std::string("DICOM"));
    QCOMPARE(sourceName(m_root / "readme.txt"), std::string("readme.txt"));
    std::vector<Note> notes;
    const auto volume = importVolume(m_root / "short0", notes, {});
    QVERIFY(volume && (*volume)->source == "DICOM" && (*volume)->scan);
    QCOMPARE((*volume)->scan->image.grid().size[2], 3);
    QCOMPARE(notes.size(), std::size_t{2});  // notes on the other series and on the threshold
  }

  // A series opens as a document, whose title is the name of the folder.
  void opened() {
    for (const fs::path& path : {m_root, m_root / ""}) {
      const DocumentKinds kinds = kindsOfVolumes();
      const Result<OpenedFile> folder = kinds.open(path, {});
      QVERIFY(folder.hasValue());
      const auto& volume = static_cast<const VolumeSnapshot&>(*folder->content);
      QCOMPARE(volume.scan->image.grid().size[2], 5);
      QCOMPARE(folder->file.title, m_root.filename().string());
      QVERIFY(folder->file.hasPrivateName);
      // The title is shown, and nothing else has it: not what is saved, not what is proposed.
      const std::unique_ptr<Document> document = folder->kind->make(*folder);
      QCOMPARE(document->name().toStdString(), m_root.filename().string());
      QCOMPARE(document->sharedName(), QStringLiteral("Volume"));
      Container container;
      folder->kind->save(*document->snapshot(), container);
      QVERIFY(container.manifest->dump().find(m_root.filename().string()) == std::string::npos);
      document->markSaved(QString::fromStdString((m_root / "mine.handwheel").string()), true);
      QCOMPARE(document->sharedName(), QStringLiteral("mine.handwheel"));
    }
    const Result<OpenedFile> empty = kindsOfVolumes().open(m_root / "empty", {});
    QVERIFY(!empty && empty.error().code == VolumeErrors::FolderWithoutSeries);
  }

  void foldersWithoutASeries() {
    const Result<ImageFile> none = readImageFile(m_root / "empty", {});
    QVERIFY(!none && none.error().code == VolumeErrors::FolderWithoutSeries);
    QCOMPARE(none.error().subject, fs::absolute(m_root / "empty").string());
    QVERIFY(readImageFile(m_root / "nowhere", {}).error().code == ErrorCode::FileMissing);
    std::vector<Note> notes;
    QVERIFY(importVolume(m_root / "nowhere", notes, {}).error().code == ErrorCode::FileMissing);
    QVERIFY(importVolume(m_root / "readme.txt", notes, {}).error().code == DocumentError::FormatUnknown);
  }

  void cancelled() {
    JobState job;
    job.cancelled = true;
    for (const fs::path& path : {m_root, m_root / "short1"}) {
      const Result<ImageFile> read = readImageFile(path, Progress(job));
      QVERIFY(!read && read.error().code == ErrorCode::Cancelled);
    }
  }

 private:
  const QTemporaryDir m_folder;
  fs::path m_root;
};

HANDWHEEL_TEST(ImageSeriesTest)
#include "ImageSeriesTest.moc"
