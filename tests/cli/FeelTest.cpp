// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Program.h"
#include "Shapes.h"
#include "TestClass.h"

#include <QTest>

#include <cmath>
#include <map>
#include <string>
#include <vector>

using namespace handwheel;

namespace {

using Row = std::map<std::string, double>;

std::vector<Row> rowsOf(const QByteArray& csv) {
  const QList<QByteArray> lines = csv.trimmed().split('\n');
  const QList<QByteArray> names = lines.first().split(',');
  std::vector<Row> rows;
  for (const QByteArray& line : lines.mid(1)) {
    const QList<QByteArray> words = line.split(',');
    Row row;
    for (qsizetype i = 0; i < names.size(); ++i) row[names[i].toStdString()] = words[i].toDouble();
    rows.push_back(std::move(row));
  }
  return rows;
}

// Down onto the middle of a cube of 2 mm, in 100 ms 1 mm deep, and up again.
const QByteArray kPress =
    "t_s,x_mm,y_mm,z_mm\n"
    "0,0.9,1.1,3\n"
    "0.2,0.9,1.1,1\n"
    "0.4,0.9,1.1,3\n";

QByteArray lines(const QByteArray& csv) {
  return csv.left(csv.indexOf('\n'));
}

}  // namespace

class FeelTest : public QObject {
  Q_OBJECT

 private slots:
  // F = k (proxy - tip) - B v, at each tick of 1 ms.
  void isTheSpringAndTheDamper() {
    const Fixture fixture;
    fixture.put("cube.off", cube(2).off());
    fixture.put("p.csv", kPress);
    const Ran ran = fixture.run(
        {"feel", "cube.off", "--path", "p.csv", "--out", "f.csv", "--stiffness", "0.7", "--damping", "0.002"},
        "de_DE.UTF-8");
    QCOMPARE(ran.err, QByteArray());
    QCOMPARE(ran.code, 0);
    const QByteArray csv = fixture.content("f.csv");
    QCOMPARE(lines(csv), QByteArray("t_s,hip_x,hip_y,hip_z,proxy_x,proxy_y,proxy_z,force_x,force_y,force_z,contact,"
                                    "tick_us"));
    const std::vector<Row> rows = rowsOf(csv);
    QCOMPARE(rows.size(), std::size_t{401});
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Row& row = rows[i];
      const double t = 0.001 * static_cast<double>(i);
      const double z = t < 0.2 ? 3 - 10 * t : 1 + 10 * (t - 0.2);
      QVERIFY(std::abs(row.at("t_s") - t) < 1e-12);
      QVERIFY(std::abs(row.at("hip_z") - z) < 1e-12);
      if (std::abs(z - 2) < 1e-6) continue;
      const bool inside = z < 2;
      const double speed = i <= 200 ? -10 : 10;
      const double force = inside ? std::max(0.0, 0.7 * (2 - z) - 0.002 * speed) : 0.0;
      QCOMPARE(row.at("contact"), inside ? 1.0 : 0.0);
      QVERIFY(std::abs(row.at("proxy_z") - (inside ? 2.0 : z)) < 1e-6);
      QVERIFY(std::abs(row.at("force_z") - force) < 1e-6);
      QVERIFY(std::abs(row.at("force_x")) + std::abs(row.at("force_y")) < 1e-6);
    }
  }

  // A body of a cell is felt where it stands: pressed 1 mm deep into the top of a box of 20 mm, 100 mm beside the
  // robot.
  void aBodyOfACell() {
    const Fixture fixture;
    fixture.put("r.urdf", "<robot name='r'><link name='base'/></robot>");
    const Ran added =
        fixture.run({"body", "r.urdf", "--add", "box:20,20,20", "--at", "100,0,10", "-o", "cell.handwheel"});
    QVERIFY2(added.code == 0, added.err);
    fixture.put("p.csv", "t_s,x_mm,y_mm,z_mm\n0,101,3,22\n0.3,101,3,19\n");
    const Ran ran = fixture.run({"feel", "cell.handwheel", "--path", "p.csv", "--out", "-", "--stiffness", "0.7"});
    QVERIFY2(ran.code == 0, ran.err);
    const Row last = rowsOf(ran.out).back();
    QVERIFY(std::abs(last.at("force_z") - 0.7) < 1e-6);
    QVERIFY(std::abs(last.at("proxy_z") - 20.0) < 1e-6);
    QVERIFY(std::abs(last.at("force_x")) + std::abs(last.at("force_y")) < 1e-6);
    const Ran snap = fixture.run({"feel", "cell.handwheel", "--path", "p.csv", "--snap", "spring"});
    QCOMPARE(snap.err, QByteArray("handwheel: Only meshes have open edges to snap to.\n"));
    QCOMPARE(snap.code, 0);
  }

  // The end of a bar of 50 mm is flat: the force is the spring's, along the axis.
  void theEndOfAWorkpiece() {
    const Fixture fixture;
    QCOMPARE(fixture.run({"new", "workpiece", "diameter=50", "length=100", "-o", "bar.handwheel"}).code, 0);
    QCOMPARE(fixture.run({"convert", "bar.handwheel", "bar.stl"}).code, 0);
    const auto box =
        nlohmann::json::parse(fixture.run({"inspect", "bar.stl", "--json"}).out.toStdString()).at("bounding_box_mm");
    const double end = box[1][2];  // the axis is z
    QCOMPARE(end - box[0][2].get<double>(), 100.0);
    const QByteArray outside = QByteArray::number(end + 2.0), inside = QByteArray::number(end - 1.0);
    fixture.put("p.csv", "t_s,x_mm,y_mm,z_mm\n0,7,3," + outside + "\n0.3,7,3," + inside + "\n");
    const Ran ran = fixture.run({"feel", "bar.handwheel", "--path", "p.csv", "--out", "-", "--stiffness", "0.4"});
    QVERIFY2(ran.code == 0, ran.err);
    const Row last = rowsOf(ran.out).back();
    QVERIFY(std::abs(last.at("force_z") - 0.4) < 1e-6);
    QVERIFY(std::abs(last.at("proxy_z") - end) < 1e-5);  // the skin goes with the size
  }

  void isTheSameAgain() {
    const Fixture fixture;
    fixture.put("cube.off", cube(2).off());
    fixture.put("p.csv", kPress);
    const auto run = [&] {
      std::vector<Row> rows = rowsOf(
          fixture.run({"feel", "cube.off", "--path", "p.csv", "--out", "-", "--friction", "0.3", "--rate", "4000"})
              .out);
      for (Row& row : rows) row.erase("tick_us");
      return rows;
    };
    const std::vector<Row> first = run();
    QCOMPARE(first.size(), std::size_t{1601});
    QVERIFY(first == run());
  }

  void saysWhatItFelt() {
    const Fixture fixture;
    fixture.put("cube.off", cube(2).off());
    fixture.put("p.csv", kPress);
    const Ran ran = fixture.run({"feel", "cube.off", "--path", "p.csv"});
    QCOMPARE(ran.code, 0);
    QVERIFY(ran.out.contains("Ticks        401\n"));
    QVERIFY(ran.out.contains("Peak force   0.5 N\n"));
  }

  // Each option of its own goes before.
  void readsTheSettings() {
    const Fixture fixture;
    fixture.put("cube.off", cube(2).off());
    fixture.put("p.csv", kPress);
    const QStringList words{"feel", "cube.off", "--path", "p.csv"};
    const Ran ran = fixture.run(words + QStringList{"--fidelity", "contact.stiffness=2,servo.rate=2000"});
    QCOMPARE(ran.code, 0);
    QVERIFY(ran.out.contains("Ticks        801\n"));
    QVERIFY(ran.out.contains("Peak force   2 N\n"));
    const Ran said = fixture.run(words + QStringList{"--fidelity", "contact.stiffness=2,servo.rate=2000", "--rate",
                                                     "1000", "--stiffness", "0.5"});
    QCOMPARE(said.out.left(said.out.indexOf("A tick")), [&] {
      const QByteArray plain = fixture.run(words).out;
      return plain.left(plain.indexOf("A tick"));
    }());
    // A proxy that may rest 1e-4 of the diagonal too soon is still pressed out by the plane that it meets.
    QVERIFY(
        fixture.run(words + QStringList{"--fidelity", "proxy.tolerance=1e-4"}).out.contains("Peak force   0.5 N\n"));
    for (const char* wrong : {"fast", "contact.stiffness=1e9", "servo.rate"}) {
      const Ran refused = fixture.run(words + QStringList{"--fidelity", wrong});
      QCOMPARE(refused.code, 1);
      QVERIFY(refused.err.endsWith("Try 'handwheel help feel'.\n"));
    }
  }

  // A setting that the command does not read would be taken for one that did something.
  void refusesSettingsThatItDoesNotRead() {
    const Fixture fixture;
    fixture.put("cube.off", cube(2).off());
    fixture.put("p.csv", kPress);
    for (const char* unread : {"servo.velocity_window=0.05", "contact.stiffness=2,mesh.near_weld=1e-4"}) {
      const Ran ran = fixture.run({"feel", "cube.off", "--path", "p.csv", "--fidelity", unread});
      QCOMPARE(ran.code, 1);
      QVERIFY2(ran.err.contains("does not use the setting"), ran.err);
      for (const char* id : {"proxy.tolerance", "contact.stiffness", "servo.rate"}) QVERIFY2(ran.err.contains(id), id);
    }
    QCOMPARE(fixture.run({"feel", "cube.off", "--path", "p.csv", "--fidelity", "exact"}).code, 0);
  }

  // The rule allows 8 N/mm at 8 kHz; the data sheet of the device says 3.
  void saysWhatTheCapComesFrom() {
    const Fixture fixture;
    fixture.put("cube.off", cube(2).off());
    fixture.put("p.csv", kPress);
    const QStringList words{"feel", "cube.off", "--path", "p.csv", "--device", "simulated", "--stiffness", "100"};
    const Ran fast = fixture.run(words + QStringList{"--rate", "8000"});
    QVERIFY2(fast.err.contains("capped at 3 N/mm"), fast.err);
    QVERIFY2(fast.err.contains("the limit of the device at any rate") && !fast.err.contains("stable"), fast.err);
    const Ran slow = fixture.run(words + QStringList{"--rate", "1000"});
    QVERIFY2(slow.err.contains("would not be stable on this device at 1000 Hz"), slow.err);
  }

  // 6 mm deep at 3 N/mm: 18 N asked, of a device that gives 8.
  void saysWhereTheForceIsCut() {
    const Fixture fixture;
    fixture.put("cube.off", cube(20).off());
    fixture.put("p.csv", "t_s,x_mm,y_mm,z_mm\n0,9,11,24\n0.5,9,11,14\n1,9,11,24\n");
    const QStringList words{"feel", "cube.off", "--path", "p.csv", "--stiffness", "3", "--rate", "8000"};
    const Ran cut = fixture.run(words + QStringList{"--device", "simulated"});
    QCOMPARE(cut.code, 0);
    QVERIFY(cut.out.contains("Peak force   8 N\n"));
    QCOMPARE(cut.err.count("limited to 8 N"), 1);
    QVERIFY2(cut.err.contains("up to 18 N"), cut.err);
    const Ran whole = fixture.run(words);
    QVERIFY2(whole.err.isEmpty(), whole.err);
    QVERIFY(whole.out.contains("Peak force   18 N\n"));
  }

  // Past the middle of the long side of an open rectangle, in the profile that was asked for: He 2008, figure 3-2a and
  // equations 3-1 to 3-3. Its four points are too far to draw.
  void snapsToOpenEdges_data() {
    QTest::addColumn<QByteArray>("profile");
    QTest::addColumn<int>("number");
    int number = 0;
    for (const char* profile : {"spring", "triangle", "quadratic", "gaussian"})
      QTest::newRow(profile) << QByteArray(profile) << number++;
  }
  void snapsToOpenEdges() {
    QFETCH(QByteArray, profile);
    QFETCH(int, number);
    const Fixture fixture;
    fixture.put("sheet.off", "OFF\n4 2 0\n0 0 0\n20 0 0\n20 10 0\n0 10 0\n3 0 1 2\n3 0 2 3\n");
    fixture.put("p.csv", "t_s,x_mm,y_mm,z_mm\n0,10,-9,0\n0.089,10,-0.1,0\n");
    const double k = 0.4, ls = 0.4 * 15.0;  // snap.radius times the mean of 20, 10, 20 and 10 mm
    const Ran ran = fixture.run({"feel", "sheet.off", "--path", "p.csv", "--out", "-", "--snap", profile,
                                 "--snap-stiffness", "0.4", "--fidelity", "snap.radius=0.4"});
    QVERIFY2(ran.err.isEmpty(), ran.err);
    const std::vector<Row> rows = rowsOf(ran.out);
    QCOMPARE(rows.size(), std::size_t{90});
    const auto g = [&](double x) { return std::exp(-0.5 * std::pow((x - ls / 2) / (ls / 6), 2)); };
    for (const Row& row : rows) {
      const double x = -row.at("hip_y");
      if (std::abs(x - ls) < 1e-9) continue;
      const double inside[] = {k * x, x < ls / 2 ? k * x : k * (ls - x), 2 * k * x * (ls - x) / ls,
                               k * ls / 2 * (g(x) - g(0)) / (1 - g(0))};
      QVERIFY(std::abs(row.at("force_y") - (x < ls ? inside[number] : 0.0)) < 1e-9);
      QVERIFY(std::abs(row.at("force_x")) + std::abs(row.at("force_z")) < 1e-9);
      QVERIFY(std::abs(row.at("proxy_y") - (x < ls ? 0.0 : -x)) < 1e-9);
    }
  }

  // Midway between two sides of a slit the proxy method has one of them; the forces of both add up to none.
  void snapsByTheSum() {
    const Fixture fixture;
    fixture.put("slit.off", "OFF\n6 2 0\n-50 -1 0\n50 -1 0\n0 -50 0\n-50 1 0\n50 1 0\n0 50 0\n3 0 2 1\n3 3 4 5\n");
    fixture.put("p.csv", "t_s,x_mm,y_mm,z_mm\n0,0,0,0\n0.01,0,0,0\n");
    const QStringList words{"feel", "slit.off", "--path", "p.csv", "--out", "-", "--snap", "triangle"};
    for (const Row& row : rowsOf(fixture.run(words + QStringList{"--snap-method", "proxy"}).out))
      QVERIFY(std::abs(std::abs(row.at("force_y")) - 0.3) < 1e-9);
    for (const Row& row : rowsOf(fixture.run(words + QStringList{"--snap-method", "force"}).out))
      QVERIFY(std::abs(row.at("force_y")) < 1e-9);
  }

  void snappingNeedsAProfileAndAnOpenEdge() {
    const Fixture fixture;
    fixture.put("cube.off", cube(2).off());
    fixture.put("p.csv", kPress);
    const QStringList words{"feel", "cube.off", "--path", "p.csv"};
    QVERIFY(fixture.run(words + QStringList{"--snap", "spring"}).err.contains("no open edge"));
    for (const QStringList& wrong :
         {QStringList{"--snap", "hook"}, QStringList{"--snap-method", "force"}, QStringList{"--snap-stiffness", "1"},
          QStringList{"--snap", "none", "--snap-method", "force"}, QStringList{"--fidelity", "snap.radius=1"},
          QStringList{"--snap", "spring", "--snap-method", "pull"},
          QStringList{"--snap", "spring", "--snap-stiffness", "-1"}})
      QCOMPARE(fixture.run(words + wrong).code, 1);
  }

  void writesToADevice() {
    const Fixture fixture;
    fixture.put("cube.off", cube(2).off());
    fixture.put("p.csv", kPress);
    const Ran ran = fixture.run({"feel", "cube.off", "--path", "p.csv", "--out", "/dev/null"});
    QVERIFY2(ran.err.isEmpty(), ran.err);
    QCOMPARE(ran.code, 0);
    QVERIFY(ran.out.contains("Ticks        401\n"));
  }

  // The device carries 1 N/mm at 1 kHz, and half of that at 500 Hz.
  void isCappedByADevice() {
    const Fixture fixture;
    fixture.put("cube.off", cube(2).off());
    fixture.put("p.csv", kPress);
    const Ran capped = fixture.run(
        {"feel", "cube.off", "--path", "p.csv", "--stiffness", "5", "--device", "simulated", "--rate", "500"});
    QCOMPARE(capped.code, 0);
    QVERIFY(capped.err.contains("capped at 0.5 N/mm"));
    QVERIFY(capped.out.contains("Peak force   0.5 N\n"));
    const Ran free = fixture.run({"feel", "cube.off", "--path", "p.csv", "--stiffness", "5"});
    QCOMPARE(free.err, QByteArray());
    QVERIFY(free.out.contains("Peak force   5 N\n"));
  }

  void readsColumnsByName() {
    const Fixture fixture;
    fixture.put("cube.off", cube(2).off());
    fixture.put("p.csv", "\xef\xbb\xbf# a comment\r\nname, z_mm ,t_s,x_mm,y_mm\r\n\r\na,5,0,1,2\r\nb,5,0.01,1,2\r\n");
    const std::vector<Row> rows = rowsOf(fixture.run({"feel", "cube.off", "--path", "p.csv", "--out", "-"}).out);
    QCOMPARE(rows.size(), std::size_t{11});
    QVERIFY(rows.back().at("hip_x") == 1 && rows.back().at("hip_y") == 2 && rows.back().at("hip_z") == 5);
  }

  void refusesWhatIsNoPath_data() {
    QTest::addColumn<QByteArray>("path");
    QTest::addColumn<QByteArray>("why");
    QTest::newRow("empty") << QByteArray() << QByteArray("no line of numbers");
    QTest::newRow("no names") << QByteArray("0,0,0,0\n") << QByteArray("Line 1: The first line must name");
    QTest::newRow("twice") << QByteArray("t_s,x_mm,y_mm,z_mm,x_mm\n0,0,0,0,1\n")
                           << QByteArray("Line 1: There are two columns x_mm");
    QTest::newRow("a word") << QByteArray("t_s,x_mm,y_mm,z_mm\n0,0,0,zero\n") << QByteArray("Line 2: 'zero' is not");
    QTest::newRow("NaN") << QByteArray("t_s,x_mm,y_mm,z_mm\n0,nan,0,0\n") << QByteArray("Line 2: 'nan' is not");
    QTest::newRow("infinity") << QByteArray("t_s,x_mm,y_mm,z_mm\n0,0,1e999,0\n") << QByteArray("Line 2: '1e999'");
    QTest::newRow("short") << QByteArray("t_s,x_mm,y_mm,z_mm\n0,0,0\n") << QByteArray("z_mm is missing");
    QTest::newRow("back in time") << QByteArray("t_s,x_mm,y_mm,z_mm\n1,0,0,0\n0.5,0,0,0\n")
                                  << QByteArray("Line 3: The time");
    QTest::newRow("too long") << QByteArray("t_s,x_mm,y_mm,z_mm\n0,0,0,0\n1e9,0,0,0\n") << QByteArray("ticks");
  }

  void refusesWhatIsNoPath() {
    QFETCH(QByteArray, path);
    QFETCH(QByteArray, why);
    const Fixture fixture;
    fixture.put("cube.off", cube(2).off());
    fixture.put("p.csv", path);
    const Ran ran = fixture.run({"feel", "cube.off", "--path", "p.csv", "--out", "f.csv"});
    QCOMPARE(ran.code, 1);
    QVERIFY2(ran.err.contains(why), ran.err.constData());
    QVERIFY(ran.err.contains("p.csv"));
    QCOMPARE(ran.err.count('\n'), 1);
    QVERIFY(!fixture.names().contains("f.csv"));
  }

  void refusesUnusableOptions() {
    const Fixture fixture;
    fixture.put("cube.off", cube(2).off());
    fixture.put("p.csv", kPress);
    QCOMPARE(fixture.run({"feel", "cube.off"}).code, 1);
    QCOMPARE(fixture.run({"feel", "cube.off", "--path", "missing.csv"}).code, 1);
    QCOMPARE(fixture.run({"feel", "missing.off", "--path", "p.csv"}).code, 1);
    for (const char* bad : {"--stiffness=-1", "--damping=nan", "--friction=a", "--rate=0", "--device=falcon"})
      QCOMPARE(fixture.run({"feel", "cube.off", "--path", "p.csv", bad}).code, 1);
    QCOMPARE(fixture.run({"feel", "cube.off", "--path", "p.csv", "--out", "cube.off"}).code, 1);
    QCOMPARE(fixture.content("cube.off"), QByteArray(cube(2).off()));
  }
};

HANDWHEEL_TEST(FeelTest)
#include "FeelTest.moc"
