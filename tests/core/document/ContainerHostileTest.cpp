// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ContainerChecks.h"
#include "TestClass.h"
#include "base/JsonText.h"
#include "document/container/ArchiveErrors.h"
#include "document/container/LocalEntries.h"
#include "document/container/ZipReader.h"

#include <QTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

std::string withManifest(const std::string& manifest) {
  return HandmadeZip().add(HandmadeZip::stored("manifest.json", manifest)).bytes();
}

ErrorCode codeOf(const std::string& bytes) {
  const auto read = readContainer(bytes);
  return read ? ErrorCode::Unsupported : read.error().code;  // Unsupported: never given by the reader
}

constexpr UnpackLimits kSmall{.largest = 10'000, .allowance = 1000, .ratio = 10};

}  // namespace

class ContainerHostileTest : public QObject {
  Q_OBJECT

 private slots:
  void manifests_data() {
    QTest::addColumn<QByteArray>("manifest");
    QTest::addColumn<ErrorCode>("code");
    const auto row = [](const char* name, const QByteArray& manifest, ErrorCode code) {
      QTest::newRow(name) << manifest << code;
    };
    row("empty", "", ErrorCode::ElementMalformed);
    row("no JSON", "{\"a\": ", ErrorCode::ElementMalformed);
    row("array", "[]", ErrorCode::ElementMalformed);
    row("no version", "{}", ErrorCode::ElementMalformed);
    row("version a text", R"({"handwheel": {"format": "1"}})", ErrorCode::ElementMalformed);
    row("version 0", R"({"handwheel": {"format": 0}})", ErrorCode::ElementMalformed);
    row("version negative", R"({"handwheel": {"format": -1}})", ErrorCode::ElementMalformed);
    row("number too large", R"({"handwheel": {"format": 1}, "a": 1e999})", ErrorCode::ElementMalformed);
    row("a million arrays", QByteArray(1000000, '['), ErrorCode::ElementMalformed);
    row("a million closed arrays", QByteArray(1000000, '[') + QByteArray(1000000, ']'), ErrorCode::ElementMalformed);
    row("a million objects", QByteArray("{\"a\":").repeated(1000000), ErrorCode::ElementMalformed);
    row("17 MiB", "{\"a\": \"" + QByteArray(17 << 20, 'a') + "\"}", ErrorCode::FileTooLarge);
    row("not UTF-8", "{\"handwheel\": {\"format\": 1}, \"a\": \"\xff\"}", ErrorCode::ElementMalformed);
  }

  void manifests() {
    QFETCH(QByteArray, manifest);
    QFETCH(ErrorCode, code);
    QCOMPARE(codeOf(withManifest(manifest.toStdString())), code);
  }

  void nestingHasALimit() {
    const auto nested = [](int depth) { return std::string(depth, '[') + "\"[[\\\"[\"" + std::string(depth, ']'); };
    QVERIFY(parseJson(nested(kDeepestJson), "a"));
    QVERIFY(!parseJson(nested(kDeepestJson + 1), "a"));
  }

  void noArchiveAtAll() {
    QVERIFY(codeOf("") == ErrorCode::FileEmpty);
    QVERIFY(codeOf("hello") == ArchiveError::Malformed);
    QVERIFY(codeOf("PK\3\4") == ArchiveError::Malformed);
    QVERIFY(codeOf(HandmadeZip().bytes()) == ArchiveError::EntryMissing);
    QVERIFY(codeOf(HandmadeZip().add(HandmadeZip::stored("a", "b")).bytes()) == ArchiveError::EntryMissing);
  }

  void namesThatLeadElsewhere() {
    for (const char* name : {"../a", "/a", "a/../../b", "a//b", "./a", "a/.", "a\\b", "C:a", "a\nb", "\xc3\xa9"}) {
      const std::string bytes = HandmadeZip()
                                    .add(HandmadeZip::stored("manifest.json", plainManifest()))
                                    .add(HandmadeZip::stored(name, "x"))
                                    .bytes();
      const auto read = readContainer(bytes);
      QVERIFY2(read && read->container.blobs.empty() && read->damage.size() == 1, name);
      QVERIFY2(read->damage[0].code == ArchiveError::EntryDamaged, name);
    }
  }

  // The name in a manifest is not trusted either.
  void namesInTheTable() {
    const auto read =
        readContainer(withManifest(R"({"handwheel": {"format": 1}, "blobs": {"../a": 1, "manifest.json": {}}})"));
    QVERIFY(read);
    QVERIFY(read->container.blobs.empty());
    QCOMPARE(read->damage.size(), std::size_t{2});
  }

  void tablesOfNonsense() {
    for (const char* table : {"7", "[]", "null", R"({"a": 5})", R"({"a": {"bytes": "x", "crc32": 9}})"}) {
      const auto read =
          readContainer(withManifest(R"({"handwheel": {"format": 1}, "blobs": )" + std::string(table) + "}"));
      QVERIFY2(read && read->damage.size() == 1, table);
      QVERIFY2(!read->container.manifest->contains("blobs"), table);
    }
  }

  void encryptedAndUnknownEntries() {
    HandmadeZip::Entry encrypted = HandmadeZip::stored("a", "secret");
    encrypted.flags = 1;
    HandmadeZip::Entry lzma = HandmadeZip::stored("b", "packed");
    lzma.method = 14;
    const auto read = readContainer(
        HandmadeZip().add(HandmadeZip::stored("manifest.json", plainManifest())).add(encrypted).add(lzma).bytes());
    QVERIFY(read);
    QVERIFY(read->container.blobs.empty());
    QCOMPARE(read->damage.size(), std::size_t{2});
  }

  void theFirstOfTwoCounts() {
    const auto read = readContainer(HandmadeZip()
                                        .add(HandmadeZip::stored("manifest.json", plainManifest()))
                                        .add(HandmadeZip::stored("a", "first"))
                                        .add(HandmadeZip::stored("a", "second"))
                                        .bytes());
    QVERIFY(read);
    QCOMPARE(read->container.blobs.at("a"), "first");
    QCOMPARE(read->damage.size(), std::size_t{1});
    QVERIFY(read->damage[0].code == ArchiveError::EntryDamaged);
  }

  // Sizes that ask for 64 bits, and a directory that counts more entries than it has.
  void liesAboutSizes() {
    HandmadeZip::Entry huge = HandmadeZip::stored("a", "abc");
    huge.size = 0xffffffff;
    HandmadeZip::Entry larger = HandmadeZip::deflated("b", "abc");
    larger.size = 2u << 30;
    HandmadeZip::Entry smaller = HandmadeZip::deflated("c", std::string(100'000, 'x'));
    smaller.size = 10;
    const auto read = readContainer(HandmadeZip()
                                        .add(HandmadeZip::stored("manifest.json", plainManifest()))
                                        .add(huge)
                                        .add(larger)
                                        .add(smaller)
                                        .bytes());
    QVERIFY(!read || read->container.blobs.empty());
    std::string counts = withManifest(plainManifest());
    counts.replace(counts.size() - 14, 4, "\xff\xff\xff\xff", 4);
    const auto counted = readContainer(counts);
    QVERIFY(counted);
    QVERIFY(!counted->damage.empty());
  }

  void bombsAreRefused() {
    const HandmadeZip::Entry bomb = HandmadeZip::deflated("bomb", std::string(1'000'000, '\0'));
    const std::string archive = HandmadeZip().add(bomb).bytes();
    ZipReader zip(archive, kSmall);
    const auto read = zip.read("bomb");
    QVERIFY(!read && read.error().code == ErrorCode::FileTooLarge);
    QCOMPARE(zip.readDamaged("bomb").size(), std::size_t{kSmall.budget(archive.size())} + 1);

    HandmadeZip::Entry liar = bomb;
    liar.size = 10;
    const std::string lying = HandmadeZip().add(liar).bytes();
    const auto lied = ZipReader(lying, kSmall).read("bomb");
    QVERIFY(!lied);

    const std::string lost = HandmadeZip().add(bomb).withoutDirectory();
    const auto salvaged = ZipReader(lost, kSmall).read("bomb");
    QVERIFY(!salvaged && salvaged.error().code == ArchiveError::EntryDamaged);
  }

  // A thousand entries over the same bytes: each is small, together they are not.
  void overlappingEntries() {
    const HandmadeZip::Entry shared = HandmadeZip::deflated("0", std::string(900, 'x'));
    HandmadeZip zip;
    zip.add(shared);
    for (int i = 1; i < 1000; ++i) {
      HandmadeZip::Entry other = shared;
      other.name = std::to_string(i);
      zip.list(other, 0);
    }
    const std::string archive = zip.bytes();
    ZipReader reader(archive, kSmall);
    QCOMPARE(reader.names().size(), std::size_t{1000});
    std::size_t total = 0;
    for (const std::string& name : reader.names())
      if (const auto bytes = reader.read(name)) total += bytes->size();
    QVERIFY(total > 0 && total <= kSmall.largest);
  }

  // None of them is whole: unsuccessful unpacking is bounded as well.
  void overlappingDamagedEntries() {
    HandmadeZip::Entry shared = HandmadeZip::deflated("0", std::string(900, 'x'));
    shared.checksum ^= 1;
    HandmadeZip zip;
    zip.add(shared);
    for (int i = 1; i < 1000; ++i) {
      shared.name = std::to_string(i);
      zip.list(shared, 0);
    }
    const std::string archive = zip.bytes();
    ZipReader reader(archive, kSmall);
    std::size_t damaged = 0, refused = 0;
    for (const std::string& name : reader.names()) {
      const auto bytes = reader.read(name);
      QVERIFY(!bytes);
      damaged += bytes.error().code == ArchiveError::EntryDamaged;
      refused += bytes.error().code == ErrorCode::FileTooLarge;
    }
    QVERIFY(damaged > 0 && refused > 0);
    QCOMPARE(damaged + refused, std::size_t{1000});
  }

  // Headers every thirty bytes, each of which claims all that follows: the work is bounded, not only the result.
  void overlappingHeaders() {
    std::string header = HandmadeZip().add({"a", "", 1u << 20, 0, 0, 0}).withoutDirectory();
    header.replace(18, 4, "\xfe\xff\x0f\0", 4);  // size of the data
    std::string archive;
    while (archive.size() < 2 << 20) archive += header;
    const std::vector<LocalEntry> entries = findLocalEntries(archive, 100'000);
    QVERIFY(entries.size() > 60'000);
    std::uint64_t work = 100 << 20;
    JobState nobody;
    std::size_t unpacked = 0;
    for (const LocalEntry& entry : entries)
      unpacked += unpackLocalEntry(archive, entry, 1 << 30, work, Progress(nobody)).bytes.size();
    QCOMPARE(work, std::uint64_t{0});
    QVERIFY(unpacked <= 100u << 20);
    const auto read = ZipReader(archive, {.largest = 1 << 30, .allowance = 1 << 20}).read("a");
    QVERIFY(!read && read.error().code == ArchiveError::EntryDamaged);
  }

  void tooManyEntries() {
    UnpackLimits few = kSmall;
    few.entries = 10;
    HandmadeZip zip;
    for (int i = 0; i < 50; ++i) zip.add(HandmadeZip::stored(std::to_string(i), ""));
    const std::string whole = zip.bytes(), lost = zip.withoutDirectory();
    QCOMPARE(ZipReader(whole, few).names().size(), std::size_t{10});
    QCOMPARE(ZipReader(lost, few).names().size(), std::size_t{10});
  }
};

HANDWHEEL_TEST(ContainerHostileTest)
#include "ContainerHostileTest.moc"
