// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ContainerChecks.h"
#include "TestClass.h"
#include "document/container/ArchiveErrors.h"

#include <QTest>
#include <random>
#include <set>

using namespace handwheel;
using namespace handwheel::test;

namespace {

Container sample() {
  Container container;
  *container.manifest = {{"kind", "mesh"}, {"document", {{"vertices", 9}}}};
  for (int i = 0; i < 5; ++i) {
    std::string bytes;
    for (int k = 0; k < 60; ++k) bytes += static_cast<char>(k * k * (i + 1));
    container.blobs["mesh/" + std::to_string(i)] = bytes;
  }
  return container;
}

// Requirements on a damaged file: no wrong blob, no additional one, and every missing one is reported.
struct Verdict {
  bool isOpen = false;
  std::set<std::string> missing;
  QString problem;
};

Verdict judge(const std::string& bytes) {
  const Container whole = sample();
  const auto read = readContainer(bytes);
  Verdict verdict;
  verdict.isOpen = read.hasValue();
  if (!read) return verdict;
  if (ownPart(*read->container.manifest) != *whole.manifest) verdict.problem = "another manifest";
  std::set<std::string> reported;
  for (const Error& error : read->damage) reported.insert(error.arguments.at(0));
  for (const auto& [name, content] : whole.blobs) {
    const auto found = read->container.blobs.find(name);
    if (found == read->container.blobs.end()) verdict.missing.insert(name);
    if (found == read->container.blobs.end() && !reported.contains(name)) verdict.problem = "a loss not reported";
    if (found != read->container.blobs.end() && found->second != content) verdict.problem = "a wrong blob";
  }
  if (read->container.blobs.size() + verdict.missing.size() != whole.blobs.size()) verdict.problem = "an extra blob";
  return verdict;
}

const auto kCompressions = {Compression::None, Compression::Fast};

std::string archive(Compression compression) {
  return *writeContainer(sample(), compression);
}

// Returns the ends of manifest.json, the five blobs and manifest.copy.json.
std::vector<std::size_t> entryEnds(const std::string& bytes) {
  std::vector<std::size_t> ends;
  for (std::size_t at = bytes.find("PK\3\4", 4); at != std::string::npos; at = bytes.find("PK\3\4", at + 4))
    ends.push_back(at);
  ends.push_back(bytes.find("PK\1\2"));
  return ends;
}

void verify(const Verdict& verdict, std::size_t byte) {
  const QString problem = verdict.isOpen ? verdict.problem : "refused";
  QVERIFY2(problem.isEmpty() && verdict.missing.size() <= 1, qPrintable(QString("byte %1: %2").arg(byte).arg(problem)));
}

}  // namespace

class ContainerDamageTest : public QObject {
  Q_OBJECT

 private slots:
  // Any one wrong byte costs one blob at most, and never the manifest.
  void everyFlippedByte() {
    for (Compression compression : kCompressions) {
      std::string bytes = archive(compression);
      for (std::size_t i = 0; i < bytes.size(); ++i)
        for (int change : {0x01, 0x10, 0x80, 0xff}) {
          bytes[i] ^= static_cast<char>(change);
          verify(judge(bytes), i);
          bytes[i] ^= static_cast<char>(change);
        }
    }
  }

  void everyLostByte() {
    for (Compression compression : kCompressions) {
      const std::string bytes = archive(compression);
      for (std::size_t i = 0; i < bytes.size(); ++i) verify(judge(bytes.substr(0, i) + bytes.substr(i + 1)), i);
    }
  }

  // A truncated file has everything before the cut.
  void everyLength() {
    for (Compression compression : kCompressions) {
      const std::string bytes = archive(compression);
      const std::vector<std::size_t> ends = entryEnds(bytes);
      for (std::size_t length = 0; length < bytes.size(); ++length) {
        const Verdict verdict = judge(bytes.substr(0, length));
        std::set<std::string> cut;
        for (std::size_t i = 0; i < 5; ++i)
          if (ends[i + 1] > length) cut.insert("mesh/" + std::to_string(i));
        QCOMPARE(verdict.problem, QString());
        QCOMPARE(verdict.isOpen, length >= ends[0]);
        if (verdict.isOpen) QVERIFY(verdict.missing == cut);
      }
    }
  }

  // A block of the disk is overwritten: the parts outside it are recovered.
  void lostBlocks() {
    QVERIFY(rc::check([] {
      const Compression compression = *rc::gen::element(Compression::None, Compression::Fast);
      std::string bytes = archive(compression);
      const std::vector<std::size_t> ends = entryEnds(bytes);
      const auto from = *rc::gen::inRange<std::size_t>(0, bytes.size());
      const std::size_t end = std::min(bytes.size(), from + *rc::gen::inRange<std::size_t>(1, 300));
      std::set<std::string> touched;
      for (std::size_t i = 0; i < 5; ++i)
        if (from < ends[i + 1] && end > ends[i]) touched.insert("mesh/" + std::to_string(i));
      std::fill(bytes.begin() + from, bytes.begin() + end, *rc::gen::arbitrary<char>());
      const Verdict verdict = judge(bytes);
      RC_ASSERT(verdict.isOpen && verdict.problem.isEmpty());
      for (const std::string& name : verdict.missing) RC_ASSERT(touched.contains(name));
    }));
  }

  // One bit makes a chunk of 2 MB one of 2 GB, which is not a reason to refuse the file.
  void aSizeThatIsTooLarge() {
    Container container;
    std::string chunk;
    std::mt19937 random(1);
    while (chunk.size() < 5 << 19) chunk += static_cast<char>(random());  // random bytes, which cannot be compressed
    container.blobs["a"] = container.blobs["b"] = chunk;
    std::string bytes = *writeContainer(container, Compression::Fast);
    const std::size_t entry = bytes.rfind("PK\1\2", bytes.rfind("PK\1\2") - 1);  // entry of b, in the directory
    bytes[entry + 27] ^= static_cast<char>(0x80);
    const auto read = readContainer(bytes);
    QVERIFY(read);
    QVERIFY(read->container.blobs == container.blobs);
    QCOMPARE(read->damage.size(), std::size_t{1});
  }

  void directoryCutOff() {
    const std::string manifest = R"({"handwheel": {"format": 1}, "blobs": {"a": {"bytes": 3, "crc32": "352441c2"}}})";
    HandmadeZip zip;
    zip.add(HandmadeZip::stored("manifest.json", manifest)).add(HandmadeZip::deflated("a", "abc"));
    const auto read = readContainer(zip.withoutDirectory());
    QVERIFY(read);
    QCOMPARE(read->container.blobs.at("a"), "abc");
    QCOMPARE(read->damage.size(), std::size_t{1});
    QVERIFY(read->damage[0].code == ArchiveError::Malformed);
  }

  // A listed blob is missing, and another one differs from the manifest.
  void theManifestKnowsBetter() {
    const std::string manifest = R"({"handwheel": {"format": 1}, "blobs": {
        "gone": {"bytes": 3, "crc32": "352441c2"}, "other": {"bytes": 3, "crc32": "352441c2"}, "short": {"bytes": 4}}})";
    HandmadeZip zip;
    zip.add(HandmadeZip::stored("manifest.json", manifest))
        .add(HandmadeZip::stored("other", "abd"))
        .add(HandmadeZip::stored("short", "abc"));
    const auto read = readContainer(zip.bytes());
    QVERIFY(read);
    QVERIFY(read->container.blobs.empty());
    QCOMPARE(read->damage.size(), std::size_t{3});
    QVERIFY(read->damage[0].code == ArchiveError::EntryMissing && read->damage[0].arguments[0] == "gone");
    QVERIFY(read->damage[1].code == ArchiveError::EntryDamaged && read->damage[1].arguments[0] == "other");
    QVERIFY(read->damage[2].code == ArchiveError::EntryDamaged && read->damage[2].arguments[0] == "short");
  }

  // Archivers that write to a pipe put sizes behind the data.
  void streamedEntriesAreFound() {
    const HandmadeZip::Entry streamed = HandmadeZip::deflated("a", std::string(500, 'x'));
    const std::string descriptor =
        std::string("PK\7\10") +
        toBlob<std::uint32_t>({streamed.checksum, static_cast<std::uint32_t>(streamed.data.size()), streamed.size});
    const std::string manifest = R"({"handwheel": {"format": 1}, "blobs": {"a": {"bytes": 500}}})";
    for (std::size_t signature : {0, 4}) {
      const std::string bytes = HandmadeZip()
                                    .add(HandmadeZip::stored("manifest.json", manifest))
                                    .add({"a", "", 0, 0, 8, 8})
                                    .withoutDirectory() +
                                streamed.data + descriptor.substr(signature);
      const auto read = readContainer(bytes);
      QVERIFY(read);
      QVERIFY(read->container.blobs.at("a") == std::string(500, 'x'));
    }
  }
};

HANDWHEEL_TEST(ContainerDamageTest)
#include "ContainerDamageTest.moc"
