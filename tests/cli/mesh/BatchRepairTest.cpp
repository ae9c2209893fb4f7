// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BatchFixture.h"
#include "TestClass.h"

using namespace handwheel;
using Json = nlohmann::json;

class BatchRepairTest : public QObject {
  Q_OBJECT

 private slots:
  void badFileAmongGoodOnes() {
    const Fixture fixture;
    putGoodFiles(fixture);
    putInto(fixture, "in/bad.stl", "solid x\nfacet normal nonsense");
    putInto(fixture, "in/notes.txt", "no mesh");
    putInto(fixture, "in/.hidden/d.off", cube().off());
    QVERIFY(QFile::link(fixture.path() + "/in", fixture.path() + "/in/sub/around"));
    const Ran ran = fixture.run({"repair", "in", "-o", "out"});
    QCOMPARE(ran.code, 1);
    QCOMPARE(ran.err, QByteArray());
    QVERIFY(lineWith(ran, "in/a.off").endsWith(" s"));
    QVERIFY(lineWith(ran, "in/a.off").contains("[1/4] in/a.off: closed, 1 of 1 hole filled, "));
    QVERIFY(lineWith(ran, "in/bad.stl").contains("[2/4] in/bad.stl: failed: line 2: "));
    QVERIFY(lineWith(ran, "together").simplified().startsWith("together 4 1 "));
    const Json report = fixture.json("out/repair-report.json");
    QCOMPARE(states(report),
             (QStringList{"in/a.off closed", "in/bad.stl failed", "in/sub/b.off closed", "in/sub/c.off closed"}));
    QCOMPARE(report.at("summary").at("failed").get<int>(), 1);
    QCOMPARE(report.at("summary").at("not_done").get<int>(), 0);
    QCOMPARE(QDir(fixture.path() + "/out").entryList(QDir::Files), (QStringList{"a.off", "repair-report.json"}));
    QCOMPARE(QDir(fixture.path() + "/out/sub").entryList(QDir::Files), (QStringList{"b.off", "c.off"}));
    QCOMPARE(fixture.content("in/a.off"), openCube().off());
    const Json repaired = Json::parse(fixture.run({"inspect", "out/a.off", "--json"}).out.toStdString());
    QCOMPARE(repaired.at("volume_mm3").get<double>(), 1.0);
  }

  void deadLink() {
    const Fixture fixture;
    putGoodFiles(fixture);
    QVERIFY(QFile::link(fixture.path() + "/gone.off", fixture.path() + "/in/dead.off"));
    const Ran ran = fixture.run({"repair", "in", "-o", "out"});
    QCOMPARE(ran.code, 1);
    QVERIFY(lineWith(ran, "in/dead.off").contains("failed: The target of the link does not exist."));
  }

  void exitCodes() {
    const Fixture fixture;
    putGoodFiles(fixture);
    QCOMPARE(fixture.run({"repair", "in", "-o", "out"}).code, 0);
    putInto(fixture, "in/sheet.off", flatSheet(2).off());
    const Ran ran = fixture.run({"repair", "in", "-o", "out"});
    QCOMPARE(ran.code, 2);
    QVERIFY(lineWith(ran, "sheet").contains("left open at 1 place, no holes, "));
    QVERIFY(lineWith(ran, "sheet").contains("1 outer boundary of an open sheet stays open"));
    QCOMPARE(fixture.run({"repair", "in/none.off", "in/a.off", "-o", "out"}).code, 1);
    QCOMPARE(fixture.run({"repair", "in", "-o", "out", "--open-sheets", "fill", "--max-hole", "4"}).code, 2);
  }

  // A line of JSON for each, and one for a single file.
  void jsonLines() {
    const Fixture fixture;
    putGoodFiles(fixture);
    const Ran ran = fixture.run({"repair", "in/a.off", "in/sub", "-o", "out", "--json", "--format", "stl"});
    QCOMPARE(ran.code, 0);
    const QList<QByteArray> lines = ran.out.trimmed().split('\n');
    QCOMPARE(lines.size(), 3);
    QCOMPARE(Json::parse(lines[0].toStdString()).at("output").get<std::string>(), std::string("out/a.stl"));
    QCOMPARE(Json::parse(lines[2].toStdString()).at("output").get<std::string>(), std::string("out/c.stl"));
    QCOMPARE(fixture.content("out/c.stl").size(), 84 + 4 * 50);  // binary: header, count, four triangles
    const Ran one = fixture.run({"repair", "in/a.off", "-o", "x.ply", "--json"});
    const Json said = Json::parse(one.out.toStdString());
    QCOMPARE(said.at("state").get<std::string>(), std::string("closed"));
    QCOMPARE(said.at("filled").get<int>(), 1);
    QVERIFY(said.at("reason").is_null());
  }

  void jobsChangeNothing() {
    const Fixture fixture;
    putGoodFiles(fixture);
    putInto(fixture, "in/bad.ply", "ply\nformat nonsense\n");
    putInto(fixture, "in/box.off", holedBox().off());
    QCOMPARE(fixture.run({"repair", "in", "-o", "one", "-j", "1"}).code, 1);
    QCOMPARE(fixture.run({"repair", "in", "-o", "two", "-j2"}).code, 1);
    const auto comparable = [&](const char* report) {
      Json json = fixture.json(report);
      json.at("summary").erase("seconds");
      for (Json& file : json.at("files")) {
        file.erase("seconds");
        file.at("output") = file.at("output").get<std::string>().substr(4);  // after "one/", "two/"
      }
      return json;
    };
    QVERIFY(comparable("one/repair-report.json") == comparable("two/repair-report.json"));
    for (const char* name : {"a.off", "box.off", "sub/b.off", "sub/c.off"}) {
      QVERIFY(!fixture.content(QString("one/") + name).isEmpty());
      QCOMPARE(fixture.content(QString("one/") + name), fixture.content(QString("two/") + name));
    }
  }

  void nothingIsOverwritten_data() {
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<QByteArray>("sentence");
    const auto row = [](const QStringList& words, const char* sentence) {
      QTest::newRow(qPrintable(words.join(' '))) << words << QByteArray(sentence);
    };
    row({"in", "in2", "-o", "out"}, "in/a.off and in2/a.off would both be written to out/a.off. ");
    row({"in", "-o", "out", "--format", "ply"}, "in/x.obj and in/x.off would both be written to out/x.ply. ");
    row({"in", "-o", "in"}, "in/a.off is an input; ");
    row({"in/a.off", "in/x.obj", "-o", "in/../in"}, "in/../in/a.off is an input; ");
    row({"in", "-o", "linked"}, "linked/a.off is an input; ");
    row({"in/a.off", "in/x.obj", "-o", "hard"}, "hard/a.off is an input; ");
    row({"in", "-o", "in/a.off"}, "in/a.off is not a folder; ");
    row({"in", "-o", "new.stl"}, "new.stl is not a folder; ");
    row({"in", "odd.mesh", "-o", "out", "--report", "odd.mesh"}, "odd.mesh is an input too.");
    row({"in", "-o", "out", "--report", "no/such/r.json"}, "There is no folder no/such for the report.");
    row({"in", "-o", "out", "--report", "r.stl"}, "--report takes a name such as parts.json, ");
    row({"empty", "-o", "out"}, "No mesh file was found.");
    row({"in", "-o", "out", "-j", "0"}, "--jobs takes a number from 1 to 64.");
    row({"in", "-o", "out", "-j", "65"}, "--jobs takes a number from 1 to 64.");
    row({"in", "-o", "out", "--time-limit", "nan"}, "--time-limit takes a number of seconds above zero.");
    row({"in", "-o", "out", "--format", "docx"}, "--format takes ");
    row({"in", "-o", "out", "--keep-open", "1"}, "--keep-open can be used with one file only.");
    row({"in", "-o", "out", "--fill", "x"}, "--fill takes ");
    row({"in"}, "The option -o OUT is missing.");
  }

  void nothingIsOverwritten() {
    QFETCH(QStringList, words);
    QFETCH(QByteArray, sentence);
    const Fixture fixture;
    for (const char* name : {"in/a.off", "in/x.off", "in/x.obj", "in2/a.off", "empty/a.txt", "hard/y.txt"}) {
      putInto(fixture, name, cube().off());
    }
    fixture.put("odd.mesh", cube().off());
    QVERIFY(QFile::link(fixture.path() + "/in", fixture.path() + "/linked"));
    QCOMPARE(::link(qPrintable(fixture.path() + "/in/a.off"), qPrintable(fixture.path() + "/hard/a.off")), 0);
    const QStringList before = fixture.names();
    const Ran ran = fixture.run(QStringList{"repair"} + words);
    QCOMPARE(ran.code, 1);
    QVERIFY2(ran.err.startsWith("handwheel: " + sentence), ran.err);
    QCOMPARE(ran.out, QByteArray());
    QCOMPARE(fixture.names(), before);
    QCOMPARE(fixture.content("in/a.off"), cube().off());
  }

  // The output lies in the folder that is searched: what an earlier run wrote there is no input.
  void outputInsideTheInput() {
    const Fixture fixture;
    putGoodFiles(fixture);
    for (int run = 0; run < 2; ++run) {
      QCOMPARE(fixture.run({"repair", ".", "-o", "out"}).code, 0);
      QCOMPARE(fixture.json("out/repair-report.json").at("files").size(), std::size_t(3));
    }
    QVERIFY(QFile::exists(fixture.path() + "/out/in/sub/b.off"));
  }

  void fileNamedTwiceIsTakenOnce() {
    const Fixture fixture;
    putGoodFiles(fixture);
    QCOMPARE(fixture.run({"repair", "in/a.off", "./in/sub/../a.off", "in", "-o", "out"}).code, 0);
    QCOMPARE(states(fixture.json("out/repair-report.json")),
             (QStringList{"in/a.off closed", "in/sub/b.off closed", "in/sub/c.off closed"}));
  }

  // Files are repaired regardless of the bytes in their names, and each has one line.
  void anyName() {
    const Fixture fixture;
    QVERIFY(QDir(fixture.path()).mkpath("in"));
    const QByteArray folder = QFile::encodeName(fixture.path());
    const QList<QByteArray> names{"-o.off", "two\nlines.off", "\xff\xfe.off", "a b'\"\\.OFF"};
    for (const QByteArray& name : names) {
      std::FILE* file = std::fopen((folder + "/in/" + name).constData(), "w");
      QVERIFY(file && std::fputs(cube().off().constData(), file) >= 0);
      std::fclose(file);
    }
    const Ran ran = fixture.run({"repair", "in", "-o", "out", "-j", "4"});
    QCOMPARE(ran.code, 0);
    QCOMPARE(ran.out.count("closed, no holes"), 4);
    QCOMPARE(ran.out.count('\n'), 4 + 6);  // with the table
    for (const QByteArray& name : names) QCOMPARE(::access((folder + "/out/" + name).constData(), R_OK), 0);
    QCOMPARE(fixture.run({"repair", "in", "-o", "out", "--resume"}).code, 0);
    QCOMPARE(fixture.json("out/repair-report.json").at("files").size(), std::size_t(4));
    for (const char* folderName : {"in/", "out/"})
      QCOMPARE(::unlink((folder + "/" + folderName + names[2]).constData()), 0);
  }
};

HANDWHEEL_TEST(BatchRepairTest)
#include "BatchRepairTest.moc"
