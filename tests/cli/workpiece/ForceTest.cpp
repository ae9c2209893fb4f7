// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Program.h"
#include "TestClass.h"

#include <QTest>
#include <cmath>

using namespace handwheel;

namespace {

nlohmann::json reportIn(const Ran& ran) {
  return nlohmann::json::parse(ran.out.toStdString());
}

// Cuts by a power law of the test's own.
QByteArray lawTable() {
  QByteArray text = "ap,f,v,Fc\n";
  for (double d : {0.5, 1.0, 1.5, 2.0})
    for (double f : {0.1, 0.2, 0.3})
      for (double v : {50.0, 100.0, 150.0})
        text += QByteArray::number(d) + "," + QByteArray::number(f) + "," + QByteArray::number(v) + "," +
                QByteArray::number(1800 * d * std::pow(f, 0.8) * std::pow(v, -0.1), 'g', 12) + "\n";
  return text;
}

}  // namespace

// 'handwheel train' and 'handwheel force'.
class ForceTest : public QObject {
  Q_OBJECT

 private slots:
  // 846 N by Kosilova with all factors 1, 855 N by Kienzle.
  void forcesOfTheExample() {
    const Fixture fixture;
    const QStringList words{"force",   "--material", "medium-carbon-steel", "--depth", "2", "--feed", "0.2",
                            "--speed", "150"};
    const Ran ran = fixture.run(words + QStringList{"--strength", "750", "--json"});
    QVERIFY2(ran.code == 0, ran.err);
    const nlohmann::json laws = reportIn(ran)["laws"];
    QVERIFY(std::abs(laws["kosilova"]["cutting_N"].get<double>() - 846.0) < 0.5);
    QVERIFY(std::abs(laws["kienzle"]["cutting_N"].get<double>() - 855.0) < 0.5);
    // The components across are 0.7 of the cutting force together: √(855² + 598²).
    QVERIFY(std::abs(laws["kienzle"]["resultant_N"].get<double>() - 1043.2) < 0.6);
    QVERIFY(std::abs(laws["kienzle"]["power_kW"].get<double>() - 855.0 * 150.0 / 60000.0) < 0.01);
    QVERIFY(laws["kosilova"]["verified"].get<bool>() && laws["network"]["synthetic"].get<bool>());
    // Kienzle's law is not corrected for strength; Kosilova's is, and reports the value before the correction.
    const nlohmann::json other = reportIn(fixture.run(words + QStringList{"--json"}))["laws"]["kosilova"];
    QVERIFY(std::abs(other["uncorrected_N"].get<double>() - 846.0) < 0.5);
    QVERIFY(std::abs(other["cutting_N"].get<double>() - 846.0 * std::pow(650.0 / 750.0, 0.75)) < 0.5);
    const Ran text = fixture.run(words + QStringList{"--tool", "hss"});
    QVERIFY2(text.code == 0 && text.out.contains("unverified"), text.out);
  }

  void warnsWithTheRule() {
    const Fixture fixture;
    const Ran ran = fixture.run({"force", "--material", "medium-carbon-steel", "--depth", "4", "--feed", "0.4",
                                 "--speed", "200", "--diameter", "10", "--length", "120", "--motor", "2", "--json"});
    QVERIFY2(ran.code == 0, ran.err);
    std::vector<std::string> rules;
    const nlohmann::json report = reportIn(ran);
    for (const nlohmann::json& warning : report["warnings"]) rules.push_back(warning["rule"]);
    QCOMPARE(rules, (std::vector<std::string>{"power", "l/d", "deflection", "chatter"}));
  }

  void saysWhatIsWrong() {
    const Fixture fixture;
    QVERIFY(fixture.run({"force", "--depth", "1"}).err.contains("--material"));
    const Ran unknown =
        fixture.run({"force", "--material", "cheese", "--depth", "1", "--feed", "0.1", "--speed", "100"});
    QVERIFY2(unknown.code == 1 && unknown.err.contains("cheese") && unknown.err.contains("--list"), unknown.err);
    fixture.put("bad.json", "{}");
    const Ran model = fixture.run(
        {"force", "--material", "brass", "--depth", "1", "--feed", "0.1", "--speed", "100", "--model", "bad.json"});
    QVERIFY2(model.code == 1 && model.err.contains("bad.json"), model.err);
    fixture.put("few.csv", "ap,f,v,Fc\n1,0.1,100,300\n2,0.1,100,600\n");
    const Ran few = fixture.run({"train", "few.csv", "-o", "m.json"});
    QVERIFY2(few.code == 1 && few.err.contains("few.csv") && few.err.contains("2 different cuts"), few.err);
    QVERIFY(fixture.run({"train", "few.csv", "-o", "few.csv"}).err.contains("replace"));
    fixture.put("word.csv", "ap,f,v,Fc\n1,0.1,100,much\n");
    const Ran word = fixture.run({"train", "word.csv", "-o", "m.json"});
    QVERIFY2(word.code == 1 && word.err.contains("line 2"), word.err);
    QVERIFY(fixture.run({"force", "--list"}).out.contains("medium-carbon-steel"));
  }

  // A table becomes a model, and the model gives the forces of the table.
  void trainsAModel() {
    const Fixture fixture;
    fixture.put("cuts.csv", lawTable());
    const Ran ran = fixture.run(
        {"train", "cuts.csv", "-o", "model.json", "--goal", "1e-5", "--hidden", "6", "--plot", "curve.svg", "--json"});
    QVERIFY2(ran.code == 0, ran.err);
    const nlohmann::json json = reportIn(ran);
    QCOMPARE(json["cuts"].get<int>(), 36);
    QVERIFY(json["goal_reached"].get<bool>() && json["mse"].get<double>() <= 1e-5);
    QVERIFY(std::abs(json["power_law"]["x"].get<double>() - 1.0) < 1e-6);
    QCOMPARE(json["errors"].size(), json["epochs"].get<std::size_t>() + 1);
    QVERIFY(fixture.content("curve.svg").contains("<svg"));
    const Ran force = fixture.run({"force", "--material", "brass", "--depth", "1.2", "--feed", "0.15", "--speed", "120",
                                   "--model", "model.json", "--json"});
    QVERIFY2(force.code == 0, force.err);
    const nlohmann::json network = reportIn(force)["laws"]["network"];
    const double expected = 1800 * 1.2 * std::pow(0.15, 0.8) * std::pow(120, -0.1);
    QVERIFY(std::abs(network["cutting_N"].get<double>() / expected - 1.0) < 0.02);
    QVERIFY(network["within_range"].get<bool>() && !network["synthetic"].get<bool>());
    const Ran outside = fixture.run(
        {"force", "--material", "brass", "--depth", "9", "--feed", "0.15", "--speed", "120", "--model", "model.json"});
    QVERIFY2(outside.out.contains("outside its range: power law"), outside.out);
    // The same once more, bit for bit; another seed is another model.
    const QByteArray first = fixture.content("model.json");
    fixture.run({"train", "cuts.csv", "-o", "model.json", "--goal", "1e-5", "--hidden", "6"});
    QCOMPARE(fixture.content("model.json"), first);
  }

  void everyTrainerCanBeChosen() {
    const Fixture fixture;
    fixture.put("cuts.csv", lawTable());
    for (const char* trainer : {"lm", "bfgs", "scg", "gdm", "gd"}) {
      const Ran ran =
          fixture.run({"train", "cuts.csv", "-o", "m.json", "--trainer", trainer, "--goal", "5e-3", "--json"});
      QVERIFY2(ran.code == 0, trainer);
      QCOMPARE(nlohmann::json::parse(fixture.content("m.json").toStdString())["trainer"].get<std::string>(),
               std::string(trainer));
    }
    const Ran unreached = fixture.run({"train", "cuts.csv", "-o", "m.json", "--trainer", "gd", "--epochs", "3"});
    QCOMPARE(unreached.code, 2);
    QVERIFY(unreached.out.contains("not reached"));
  }

  void syntheticModelsSaySo() {
    const Fixture fixture;
    const Ran ran = fixture.run({"train", "synthetic:brass", "-o", "brass.json", "--hidden", "6", "--goal", "1e-4"});
    QVERIFY2(ran.code == 0 && ran.out.contains("not measured"), ran.err);
    const Ran force = fixture.run(
        {"force", "--material", "brass", "--depth", "1", "--feed", "0.1", "--speed", "100", "--model", "brass.json"});
    QVERIFY2(force.out.contains("trained on calculated rows"), force.out);
    QCOMPARE(fixture.run({"train", "synthetic:cheese", "-o", "m.json"}).code, 1);
  }
};

HANDWHEEL_TEST(ForceTest)
#include "ForceTest.moc"
