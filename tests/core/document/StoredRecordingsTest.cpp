// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "AnyRecording.h"
#include "ContainerChecks.h"
#include "MeshDocuments.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "document/AtomicFile.h"
#include "document/FileBytes.h"
#include "document/RecordingExport.h"
#include "document/RecordingsEdit.h"
#include "document/container/RecordingBlobs.h"
#include "haptics/recording/RecordingCsv.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <sstream>

using namespace handwheel;
using namespace handwheel::test;

namespace {

DocumentKinds meshes() {
  std::vector<std::unique_ptr<DocumentKind>> kinds;
  kinds.push_back(std::make_unique<MeshKind>());
  return DocumentKinds(std::move(kinds));
}

std::vector<StoredRecording> anyRecordings() {
  std::vector<StoredRecording> all;
  for (int i = *rc::gen::inRange(0, 4); i > 0; --i) {
    const std::string name = *rc::gen::container<std::string>(rc::gen::inRange<char>(1, 127));
    all.push_back({freeKey(all), name, "device", *rc::gen::element(0.0, 3.25), anyRecording()});
  }
  return all;
}

// Returns a recording of so many ticks, one each millisecond.
Recording steady(std::size_t ticks) {
  Recording recording;
  for (std::size_t i = 0; i < ticks; ++i) {
    RecordedTick tick;
    tick.tick = i;
    tick.tip.time = 0.001 * static_cast<double>(i);
    recording.add(tick);
  }
  return recording;
}

void checkSame(const std::vector<StoredRecording>& read, const std::vector<StoredRecording>& written) {
  RC_ASSERT(read.size() == written.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    RC_ASSERT(read[i].key == written[i].key && read[i].name == written[i].name && read[i].device == written[i].device);
    RC_ASSERT(read[i].forceLimit == written[i].forceLimit);
    RC_ASSERT(isSame(read[i].ticks, written[i].ticks));
  }
}

// A document on the disk, and reading it back.
struct Fixture {
  QTemporaryDir folder;
  std::filesystem::path path = folder.filePath("part.handwheel").toStdString();
  DocumentKinds kinds = meshes();
  std::unique_ptr<MeshDocument> document = meshDocument(tetrahedron());

  void give(std::vector<StoredRecording> recordings) {
    document->commit("recordings", std::make_unique<RecordingsEdit>(std::move(recordings)));
  }
  bool save() const { return saveDocument(document->kind(), document->file(), *document->snapshot(), path).hasValue(); }
  // The container with a change by hand, written again with sums that fit.
  template <class Change>
  void change(Change change) const {
    auto read = readContainer(*readFileBytes(path));
    QVERIFY(read.hasValue());
    change(read->container);
    QVERIFY(writeFileAtomically(path, *writeContainer(read->container, Compression::Fast)).hasValue());
  }
};

}  // namespace

// The recordings of a device in a document and its file.
class StoredRecordingsTest : public QObject {
  Q_OBJECT

 private slots:
  void comeBackTheSame() {
    QVERIFY(rc::check([] {
      Fixture fixture;
      fixture.give(anyRecordings());
      RC_ASSERT(fixture.save());
      const auto opened = fixture.kinds.open(fixture.path, {});
      RC_ASSERT(opened.hasValue() && opened->file.damage.empty());
      checkSame(opened->file.recordings, fixture.document->file().recordings);
      // The same through a document that knows nothing else of the file.
      RC_ASSERT(saveDocument(*opened->kind, opened->file, *opened->content, fixture.path).hasValue());
      const auto again = fixture.kinds.open(fixture.path, {});
      RC_ASSERT(again.hasValue());
      checkSame(again->file.recordings, fixture.document->file().recordings);
    }));
  }

  void areAStepOfTheHistory() {
    Fixture fixture;
    QVERIFY(!fixture.document->isModified());
    const std::uint64_t before = fixture.document->revision();
    QSignalSpy changed(fixture.document.get(), &Document::changed);  // change of the model: a tool would begin anew
    fixture.give({{"0001", "first", "", 0.0, steady(3)}});
    QVERIFY(fixture.document->isModified());
    QVERIFY(fixture.document->revision() > before);
    QCOMPARE(fixture.document->file().recordings.size(), std::size_t{1});
    fixture.document->history()->undo();
    QVERIFY(fixture.document->file().recordings.empty());
    QVERIFY(!fixture.document->isModified());
    fixture.document->history()->redo();
    QCOMPARE(fixture.document->file().recordings[0].ticks.size(), std::size_t{3});
    QCOMPARE(changed.count(), 0);
  }

  void keysAreNotGivenTwice() {
    QVERIFY(rc::check([] {
      std::vector<StoredRecording> all;
      for (int i = *rc::gen::inRange(0, 30); i > 0; --i) all.push_back({freeKey(all), {}, {}, 0.0, {}});
      if (!all.empty()) all.erase(all.begin() + *rc::gen::inRange<int>(0, static_cast<int>(all.size())));
      const std::string key = freeKey(all);
      RC_ASSERT(key.size() == 4);
      for (const StoredRecording& each : all) RC_ASSERT(each.key != key);
    }));
    QCOMPARE(freeKey({{"9999", {}, {}, 0.0, {}}}), std::string("10000"));
  }

  // Unknown keys of other programs or users are kept; deleted recordings are gone.
  void strangersStayAndTheDeletedIsGone() {
    Fixture fixture;
    fixture.give({{"0001", "first", "", 0.0, steady(3)}, {"0002", "second", "", 0.0, steady(2)}});
    QVERIFY(fixture.save());
    fixture.change([](Container& container) {
      (*container.manifest)["recordings"]["0001"]["hand"] = "left";
      (*container.manifest)["recordings"]["0002"]["hand"] = "right";
    });
    auto opened = fixture.kinds.open(fixture.path, {});
    QVERIFY(opened.hasValue());
    opened->file.recordings.erase(opened->file.recordings.begin());
    QVERIFY(saveDocument(*opened->kind, opened->file, *opened->content, fixture.path).hasValue());
    const auto read = readContainer(*readFileBytes(fixture.path));
    const json& list = (*read->container.manifest)["recordings"];
    QCOMPARE(list.size(), std::size_t{1});
    QVERIFY(list["0002"]["hand"] == "right");
    for (const auto& [name, bytes] : read->container.blobs) QVERIFY(!name.starts_with("recordings/0001"));
  }

  // A damaged part costs that part; the rest of the document opens, and says what is missing.
  void damageCostsOnePart() {
    Fixture fixture;
    fixture.give({{"0001", "long", "", 0.0, steady(140'000)}, {"0002", "short", "", 0.0, steady(5)}});
    QVERIFY(fixture.save());
    fixture.change([](Container& container) {
      QCOMPARE(container.blobs.count("recordings/0001/0002"), std::size_t{1});
      container.blobs["recordings/0001/0001"].resize(1000);
    });
    const auto opened = fixture.kinds.open(fixture.path, {});
    QVERIFY(opened.hasValue());
    QCOMPARE(opened->file.damage.size(), std::size_t{1});
    const Error& damage = opened->file.damage[0];
    QVERIFY(damage.code == ErrorCode::DataTruncated);
    QCOMPARE(damage.arguments[0], std::string("ticks of the recording 'long'"));
    QCOMPARE(damage.arguments[1], std::string("140000"));
    QCOMPARE(damage.arguments[2], std::to_string(140'000 - 65'536));
    QCOMPARE(opened->file.recordings[0].ticks.missing(), std::uint64_t{65'536});
    QCOMPARE(opened->file.recordings[1].ticks.size(), std::size_t{5});
    QVERIFY(opened->file.wouldLoseDataOnOverwrite());
  }

  void whatIsLostIsReported() {
    Fixture fixture;
    fixture.give({{"0001", "gone", "", 0.0, steady(7)}});
    QVERIFY(fixture.save());
    fixture.change([](Container& container) { container.blobs.erase("recordings/0001/0000"); });
    const auto opened = fixture.kinds.open(fixture.path, {});
    QVERIFY(opened.hasValue());
    QVERIFY(!opened->file.damage.empty());
    QCOMPARE(opened->file.recordings[0].ticks.size(), std::size_t{0});
  }

  // The manifest may contain anything.
  void anyManifestIsBorne() {
    Fixture fixture;
    QVERIFY(fixture.save());
    const Container whole = readContainer(*readFileBytes(fixture.path))->container;
    QVERIFY(rc::check([&] {
      Container container = whole;
      json& list = (*container.manifest)["recordings"] = anyJson(3);
      if (list.is_object()) list["0001"] = anyJson(2);
      if (list.is_object() && list["0001"].is_object()) list["0001"]["ticks"] = anyJson(0);
      container.blobs["recordings/0001/0000"] = *rc::gen::arbitrary<std::string>();
      RC_ASSERT(writeFileAtomically(fixture.path, *writeContainer(container, Compression::Fast)).hasValue());
      const auto opened = fixture.kinds.open(fixture.path, {});
      RC_ASSERT(opened.hasValue());
      for (const StoredRecording& each : opened->file.recordings) RC_ASSERT(each.forceLimit >= 0.0);
    }));
  }

  // A foreign file cannot store them, and the user is informed.
  void aForeignFileLacksThem() {
    Fixture fixture;
    const std::filesystem::path stl = fixture.folder.filePath("part.stl").toStdString();
    const auto before =
        saveDocument(fixture.document->kind(), fixture.document->file(), *fixture.document->snapshot(), stl);
    fixture.give({{"0001", "first", "", 0.0, steady(3)}});
    const auto after =
        saveDocument(fixture.document->kind(), fixture.document->file(), *fixture.document->snapshot(), stl);
    QVERIFY(before.hasValue() && after.hasValue());
    QCOMPARE(after->notes.size(), before->notes.size() + 1);
  }

  void theTableIsThatOfTheRecording() {
    const Fixture fixture;
    const std::filesystem::path csv = fixture.folder.filePath("a.csv").toStdString();
    QVERIFY(exportRecording(steady(3), csv).hasValue());
    std::ostringstream expected;
    QVERIFY(writeCsv(steady(3), expected).hasValue());
    QCOMPARE(*readFileBytes(csv), expected.str());
    const auto nowhere = exportRecording(steady(3), fixture.folder.filePath("none/a.csv").toStdString());
    QVERIFY(!nowhere.hasValue() && nowhere.error().code == ErrorCode::WriteFailed);
  }
};

HANDWHEEL_TEST(StoredRecordingsTest)
#include "StoredRecordingsTest.moc"
