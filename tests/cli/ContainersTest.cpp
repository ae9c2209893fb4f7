// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Program.h"
#include "Shapes.h"
#include "TestClass.h"
#include "document/Container.h"

#include <QTest>
#include <filesystem>

using namespace handwheel;
using Json = nlohmann::json;

namespace {

Container containerIn(const Fixture& fixture, const QString& name) {
  const auto read = readContainer(fixture.content(name).toStdString());
  return read ? read->container : Container();
}

void put(const Fixture& fixture, const QString& name, const Container& container) {
  fixture.put(name, QByteArray::fromStdString(*writeContainer(container, Compression::Fast)));
}

// The same, as a program of the next version would have written it.
void putNewer(const Fixture& fixture, const QString& name, const Container& container) {
  Json manifest = *container.manifest;
  manifest["handwheel"]["format"] = kContainerVersion + 1;
  const std::string text = manifest.dump();
  std::vector<ZipEntry> entries{{"manifest.json", text}};
  for (const auto& [blob, bytes] : container.blobs) entries.push_back({blob, bytes});
  entries.push_back({"manifest.copy.json", text});
  fixture.put(name, QByteArray::fromStdString(*writeZip(entries, Compression::Fast)));
}

int loopWith(const Json& report, int edges) {
  for (const Json& loop : report.at("loops")) {
    if (loop.at("edges") == edges) return loop.at("id");
  }
  return -1;
}

// A box with three holes, of 4, 6 and 8 edges, in a document with all that can be lost of one: a mark on the hole with
// 6 edges, a unit, and what this program does not know.
QByteArray madeDocument() {
  const Fixture fixture;
  const QString name = "made.handwheel";
  fixture.put("a.off", holedBox().off());
  const int kept = loopWith(fixture.inspected("a.off"), 6);
  fixture.run({"repair", "a.off", "-o", name, "--keep-open", QString::number(kept), "--max-hole", "3"});
  fixture.run({"set", name, "display_unit=in", "-o", name});
  Container container = containerIn(fixture, name);
  (*container.manifest)["future"] = {{"list", {1, {{"deep", true}}}}};
  (*container.manifest)["document"]["future"] = {{"object", {{"deep", "yes"}}}};
  container.blobs["future/data"] = "kept";
  put(fixture, name, container);
  return fixture.content(name);
}

// Writes the document, and "a.off" from which it was made.
void putDocument(const Fixture& fixture, const QString& name) {
  static const QByteArray made = madeDocument();
  fixture.put("a.off", holedBox().off());
  fixture.put(name, made);
}

// Other names of a file: symbolic and hard links, also with the ending of another format.
void putLinks(const Fixture& fixture, const QString& name) {
  const std::filesystem::path folder = fixture.path().toStdString(), file = folder / name.toStdString();
  for (const char* ending : {".handwheel", ".stl"}) {
    std::filesystem::create_symlink(file.filename(), folder / (std::string("link") + ending));
    std::filesystem::create_hard_link(file, folder / (std::string("hard") + ending));
  }
}

void compareWhatMustNotBeLost(const Fixture& fixture, const QString& before, const QString& after) {
  const Container was = containerIn(fixture, before), is = containerIn(fixture, after);
  for (const char* key : {"id", "display_unit", "future", "kind"}) QVERIFY((*is.manifest)[key] == (*was.manifest)[key]);
  for (const char* key : {"kept_open", "future", "numbers"})
    QVERIFY((*is.manifest)["document"][key] == (*was.manifest)["document"][key]);
  QCOMPARE(is.blobs.at("future/data"), std::string("kept"));
}

}  // namespace

// Tests that commands preserve the contents of containers beyond the triangles.
class ContainersTest : public QObject {
  Q_OBJECT

 private slots:
  void repairKeepsTheDocument() {
    const Fixture fixture;
    putDocument(fixture, "a.handwheel");
    const Ran ran = fixture.run({"repair", "a.handwheel", "-o", "b.handwheel", "--report", "r.json"});
    QCOMPARE(ran.code, 2);
    QVERIFY(ran.out.startsWith("2 of 3 holes filled, 1 kept open. "));
    QVERIFY(ran.err.contains(", 6 edges) stays open: it is marked to be kept open."));
    compareWhatMustNotBeLost(fixture, "a.handwheel", "b.handwheel");
    const Json after = fixture.inspected("b.handwheel");
    QCOMPARE(after.at("loops").size(), std::size_t(1));
    QCOMPARE(after.at("loops").at(0).at("edges").get<int>(), 6);
    QCOMPARE(after.at("kept_open").size(), std::size_t(1));
    QVERIFY(fixture.json("r.json").at("unmodified_vertices_identical").get<bool>());
    // Repeats the repair, writing to its own input: nothing is left to do.
    QCOMPARE(fixture.run({"repair", "b.handwheel", "-o", "b.handwheel"}).code, 2);
    compareWhatMustNotBeLost(fixture, "a.handwheel", "b.handwheel");
    // The marks hold for exports too.
    QVERIFY(fixture.run({"repair", "a.handwheel", "-o", "b.stl"}).out.startsWith("2 of 3 holes filled, 1 kept open. "));
  }

  void convertAndSetKeepTheDocument() {
    const Fixture fixture;
    putDocument(fixture, "a.handwheel");
    QCOMPARE(fixture.run({"convert", "a.handwheel", "b.handwheel"}).code, 0);
    compareWhatMustNotBeLost(fixture, "a.handwheel", "b.handwheel");
    QCOMPARE(fixture.content("b.handwheel"), fixture.content("a.handwheel"));
    QCOMPARE(fixture.run({"set", "b.handwheel", "display_unit=mm", "-o", "b.handwheel"}).code, 0);
    QCOMPARE(fixture.run({"set", "b.handwheel", "display_unit=in", "-o", "b.handwheel"}).code, 0);
    QCOMPARE(fixture.content("b.handwheel"), fixture.content("a.handwheel"));
    QCOMPARE(fixture.run({"set", "a.handwheel", "display_unit=in", "-o", "c.handwheel"}).code, 0);
    QCOMPARE(fixture.content("c.handwheel"), fixture.content("a.handwheel"));
  }

  // A document keeps the numbers of its vertices. After an edit its loops are in another order than its bare triangles
  // would give; the numbers that inspect shows are those that repair takes.
  void loopsHaveTheNumbersThatInspectShows() {
    const Fixture fixture;
    putDocument(fixture, "a.handwheel");
    Container container = containerIn(fixture, "a.handwheel");
    // The last triangles become the first: their vertices are met first by whoever reads triangles only.
    std::string& faces = container.blobs.at("mesh/faces/0000");
    const std::size_t count = faces.size() / 24;
    const auto number = [&](std::size_t i) { return reinterpret_cast<std::uint32_t*>(faces.data()) + i; };
    for (std::size_t f = 0; f < count / 2; ++f) {
      std::swap_ranges(number(6 * f), number(6 * f + 6), number(6 * (count - 1 - f)));
    }
    for (std::size_t f = 0; f < count; ++f) {
      for (std::size_t k = 3; k < 6; ++k) {
        std::uint32_t& opposite = *number(6 * f + k);
        if (opposite < 3 * count) opposite = 3 * (count - 1 - opposite / 3) + opposite % 3;
      }
    }
    put(fixture, "b.handwheel", container);
    const Json report = fixture.inspected("b.handwheel");
    QVERIFY(fixture.run({"inspect", "b.handwheel"}).err.isEmpty());  // still a sound mesh
    QCOMPARE(fixture.run({"convert", "b.handwheel", "bare.off"}).code, 0);
    QVERIFY(loopWith(fixture.inspected("bare.off"), 8) != loopWith(report, 8));
    QCOMPARE(report.at("kept_open").at(0).get<int>(), loopWith(report, 6));
    const QString id = QString::number(loopWith(report, 8));
    fixture.run({"repair", "b.handwheel", "-o", "c.handwheel", "--keep-open", id});
    const Json after = fixture.inspected("c.handwheel");
    QCOMPARE(after.at("loops").size(), std::size_t(2));
    QVERIFY(loopWith(after, 4) == -1);
    QCOMPARE(after.at("kept_open").size(), std::size_t(2));
  }

  void newerFilesAreNotReplaced_data() {
    QTest::addColumn<QStringList>("words");
    const auto row = [](const char* words) { QTest::newRow(words) << QString(words).split(' '); };
    row("set n.handwheel display_unit=cm -o n.handwheel");
    row("set n.handwheel display_unit=cm -o ./link.handwheel");
    row("set link.handwheel display_unit=cm -o n.handwheel");
    row("convert n.handwheel n.handwheel");
    row("convert a.off n.handwheel");
    row("repair n.handwheel -o n.handwheel");
    row("repair a.handwheel -o n.handwheel");
    row("new workpiece -o n.handwheel");
    // Under another name, also as another format.
    row("set n.handwheel display_unit=cm -o hard.handwheel");
    row("set n.handwheel display_unit=cm -o hard.stl");
    row("convert a.off link.stl");
    row("convert n.handwheel link.stl");
    row("repair a.off -o link.stl");
  }
  void newerFilesAreNotReplaced() {
    QFETCH(QStringList, words);
    const Fixture fixture;
    putDocument(fixture, "a.handwheel");
    putNewer(fixture, "n.handwheel", containerIn(fixture, "a.handwheel"));
    putLinks(fixture, "n.handwheel");
    const QByteArray before = fixture.content("n.handwheel");
    const Ran ran = fixture.run(words);
    QCOMPARE(ran.code, 1);
    QVERIFY2(ran.err.endsWith(" was written by a newer version of Handwheel and is not replaced, so that no content "
                              "unknown to this version is lost. Write to another file.\n"),
             ran.err);
    QCOMPARE(fixture.content("n.handwheel"), before);
    QVERIFY(QFileInfo(fixture.path() + "/link.handwheel").isSymLink());
  }

  void newerFilesAreReadAsFarAsTheyAreUnderstood() {
    const Fixture fixture;
    putDocument(fixture, "a.handwheel");
    putNewer(fixture, "n.handwheel", containerIn(fixture, "a.handwheel"));
    const Ran ran = fixture.run({"convert", "n.handwheel", "b.handwheel"});
    QCOMPARE(ran.code, 0);
    QCOMPARE(ran.err,
             QByteArray("handwheel: A newer version of Handwheel wrote the file; only what this version knows was "
                        "read.\n"));
    compareWhatMustNotBeLost(fixture, "a.handwheel", "b.handwheel");
  }

  void damagedFilesAreNotReplaced_data() {
    QTest::addColumn<QStringList>("words");
    const auto row = [](const char* words) { QTest::newRow(words) << QString(words).split(' '); };
    row("set d.handwheel display_unit=cm -o d.handwheel");
    row("convert d.handwheel d.handwheel");
    row("repair d.handwheel -o d.handwheel");
    for (const char* other : {"link.handwheel", "hard.handwheel", "./d.handwheel", "sub/../d.handwheel", "hard.stl"}) {
      row(qPrintable(QString("set d.handwheel display_unit=cm -o ") + other));
      row(qPrintable(QString("convert d.handwheel ") + other));
      row(qPrintable(QString("repair d.handwheel -o ") + other));
    }
  }
  void damagedFilesAreNotReplaced() {
    QFETCH(QStringList, words);
    const Fixture fixture;
    putDocument(fixture, "a.handwheel");
    QByteArray damaged = fixture.content("a.handwheel");
    damaged.replace("future/data", "fXture/data");  // in the local header and in the directory
    fixture.put("d.handwheel", damaged);
    putLinks(fixture, "d.handwheel");
    QVERIFY(QDir(fixture.path()).mkdir("sub"));
    const Ran ran = fixture.run(words);
    QCOMPARE(ran.code, 1);
    QVERIFY2(ran.err.contains("'future/data' is missing"), ran.err);
    QVERIFY2(ran.err.endsWith(" is damaged and is not replaced, to prevent further loss. Write to "
                              "another file.\n"),
             ran.err);
    QCOMPARE(fixture.content("d.handwheel"), damaged);
    // The readable part goes to another file, and an intact file may replace it. The words for the other names of the
    // file are the same then.
    if (words.last() != "d.handwheel") return;
    words.last() = "e.handwheel";
    QVERIFY(fixture.run(words).code != 1);
    QVERIFY(fixture.names().contains("e.handwheel"));
    QCOMPARE(fixture.run({"convert", "e.handwheel", "d.handwheel"}).code, 0);
  }

  void importedDocumentsRememberWhatWasTurned() {
    Shape shape = cube();
    std::swap(shape.faces[7][0], shape.faces[7][1]);
    const Fixture fixture;
    fixture.put("a.off", shape.off());
    const Ran ran = fixture.run({"convert", "a.off", "a.handwheel"});
    QCOMPARE(ran.code, 0);
    QCOMPARE(ran.err, QByteArray("handwheel: Triangles reversed to agree with their neighbours: 1.\n"));
    QVERIFY((*containerIn(fixture, "a.handwheel").manifest)["document"]["turned_faces"] == 1);
    QCOMPARE(fixture.run({"repair", "a.off", "-o", "b.handwheel"}).code, 0);
    QVERIFY((*containerIn(fixture, "b.handwheel").manifest)["document"]["turned_faces"] == 1);
  }
};

HANDWHEEL_TEST(ContainersTest)
#include "ContainersTest.moc"
