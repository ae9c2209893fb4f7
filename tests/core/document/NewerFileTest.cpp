// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/NewerFile.h"

#include "TestClass.h"
#include "document/AtomicFile.h"
#include "document/Container.h"
#include "document/FileBytes.h"
#include "document/container/ZipWriter.h"
#include "document/workpiece/WorkpieceKind.h"

#include <QTemporaryDir>
#include <QTest>

using namespace handwheel;

namespace {

const std::string kThis = std::to_string(kContainerVersion), kNext = std::to_string(kContainerVersion + 1);

// Returns an archive as a program of that version would write it.
std::string containerOfFormat(const std::string& format) {
  const std::string manifest = R"({"handwheel": {"format": )" + format + R"(}, "kind": "workpiece", "document": {}})";
  const std::vector<ZipEntry> entries{{"manifest.json", manifest}, {"manifest.copy.json", manifest}};
  return *writeZip(entries, Compression::Fast);
}

}  // namespace

class NewerFileTest : public QObject {
  Q_OBJECT

 private slots:
  void checkNotNewer_data() {
    QTest::addColumn<QByteArray>("there");
    QTest::addColumn<bool>("may");
    const auto row = [](const char* name, const std::string& there, bool may) {
      QTest::newRow(name) << QByteArray::fromStdString(there) << may;
    };
    row("nothing in it", "", true);
    row("no container", "solid", true);
    row("this version", containerOfFormat(kThis), true);
    row("the next", containerOfFormat(kNext), false);
    row("a far one", containerOfFormat("18446744073709551615"), false);
    row("no number", containerOfFormat("\"two\""), true);
    row("no version", containerOfFormat("null"), true);
    row("cut short", containerOfFormat(kNext).substr(0, 30), true);
    std::string damaged = containerOfFormat(kNext);
    damaged[50] ^= 0x55;  // within the first manifest; the copy still tells
    row("damaged", damaged, false);
  }
  void checkNotNewer() {
    QFETCH(QByteArray, there);
    QFETCH(bool, may);
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath("x.handwheel").toStdString();
    QVERIFY(writeFileAtomically(path, there.toStdString()).hasValue());
    const Status status = handwheel::checkNotNewer(path);
    QCOMPARE(status.hasValue(), may);
    if (!may) QCOMPARE(status.error().code, ErrorCode::VersionNewer);
    if (!may) QCOMPARE(status.error().subject, path.string());
  }

  void whereNothingIs() {
    const QTemporaryDir folder;
    QVERIFY(handwheel::checkNotNewer(folder.filePath("x.handwheel").toStdString()).hasValue());
    QVERIFY(handwheel::checkNotNewer(folder.path().toStdString()).hasValue());
    QVERIFY(handwheel::checkNotNewer("/dev/zero").hasValue());
  }

  // Neither a save nor an export replaces it, for any origin of the document and any file name.
  void savingLeavesItAlone_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"x.handwheel", "x.stl", "x.step"}) QTest::newRow(name) << name;
  }
  void savingLeavesItAlone() {
    QFETCH(QString, name);
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath(name).toStdString();
    const std::string newer = containerOfFormat(kNext);
    QVERIFY(writeFileAtomically(path, newer).hasValue());
    const WorkpieceKind kind;
    const OpenedFile blank = DocumentKinds::blank(kind);
    const auto saved = saveDocument(kind, blank.file, *blank.content, path);
    QVERIFY(!saved.hasValue());
    QCOMPARE(saved.error().code, ErrorCode::VersionNewer);
    QCOMPARE(*readFileBytes(path), newer);
  }
};

HANDWHEEL_TEST(NewerFileTest)
#include "NewerFileTest.moc"
