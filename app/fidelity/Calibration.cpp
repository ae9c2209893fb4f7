// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fidelity/Calibration.h"

#include "document/AtomicFile.h"
#include "document/FileBytes.h"
#include "fidelity/SphereServoLoop.h"

#include <QStandardPaths>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

namespace handwheel {
namespace {

using Json = nlohmann::ordered_json;

constexpr SweepOptions kCoarse{.steps = 5, .repeats = 3, .seed = 1};

bool isOfBuiltInCases(const FidelityRegistry::Entry& entry, const CurveFile& curve) {
  std::set<std::string> measured, builtIn;
  for (const FidelityRow& row : curve.rows) measured.insert(row.testCase);
  for (const FidelityCase& c : entry.cases) builtIn.insert(c.name);
  return measured == builtIn;
}

// An octave apart: between them the time hardly changes otherwise than evenly.
std::map<double, double> ticksInUse(Progress progress) {
  std::map<double, double> ticks;
  const double octaves = std::log2(kLargestServoRate / kLeastServoRate);
  for (int i = 0; i <= octaves && !progress.cancelled(); ++i) {
    const double rate = std::ldexp(kLeastServoRate, i);
    const double tick = tickInUse(rate, progress.part(i / (octaves + 1.0), (i + 1.0) / (octaves + 1.0)));
    if (tick > 0.0) ticks[rate] = tick;
  }
  return ticks;
}

Error malformed(const std::string& element, const std::string& problem) {
  return {ErrorCode::ElementMalformed, {element, problem}, {}, {}};
}

}  // namespace

std::vector<const FidelityRegistry::Entry*> machineDependent(const FidelityRegistry& registry) {
  std::vector<const FidelityRegistry::Entry*> entries;
  for (const FidelityBudget budget : {FidelityBudget::Core, FidelityBudget::Tick, FidelityBudget::Frame,
                                      FidelityBudget::Wait, FidelityBudget::Fill}) {
    for (const FidelityRegistry::Entry& entry : registry.entries()) {
      if (entry.setting.budget == budget) entries.push_back(&entry);
    }
  }
  return entries;
}

Status calibrate(const FidelityRegistry::Entry& entry, Calibration& calibration, Progress progress) {
  const bool isFirst = entry.setting.budget == FidelityBudget::Core;
  const std::map<double, double> used = isFirst ? ticksInUse(progress.part(0.0, 0.5)) : calibration.ticksInUse;
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  auto rows = sweep(entry.setting, entry.cases, kCoarse, progress.part(isFirst ? 0.5 : 0.0, 1.0));
  if (!rows) return rows.error();
  calibration.machine = machineClass();
  calibration.ticksInUse = used;
  calibration.curves[entry.setting.id] = {today(), calibration.machine, std::move(*rows)};
  return Done{};
}

std::string jsonOf(const FidelityRegistry& registry, const Calibration& calibration) {
  Json json{{"version", kCalibrationVersion},
            {"machine", calibration.machine},
            {"ticks_in_use", Json::array()},
            {"curves", Json::array()}};
  for (const auto& [rate, tick] : calibration.ticksInUse)
    json["ticks_in_use"].push_back({{"rate", rate}, {"us", tick}});
  for (const auto& [id, curve] : calibration.curves)
    json["curves"].push_back(Json::parse(jsonOf(registry.find(id)->setting, curve)));
  return json.dump(1) + "\n";
}

Result<Calibration> readCalibration(const FidelityRegistry& registry, std::string_view text) {
  try {
    const Json json = Json::parse(text);
    const int version = json.at("version").get<int>();
    if (version != kCalibrationVersion)
      return Error{ErrorCode::VersionNewer, {std::to_string(version), std::to_string(kCalibrationVersion)}, {}, {}};
    Calibration calibration;
    calibration.machine = json.at("machine").get<std::string>();
    for (const Json& each : json.at("ticks_in_use")) {
      const double rate = each.at("rate").get<double>(), tick = each.at("us").get<double>();
      if (!(rate > 0.0 && tick > 0.0)) return malformed("ticks_in_use", "a rate or a time is not above zero");
      calibration.ticksInUse[rate] = tick;
    }
    for (const Json& each : json.at("curves")) {
      const std::string id = each.at("setting").get<std::string>();
      const FidelityRegistry::Entry* entry = registry.find(id);
      if (!entry) continue;
      Result<CurveFile> curve = readCurveFile(entry->setting, each.dump());
      if (!curve) return curve.error();
      if (isOfBuiltInCases(*entry, *curve)) calibration.curves[id] = std::move(*curve);
    }
    return calibration;
  } catch (const std::exception& problem) {
    return malformed("calibration", problem.what());
  }
}

std::filesystem::path defaultCalibrationFile() {
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::CacheLocation);
  return std::filesystem::path(folder.toStdString()) / "calibration.json";
}

Status storeCalibration(const FidelityRegistry& registry, const Calibration& calibration,
                        const std::filesystem::path& path) {
  std::error_code failed;  // then there is no folder to write to, which is what is reported
  std::filesystem::create_directories(path.parent_path(), failed);
  return writeFileAtomically(path, jsonOf(registry, calibration));
}

Result<Calibration> loadCalibration(const FidelityRegistry& registry, const std::filesystem::path& path) {
  const Result<std::string> text = readFileBytes(path);
  if (!text) return text.error();
  return readCalibration(registry, *text);
}

}  // namespace handwheel
