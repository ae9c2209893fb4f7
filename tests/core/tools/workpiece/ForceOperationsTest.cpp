// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/workpiece/ForceOperations.h"

#include "TestClass.h"
#include "document/OperationText.h"

#include <QtTest>
#include <numbers>

using namespace handwheel;

namespace {

// Returns the values of options as they are typed: an empty word sets a flag.
OperationValues typedFor(const Operation& operation,
                         std::initializer_list<std::pair<const char*, const char*>> options) {
  OperationValues values(operation);
  for (const auto& [id, word] : options) {
    const Parameter* const parameter = operation.find(id);
    if (!parameter) qFatal("there is no such option");
    if (parameter->isFlag()) {
      values.setValid(id, true);
    } else if (const std::string refused = readWord(values, *parameter, word); !refused.empty()) {
      qFatal("%s", refused.c_str());
    }
  }
  return values;
}

OperationValues someCut(std::initializer_list<std::pair<const char*, const char*>> more = {}) {
  OperationValues values =
      typedFor(forceOperation(), {{"material", "brass"}, {"depth", "2"}, {"feed", "0.2"}, {"speed", "120"}});
  for (const auto& [id, word] : more) {
    const Parameter& parameter = *forceOperation().find(id);
    const std::string refused = parameter.isFlag() ? values.set(id, true) : readWord(values, parameter, word);
    if (!refused.empty()) qFatal("%s", refused.c_str());
  }
  return values;
}

constexpr double kDegree = std::numbers::pi / 180.0;

}  // namespace

// The options of force calculations as the values that these take.
class ForceOperationsTest : public QObject {
  Q_OBJECT

 private slots:
  // A word means the enumerator that has its name, though the values only have a number.
  void wordsAreTheirEnumerators() {
    const Parameter& trainer = *trainOperation().find("trainer");
    QCOMPARE(trainer.words.size(), kNetworkTrainers.size());
    QCOMPARE(trainer.property.choices.size(), kNetworkTrainers.size());
    for (const NetworkTrainer each : kNetworkTrainers)
      QVERIFY(trainingOptionsOf(typedFor(trainOperation(), {{"trainer", wordFor(each)}})).trainer == each);
    QVERIFY(thrustOf(someCut({{"thrust", "depth"}})).law == ThrustLaw::Depth);
    QVERIFY(thrustOf(someCut({{"thrust", "constant"}})).law == ThrustLaw::Constant);
    QVERIFY(thrustOf(someCut({{"thrust", "table"}})).law == ThrustLaw::Table);
    QVERIFY(edgeOf(someCut({{"tool", "carbide"}})).material == ToolMaterial::Carbide);
    QVERIFY(edgeOf(someCut({{"tool", "hss"}})).material == ToolMaterial::HighSpeedSteel);
  }

  // Without options, training and drive use the defaults of the calculation.
  void withoutOptionsItIsTheUsual() {
    const TrainingOptions usual, options = trainingOptionsOf(OperationValues(trainOperation()));
    QVERIFY(options.trainer == usual.trainer && options.hidden == usual.hidden && options.goal == usual.goal);
    QVERIFY(options.seed == usual.seed && options.epochs == usual.epochs);
    const OperationValues cut = someCut();
    QVERIFY(driveOf(cut) == SpindleDrive());
    QVERIFY(thrustOf(cut) == ThrustSettings());
    QVERIFY(edgeOf(cut) == CuttingEdge());  // all is as each table has it
    QCOMPARE(cut.number("wear"), 0.0);
    QVERIFY(!slenderWorkOf(cut));
  }

  void trainingTakesItsOptions() {
    const TrainingOptions options = trainingOptionsOf(
        typedFor(trainOperation(),
                 {{"trainer", "scg"}, {"hidden", "9"}, {"goal", "0.0005"}, {"seed", "1000000000"}, {"epochs", "77"}}));
    QVERIFY(options.trainer == NetworkTrainer::ScaledConjugateGradient);
    QCOMPARE(options.hidden, std::size_t{9});
    QCOMPARE(options.goal, 0.0005);
    QCOMPARE(options.seed, std::uint64_t{1'000'000'000});
    QCOMPARE(options.epochs, std::size_t{77});
    QVERIFY(!OperationValues(trainOperation()).given("diameter"));  // tables with cutting speeds need none
  }

  // Lengths in mm, speeds in m/min, angles in degrees, which the edge has in radian.
  void aCutIsAsItIsTyped() {
    const OperationValues values = someCut({{"approach", "95"},
                                            {"rake", "-6"},
                                            {"inclination", "-4"},
                                            {"nose", "0.8"},
                                            {"motor", "5.5"},
                                            {"torque", "80"},
                                            {"efficiency", "0.9"}});
    QVERIFY(cutOf(values) == CutConditions({2.0, 0.2, 120.0}));
    const CuttingEdge edge = edgeOf(values);
    QVERIFY(std::abs(*edge.approach - 95.0 * kDegree) < 1e-12);
    QVERIFY(std::abs(*edge.rake + 6.0 * kDegree) < 1e-12 && std::abs(*edge.inclination + 4.0 * kDegree) < 1e-12);
    QCOMPARE(*edge.noseRadius, 0.8);
    QVERIFY(driveOf(values) == SpindleDrive({5.5, 80.0, 0.9}));
  }

  // Free work is cut at its end, where it bends most; a centre supports the end, so it is cut in the middle.
  void whereTheWorkIsCut() {
    QVERIFY(!slenderWorkOf(someCut({{"diameter", "20"}})));  // for the torque alone
    const auto free = slenderWorkOf(someCut({{"diameter", "20"}, {"length", "150"}}));
    QVERIFY(free && !free->hasTailstock && free->diameter == 20.0 && free->length == 150.0 && free->position == 150.0);
    const auto held = slenderWorkOf(someCut({{"diameter", "20"}, {"length", "150"}, {"tailstock", ""}}));
    QVERIFY(held && held->hasTailstock && held->length == 150.0 && held->position == 75.0);
  }

  // Values that the force needs are named if missing, and so are options that are meaningless without another.
  void whatIsMissingIsNamed() {
    QVERIFY(problemOfForceValues(someCut()).empty());
    for (const char* const id : {"material", "depth", "feed", "speed"}) {
      OperationValues values = someCut();
      values.reset(id);
      QCOMPARE(problemOfForceValues(values), "the option --" + std::string(id) + " is missing");
    }
    QCOMPARE(problemOfForceValues(someCut({{"length", "90"}})),
             std::string("--length is only possible with --diameter"));
    QCOMPARE(problemOfForceValues(someCut({{"tailstock", ""}})),
             std::string("--tailstock is only possible with --diameter"));
    QCOMPARE(problemOfForceValues(someCut({{"tailstock", ""}, {"diameter", "20"}})),
             std::string("--tailstock is only possible with --length"));
    QVERIFY(problemOfForceValues(someCut({{"tailstock", ""}, {"diameter", "20"}, {"length", "90"}})).empty());
  }

  void valuesBesideTheRangeAreRefused_data() {
    QTest::addColumn<QString>("id");
    QTest::addColumn<QString>("within");
    QTest::addColumn<QString>("beyond");
    QTest::addRow("approach") << "approach"
                              << "145"
                              << "145.1";  // degrees
    QTest::addRow("flat approach") << "approach"
                                   << "5"
                                   << "4.9";
    QTest::addRow("rake") << "rake"
                          << "-90"
                          << "-91";
    QTest::addRow("wear") << "wear"
                          << "0.5"
                          << "0.51";
    QTest::addRow("efficiency") << "efficiency"
                                << "1"
                                << "1.01";
    QTest::addRow("no efficiency") << "efficiency"
                                   << "0.01"
                                   << "0";
    QTest::addRow("depth") << "depth"
                           << "1000"
                           << "-1";
    QTest::addRow("tool") << "tool"
                          << "hss"
                          << "diamond";
  }
  void valuesBesideTheRangeAreRefused() {
    QFETCH(QString, id);
    QFETCH(QString, within);
    QFETCH(QString, beyond);
    const Parameter& parameter = *forceOperation().find(id.toStdString());
    OperationValues values(forceOperation());
    QVERIFY(readWord(values, parameter, within.toStdString()).empty());
    const OperationValues before = values;
    const std::string refused = readWord(values, parameter, beyond.toStdString());
    QVERIFY2(refused.find("--" + id.toStdString()) != std::string::npos, refused.c_str());
    QVERIFY(values == before);
  }

  // A hidden layer is of whole neurons, as many as a network holds.
  void neuronsAreWhole() {
    const Parameter& hidden = *trainOperation().find("hidden");
    OperationValues values(trainOperation());
    for (const char* const wrong : {"0", "2.5", "65", "nan"}) QVERIFY2(!readWord(values, hidden, wrong).empty(), wrong);
    QVERIFY(readWord(values, hidden, std::to_string(ForceNetwork::kMostHidden)).empty());
  }
};

HANDWHEEL_TEST(ForceOperationsTest)
#include "ForceOperationsTest.moc"
