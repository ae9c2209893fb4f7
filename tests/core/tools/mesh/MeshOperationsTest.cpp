// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/operations/MeshOperations.h"

#include "AnyValues.h"
#include "MeshDocuments.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "tools/mesh/MeshScript.h"
#include "tools/mesh/Placement.h"
#include "tools/mesh/ScriptLine.h"
#include "tools/mesh/operations/BoundaryEditOperations.h"
#include "tools/mesh/operations/DecimateOperation.h"
#include "tools/mesh/operations/FillOperation.h"
#include "tools/mesh/operations/RepairOperation.h"

#include <QTest>
#include <set>

using namespace handwheel;

namespace {

bool takesText(const Parameter& parameter) {
  return std::holds_alternative<std::string>(parameter.property.value) && parameter.parts.empty();
}

// Values that are next to the range, as words.
std::vector<std::string> wordsBeside(const Parameter& parameter) {
  const Property& p = parameter.property;
  if (parameter.isFlag() || takesText(parameter)) return {};
  std::vector<std::string> words = {"nan", "inf", "1e999", "x", ""};
  if (!parameter.words.empty() || !std::isfinite(p.least)) return words;
  std::vector<double> beside = {p.least - 0.5 * std::abs(p.least) - 0.25, p.largest + 0.5 * std::abs(p.largest) + 0.25};
  for (const double number : beside) {
    if (!parameter.parts.empty()) {
      words.push_back(listText(parameter, std::vector<double>(parameter.parts.size(), number)));
    } else {
      words.push_back(textOf(parameter, number));
    }
  }
  if (parameter.isWhole) words.push_back(textOf(parameter, 0.5 * (p.least + p.largest) + 0.25));
  return words;
}

}  // namespace

class MeshOperationsTest : public QObject {
  Q_OBJECT

 private slots:
  void eachHasItsOwnNames() {
    QVERIFY(!meshOperations().empty());
    std::set<std::string> verbs;
    for (const Operation& operation : meshOperations()) {
      QVERIFY(verbs.insert(operation.id).second);
      if (!operation.formerId.empty()) QVERIFY(verbs.insert(operation.formerId).second);
      QVERIFY(!operation.meaning.empty() && !operation.meaning.ends_with('.'));
      std::set<std::string> ids;
      for (const Parameter& parameter : operation.parameters) {
        QVERIFY(ids.insert(parameter.id()).second);
        if (!parameter.formerId.empty()) QVERIFY(ids.insert(parameter.formerId).second);
        QVERIFY(!parameter.meaning.empty() && !parameter.meaning.ends_with('.'));
        QVERIFY(parameter.meaning.find('\n') == std::string::npos);
        QCOMPARE(parameter.word.empty(), parameter.isFlag());
        QVERIFY(parameter.property.choices.empty() || parameter.property.choices.size() == parameter.words.size());
      }
      QCOMPARE(findMeshOperation(operation.id), &operation);
      if (!operation.formerId.empty()) QCOMPARE(findMeshOperation(operation.formerId), &operation);
    }
    QVERIFY(!findMeshOperation("fly") && !findMeshOperation(""));
  }

  // The default of each can be set, and is then not set.
  void defaultsAreValues() {
    for (const Operation& operation : meshOperations()) {
      for (const Parameter& parameter : operation.parameters) {
        if (!parameter.hasDefault) continue;
        OperationValues values(operation);
        QCOMPARE(values.set(parameter.id(), parameter.property.value), std::string());
        QVERIFY(values == OperationValues(operation));
      }
    }
  }

  // Each is a step: the program that carries steps out knows it. Cancelled before it begins, it does not take its time.
  void eachIsAStep() {
    JobState job;
    job.cancelled = true;
    const auto isStep = [&](const std::string& id) {
      const auto done = applyScriptLine(*test::meshDocument(test::cube()), id, Progress(job));
      return done || done.error().arguments.empty() ||
             done.error().arguments[0].find("there is no step") == std::string::npos;
    };
    for (const Operation& operation : meshOperations()) QVERIFY(isStep(operation.id));
    QVERIFY(!isStep("fly"));
  }

  // Values, a step, and values again: the same. What is the default is not written, but where it always is.
  void throughAStep() {
    for (const Operation& operation : meshOperations()) {
      const bool holds = rc::check(operation.id, [&] {
        const OperationValues values = test::anyValues(operation);
        const std::string step = ScriptLineWriter(operation.id).options(values).text();
        ScriptLineReader reader(step);
        RC_ASSERT(reader.verb() == operation.id);
        RC_ASSERT(reader.values(operation) == values);
        RC_ASSERT(reader.status().hasValue());
        for (const Parameter& parameter : operation.parameters) {
          if (values.isSet(parameter.id()) || parameter.isAlwaysWritten) continue;
          RC_ASSERT((step + " ").find("--" + parameter.id() + " ") == std::string::npos);
        }
      });
      QVERIFY2(holds, operation.id.c_str());
    }
  }

  void formerNamesAreUnderstood() {
    for (const Operation& operation : meshOperations()) {
      for (const Parameter& parameter : operation.parameters) {
        if (parameter.formerId.empty()) continue;
        const std::string value = parameter.words.empty() ? "" : " " + parameter.words.back();
        ScriptLineReader now(operation.id + " --" + parameter.id() + value);
        ScriptLineReader before(operation.id + " --" + parameter.formerId + value);
        const OperationValues values = now.values(operation);
        QVERIFY(values.isSet(parameter.id()) && values == before.values(operation));
        QVERIFY(now.status() && before.status());
      }
    }
  }

  // The message names the parameter, what was given, and what can be.
  void outOfRange() {
    for (const Operation& operation : meshOperations()) {
      for (const Parameter& parameter : operation.parameters) {
        for (const std::string& word : wordsBeside(parameter)) {
          OperationValues values(operation);
          const std::string problem = readWord(values, parameter, word);
          QVERIFY2(problem.starts_with("--" + parameter.id() + " takes "), (parameter.id() + " " + word).c_str());
          QVERIFY2(problem.find(", not '" + word.substr(0, 40)) != std::string::npos, problem.c_str());
          QVERIFY(values == OperationValues(operation));
          for (const std::string& choice : parameter.words) QVERIFY(problem.find(choice) != std::string::npos);
        }
      }
    }
  }

  // The structures that the algorithms take, and the values: one is made from the other, and back.
  void optionsAndValues() {
    const bool holds = rc::check("options", [] {
      const OperationValues repair = [] {
        OperationValues values = test::anyValues(repairOperation());
        setNumbers(values, NumberType::Float32);
        return values;
      }();
      RC_ASSERT(valuesOf(repairOptionsOf(repair)) == repair);
      const OperationValues decimation = test::anyValues(decimateOperation());
      RC_ASSERT(valuesOf(decimationOptionsOf(decimation)) == decimation);
      OperationValues smoothing = test::anyValues(meshOperation("smooth-edge"));
      setNumbers(smoothing, NumberType::Float64);
      RC_ASSERT(valuesOf(smoothingOptionsOf(smoothing)) == smoothing);
      const OperationValues placing = test::anyValues(meshOperation("place"));
      RC_ASSERT(valuesOf(placementOf(placing)) == placing);
      OperationValues fill = test::anyValues(fillOperation());
      setNumbers(fill, NumberType::Float64);
      fill.reset("bridges");
      RC_ASSERT(valuesOf(fillOptionsOf(fill)) == fill);
    });
    QVERIFY(holds);
  }

  // The defaults of the operations equal the defaults of the algorithms.
  void theDefaultsAreTheirs() {
    QVERIFY(valuesOf(DecimationOptions()) == OperationValues(decimateOperation()));
    QVERIFY(valuesOf(Placement()) == OperationValues(meshOperation("place")));
    for (OperationValues values : {valuesOf(RepairOptions()), valuesOf(FillOptions()), valuesOf(SmoothingOptions())}) {
      values.reset("numbers");
      QVERIFY(values == OperationValues(values.operation()));
    }
  }
};

HANDWHEEL_TEST(MeshOperationsTest)
#include "MeshOperationsTest.moc"
