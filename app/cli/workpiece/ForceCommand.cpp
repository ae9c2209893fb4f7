// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/workpiece/ForceCommand.h"

#include "base/NumberText.h"
#include "cli/Messages.h"
#include "cli/OperationJson.h"
#include "cli/OperationOptions.h"
#include "cli/ReportJson.h"
#include "document/FileBytes.h"
#include "machining/force/ForceErrors.h"
#include "machining/force/ForceFidelity.h"
#include "machining/force/TrainedForceModel.h"
#include "tools/workpiece/ForceOperations.h"

#include <limits>

namespace handwheel {

namespace {

// The forces of a cut by one law.
struct LawForces {
  std::string law;     // "kosilova"
  std::string source;  // a sentence
  CutForces forces;
  bool isVerified = true;
  bool isSynthetic = false;  // a network that was trained on calculated rows
  bool isCovered = true;     // else the law is beyond its range
};

struct CutReport {
  WorkMaterial material;
  CutConditions cut;
  std::vector<LawForces> laws;
  double uncorrected = 0.0;  // N, of Kosilova's law with K = 1; 0: it has none
  std::vector<CutWarning> warnings;
  std::string network;  // the reason why the network has no forces; empty: it has
};

LawForces forcesBy(const CuttingForceModel& model, const CutReport& report, const OperationValues& values,
                   std::string law, std::string source) {
  LawForces result{std::move(law), std::move(source), {}};
  result.forces = worn(model.at(report.cut), values.number("wear"));
  result.isCovered = model.covers(report.cut);
  result.isVerified = lawInUse(model, report.material).isVerified;
  return result;
}

void addKosilova(CutReport& report, const OperationValues& values) {
  const KosilovaTables& tables = KosilovaTables::standard();
  WorkMaterial material = report.material;
  if (const std::optional<double> strength = values.given("strength")) material.strength = *strength;
  const CuttingEdge edge = edgeOf(values);
  const auto model = kosilovaModel(tables, material, edge, thrustOf(values));
  if (!model) return;
  const KosilovaRow& row = *kosilovaRowFor(tables, material, edge.material);
  report.laws.push_back(forcesBy(*model, report, values, "kosilova", row.source + ", row " + row.id));
  report.uncorrected = model->at(report.cut).cutting / model->correction();
}

// The model that was given, or the shipped one for its material.
Status addNetwork(CutReport& report, const OperationValues& values, const std::string& path) {
  const CuttingEdge edge = edgeOf(values);
  std::optional<TrainedForceModel> model;
  if (path.empty()) {
    model = shippedForceModel(edge, thrustOf(values));
    if (model->origin().material != report.material.id) {
      report.network = "the model that ships is for " + model->origin().material + "; --model takes another";
      return Done{};
    }
  } else {
    Result<std::string> text = readFileHead(path, kMostModelBytes + 1);
    Result<TrainedForceModel> read =
        text ? forceModelFromJson(*text, edge, thrustOf(values)) : Result<TrainedForceModel>(text.error());
    if (!read) {
      Error error = read.error();
      error.subject = path;
      return error;
    }
    model = std::move(read.value());
  }
  report.laws.push_back(forcesBy(*model, report, values, "network", model->origin().data));
  report.laws.back().isSynthetic = model->origin().isSynthetic;
  return Done{};
}

Result<CutReport> reportOn(const OperationValues& values, const std::string& modelPath) {
  const WorkMaterials& materials = WorkMaterials::standard();
  const WorkMaterial* material = materials.find(values.text("material"));
  if (!material) return Error{ForceErrors::MaterialUnknown, {values.text("material")}, {}, {}};
  CutReport report{*material, cutOf(values), {}, 0.0, {}, {}};
  addKosilova(report, values);
  const auto kienzle = kienzleModel(*material, edgeOf(values), thrustOf(values));
  report.laws.push_back(forcesBy(*kienzle, report, values, "kienzle", material->source));
  const Status network = addNetwork(report, values, modelPath);
  if (!network) return network.error();
  // Rules are judged by the law that asks for most.
  const LawForces* largest = &report.laws[0];
  for (const LawForces& law : report.laws)
    if (law.forces.cutting > largest->forces.cutting) largest = &law;
  SlenderWork work;
  work.length = 0.0;
  work.position = 0.0;
  work.diameter = values.given("diameter").value_or(1.0);
  if (const auto slender = slenderWorkOf(values)) work = *slender;
  SpindleDrive drive = driveOf(values);
  if (!values.isSet("diameter")) drive.torque = std::numeric_limits<double>::infinity();
  report.warnings = warningsFor(report.cut, largest->forces, edgeOf(values), work, drive);
  return report;
}

nlohmann::ordered_json toJson(const LawForces& law, const CutReport& report, const OperationValues& values) {
  const double power = cuttingPower(law.forces, report.cut);
  nlohmann::ordered_json json = {
      {"cutting_N", law.forces.cutting},
      {"feed_N", law.forces.feed},
      {"radial_N", law.forces.radial},
      {"resultant_N", law.forces.norm()},
      {"power_kW", power},
      {"motor_kW", motorPower(power, values.number("efficiency"))},
      {"torque_Nm", nullptr},
      {"verified", law.isVerified},
      {"synthetic", law.isSynthetic},
      {"within_range", law.isCovered},
      {"source", law.source},
  };
  if (const auto diameter = values.given("diameter")) json["torque_Nm"] = cuttingTorque(law.forces, *diameter);
  return json;
}

std::string jsonText(const CutReport& report, const OperationValues& values) {
  nlohmann::ordered_json laws = nlohmann::ordered_json::object(), warnings = nlohmann::ordered_json::array();
  for (const LawForces& law : report.laws) laws[law.law] = toJson(law, report, values);
  if (laws.contains("kosilova")) laws["kosilova"]["uncorrected_N"] = report.uncorrected;
  for (const CutWarning& warning : report.warnings)
    warnings.push_back({{"rule", wordFor(warning.rule)},
                        {"value", warning.value},
                        {"limit", warning.limit},
                        {"text", textOf(warning)}});
  return textOf(
      {{"options", toJson(values)}, {"material", report.material.id}, {"laws", laws}, {"warnings", warnings}});
}

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(text.size(), width), ' ');
  return text;
}

std::string remarksOn(const LawForces& law) {
  std::string remarks;
  if (!law.isVerified) remarks += ", unverified";
  if (law.isSynthetic) remarks += ", trained on calculated rows";
  if (!law.isCovered) remarks += law.law == "network" ? ", outside its range: power law" : ", outside its range";
  return remarks.empty() ? remarks : "  (" + remarks.substr(2) + ")";
}

std::string readableText(const CutReport& report, const OperationValues& values) {
  std::string text = report.material.name + ", depth " + shownText(report.cut.depth) + " mm, feed " +
                     shownText(report.cut.feed) + " mm, speed " + shownText(report.cut.speed) + " m/min\n" +
                     padded("", 10);
  for (const char* column : {"cutting N", "feed N", "radial N", "result. N", "power kW", "motor kW"})
    text += padded(column, 11);
  text = text.substr(0, text.find_last_not_of(' ') + 1) + "\n";
  for (const LawForces& law : report.laws) {
    const double power = cuttingPower(law.forces, report.cut);
    text += padded(law.law, 10);
    for (const double value : {law.forces.cutting, law.forces.feed, law.forces.radial, law.forces.norm(), power,
                               motorPower(power, values.number("efficiency"))})
      text += padded(roundedText(value, 4), 11);
    while (text.ends_with(' ')) text.pop_back();
    text += remarksOn(law) + "\n";
  }
  if (report.uncorrected > 0.0)
    text += "Kosilova's law without correction factors: " + roundedText(report.uncorrected, 4) + " N.\n";
  if (!report.network.empty()) text += "No network: " + report.network + ".\n";
  for (const LawForces& law : report.laws) text += padded(law.law + ":", 10) + law.source + "\n";
  for (const CutWarning& warning : report.warnings) text += "Warning. " + textOf(warning) + "\n";
  return text;
}

std::string listOfMaterials(bool asJson) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  std::string text;
  const WorkMaterials& materials = WorkMaterials::standard();
  for (const WorkMaterial& m : materials.all()) {
    json.push_back({{"id", m.id},
                    {"name", m.name},
                    {"group", std::string(1, m.group)},
                    {"kc11", m.kienzle.kc11},
                    {"mc", m.kienzle.mc},
                    {"kosilova", m.kosilova},
                    {"verified", m.isVerified},
                    {"source", m.source}});
    text += padded(m.id, 36) + std::string(1, m.group) + "  kc1.1 " + padded(roundedText(m.kienzle.kc11, 4), 5) +
            " mc " + padded(roundedText(m.kienzle.mc, 3), 6) + m.name + (m.isVerified ? "" : ", unverified") + "\n";
  }
  return asJson ? textOf(json) : text;
}

int runForce(const Arguments& arguments, const DocumentKinds&) {
  if (arguments.has("list")) return print(listOfMaterials(arguments.has("json")));
  OperationValues values(forceOperation());
  if (const std::string problem = readOptions(arguments, values); !problem.empty()) return failUsage(problem, "force");
  if (const std::string problem = problemOfForceValues(values); !problem.empty())
    return failUsage(sentenceOf(problem), "force");
  const Result<CutReport> report = reportOn(values, arguments.valueOf("model"));
  if (!report) return fail(report.error());
  return print(arguments.has("json") ? jsonText(*report, values) : readableText(*report, values));
}

}  // namespace

Command forceCommand() {
  CommandSpec spec = {
      forceOperation().id,
      "",
      "Calculates the forces of a turning cut by Kosilova's and Kienzle's law and by a trained network, with power,\n"
      "torque and the rules that the cut breaks. Each law names its source; values that were not compared with their\n"
      "source are marked 'unverified'. Sources differ by a quarter. Exit code 0: done; 1: error.",
      {},
      "(--material M --depth MM --feed MM --speed M/MIN [--model FILE] [...] | --list) [--json]"};
  spec.options = optionsOf(forceOperation());
  spec.options.push_back({"model", 0, "FILE", "A model that 'handwheel train' wrote, in place of the one that ships"});
  spec.options.push_back({"list", 0, "", "List the work materials with their constants"});
  spec.options.push_back({"json", 0, "", "Report as JSON"});
  spec.options.push_back({"help", 'h', "", "Show this help"});
  return {std::move(spec), runForce};
}

}  // namespace handwheel
