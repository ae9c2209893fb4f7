// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BuildPaths.h"
#include "Program.h"
#include "Shapes.h"
#include "TestClass.h"

#include <QImage>
#include <QTest>
#include <clocale>
#include <csignal>
#include <set>

using namespace handwheel;

namespace {

const QStringList kChord{"measure", "nurbs.chord_mm", "--repeats", "1"};

// A finely cut ball of radius 1.
Shape ball(int n) {
  return grid(
      2 * n, n,
      [n](int x, int y) {
        const double u = M_PI * (x % (2 * n)) / n, v = M_PI * (y - n / 2.0) / (n + 1.0);
        return std::array<double, 3>{std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v)};
      },
      [](int, int) { return false; });
}

// The fields of a line of a CSV file; no field of ours holds a line feed.
QStringList fields(const QByteArray& line) {
  QStringList list{QString()};
  bool quoted = false;
  for (const QChar c : QString::fromUtf8(line)) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      list << QString();
    } else {
      list.back() += c;
    }
  }
  return list;
}

}  // namespace

class MeasureTest : public QObject {
  Q_OBJECT

 private slots:
  void list();
  void table();
  void csvHasItsColumns();
  void json();
  void plots();
  void budget();
  void usersFile();
  void curves();
  void repairReadsTheSettings();
  void wrongWords_data();
  void wrongWords();
  void wrongFiles();
  void sameUnderGermanLocale();
  void interrupted();
};

void MeasureTest::list() {
  const Fixture fixture;
  const Ran ran = fixture.run({"measure", "--list"});
  QCOMPARE(ran.code, 0);
  QCOMPARE(ran.err, QByteArray());
  for (const char* id : {"mesh.near_weld",
                         "mesh.fill_method",
                         "mesh.fill_continuity",
                         "mesh.patch_density",
                         "mesh.piece_edges",
                         "mesh.decimation_error",
                         "mesh.decimation_method",
                         "nurbs.chord_mm",
                         "step.chord",
                         "document.undo_granularity",
                         "view.block_faces",
                         "view.coarse_triangles",
                         "cell.shape_sides",
                         "ik.tolerance",
                         "plan.resolution",
                         "plan.shortcuts",
                         "verify.step",
                         "proximity.tolerance",
                         "snap.radius",
                         "snap.features",
                         "proxy.tolerance",
                         "contact.stiffness",
                         "servo.rate",
                         "servo.velocity_window"}) {
    QVERIFY2(ran.out.contains(QByteArray(id) + ": "), id);
  }
}

void MeasureTest::table() {
  const Fixture fixture;
  const Ran ran = fixture.run(kChord);
  QCOMPARE(ran.code, 0);
  QCOMPARE(ran.err, QByteArray());
  QVERIFY(ran.out.startsWith("nurbs.chord_mm: "));
  for (const char* words : {"\n  value ", "/ default", "closed form", "\n  Front",
                            "knee: ", "\n  Draft: ", "\n  Balanced: ", "\n  Exact: ", "\n  Default: "}) {
    QVERIFY2(ran.out.contains(words), words);
  }
  QVERIFY(!ran.out.contains("mesh."));
  QVERIFY(!ran.out.contains("Fit for"));
}

void MeasureTest::csvHasItsColumns() {
  const Fixture fixture;
  QCOMPARE(fixture.run(kChord + QStringList{"--csv", "a.csv", "--steps", "4"}).code, 0);
  const QList<QByteArray> lines = fixture.content("a.csv").trimmed().split('\n');
  QCOMPARE(lines[0], QByteArray("setting,value,case,error,error_unit,cost,cost_unit,spread,repeats,seed,truth"));
  std::set<QString> cases;
  double last = 0.0;
  for (const QByteArray& line : lines.mid(1)) {
    const QStringList f = fields(line);
    QCOMPARE(f.size(), 11);
    QCOMPARE(f[0], QString("nurbs.chord_mm"));
    // Triangles keep the tolerance that they were asked to keep.
    QVERIFY(f[3].toDouble() > 0.0 && f[3].toDouble() <= f[1].toDouble());
    QCOMPARE(f[4], QString("mm"));
    QVERIFY(f[5].toDouble() > 0.0);
    QCOMPARE(f[6], QString("ms"));
    QCOMPARE(f[8], QString("1"));
    QVERIFY(cases.insert(f[2]).second || f[1].toDouble() > last);  // ascending in each case
    last = f[1].toDouble();
  }
  QVERIFY(cases.size() >= 2);
  QVERIFY(lines.size() >= int(1 + 4 * cases.size()));
}

void MeasureTest::json() {
  const Fixture fixture;
  const Ran ran = fixture.run(kChord + QStringList{"--json", "--budget", "ms=1000"});
  QCOMPARE(ran.code, 0);
  const auto all = nlohmann::json::parse(ran.out.toStdString());
  QCOMPARE(all.at("settings").size(), std::size_t{1});
  const auto& setting = all.at("settings")[0];
  QVERIFY(setting.at("setting") == "nurbs.chord_mm");
  QVERIFY(setting.at("front").size() >= 2);
  for (const char* preset : {"Draft", "Balanced", "Exact"}) {
    QVERIFY(setting.at("presets").at(preset).at("error").get<double>() > 0.0);
  }
  // Everything is affordable: the fit is the most accurate of all.
  double least = 1e300;
  for (const auto& row : setting.at("rows")) least = std::min(least, std::stod(row.at("value").get<std::string>()));
  QCOMPARE(std::stod(setting.at("fit").at("value").get<std::string>()), least);
}

void MeasureTest::plots() {
  const Fixture fixture;
  QCOMPARE(fixture.run(kChord + QStringList{"--plot", "a.png"}).code, 0);
  QCOMPARE(fixture.run(kChord + QStringList{"--dark", "--plot=b.png"}).code, 0);
  const QImage light(fixture.path() + "/a.png"), dark(fixture.path() + "/b.png");
  QVERIFY(light.width() > 400 && light.height() > 300);
  QCOMPARE(light.size(), dark.size());
  QVERIFY(light.pixelColor(2, 2).lightness() > 200 && dark.pixelColor(2, 2).lightness() < 60);
  QCOMPARE(fixture.run(kChord + QStringList{"--plot", "a.svg"}).code, 0);
  QVERIFY(fixture.content("a.svg").contains("<svg"));
  QVERIFY(fixture.content("a.svg").contains("nurbs.chord_mm"));
}

void MeasureTest::budget() {
  const Fixture fixture;
  const Ran rich = fixture.run(kChord + QStringList{"--budget", "us=1,ms=1000"});
  QCOMPARE(rich.code, 0);
  QVERIFY(rich.out.contains("Fit for 1e+03 ms: 1e-04 ("));
  const Ran poor = fixture.run(kChord + QStringList{"--budget", "ms=1e-9"});
  QCOMPARE(poor.code, 2);
  QVERIFY(poor.out.contains("Fit for 1e-09 ms: none"));
  QCOMPARE(poor.err, QByteArray("handwheel: No value of nurbs.chord_mm keeps within the budget.\n"));
}

void MeasureTest::usersFile() {
  const Fixture fixture;
  fixture.put("ball.off", ball(40).off());
  const Ran ran = fixture.run(
      {"measure", "mesh.fill_method", "--repeats", "1", "--json", "--input", "ball.off", "--input", "ball.off"});
  QCOMPARE(ran.code, 0);
  const auto all = nlohmann::json::parse(ran.out.toStdString());
  int own = 0;
  double ear = 0.0, fair = 0.0;
  for (const auto& row : all.at("settings")[0].at("rows")) {
    if (!row.at("case").get<std::string>().starts_with("ball.off")) continue;
    QVERIFY(row.at("truth") == "surface cut out");
    if (row.at("value") == "ear") ear = row.at("error");
    if (row.at("value") == "fair") fair = row.at("error");
    ++own;
  }
  QVERIFY(own >= 8);          // both times, each method
  QVERIFY(ear > 2.0 * fair);  // flat lids do not fit a ball
}

void MeasureTest::curves() {
  const Fixture fixture;
  QCOMPARE(fixture.run(kChord + QStringList{"--write-curves", "."}).code, 0);
  QCOMPARE(fixture.names(), QStringList{"nurbs.chord_mm.json"});
  const auto curve = fixture.json("nurbs.chord_mm.json");
  QVERIFY(curve.at("setting") == "nurbs.chord_mm");
  QVERIFY(!curve.at("machine").get<std::string>().empty());
  QVERIFY(curve.at("rows").size() >= 18);
}

// Two halves of a sheet, torn apart by 1e-4 of the diagonal: a matter of mesh.near_weld. A hole in a ball: a matter of
// the method and the density.
void MeasureTest::repairReadsTheSettings() {
  const Fixture fixture;
  Shape sheet = flatSheet(4);
  sheet.add(flatSheet(4), {4.0 + 1e-4 * std::sqrt(80.0), 0, 0});
  fixture.put("torn.off", sheet.off());
  const auto merged = [&](const QStringList& more) {
    fixture.run(QStringList{"repair", "torn.off", "-o", "b.off", "--report", "r.json"} + more);
    return fixture.json("r.json").at("merged_vertices").get<int>();
  };
  QCOMPARE(merged({}), 0);
  QCOMPARE(merged({"--fidelity", "mesh.near_weld=1e-3"}), 5);

  Shape holed = ball(40);
  holed.faces.resize(holed.faces.size() - 2 * 80 * 4);  // the cap around the north pole
  fixture.put("holed.off", holed.off());
  const auto newFaces = [&](const QStringList& more) {
    fixture.run(QStringList{"repair", "holed.off", "-o", "b.off", "--report", "r.json"} + more);
    const auto report = fixture.json("r.json");
    int sum = 0;
    for (const auto& loop : report.at("loops")) sum += loop.at("new_faces").get<int>();
    return sum;
  };
  const int standard = newFaces({}), draft = newFaces({"--fidelity", "draft"}),
            ear = newFaces({"--fidelity", "exact,mesh.fill_method=ear"});
  QVERIFY(ear < draft && draft < standard);
  QCOMPARE(newFaces({"--fidelity", "exact,mesh.fill_method=ear", "--fill", "fair"}), newFaces({"--fidelity", "exact"}));

  for (const char* wrong : {"fast", "mesh.near_weld=7", "mesh.near_weld", "mesh.fill_method=round"}) {
    const Ran ran = fixture.run({"repair", "torn.off", "-o", "c.off", "--fidelity", wrong});
    QCOMPARE(ran.code, 1);
    QVERIFY(ran.err.endsWith("Try 'handwheel help repair'.\n"));
    QVERIFY(!fixture.names().contains("c.off"));
  }
}

void MeasureTest::wrongWords_data() {
  QTest::addColumn<QStringList>("words");
  QTest::addColumn<QByteArray>("complaint");
  const QByteArray budget = "--budget takes numbers above zero: us=50,ms=16,mb=200.";
  const QByteArray plot = "--plot takes a name that ends in .png, .svg or .csv.";
  QTest::newRow("setting") << QStringList{"mesh.near"}
                           << QByteArray("There is no setting mesh.near; 'handwheel measure --list' names them.");
  for (const char* words :
       {",", "16", "ms", "ms=", "ms=x", "s=3", "ms=-1", "ms=0", "ms=nan", "ms=inf", "ms=1,", "ms=1 "}) {
    QTest::newRow((QByteArray("budget ") + words).constData()) << QStringList{"--budget", words} << budget;
  }
  QTest::newRow("plot") << QStringList{"--plot", "a.bmp"} << plot;
  QTest::newRow("no ending") << QStringList{"--plot", "png"} << plot;
  QTest::newRow("steps") << QStringList{"--steps", "0"} << QByteArray("--steps takes a number from 1 to 1000.");
  QTest::newRow("repeats") << QStringList{"--repeats=many"} << QByteArray("--repeats takes a number from 1 to 1000.");
}

void MeasureTest::wrongWords() {
  QFETCH(QStringList, words);
  QFETCH(QByteArray, complaint);
  const Fixture fixture;
  const Ran ran = fixture.run(QStringList{"measure"} + words);
  QCOMPARE(ran.code, 1);
  QCOMPARE(ran.out, QByteArray());
  QCOMPARE(ran.err, "handwheel: " + complaint + "\nTry 'handwheel help measure'.\n");
}

void MeasureTest::wrongFiles() {
  const Fixture fixture;
  fixture.put("letter.txt", "Dear Sir or Madam\n");
  for (const char* name : {"none.stl", "letter.txt"}) {
    const Ran ran = fixture.run(kChord + QStringList{"--input", name});
    QCOMPARE(ran.code, 1);
    QCOMPARE(ran.out, QByteArray());
    QVERIFY(ran.err.startsWith(QByteArray("handwheel: ") + name));
  }
  for (const char* option : {"--csv", "--write-curves"}) {
    const Ran ran = fixture.run(kChord + QStringList{option, "none/a"});
    QCOMPARE(ran.code, 1);
    QCOMPARE(ran.err.count('\n'), 1);
  }
}

void MeasureTest::sameUnderGermanLocale() {
  const char* const german = "de_DE.UTF-8";
  if (!std::setlocale(LC_ALL, german)) QSKIP("the locale de_DE.UTF-8 is not installed");
  std::setlocale(LC_ALL, "C");
  const Fixture fixture;
  QCOMPARE(fixture.run({"measure", "--list"}, german).out, fixture.run({"measure", "--list"}).out);
  QCOMPARE(fixture.run(kChord + QStringList{"--plot", "a.svg", "--csv", "a.csv"}, german).code, 0);
  QVERIFY(fixture.content("a.csv").contains(",0.01,"));
  QVERIFY(fixture.content("a.svg").contains(">0.01</text>"));
}

void MeasureTest::interrupted() {
  const Fixture fixture;
  QProcess process;
  process.setWorkingDirectory(fixture.path());
  process.start(test::programPath(), {"measure", "--repeats", "1000", "--csv", "a.csv"});
  QVERIFY(process.waitForStarted());
  QTRY_VERIFY_WITH_TIMEOUT(catches(process.processId(), SIGINT), 30000);
  QTest::qWait(1500);  // into the middle of it
  ::kill(static_cast<pid_t>(process.processId()), SIGINT);
  QVERIFY(process.waitForFinished(kLongestRun));
  QCOMPARE(process.exitStatus(), QProcess::NormalExit);
  QCOMPARE(process.exitCode(), 130);
  QCOMPARE(process.readAllStandardError(), QByteArray("handwheel: Cancelled.\n"));
  QVERIFY(fixture.names().isEmpty());
}

HANDWHEEL_TEST(MeasureTest)
#include "MeasureTest.moc"
