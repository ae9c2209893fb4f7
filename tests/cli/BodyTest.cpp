// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Program.h"
#include "TestClass.h"

#include <QTest>
#include <cmath>

using namespace handwheel;

namespace {

const QByteArray kRobot = R"(<robot name='r'><link name='foot'><visual><geometry><box size='0.1 0.1 0.1'/></geometry>
</visual></link></robot>)";

// A solid in STL: a corner of a cube of this size.
QByteArray corner(double size) {
  const double points[4][3] = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, size}};
  const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  QByteArray text = "solid corner\n";
  for (const auto& face : faces) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (int p : face) {
      text += "vertex";
      for (double v : points[p]) text += ' ' + QByteArray::number(v);
      text += '\n';
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid corner\n";
}

}  // namespace

// 'handwheel body': what stands beside a robot.
class BodyTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    m_fixture = std::make_unique<Fixture>();
    m_fixture->put("r.urdf", kRobot);
    m_fixture->put("part.stl", corner(30));
  }

  void saysWhatItRead() {
    const Ran mesh = m_fixture->run({"body", "r.urdf", "--add", "part.stl", "-o", "cell.handwheel"});
    QCOMPARE(mesh.code, 0);
    QVERIFY2(mesh.err.contains("30 × 30 × 30 mm"), mesh.err);
    const Ran robot = m_fixture->run({"body", "cell.handwheel", "--add", "r.urdf", "-o", "cell.handwheel"});
    QCOMPARE(robot.code, 0);
    QVERIFY2(robot.err.contains("no joints") && robot.err.contains("100 × 100 × 100 mm"), robot.err);
  }

  void addsMovesAndRemoves() {
    const Ran added = m_fixture->run({"body", "r.urdf", "--add", "box:10,20,30", "--name", "vice", "--at", "100,0,15",
                                      "--turn", "0,0,90", "-o", "cell.handwheel", "--json"});
    QVERIFY2(added.code == 0, added.err);
    const nlohmann::json json = jsonOf(added);
    QCOMPARE(json["options"]["add"].get<std::string>(), "box:10,20,30");
    QCOMPARE(json["bodies"][0]["name"].get<std::string>(), "vice");
    QVERIFY(json["bodies"][0]["position"] == nlohmann::json({100.0, 0.0, 15.0}));
    QCOMPARE(m_fixture->run({"set", "cell.handwheel", "body.1.x=50", "body.1.name=table", "-o", "cell.handwheel"}).code,
             0);
    const nlohmann::json shown = jsonOf(m_fixture->run({"inspect", "cell.handwheel", "--json"}));
    QCOMPARE(shown["document"]["bodies"][0]["name"].get<std::string>(), "table");
    QCOMPARE(shown["document"]["bodies"][0]["position"][0].get<double>(), 50.0);
    const Ran removed =
        m_fixture->run({"body", "cell.handwheel", "--remove", "table", "-o", "cell.handwheel", "--json"});
    QVERIFY2(removed.code == 0, removed.err);
    QVERIFY(jsonOf(removed)["bodies"].empty());
  }

  void linksAreFollowed() {
    QCOMPARE(m_fixture->run({"body", "r.urdf", "--add", "part.stl", "--link", "-o", "cell.handwheel"}).code, 0);
    const auto stateNow = [&](QByteArray* said = nullptr) {
      const Ran ran = m_fixture->run({"inspect", "cell.handwheel", "--json"});
      if (said) *said = ran.err;
      return jsonOf(ran)["document"]["bodies"][0]["link"]["state"].get<std::string>();
    };
    QCOMPARE(stateNow(), "present");
    m_fixture->put("part.stl", corner(60));
    QByteArray said;
    QCOMPARE(stateNow(&said), "changed");
    QVERIFY2(said.contains("part.stl"), said);
    QCOMPARE(m_fixture->run({"body", "cell.handwheel", "--update", "part", "-o", "cell.handwheel"}).code, 0);
    QCOMPARE(stateNow(), "present");
    // The volume of the part and of the robot's box.
    QCOMPARE(m_fixture->run({"convert", "cell.handwheel", "all.stl"}).code, 0);
    const double volume = jsonOf(m_fixture->run({"inspect", "all.stl", "--json"}))["volume_mm3"].get<double>();
    QVERIFY(std::abs(volume - (1e6 + 60.0 * 60 * 60 / 6)) < 1.0);
    QVERIFY(QFile::remove(m_fixture->path() + "/part.stl"));
    QCOMPARE(stateNow(&said), "missing");
    QVERIFY2(said.contains("part.stl"), said);
    const Ran refused = m_fixture->run({"body", "cell.handwheel", "--update", "1", "-o", "cell.handwheel"});
    QCOMPARE(refused.code, 1);
    QCOMPARE(m_fixture->run({"body", "cell.handwheel", "--unlink", "1", "-o", "cell.handwheel"}).code, 0);
    QVERIFY(jsonOf(m_fixture->run({"inspect", "cell.handwheel", "--json"}))["document"]["bodies"][0]["link"].is_null());
  }

  void aBodyIsLinkedToAnotherFile() {
    m_fixture->put("other.stl", corner(30));
    QCOMPARE(
        m_fixture
            ->run({"body", "r.urdf", "--add", "part.stl", "--name", "vice", "--at", "7,0,0", "-o", "cell.handwheel"})
            .code,
        0);
    const Ran ran = m_fixture->run(
        {"body", "cell.handwheel", "--update", "vice", "--from", "other.stl", "-o", "cell.handwheel", "--json"});
    QVERIFY2(ran.code == 0, ran.err);
    const nlohmann::json body = jsonOf(ran)["bodies"][0];
    QCOMPARE(body["name"].get<std::string>(), "vice");
    QCOMPARE(body["position"][0].get<double>(), 7.0);
    QCOMPARE(body["link"]["state"].get<std::string>(), "present");
    QVERIFY(body["link"]["path"].get<std::string>().ends_with("other.stl"));
    QCOMPARE(m_fixture->run({"convert", "cell.handwheel", "all.stl"}).code, 0);
    const double volume = jsonOf(m_fixture->run({"inspect", "all.stl", "--json"}))["volume_mm3"].get<double>();
    QVERIFY(std::abs(volume - (1e6 + 30.0 * 30 * 30 / 6)) < 1.0);
  }

  void namesAndWhatIsHidden() {
    QCOMPARE(m_fixture->run({"body", "r.urdf", "--add", "box:1,2,3", "--name", "Table", "-o", "cell.handwheel"}).code,
             0);
    QCOMPARE(
        m_fixture->run({"body", "cell.handwheel", "--add", "box:1,2,3", "--name", "1", "-o", "cell.handwheel"}).code,
        0);
    const Ran refused = m_fixture->run({"body", "cell.handwheel", "--remove", "1", "-o", "cell.handwheel"});
    QCOMPARE(refused.code, 1);
    QVERIFY2(refused.err.contains("name of body 2"), refused.err);
    const Ran set =
        m_fixture->run({"set", "cell.handwheel", "body.Table.x=12", "body.Table.visible=no", "-o", "cell.handwheel"});
    QVERIFY2(set.code == 0, set.err);
    const nlohmann::json shown = jsonOf(m_fixture->run({"inspect", "cell.handwheel", "--json"}));
    QCOMPARE(shown["document"]["bodies"][0]["position"][0].get<double>(), 12.0);
    const Ran converted = m_fixture->run({"convert", "cell.handwheel", "all.stl"});
    QVERIFY2(converted.err.contains("1 hidden body (Table) was left out."), converted.err);
  }

  // A bar comes in with its exact profile: shown with its own tolerance, its volume is that of a cylinder.
  void aWorkpieceAsABody() {
    QCOMPARE(m_fixture->run({"new", "workpiece", "-o", "bar.handwheel"}).code, 0);
    const Ran added = m_fixture->run({"body", "r.urdf", "--add", "bar.handwheel", "-o", "cell.handwheel", "--json"});
    QVERIFY2(added.code == 0, added.err);
    QCOMPARE(jsonOf(added)["bodies"][0]["shape"].get<std::string>(), "revolution");
  }

  void refuses() {
    const auto said = [&](QStringList words) {
      const Ran ran = m_fixture->run(words << "-o"
                                           << "out.handwheel");
      return ran.code == 1 && !m_fixture->names().contains("out.handwheel") ? ran.err : QByteArray("done");
    };
    QVERIFY(said({"body", "r.urdf"}).contains("--add"));
    QVERIFY(said({"body", "r.urdf", "--add", "sphere:1", "--remove", "a"}).contains("one of"));
    QVERIFY(said({"body", "r.urdf", "--remove", "a", "--name", "b"}).contains("--name is only possible with --add"));
    QVERIFY(said({"body", "r.urdf", "--add", "sphere:1", "--link"}).contains("--link"));
    QVERIFY(said({"body", "r.urdf", "--add", "box:1,2"}).contains("3 dimension(s)"));
    QVERIFY(said({"body", "r.urdf", "--add", "box:1,2,x"}).contains("x"));
    QVERIFY(said({"body", "r.urdf", "--add", "sphere:-1"}).contains("Radius cannot be -1"));
    QVERIFY(said({"body", "r.urdf", "--add", "none.stl"}).contains("none.stl"));
    QVERIFY(said({"body", "r.urdf", "--add", "sphere:1", "--name", ""}).contains("name"));
    QVERIFY(said({"body", "r.urdf", "--remove", "a"}).contains("'a'"));
    QVERIFY(said({"body", "part.stl", "--add", "sphere:1"}).contains("no bodies"));
  }

 private:
  std::unique_ptr<Fixture> m_fixture;
};

HANDWHEEL_TEST(BodyTest)
#include "BodyTest.moc"
