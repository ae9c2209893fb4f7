// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/exercise/DrillingTask.h"

#include "TestClass.h"
#include "volume/drilling/DrillBits.h"
#include "volume/drilling/Skull.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

using namespace handwheel;

namespace {

DrillingTask plannedTask() {
  DrillingTask task;
  task.plan = {Vec3(1.0, -2.5, 0.125), Vec3(0.0, 0.6, -0.8), 0.5, {{Vec3(0.0, 26.0, -3.0), 50.0}, {Vec3::Zero(), 5.5}}};
  task.tool = *drillBitOf("burr:4");
  task.material = "porcine-bone";
  task.spindle = 1200.0;
  task.feed = 2.0;
  task.failedTries = FailedTries::FailTheWork;
  return task;
}

Property taskProperty(const DrillingTask& task, std::string_view id) {
  const std::vector<Property> all = propertiesOf(task);
  const auto found = std::find_if(all.begin(), all.end(), [&](const Property& p) { return p.id == id; });
  if (found == all.end()) qFatal("there is no such property");
  return *found;
}

std::string textOfProperty(const DrillingTask& task, std::string_view id) {
  return std::get<std::string>(taskProperty(task, id).value);
}

}  // namespace

// The properties of a task of drilling, as teachers see and change them.
class DrillingTaskTest : public QObject {
  Q_OBJECT

 private slots:
  // The path comes before the drill, each under its heading.
  void orderOfProperties() {
    std::vector<std::string> path, drill;
    for (const Property& each : propertiesOf(plannedTask()))
      (each.group == "Planned path" ? path : drill).push_back(each.id);
    QCOMPARE(path, (std::vector<std::string>{"entry", "direction", "tolerance", "forbidden", "failed_tries"}));
    QCOMPARE(drill, (std::vector<std::string>{"spindle_speed", "feed", "drill", "material"}));
    QCOMPARE(taskProperty(plannedTask(), "drill").group, std::string("Drill"));
  }

  void valuesOfProperties() {
    const DrillingTask task = plannedTask();
    QCOMPARE(textOfProperty(task, "entry"), std::string("1; -2.5; 0.125"));
    QCOMPARE(textOfProperty(task, "direction"), std::string("0; 0.6; -0.8"));
    QCOMPARE(textOfProperty(task, "forbidden"), std::string("0; 26; -3; 50 | 0; 0; 0; 5.5"));
    QCOMPARE(textOfProperty(task, "drill"), std::string("burr:4"));
    QCOMPARE(std::get<double>(taskProperty(task, "tolerance").value), 0.5);
    QCOMPARE(std::get<double>(taskProperty(task, "spindle_speed").value), 1200.0);
    QCOMPARE(std::get<double>(taskProperty(task, "feed").value), 2.0);
    QVERIFY(taskProperty(task, "tolerance").quantity == Quantity::Length);
    QCOMPARE(taskProperty(task, "feed").largest, 50.0);
    const auto chosen = [&](const char* id) {
      const Property property = taskProperty(task, id);
      return property.choices.at(static_cast<std::size_t>(std::get<double>(property.value)));
    };
    QCOMPARE(chosen("material"), drillMaterial("porcine-bone")->name);
    QCOMPARE(chosen("failed_tries"), std::string("fail the work"));
    QCOMPARE(taskProperty(task, "material").choices.size(), drillMaterials().size());
    DrillingTask free = task;
    free.plan.forbidden.clear();
    QCOMPARE(textOfProperty(free, "forbidden"), std::string());
  }

  // Each property of one task, set in another, makes it that one; and files have the same.
  void propertiesMakeATask() {
    const DrillingTask wanted = plannedTask();
    Result<DrillingTask> task = DrillingTask::ofSkull();
    for (const Property& each : propertiesOf(wanted)) {
      task = withTaskProperty(*task, each.id, each.value);
      QVERIFY2(task.hasValue(), each.id.c_str());
    }
    QVERIFY(toJson(*task) == toJson(wanted));
    std::vector<Error> damage;
    const DrillingTask read = drillingTaskFrom(toJson(wanted), damage);
    QVERIFY(damage.empty() && toJson(read) == toJson(wanted));
  }

  // Values within the limits are accepted, others are refused with the limits.
  void numbersAndTheirLimits() {
    for (const auto& [id, least, largest] : {std::tuple("tolerance", 0.01, 1000.0),
                                             std::tuple("spindle_speed", 1.0, 1e5), std::tuple("feed", 0.05, 50.0)}) {
      QVERIFY(withTaskProperty(plannedTask(), id, least) && withTaskProperty(plannedTask(), id, largest));
      for (const double wrong : {0.0, 2.0 * largest, std::numeric_limits<double>::quiet_NaN()}) {
        const Result<DrillingTask> refused = withTaskProperty(plannedTask(), id, wrong);
        QVERIFY(!refused && refused.error().code == ErrorCode::ValueOutOfRange);
        QCOMPARE(refused.error().arguments.front(), std::string(id));
        QCOMPARE(std::stod(refused.error().arguments[2]), least);
        QCOMPARE(std::stod(refused.error().arguments[3]), largest);
      }
    }
  }

  void materialsByTheirNumber() {
    for (std::size_t i = 0; i < drillMaterials().size(); ++i) {
      const Result<DrillingTask> task = withTaskProperty(plannedTask(), "material", static_cast<double>(i));
      QVERIFY(task.hasValue());
      QCOMPARE(task->material, drillMaterials()[i].id);
      QCOMPARE(task->setup().material.energy, drillMaterials()[i].energy);
    }
    QVERIFY(std::abs(plannedTask().setup().spindle - 40.0 * M_PI) < 1e-12);  // 1200 r/min
  }

  // A value of another type, a choice that there is not and a saw, which goes along no path, are malformed; a property
  // that there is not is missing.
  void refusedValues() {
    const std::string text = "1; 2; 3";
    for (const auto& [id, wrong] :
         std::initializer_list<std::pair<const char*, PropertyValue>>{{"entry", 1.0},
                                                                      {"entry", text + " | " + text},
                                                                      {"entry", std::string("0; 0; 2e5")},
                                                                      {"direction", true},
                                                                      {"forbidden", 2.0},
                                                                      {"forbidden", std::string("0; 0; 0; 1 | 2")},
                                                                      {"drill", std::string("saw:30")},
                                                                      {"drill", 3.0},
                                                                      {"material", -1.0},
                                                                      {"material", std::string("beech")},
                                                                      {"failed_tries", true},
                                                                      {"feed", text}}) {
      const Result<DrillingTask> refused = withTaskProperty(plannedTask(), id, wrong);
      QVERIFY2(!refused && refused.error().code == ErrorCode::ElementMalformed, id);
      QCOMPARE(refused.error().arguments.front(), std::string(id));
    }
    const Result<DrillingTask> unknown = withTaskProperty(plannedTask(), "colour", text);
    QVERIFY(!unknown && unknown.error().code == ErrorCode::ReferenceMissing);
    QCOMPARE(unknown.error().arguments, (std::vector<std::string>{"property", "colour", ""}));
  }

  // Blanks do not count, and no more balls are taken than a hundred.
  void textsOfBalls() {
    const auto ballsIn = [](const std::string& text) {
      const Result<DrillingTask> task = withTaskProperty(plannedTask(), "forbidden", text);
      return task ? static_cast<int>(task->plan.forbidden.size()) : -1;
    };
    QCOMPARE(ballsIn(""), 0);
    QCOMPARE(ballsIn("  1;2 ;3;  4|5;6;7;8 "), 2);
    std::string many = "0; 0; 0; 1";
    for (std::size_t i = 1; i < DrillingTask::kMostForbidden; ++i) many += " | 0; 0; 0; 1";
    QCOMPARE(ballsIn(many), 100);
    QCOMPARE(ballsIn(many + " | 0; 0; 0; 1"), -1);
  }

  // The exercise that comes with the program is on the skull, its brain forbidden.
  void theSkull() {
    const DrillingTask task = DrillingTask::ofSkull();
    QVERIFY(!task.stock);
    QVERIFY((task.plan.entry - skullSite().entry).norm() == 0.0 && std::abs(task.plan.direction.norm() - 1.0) < 1e-12);
    QVERIFY(std::abs(Skull::depthAt(task.plan.entry)) < 0.01);
    QVERIFY(task.plan.forbidden == skullBrain());
    QCOMPARE(toJson(task)["stock"], nlohmann::json("skull"));
    QVERIFY(!toJson(task).contains("failed_tries"));  // the default is not written
  }
};

HANDWHEEL_TEST(DrillingTaskTest)
#include "DrillingTaskTest.moc"
