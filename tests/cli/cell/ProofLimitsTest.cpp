// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PlannedCell.h"
#include "TestClass.h"

#include <QTest>

using namespace handwheel;

namespace {

const QByteArray kCapsule =
    "<robot name='cap'><link name='b'/><link name='l'><collision><geometry><capsule radius='0.1' length='0.3'/>"
    "</geometry></collision></link><joint name='j' type='revolute'><parent link='b'/><child link='l'/>"
    "<limit lower='-1' upper='1' effort='0' velocity='0'/></joint></robot>";

// A cube of 20 mm on a slide along x.
const QByteArray kGantry =
    "<robot name='gantry'><link name='base'/><link name='tool'><collision><geometry><box size='0.02 0.02 0.02'/>"
    "</geometry></collision></link><joint name='x' type='prismatic'><parent link='base'/><child link='tool'/>"
    "<axis xyz='1 0 0'/><limit lower='-1' upper='1' velocity='1' effort='1'/></joint></robot>";

// The third link turns through the first one, on which it lies at rest.
const QByteArray kFolded =
    "<robot name='folded'><link name='base'/>"
    "<link name='upper'><collision><origin xyz='0.2 0 0'/><geometry><box size='0.4 0.04 0.04'/></geometry></collision>"
    "</link><link name='elbow'><collision><geometry><sphere radius='0.03'/></geometry></collision></link>"
    "<link name='fore'><collision><origin xyz='-0.2 0 0.02'/><geometry><box size='0.3 0.04 0.03'/></geometry>"
    "</collision></link><joint name='j1' type='revolute'><parent link='base'/><child link='upper'/><axis xyz='0 0 1'/>"
    "<limit lower='-3' upper='3' velocity='1' effort='1'/></joint><joint name='j2' type='revolute'>"
    "<parent link='upper'/><child link='elbow'/><origin xyz='0.4 0 0'/><axis xyz='0 0 1'/>"
    "<limit lower='-3' upper='3' velocity='1' effort='1'/></joint><joint name='j3' type='prismatic'>"
    "<parent link='elbow'/><child link='fore'/><axis xyz='0 0 1'/>"
    "<limit lower='0' upper='0.3' velocity='1' effort='1'/></joint></robot>";

}  // namespace

// Proofs name what they leave out, and prove nothing where a shape is unknown.
class ProofLimitsTest : public QObject {
  Q_OBJECT

 private slots:
  void shapesThatWereNotRead() {
    const PlannedCell cell;
    cell.put("cap.urdf", kCapsule);
    const auto change = [&](const QStringList& words) {
      return cell.run(words + QStringList{"-o", "c.handwheel"}).code;
    };
    QVERIFY(change({"configuration", "cap.urdf", "--add", "a", "--joints", "j=-0.5"}) != 1);
    QVERIFY(change({"configuration", "c.handwheel", "--add", "c", "--joints", "j=0.5"}) != 1);
    const QStringList plan{"plan", "c.handwheel", "--from", "a", "--to", "c"};
    const Ran open = cell.run(plan + QStringList{"-o", "p.json", "--json"});
    QCOMPARE(open.code, 2);
    const nlohmann::json missing = jsonOf(open.out);
    QVERIFY(!missing["certified"].get<bool>());
    QCOMPARE(missing["missing_shapes"][0]["part"].get<std::string>(), std::string("l"));
    QCOMPARE(missing["missing_shapes"][0]["shape"].get<std::string>(), std::string("capsule"));
    const Ran verified = cell.run({"verify", "c.handwheel", "p.json"});
    QVERIFY2(verified.code == 2 && verified.out.contains("not proven free") &&
                 verified.out.contains("l: its shape (capsule)"),
             verified.out);
    const QStringList post{"post", "c.handwheel", "p.json", "--controller", "csv", "-o", "p.csv"};
    const Ran refused = cell.run(post);
    QVERIFY2(refused.code == 1 && refused.err.contains("the shape of l (capsule) could not be read"), refused.err);
    // It is left out knowingly, and every proof says so.
    QCOMPARE(change({"set", "c.handwheel", "missing.l=left out"}), 0);
    const Ran leftOut = cell.run({"verify", "c.handwheel", "p.json"});
    QVERIFY2(leftOut.code == 0 && leftOut.out.contains("l: its shape (capsule) could not be read, and is left out"),
             leftOut.out);
    const Ran written = cell.run(post);
    QVERIFY2(written.code == 0 && cell.read("p.csv").contains("Shape not read: l (capsule), left out of the proof."),
             written.err + cell.read("p.csv"));
    const nlohmann::json inspected = jsonOf(cell.run({"inspect", "c.handwheel", "--json"}).out)["document"];
    QCOMPARE(inspected["missing_shapes"][0]["state"].get<std::string>(), std::string("left out"));
    // A body that the link carries replaces it.
    QCOMPARE(change({"body", "c.handwheel", "--add", "cylinder:100,500", "--name", "capsule"}), 0);
    QCOMPARE(change({"set", "c.handwheel", "body.capsule.carrier=l"}), 0);
    QCOMPARE(change({"set", "c.handwheel", "missing.l=capsule"}), 0);
    const Ran replaced = cell.run({"verify", "c.handwheel", "p.json", "--json"});
    QVERIFY2(replaced.code == 0, replaced.out + replaced.err);
    QCOMPARE(jsonOf(replaced.out)["missing_shapes"][0]["by"].get<std::string>(), std::string("capsule"));
  }

  // The pair that touches at rest is shown, listed, and named by each proof; forbidden, it is found.
  void pairsThatTouchAtRest() {
    const PlannedCell cell;
    cell.put("folded.urdf", kFolded);
    const Ran read =
        cell.run({"configuration", "folded.urdf", "--add", "a", "--joints", "j2=1.5", "-o", "f.handwheel"});
    QVERIFY2(read.code == 0 && read.err.contains("upper – fore"), read.err);
    const auto change = [&](const QStringList& words) {
      return cell.run(words + QStringList{"-o", "f.handwheel"}).code;
    };
    QCOMPARE(change({"configuration", "f.handwheel", "--add", "b", "--joints", "j2=-1.5"}), 0);
    const Ran inspected = cell.run({"inspect", "f.handwheel"});
    QVERIFY2(inspected.out.contains("may touch: upper with fore"), inspected.out);
    const QStringList plan{"plan", "f.handwheel", "--from", "a", "--to", "b", "-o", "p.json", "--json"};
    const Ran planned = cell.run(plan);
    QVERIFY2(planned.code == 0, planned.out + planned.err);
    QVERIFY(jsonOf(planned.out)["not_checked"] == nlohmann::json::parse(R"([["upper", "fore"]])"));
    const Ran written = cell.run({"post", "f.handwheel", "p.json", "--controller", "csv", "-o", "p.csv"});
    QVERIFY2(written.code == 0 && cell.read("p.csv").contains("Not checked: upper with fore."), written.err);
    QCOMPARE(change({"configuration", "f.handwheel", "--forbid", "upper,fore"}), 0);
    const Ran verified = cell.run({"verify", "f.handwheel", "p.json"});
    QVERIFY2(verified.code == 2, verified.out);
    QVERIFY2(verified.out.contains("upper with fore") || verified.out.contains("fore with upper"), verified.out);
  }

  // A motion along a wall at no distance is not free, and one that ends a hair's breadth from it is said to touch.
  void touching() {
    const PlannedCell cell;
    cell.put("gantry.urdf", kGantry);
    const auto done = [&](const QStringList& words) {
      const Ran ran = cell.run(words + QStringList{"-o", "g.handwheel"});
      if (ran.code != 0) qWarning("%s", ran.err.constData());
      return ran.code == 0;
    };
    QVERIFY(done({"configuration", "gantry.urdf", "--add", "left", "--joints", "x=-10"}));
    QVERIFY(done({"configuration", "g.handwheel", "--add", "right", "--joints", "x=10"}));
    const auto report = [&](const char* z, const QStringList& more = {}) {
      if (!done({"set", "g.handwheel", QString("body.wall.z=") + z})) return nlohmann::json();
      return jsonOf(
          cell.run(QStringList{"plan", "g.handwheel", "--from", "left", "--to", "right", "--json"} + more).out);
    };
    QVERIFY(done({"body", "g.handwheel", "--add", "box:100,200,40", "--at", "0,0,-30", "--name", "wall"}));
    QVERIFY(!report("-30")["certified"].get<bool>());  // its top is where the cube's bottom is
    const nlohmann::json near = report("-30.0008", {"--resolution", "0.001"});
    QVERIFY(near["certified"].get<bool>() && near["touching"].get<bool>());
    const nlohmann::json apart = report("-30.2");
    QVERIFY(apart["certified"].get<bool>() && !apart["touching"].get<bool>());
  }

  // The flange and the tool centre point are told apart.
  void flangeAndCentrePoint() {
    const PlannedCell cell;
    QCOMPARE(cell.run({"set", "cell.handwheel", "tcp.z=150", "-o", "t.handwheel"}).code, 0);
    const nlohmann::json described = jsonOf(cell.run({"inspect", "t.handwheel", "--json"}).out)["document"];
    const auto at = [&](const nlohmann::json& pose) {
      const auto p = pose["position"].get<std::vector<double>>();
      return std::array{p[0], p[1], p[2]};
    };
    const auto flange = at(described["flange"]), centre = at(described["tcp"]);
    const double apart = std::hypot(centre[0] - flange[0], centre[1] - flange[1], centre[2] - flange[2]);
    QVERIFY(std::abs(apart - 150.0) < 1e-9);
    QVERIFY((at(described["tcp"]["on_flange"]) == std::array{0.0, 0.0, 150.0}));
    QVERIFY(described["flange"].contains("link"));
  }
};

HANDWHEEL_TEST(ProofLimitsTest)
#include "ProofLimitsTest.moc"
