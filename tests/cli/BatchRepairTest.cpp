// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Program.h"
#include "Shapes.h"

#include <unistd.h>
#include <utime.h>
#include <QTest>
#include <csignal>

using namespace handwheel;
using Json = nlohmann::json;

namespace {

// An open tube that keeps the program busy for a second or more.
QByteArray largeTube() {
  const int n = 500;
  const auto at = [n](int x, int y) {
    const double u = 2 * M_PI * x / n;
    return std::array<double, 3>{std::cos(u), std::sin(u), 0.01 * y};
  };
  return grid(n, n, at, [](int, int) { return false; }).off();
}

void putInto(const Bench& bench, const QString& name, const QByteArray& content) {
  QVERIFY(QDir(bench.path()).mkpath(QFileInfo(name).path()));
  bench.put(name, content);
}

// Good files of which one has a hole, and one in a folder below.
void putGoodFiles(const Bench& bench) {
  putInto(bench, "in/a.off", openCube().off());
  putInto(bench, "in/sub/b.off", cube().off());
  putInto(bench, "in/sub/c.off", tetrahedron().off());
}

// "a.off closed", for each file in the order of the report.
QStringList states(const Json& report) {
  QStringList list;
  for (const Json& file : report.at("files")) {
    list << QString::fromStdString(file.at("input").get<std::string>() + " " + file.at("state").get<std::string>());
  }
  return list;
}

QByteArray lineWith(const Ran& ran, const QByteArray& words) {
  for (const QByteArray& line : ran.out.split('\n')) {
    if (line.contains(words)) return line;
  }
  return {};
}

QByteArray contentOf(pid_t process, const char* name) {
  QFile file(QString("/proc/%1/%2").arg(process).arg(name));
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

// In /proc/PID/stat the state and the parent follow the program's name, which may hold anything.
QList<QByteArray> stateAndParent(pid_t process) {
  const QByteArray stat = contentOf(process, "stat");
  return stat.mid(stat.lastIndexOf(')') + 2).split(' ').mid(0, 2);
}
pid_t parentOf(pid_t process) {
  return stateAndParent(process).value(1).toInt();
}
// Or only its parent has not heard of its end yet.
bool isGone(pid_t process) {
  const QByteArray state = stateAndParent(process).value(0);
  return state.isEmpty() || state == "Z";
}

// A batch that is under way.
class Batch {
 public:
  Batch(const Bench& bench, const QStringList& words) {
    m_process.setWorkingDirectory(bench.path());
    m_process.start(HANDWHEEL_PROGRAM, QStringList{"repair"} + words);
    if (!m_process.waitForStarted()) qFatal("the program does not start");
  }
  // The processes that repair a file: those that have become the program.
  QList<pid_t> children() const {
    QList<pid_t> found;
    for (const QString& name : QDir("/proc").entryList(QDir::Dirs)) {
      const pid_t process = name.toInt();
      if (process == 0 || parentOf(process) != m_process.processId()) continue;
      if (contentOf(process, "cmdline").contains("--json")) found << process;
    }
    return found;
  }
  // The one that repairs a file of this name; 0: none at present.
  pid_t childFor(const QByteArray& name) const {
    for (pid_t child : children()) {
      if (contentOf(child, "cmdline").contains(name)) return child;
    }
    return 0;
  }
  void send(int signal) { ::kill(static_cast<pid_t>(m_process.processId()), signal); }
  Ran finish() {
    if (!m_process.waitForFinished(120000)) return {};
    const int code = m_process.exitStatus() == QProcess::NormalExit ? m_process.exitCode() : -1;
    return {code, m_process.readAllStandardOutput(), m_process.readAllStandardError()};
  }

 private:
  QProcess m_process;
};

bool tellsOf(const Bench& bench, const char* file) {
  const QByteArray report = bench.content("out/repair-report.json");
  return report.contains(file);
}

}  // namespace

class BatchRepairTest : public QObject {
  Q_OBJECT

 private slots:
  void badFileAmongGoodOnes() {
    const Bench bench;
    putGoodFiles(bench);
    putInto(bench, "in/bad.stl", "solid x\nfacet normal nonsense");
    putInto(bench, "in/notes.txt", "no mesh");
    putInto(bench, "in/.hidden/d.off", cube().off());
    QVERIFY(QFile::link(bench.path() + "/in", bench.path() + "/in/sub/around"));
    const Ran ran = bench.run({"repair", "in", "-o", "out"});
    QCOMPARE(ran.code, 1);
    QCOMPARE(ran.err, QByteArray());
    QVERIFY(lineWith(ran, "in/a.off").endsWith(" s"));
    QVERIFY(lineWith(ran, "in/a.off").contains("[1/4] in/a.off: closed, 1 of 1 holes filled, "));
    QVERIFY(lineWith(ran, "in/bad.stl").contains("[2/4] in/bad.stl: failed: line 2: "));
    QVERIFY(lineWith(ran, "together").simplified().startsWith("together 4 1 "));
    const Json report = bench.json("out/repair-report.json");
    QCOMPARE(states(report),
             (QStringList{"in/a.off closed", "in/bad.stl failed", "in/sub/b.off closed", "in/sub/c.off closed"}));
    QCOMPARE(report.at("summary").at("failed").get<int>(), 1);
    QCOMPARE(report.at("summary").at("not_done").get<int>(), 0);
    QCOMPARE(QDir(bench.path() + "/out").entryList(QDir::Files), (QStringList{"a.off", "repair-report.json"}));
    QCOMPARE(QDir(bench.path() + "/out/sub").entryList(QDir::Files), (QStringList{"b.off", "c.off"}));
    QCOMPARE(bench.content("in/a.off"), openCube().off());
    const Json repaired = Json::parse(bench.run({"inspect", "out/a.off", "--json"}).out.toStdString());
    QCOMPARE(repaired.at("volume_mm3").get<double>(), 1.0);
  }

  void exitCodes() {
    const Bench bench;
    putGoodFiles(bench);
    QCOMPARE(bench.run({"repair", "in", "-o", "out"}).code, 0);
    putInto(bench, "in/sheet.off", flatSheet(2).off());
    const Ran ran = bench.run({"repair", "in", "-o", "out"});
    QCOMPARE(ran.code, 2);
    QVERIFY(lineWith(ran, "sheet").contains("left open at 1 place, 0 of 1 holes filled, "));
    QVERIFY(lineWith(ran, "sheet").contains(". Loop 0 (8 edges) stays open: it is the outer edge of an open sheet"));
    QCOMPARE(bench.run({"repair", "in/none.off", "in/a.off", "-o", "out"}).code, 1);
    QCOMPARE(bench.run({"repair", "in", "-o", "out", "--rims", "fill", "--max-hole", "4"}).code, 2);
  }

  // A line of JSON for each, and one for a single file.
  void jsonLines() {
    const Bench bench;
    putGoodFiles(bench);
    const Ran ran = bench.run({"repair", "in/a.off", "in/sub", "-o", "out", "--json", "--format", "stl"});
    QCOMPARE(ran.code, 0);
    const QList<QByteArray> lines = ran.out.trimmed().split('\n');
    QCOMPARE(lines.size(), 3);
    QCOMPARE(Json::parse(lines[0].toStdString()).at("output").get<std::string>(), std::string("out/a.stl"));
    QCOMPARE(Json::parse(lines[2].toStdString()).at("output").get<std::string>(), std::string("out/c.stl"));
    QCOMPARE(bench.content("out/c.stl").size(), 84 + 4 * 50);  // binary: header, count, four triangles
    const Ran one = bench.run({"repair", "in/a.off", "-o", "x.ply", "--json"});
    const Json said = Json::parse(one.out.toStdString());
    QCOMPARE(said.at("state").get<std::string>(), std::string("closed"));
    QCOMPARE(said.at("filled").get<int>(), 1);
    QVERIFY(said.at("reason").is_null());
  }

  void jobsChangeNothing() {
    const Bench bench;
    putGoodFiles(bench);
    putInto(bench, "in/bad.ply", "ply\nformat nonsense\n");
    putInto(bench, "in/box.off", holedBox().off());
    QCOMPARE(bench.run({"repair", "in", "-o", "one", "-j", "1"}).code, 1);
    QCOMPARE(bench.run({"repair", "in", "-o", "two", "-j2"}).code, 1);
    const auto comparable = [&](const char* report) {
      Json json = bench.json(report);
      json.at("summary").erase("seconds");
      for (Json& file : json.at("files")) {
        file.erase("seconds");
        file.at("output") = file.at("output").get<std::string>().substr(4);  // after "one/", "two/"
      }
      return json;
    };
    QVERIFY(comparable("one/repair-report.json") == comparable("two/repair-report.json"));
    for (const char* name : {"a.off", "box.off", "sub/b.off", "sub/c.off"}) {
      QVERIFY(!bench.content(QString("one/") + name).isEmpty());
      QCOMPARE(bench.content(QString("one/") + name), bench.content(QString("two/") + name));
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
    row({"in", "-o", "in/a.off"}, "in/a.off is no folder, ");
    row({"in", "-o", "new.stl"}, "new.stl is no folder, ");
    row({"in", "odd.mesh", "-o", "out", "--report", "odd.mesh"}, "odd.mesh is an input too.");
    row({"in", "-o", "out", "--report", "no/such/r.json"}, "There is no folder no/such for the report.");
    row({"in", "-o", "out", "--report", "r.stl"}, "--report takes a name such as parts.json, ");
    row({"empty", "-o", "out"}, "No mesh file was found.");
    row({"in", "-o", "out", "-j", "0"}, "--jobs takes a number from 1 to 64.");
    row({"in", "-o", "out", "-j", "65"}, "--jobs takes a number from 1 to 64.");
    row({"in", "-o", "out", "--time-limit", "nan"}, "--time-limit takes a number of seconds above zero.");
    row({"in", "-o", "out", "--format", "docx"}, "--format takes ");
    row({"in", "-o", "out", "--keep-open", "1"}, "--keep-open is for one file at a time.");
    row({"in", "-o", "out", "--fill", "x"}, "--fill takes ");
    row({"in"}, "The option -o OUT is missing.");
  }

  void nothingIsOverwritten() {
    QFETCH(QStringList, words);
    QFETCH(QByteArray, sentence);
    const Bench bench;
    for (const char* name : {"in/a.off", "in/x.off", "in/x.obj", "in2/a.off", "empty/a.txt", "hard/y.txt"}) {
      putInto(bench, name, cube().off());
    }
    bench.put("odd.mesh", cube().off());
    QVERIFY(QFile::link(bench.path() + "/in", bench.path() + "/linked"));
    QCOMPARE(::link(qPrintable(bench.path() + "/in/a.off"), qPrintable(bench.path() + "/hard/a.off")), 0);
    const QStringList before = bench.names();
    const Ran ran = bench.run(QStringList{"repair"} + words);
    QCOMPARE(ran.code, 1);
    QVERIFY2(ran.err.startsWith("handwheel: " + sentence), ran.err);
    QCOMPARE(ran.out, QByteArray());
    QCOMPARE(bench.names(), before);
    QCOMPARE(bench.content("in/a.off"), cube().off());
  }

  // The output lies in the folder that is searched: what an earlier run wrote there is no input.
  void outputInsideTheInput() {
    const Bench bench;
    putGoodFiles(bench);
    for (int run = 0; run < 2; ++run) {
      QCOMPARE(bench.run({"repair", ".", "-o", "out"}).code, 0);
      QCOMPARE(bench.json("out/repair-report.json").at("files").size(), std::size_t(3));
    }
    QVERIFY(QFile::exists(bench.path() + "/out/in/sub/b.off"));
  }

  void fileNamedTwiceIsTakenOnce() {
    const Bench bench;
    putGoodFiles(bench);
    QCOMPARE(bench.run({"repair", "in/a.off", "./in/sub/../a.off", "in", "-o", "out"}).code, 0);
    QCOMPARE(states(bench.json("out/repair-report.json")),
             (QStringList{"in/a.off closed", "in/sub/b.off closed", "in/sub/c.off closed"}));
  }

  // Whatever bytes a name has, its file is repaired and its line is one.
  void anyName() {
    const Bench bench;
    QVERIFY(QDir(bench.path()).mkpath("in"));
    const QByteArray folder = QFile::encodeName(bench.path());
    const QList<QByteArray> names{"-o.off", "two\nlines.off", "\xff\xfe.off", "a b'\"\\.OFF"};
    for (const QByteArray& name : names) {
      std::FILE* file = std::fopen((folder + "/in/" + name).constData(), "w");
      QVERIFY(file && std::fputs(cube().off().constData(), file) >= 0);
      std::fclose(file);
    }
    const Ran ran = bench.run({"repair", "in", "-o", "out", "-j", "4"});
    QCOMPARE(ran.code, 0);
    QCOMPARE(ran.out.count("closed, 0 of 0 holes filled"), 4);
    QCOMPARE(ran.out.count('\n'), 4 + 6);  // with the table
    for (const QByteArray& name : names) QCOMPARE(::access((folder + "/out/" + name).constData(), R_OK), 0);
    QCOMPARE(bench.run({"repair", "in", "-o", "out", "--resume"}).code, 0);
    QCOMPARE(bench.json("out/repair-report.json").at("files").size(), std::size_t(4));
    for (const char* place : {"in/", "out/"}) QCOMPARE(::unlink((folder + "/" + place + names[2]).constData()), 0);
  }

  void resumesWhatWasKilled() {
    const Bench bench;
    putGoodFiles(bench);
    putInto(bench, "in/large.off", largeTube());
    Batch batch(bench, {"in", "-o", "out"});
    QTRY_VERIFY_WITH_TIMEOUT(batch.childFor("in/large.off") != 0, 30000);
    const pid_t child = batch.childFor("in/large.off");
    QVERIFY(tellsOf(bench, "in/a.off"));
    batch.send(SIGKILL);
    QCOMPARE(batch.finish().code, -1);
    QTRY_VERIFY(isGone(child));  // it does not outlive the batch
    QCOMPARE(bench.json("out/repair-report.json").at("summary").at("not_done").get<int>(), 3);
    QVERIFY(!QFile::exists(bench.path() + "/out/large.off"));

    const QDateTime written = QFileInfo(bench.path() + "/out/a.off").lastModified();
    const Ran ran = bench.run({"repair", "in", "-o", "out", "--resume"});
    QVERIFY(ran.code == 0 || ran.code == 2);
    QVERIFY(lineWith(ran, "in/a.off").endsWith(" (done before)"));
    QCOMPARE(ran.out.count("done before"), 1);
    QCOMPARE(QFileInfo(bench.path() + "/out/a.off").lastModified(), written);
    QCOMPARE(bench.json("out/repair-report.json").at("summary").at("not_done").get<int>(), 0);
    QCOMPARE(QDir(bench.path() + "/out").entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
             (QStringList{"a.off", "large.off", "repair-report.json", "sub"}));
  }

  void resumeDoesWhatHasChanged() {
    const Bench bench;
    putGoodFiles(bench);
    putInto(bench, "in/bad.off", "OFF\nnonsense\n");
    const auto doneBefore = [&](const QStringList& more) {
      const Ran ran = bench.run(QStringList{"repair", "in", "-o", "out", "--resume"} + more);
      return ran.code == 1 ? ran.out.count("done before") : -1;
    };
    QCOMPARE(doneBefore({}), 0);  // there is no earlier run
    QCOMPARE(doneBefore({}), 3);  // what failed is tried again
    QCOMPARE(doneBefore({"-j", "2", "--time-limit", "1000"}), 3);
    QVERIFY(QFile::remove(bench.path() + "/out/a.off"));
    QCOMPARE(doneBefore({}), 2);
    putInto(bench, "in/sub/b.off", cube(2.0).off() + "\n");
    QCOMPARE(doneBefore({}), 2);
    const utimbuf earlier{1000, 1000};
    QCOMPARE(::utime(qPrintable(bench.path() + "/in/a.off"), &earlier), 0);
    QCOMPARE(doneBefore({}), 2);
    putInto(bench, "out/sub/c.off", "cut short");
    QCOMPARE(doneBefore({}), 2);
    QCOMPARE(doneBefore({"--fill", "ear"}), 0);
    QCOMPARE(doneBefore({"--fill=ear"}), 3);
    QCOMPARE(bench.json("out/repair-report.json").at("options").at(0).get<std::string>(), std::string("--fill=ear"));
  }

  void reportThatIsNone_data() {
    QTest::addColumn<QByteArray>("content");
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("text") << QByteArray("my thesis");
    QTest::newRow("other JSON") << QByteArray("{\"before\": 1}");
    QTest::newRow("a list") << QByteArray("[]");
    QTest::newRow("files of another kind") << QByteArray("{\"batch\": \"1\", \"files\": {}}");
    QTest::newRow("deep") << QByteArray(100000, '[');
  }
  void reportThatIsNone() {
    QFETCH(QByteArray, content);
    const Bench bench;
    putGoodFiles(bench);
    bench.put("r.json", content);
    const Ran ran = bench.run({"repair", "in", "-o", "out", "--report", "r.json", "--resume"});
    QCOMPARE(ran.code, 1);
    QVERIFY2(ran.err.startsWith("handwheel: r.json is no report to resume from: "), ran.err);
    QCOMPARE(bench.content("r.json"), content);
  }

  // Entries that make no sense are as if they were not there.
  void reportWithNonsense() {
    const Bench bench;
    putGoodFiles(bench);
    QCOMPARE(bench.run({"repair", "in", "-o", "out"}).code, 0);
    Json report = bench.json("out/repair-report.json");
    report["files"][0]["input_bytes"] = "many";
    report["files"][1]["state"] = 7;
    report["files"].push_back(nullptr);
    report["files"].push_back({{"state", "closed"}, {"notes", 3}, {"seconds", "x"}});
    bench.put("out/repair-report.json", QByteArray::fromStdString(report.dump()));
    const Ran ran = bench.run({"repair", "in", "-o", "out", "--resume"});
    QCOMPARE(ran.code, 0);
    QCOMPARE(ran.out.count("done before"), 1);
    QVERIFY(lineWith(ran, "in/sub/c.off").endsWith("(done before)"));
  }

  // As a crash or the system would end it.
  void endedChildStopsNoOther_data() {
    QTest::addColumn<int>("signal");
    QTest::addColumn<QByteArray>("reason");
    QTest::newRow("killed") << SIGKILL << QByteArray("The system ended its process; memory may have run out.");
    QTest::newRow("crashed") << SIGSEGV << QByteArray("Its process crashed (Segmentation fault).");
  }
  void endedChildStopsNoOther() {
    QFETCH(int, signal);
    QFETCH(QByteArray, reason);
    const Bench bench;
    putGoodFiles(bench);
    putInto(bench, "in/large.off", largeTube());
    Batch batch(bench, {"in", "-o", "out", "-j", "2"});
    QTRY_VERIFY_WITH_TIMEOUT(batch.childFor("in/large.off") != 0, 30000);
    ::kill(batch.childFor("in/large.off"), signal);
    const Ran ran = batch.finish();
    QCOMPARE(ran.code, 1);
    QVERIFY2(ran.out.contains("in/large.off: failed: " + reason + "\n"), ran.out);
    QCOMPARE(states(bench.json("out/repair-report.json")),
             (QStringList{"in/a.off closed", "in/large.off failed", "in/sub/b.off closed", "in/sub/c.off closed"}));
    QVERIFY(!QFile::exists(bench.path() + "/out/large.off"));
  }

  // Also one that does not listen.
  void timeLimit() {
    const Bench bench;
    putGoodFiles(bench);
    putInto(bench, "in/large.off", largeTube());
    Batch batch(bench, {"in", "-o", "out", "--time-limit", "5"});
    QTRY_VERIFY_WITH_TIMEOUT(batch.childFor("in/large.off") != 0, 30000);
    ::kill(batch.childFor("in/large.off"), SIGSTOP);
    const Ran ran = batch.finish();
    QCOMPARE(ran.code, 1);
    QVERIFY2(ran.out.contains("in/large.off: failed: It took longer than 5 s.\n"), ran.out);
    QCOMPARE(ran.out.count(": closed"), 3);
  }

  void interrupt_data() {
    QTest::addColumn<int>("signal");
    QTest::addColumn<bool>("isDeaf");
    QTest::newRow("SIGINT") << SIGINT << false;
    QTest::newRow("SIGTERM") << SIGTERM << false;
    QTest::newRow("a child does not listen") << SIGINT << true;
  }
  void interrupt() {
    QFETCH(int, signal);
    QFETCH(bool, isDeaf);
    const Bench bench;
    putGoodFiles(bench);
    for (const char* name : {"in/large1.off", "in/large2.off"}) putInto(bench, name, largeTube());
    putInto(bench, "out/large1.off", "what was there before");
    Batch batch(bench, {"in", "-o", "out", "-j", "2"});
    QTRY_VERIFY_WITH_TIMEOUT(batch.childFor("in/large1.off") != 0 && batch.childFor("in/large2.off") != 0, 30000);
    const QList<pid_t> children = batch.children();
    if (isDeaf) ::kill(children.front(), SIGSTOP);
    batch.send(signal);
    const Ran ran = batch.finish();
    QCOMPARE(ran.code, 130);
    QCOMPARE(ran.err,
             QByteArray("handwheel: Cancelled after 1 of 5 files. With --resume the next run does the rest.\n"));
    for (pid_t child : children) QVERIFY(isGone(child));
    QCOMPARE(QDir(bench.path() + "/out").entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
             (QStringList{"a.off", "large1.off", "repair-report.json"}));
    QCOMPARE(bench.content("out/large1.off"), QByteArray("what was there before"));
    const Ran next = bench.run({"repair", "in", "-o", "out", "-j", "2", "--resume"});
    QVERIFY(next.code == 0 || next.code == 2);
    QCOMPARE(next.out.count("done before"), 1);
  }
};

QTEST_GUILESS_MAIN(BatchRepairTest)
#include "BatchRepairTest.moc"
