// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fidelity/CurveFile.h"

#include <cmath>
#include <ctime>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <thread>

namespace handwheel {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Json rowJson(const FidelitySetting& setting, const FidelityRow& r) {
  return {{"value", textOf(setting, r.value)},
          {"case", r.testCase},
          {"error", std::isfinite(r.error) ? Json(r.error) : Json(nullptr)},
          {"cost", r.cost},
          {"spread", r.spread},
          {"repeats", r.repeats},
          {"seed", r.seed},
          {"truth", r.truth}};
}

FidelityRow rowOf(const FidelitySetting& setting, const Json& j) {
  FidelityRow r;
  r.setting = setting.id;
  const Result<double> value = valueOf(setting, j.at("value").get<std::string>());
  if (!value) throw std::invalid_argument("a value is out of range");
  r.value = *value;
  r.testCase = j.at("case").get<std::string>();
  r.error = j.at("error").is_null() ? kInfinity : j.at("error").get<double>();
  r.errorUnit = setting.error.unit;
  r.cost = j.at("cost").get<double>();
  r.costUnit = setting.cost.unit;
  r.spread = j.at("spread").get<double>();
  r.repeats = j.at("repeats").get<int>();
  r.seed = j.at("seed").get<std::uint64_t>();
  r.truth = j.at("truth").get<std::string>();
  if (!(r.error >= 0.0) || !(r.cost >= 0.0)) throw std::invalid_argument("an error or a cost is below zero");
  return r;
}

}  // namespace

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm date{};
  gmtime_r(&now, &date);
  char text[16];
  return {text, std::strftime(text, sizeof text, "%Y-%m-%d", &date)};
}

std::string machineClass() {
  std::string processor = "unknown processor";
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    const std::size_t colon = line.find(": ");
    if (!line.starts_with("model name") || colon == std::string::npos) continue;
    processor = line.substr(colon + 2);
    break;
  }
  return processor + ", " + std::to_string(std::thread::hardware_concurrency()) + " cores";
}

std::string jsonOf(const FidelitySetting& setting, const CurveFile& curve) {
  std::string text = "{\n  \"setting\": " + Json(setting.id).dump() + ",\n  \"date\": " + Json(curve.date).dump() +
                     ",\n  \"machine\": " + Json(curve.machine).dump() +
                     ",\n  \"error\": " + Json(setting.error.name + " (" + setting.error.unit + ")").dump() +
                     ",\n  \"cost\": " + Json(setting.cost.name + " (" + setting.cost.unit + ")").dump() +
                     ",\n  \"rows\": [\n";
  for (std::size_t i = 0; i < curve.rows.size(); ++i) {
    text += "    " + rowJson(setting, curve.rows[i]).dump() + (i + 1 < curve.rows.size() ? ",\n" : "\n");
  }
  return text + "  ]\n}\n";
}

Result<CurveFile> readCurveFile(const FidelitySetting& setting, std::string_view json) {
  try {
    const Json j = Json::parse(json);
    CurveFile curve;
    if (j.at("setting").get<std::string>() != setting.id) throw std::invalid_argument("it is of another setting");
    curve.date = j.at("date").get<std::string>();
    curve.machine = j.at("machine").get<std::string>();
    for (const Json& row : j.at("rows")) curve.rows.push_back(rowOf(setting, row));
    return curve;
  } catch (const std::exception& problem) {
    return Error{ErrorCode::ElementMalformed, {setting.id, problem.what()}, {}, {}};
  }
}

}  // namespace handwheel
