// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/OperationOptions.h"

#include "AnyValues.h"
#include "TestClass.h"
#include "cli/OperationJson.h"
#include "tools/mesh/operations/MeshOperations.h"

#include <QTest>

using namespace handwheel;

namespace {

// The options as a shell passes them, in one of the two forms.
std::vector<std::string> commandWords(const OperationValues& values, bool joined) {
  std::vector<std::string> words;
  for (const auto& [name, word] : writtenOptions(values)) {
    words.push_back("--" + name + (joined && !word.empty() ? "=" + word : ""));
    if (!joined && !word.empty()) words.push_back(word);
  }
  return words;
}

Arguments parsed(const CommandSpec& spec, std::vector<std::string> words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  return parseArguments(spec, pointers);
}

}  // namespace

class OperationOptionsTest : public QObject {
  Q_OBJECT

 private slots:
  // Values, words of a command line, and values again: the same.
  void throughTheCommandLine() {
    for (const Operation& operation : meshOperations()) {
      const CommandSpec spec = {operation.id, "", "", optionsOf(operation)};
      const bool holds = rc::check(operation.id, [&] {
        const OperationValues values = test::anyValues(operation);
        const Arguments arguments = parsed(spec, commandWords(values, *rc::gen::arbitrary<bool>()));
        RC_ASSERT(arguments.problem == std::string());
        OperationValues read(operation);
        RC_ASSERT(readOptions(arguments, read) == std::string());
        RC_ASSERT(read == values);
      });
      QVERIFY2(holds, operation.id.c_str());
    }
  }

  // Options that are not given keep their values.
  void othersStay() {
    OperationValues values(meshOperation("repair"));
    values.setValid("near-weld", 1e-3);
    values.setValid("density", 0.5);
    const CommandSpec spec = {"repair", "", "", optionsOf(values.operation(), {"numbers"})};
    QCOMPARE(readOptions(parsed(spec, {"--density", "0.75", "--keep-tangles"}), values), std::string());
    QCOMPARE(values.number("density"), 0.75);
    QCOMPARE(values.number("near-weld"), 1e-3);
    QVERIFY(values.flag("keep-folded-regions"));
    QCOMPARE(parsed(spec, {"--numbers", "single"}).problem, std::string("There is no option --numbers."));
  }

  void mistakesAreSentences() {
    OperationValues values(meshOperation("repair"));
    const CommandSpec spec = {"repair", "", "", optionsOf(values.operation())};
    QCOMPARE(readOptions(parsed(spec, {"--near-weld", "2"}), values),
             std::string("--near-weld takes a number from 0 to 1, not '2'."));
    QCOMPARE(sentenceOf("say so"), std::string("Say so."));
  }

  // Every option is on the page, with what it means.
  void helpPages() {
    for (const Operation& operation : meshOperations()) {
      const std::string page = helpPage({operation.id, "", "", optionsOf(operation)});
      const std::string steps = stepsHelp({&operation, 1});
      for (const Parameter& parameter : operation.parameters) {
        const std::string option = "--" + parameter.id() + (parameter.word.empty() ? "" : " " + parameter.word);
        for (const std::string& text : {page, steps}) {
          QVERIFY2(text.find(option + "  ") != std::string::npos, option.c_str());
          QVERIFY2(text.find(parameter.meaning) != std::string::npos, option.c_str());
        }
      }
      QVERIFY(steps.starts_with("  " + operation.id));
    }
  }

  // In reports: a key for each parameter, with its unit.
  void reports() {
    OperationValues values(meshOperation("decimate"));
    values.setValid("error", 0.5);
    values.setValid("keep-creases", 30.0 * kRadiansPerDegree);
    values.setValid("faces", 7.0);
    const nlohmann::json expected = {{"faces", 7},
                                     {"error_mm", 0.5},
                                     {"keep_borders", false},
                                     {"keep_creases_deg", 30.0},
                                     {"no_crossings", false},
                                     {"method", "bounded"}};
    const nlohmann::json decimation = toJson(values);
    QVERIFY2(decimation == expected, decimation.dump().c_str());
    const nlohmann::json repair = toJson(OperationValues(meshOperation("repair")));
    QCOMPARE(repair.at("open_sheets").get<std::string>(), std::string("keep"));
    QVERIFY(repair.at("numbers").is_null());
    QCOMPARE(repair.at("ears").get<std::vector<double>>(), std::vector<double>({1.0, 1.0, 1.0, 2.0}));
  }
};

HANDWHEEL_TEST(OperationOptionsTest)
#include "OperationOptionsTest.moc"
