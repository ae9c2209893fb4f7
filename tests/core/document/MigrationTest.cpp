// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BuildPaths.h"
#include "ContainerChecks.h"
#include "TestClass.h"
#include "document/container/Migrations.h"

#include <QFile>
#include <QTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// Written once, when the version was new, and never again.
std::string fixture(int version) {
  QFile file(test::sourcePath("tests/core/document/fixtures/version-%1.handwheel").arg(version));
  return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
}

Migration noting(const char* step) {
  return [step](Container& container) -> Status {
    (*container.manifest)["steps"].push_back(step);
    return Done{};
  };
}

}  // namespace

class MigrationTest : public QObject {
  Q_OBJECT

 private slots:
  void everyVersionHasAFixture() {
    for (int version = 1; version <= kContainerVersion; ++version) {
      const std::string bytes = fixture(version);
      QVERIFY2(!bytes.empty(), qPrintable(QString("version %1 has no fixture").arg(version)));
      const QString asWritten = python(
          "import io, json, sys, zipfile\n"
          "z = zipfile.ZipFile(io.BytesIO(sys.stdin.buffer.read()))\n"
          "print(json.loads(z.read('manifest.json'))['handwheel']['format'])\n",
          bytes);
      QCOMPARE(asWritten, QString::number(version));
    }
    QVERIFY(fixture(kContainerVersion + 1).empty());
  }

  // Each fixture has the same document: a tetrahedron, and unknown additions.
  void fixturesAreRead() {
    for (int version = 1; version <= kContainerVersion; ++version) {
      const auto read = readContainer(fixture(version));
      QVERIFY(read);
      QVERIFY(read->damage.empty() && !read->isNewer);
      const json& manifest = *read->container.manifest;
      QCOMPARE(manifest.value("kind", ""), "mesh");
      QCOMPARE(manifest.value("id", ""), "0b9d5a6e-6d1c-4f5e-9a53-0c2f6c1d7e11");
      QCOMPARE(manifest.value("display_unit", ""), "in");
      QCOMPARE(manifest["document"].value("vertices", 0), 4);
      QCOMPARE(manifest["document"].value("faces", 0), 4);
      QCOMPARE(manifest["stranger"].value("mood", ""), "good");
      const auto positions = fromBlob<double>(read->container.blobs.at("mesh/positions/0000"));
      QVERIFY(positions == (std::vector<double>{0, 0, 0, 25.4, 0, 0, 0, 25.4, 0, 0, 0, 25.4}));
      QCOMPARE(fromBlob<std::uint32_t>(read->container.blobs.at("mesh/faces/0000")).size(), std::size_t{24});
      QCOMPARE(read->container.blobs.at("stranger/note.txt"), "keep me");
    }
  }

  void theChainIsAsLongAsItMustBe() {
    QCOMPARE(migrations().size(), std::size_t{kContainerVersion - 1});
    for (const Migration& migration : migrations()) QVERIFY(migration);
  }

  void aChainRunsFromTheVersionOn() {
    const std::vector<Migration> chain{noting("1 to 2"), noting("2 to 3"), noting("3 to 4")};
    const std::vector<json> expected{
        {"1 to 2", "2 to 3", "3 to 4"}, {"2 to 3", "3 to 4"}, {"3 to 4"}, nullptr, nullptr};
    for (std::uint64_t version = 1; version <= 5; ++version) {
      Container container;
      QVERIFY(migrate(container, version, chain));
      QVERIFY(container.manifest->value("steps", json()) == expected[version - 1]);
    }
    Container newest;
    QVERIFY(migrate(newest, ~std::uint64_t{0}, chain));
    QVERIFY(newest.manifest->empty());
  }

  void aChainStopsWhereItFails() {
    const std::vector<Migration> chain{noting("1 to 2"),
                                       [](Container&) -> Status {
                                         return Error{ErrorCode::ElementMalformed, {"a", "b"}, {}, {}};
                                       },
                                       noting("3 to 4")};
    Container container;
    const Status done = migrate(container, 1, chain);
    QVERIFY(!done && done.error().code == ErrorCode::ElementMalformed);
    QVERIFY((*container.manifest)["steps"] == json({"1 to 2"}));
  }
};

HANDWHEEL_TEST(MigrationTest)
#include "MigrationTest.moc"
