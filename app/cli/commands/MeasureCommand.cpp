// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands/MeasureCommand.h"

#include "cli/BenchmarkRun.h"
#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/ReportJson.h"
#include "cli/commands/MeasureReport.h"
#include "document/AtomicFile.h"
#include "fidelity/CurveFile.h"
#include "fidelity/MeasuredSettings.h"
#include "plot/PlotExport.h"

#include <QFile>
#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr QSize kPlotSize(560, 420);

struct MeasureRequest {
  FidelityRegistry registry = measuredSettings();
  std::vector<const FidelityRegistry::Entry*> entries;
  std::vector<std::filesystem::path> inputs;
  FidelityBudgets budgets;
  SweepOptions sweep;
};

// Parses "us=50,ms=16,mb=200".
bool readBudgets(std::string_view list, FidelityBudgets& budgets) {
  static const std::map<std::string_view, std::string> kUnits{{"us", "us"}, {"ms", "ms"}, {"mb", "MB"}};
  while (true) {
    const std::size_t comma = list.find(',');
    const std::string_view word = list.substr(0, comma);
    const std::size_t equals = word.find('=');
    const auto unit = kUnits.find(word.substr(0, equals));
    double value = 0.0;
    if (equals == std::string_view::npos || unit == kUnits.end() || !readNumber(word.substr(equals + 1), value)) {
      return false;
    }
    if (!(value > 0.0) || !std::isfinite(value)) return false;
    budgets[unit->second] = value;
    if (comma == std::string_view::npos) return true;
    list.remove_prefix(comma + 1);
  }
}

// Reads a count between one and a thousand; unset counts stay unchanged.
bool readCount(const Arguments& arguments, std::string_view name, int& count) {
  return !arguments.has(name) || (readNumber(arguments.valueOf(name), count) && count >= 1 && count <= 1000);
}

// Reads a request to measure as the window does, where only the settings can be chosen. Returns the error, or nothing.
std::string readCalibration(const Arguments& arguments, MeasureRequest& request) {
  for (const char* other : {"input", "budget", "steps", "repeats", "write-curves", "list"}) {
    if (arguments.has(other)) return std::string("--calibrate cannot be combined with --") + other + ".";
  }
  const std::vector<const FidelityRegistry::Entry*> dependent = machineDependent(request.registry);
  for (const FidelityRegistry::Entry* entry : request.entries) {
    if (std::find(dependent.begin(), dependent.end(), entry) == dependent.end())
      return "What " + entry->setting.id + " costs is no time of this machine.";
  }
  if (arguments.operands.empty()) request.entries = dependent;
  return {};
}

// Turns the words into a request. Returns the error, or nothing.
std::string readRequest(const Arguments& arguments, const DocumentKinds& kinds, MeasureRequest& request) {
  for (const std::string& id : arguments.operands) {
    const FidelityRegistry::Entry* entry = request.registry.find(id);
    if (!entry) return "There is no setting " + id + "; 'handwheel measure --list' names them.";
    request.entries.push_back(entry);
  }
  if (arguments.has("calibrate")) {
    if (const std::string problem = readCalibration(arguments, request); !problem.empty()) return problem;
  }
  if (request.entries.empty()) {
    for (const FidelityRegistry::Entry& entry : request.registry.entries()) request.entries.push_back(&entry);
  }
  for (const std::string& input : arguments.valuesOf("input")) request.inputs.emplace_back(input);
  if (arguments.has("budget") && !readBudgets(arguments.valueOf("budget"), request.budgets)) {
    return "--budget takes numbers above zero: us=50,ms=16,mb=200.";
  }
  if (!readCount(arguments, "steps", request.sweep.steps)) return "--steps takes a number from 1 to 1000.";
  if (!readCount(arguments, "repeats", request.sweep.repeats)) return "--repeats takes a number from 1 to 1000.";
  if (isDocumentName(arguments.valueOf("csv"), kinds))
    return "--csv takes a name such as curves.csv, not that of a document.";
  const std::string plot = std::filesystem::path(arguments.valueOf("plot")).extension().string();
  if (arguments.has("plot") && plot != ".png" && plot != ".svg" && plot != ".csv") {
    return "--plot takes a name that ends in .png, .svg or .csv.";
  }
  return {};
}

std::string list(const FidelityRegistry& registry) {
  std::string text;
  for (const FidelityRegistry::Entry& entry : registry.entries()) {
    const FidelitySetting& s = entry.setting;
    text += s.id + ": " + s.label + "\n  from " + textOf(s, s.least) + " to " + textOf(s, s.largest) +
            (s.unit.empty() ? "" : " (" + s.unit + ")") + ", default " + textOf(s, s.standard);
    for (FidelityPreset preset : kFidelityPresets) {
      text += ", " + std::string(wordFor(preset)) + " " + textOf(s, s.presetValue(preset));
    }
    text +=
        "\n  error: " + s.error.name + " (" + s.error.unit + ")\n  cost: " + s.cost.name + " (" + s.cost.unit + ")\n";
  }
  return text;
}

Result<std::vector<std::pair<std::string, SoupSource>>> readInputs(const MeasureRequest& request,
                                                                   const DocumentKinds& kinds, Progress progress) {
  std::vector<std::pair<std::string, SoupSource>> soups;
  for (const std::filesystem::path& path : request.inputs) {
    Result<Input> input = readMeshInput(path, {}, kinds, progress);
    if (!input) return input.error();
    const auto soup = std::make_shared<const TriangleSoup>(std::move(input->mesh->soup));
    soups.emplace_back(path.filename().string(), [soup] { return soup; });
  }
  return soups;
}

Result<std::vector<MeasuredSetting>> measure(const MeasureRequest& request, const DocumentKinds& kinds,
                                             Progress progress) {
  const auto soups = readInputs(request, kinds, progress.part(0.0, 0.05));
  if (!soups) return soups.error();
  std::vector<MeasuredSetting> measured;
  const double n = static_cast<double>(request.entries.size());
  for (const FidelityRegistry::Entry* entry : request.entries) {
    std::vector<FidelityCase> cases = entry->cases;
    for (const auto& [name, soup] : *soups) {
      for (FidelityCase& c : casesOnMesh(entry->setting.id, name, soup)) cases.push_back(std::move(c));
    }
    const double i = static_cast<double>(measured.size());
    auto rows =
        sweep(entry->setting, cases, request.sweep, progress.part(0.05 + 0.95 * i / n, 0.05 + 0.95 * (i + 1.0) / n));
    if (!rows) return rows.error();
    measured.emplace_back(entry->setting, std::move(*rows));
  }
  return measured;
}

// Writes the requested files.
Status writeFiles(const std::vector<MeasuredSetting>& measured, const Arguments& arguments) {
  if (arguments.has("csv")) {
    std::string csv(kFidelityCsvHeader);
    for (const MeasuredSetting& m : measured) csv += csvOf(m.setting, m.rows);
    const Status written = writeFileAtomically(arguments.valueOf("csv"), csv);
    if (!written) return written;
  }
  if (arguments.has("plot")) {
    std::vector<Plot> plots;
    for (const MeasuredSetting& m : measured) plots.push_back(plotOf(m));
    const Status written = exportPlots(plots, QFile::decodeName(arguments.valueOf("plot").c_str()), kPlotSize,
                                       arguments.has("dark") ? ThemeKind::Dark : ThemeKind::Light);
    if (!written) return written;
  }
  for (const MeasuredSetting& m : measured) {
    if (!arguments.has("write-curves")) break;
    const auto path = std::filesystem::path(arguments.valueOf("write-curves")) / (m.setting.id + ".json");
    const Status written = writeFileAtomically(path, jsonOf(m.setting, {today(), machineClass(), m.rows}));
    if (!written) return written;
  }
  return Done{};
}

// Returns the settings for which no value keeps its budget.
std::vector<std::string> overBudget(const std::vector<MeasuredSetting>& measured, const FidelityBudgets& budgets) {
  std::vector<std::string> ids;
  for (const MeasuredSetting& m : measured) {
    const auto budget = budgets.find(m.setting.cost.unit);
    if (budget != budgets.end() && !fitToBudget(m.curve, budget->second)) ids.push_back(m.setting.id);
  }
  return ids;
}

std::string text(const std::vector<MeasuredSetting>& measured, const MeasureRequest& request, bool json) {
  if (json) {
    nlohmann::ordered_json settings = nlohmann::ordered_json::array();
    for (const MeasuredSetting& m : measured) settings.push_back(toJson(m, request.budgets));
    return textOf({{"date", today()}, {"machine", machineClass()}, {"settings", settings}});
  }
  std::string all;
  for (const MeasuredSetting& m : measured) all += (all.empty() ? "" : "\n") + readableText(m, request.budgets);
  return all;
}

int runCalibration(const MeasureRequest& request, const Arguments& arguments) {
  std::optional<Result<BenchmarkRun>> result;
  runInterruptible("Measuring this machine", [&](CommandJob& job) {
    result = benchmarkMachine(request.registry, request.entries, job.progress());
  });
  if (!*result) return fail(result->error());
  const BenchmarkRun& run = result->value();
  const Status written = writeFiles(run.measured, arguments);
  if (!written) return fail(written.error());
  if (const int code = print(arguments.has("json") ? textOf(toJson(run)) : readableText(run)); code != kExitDone)
    return code;
  if (!run.kept) return fail(run.kept.error());
  if (run.measured.size() == run.wanted) return kExitDone;
  complain("The time limit was reached; the last " + std::to_string(run.wanted - run.measured.size()) +
           " are unchanged.");
  return kExitSomethingLeft;
}

}  // namespace

CommandSpec measureSpec() {
  return {
      "measure",
      "[ID...]",
      "Measures the trade-off between speed and accuracy. Sweeps each setting (or those named) over its range on "
      "built-in\n"
      "shapes and prints error and cost, the Pareto front, its knee, and the values of the presets. Cost is CPU time.\n"
      "Exit code 0: done; 2: no value of a setting keeps within the budget; 1: error.",
      {
          {"calibrate", 0, "", "Measure the CPU time on this machine, and save it for the window"},
          {"input", 0, "FILE", "Measure on this mesh, too; can be given several times"},
          {"budget", 0, "LIST",
           "Show the most accurate value within us=...,ms=...,mb=... per step, with a third left unused"},
          {"csv", 0, "FILE", "Write the measurements as comma-separated values"},
          {"plot", 0, "FILE", "Plot error over cost, as .png or .svg, or write its points as .csv"},
          {"dark", 0, "", "Draw on a dark background"},
          {"json", 0, "", "Print everything as JSON"},
          {"list", 0, "", "List the settings only"},
          {"steps", 0, "N", "Values over each range (default 9)"},
          {"repeats", 0, "N", "Runs of each; the median is used (default 5)"},
          {"write-curves", 0, "FOLDER", "Write the curves from which presets are derived, one file for each setting"},
          {"help", 'h', "", "Show this help"},
      }};
}

int runMeasure(const Arguments& arguments, const DocumentKinds& kinds) {
  MeasureRequest request;
  const std::string problem = readRequest(arguments, kinds, request);
  if (!problem.empty()) return failUsage(problem, "measure");
  if (arguments.has("list")) return print(list(request.registry));

  if (arguments.has("calibrate")) return runCalibration(request, arguments);
  std::optional<Result<std::vector<MeasuredSetting>>> result;
  runInterruptible("Measuring", [&](CommandJob& job) { result = measure(request, kinds, job.progress()); });
  if (!*result) return fail(result->error());
  const std::vector<MeasuredSetting>& measured = result->value();
  const Status written = writeFiles(measured, arguments);
  if (!written) return fail(written.error());
  if (const int code = print(text(measured, request, arguments.has("json"))); code != kExitDone) return code;
  const std::vector<std::string> over = overBudget(measured, request.budgets);
  for (const std::string& id : over) complain("No value of " + id + " keeps within the budget.");
  return over.empty() ? kExitDone : kExitSomethingLeft;
}

}  // namespace handwheel
