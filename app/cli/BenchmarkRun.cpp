// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/BenchmarkRun.h"

#include "base/NumberText.h"

#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

using Json = nlohmann::ordered_json;

// Returns the stored calibration if it was made on this class of machine. Otherwise everything is measured anew.
Calibration keptBefore(const FidelityRegistry& registry, const std::filesystem::path& file) {
  Result<Calibration> kept = loadCalibration(registry, file);
  return kept && kept->machine == machineClass() ? std::move(*kept) : Calibration();
}

std::string costText(const MeasuredSetting& m, double value) {
  return roundedText(m.at(value).cost, 3);
}

}  // namespace

Result<BenchmarkRun> benchmarkMachine(const FidelityRegistry& registry,
                                      const std::vector<const FidelityRegistry::Entry*>& entries, Progress progress) {
  BenchmarkRun run;
  run.file = defaultCalibrationFile();
  run.calibration = keptBefore(registry, run.file);
  run.wanted = entries.size();
  const auto end = std::chrono::steady_clock::now() + kLongestCalibration;
  const double n = static_cast<double>(entries.size());
  for (const FidelityRegistry::Entry* entry : entries) {
    if (std::chrono::steady_clock::now() > end) break;
    const double i = static_cast<double>(run.measured.size());
    const Status done = calibrate(*entry, run.calibration, progress.part(i / n, (i + 1.0) / n));
    if (!done) return done.error();
    run.kept = storeCalibration(registry, run.calibration, run.file);
    run.measured.emplace_back(entry->setting, run.calibration.curves.at(entry->setting.id).rows);
  }
  return run;
}

std::string readableText(const BenchmarkRun& run) {
  std::string text = "Machine: " + run.calibration.machine + "\n";
  if (run.kept) text += "Saved in: " + run.file.string() + "\n";
  text += "\nCost on this machine in the worst case, at the presets and at the default\n";
  std::vector<TableRow> rows{{"setting", "unit", "draft", "balanced", "exact", "default"}};
  for (const MeasuredSetting& m : run.measured) {
    TableRow row{m.setting.id, m.setting.cost.unit};
    for (const FidelityPreset preset : kFidelityPresets) row.push_back(costText(m, m.setting.presetValue(preset)));
    row.push_back(costText(m, m.setting.standard));
    rows.push_back(row);
  }
  text += alignedTable(rows);
  if (run.calibration.ticksInUse.empty()) return text;
  text += "\nServo tick in contact, with the loop sleeping in between\n";
  rows = {{"rate", "unit", "us", "% of its period"}};
  for (const auto& [rate, tick] : run.calibration.ticksInUse)
    rows.push_back({roundedText(rate, 4), "Hz", roundedText(tick, 3), roundedText(1e-4 * tick * rate, 3)});
  return text + alignedTable(rows);
}

Json toJson(const BenchmarkRun& run) {
  Json json{{"date", today()},
            {"machine", run.calibration.machine},
            {"file", run.kept ? Json(run.file.string()) : Json(nullptr)},
            {"ticks_in_use", Json::array()},
            {"settings", Json::array()}};
  for (const auto& [rate, tick] : run.calibration.ticksInUse)
    json["ticks_in_use"].push_back({{"rate", rate}, {"us", tick}});
  for (const MeasuredSetting& m : run.measured) json["settings"].push_back(toJson(m, {}));
  return json;
}

}  // namespace handwheel
