// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/force/KosilovaTables.h"

#include "base/JsonText.h"
#include "base/Units.h"
#include "machining/force/ForceResources.h"

#include <algorithm>
#include <cassert>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

KosilovaLaw kosilovaLawIn(const nlohmann::json& row, const char* component, std::size_t index) {
  KosilovaLaw law;
  if (!row.contains(component)) return law;
  const nlohmann::json& given = row.at(component);
  law.c = given.at("c");
  law.x = given.at("x");
  law.y = given.at("y");
  law.n = given.at("n");
  law.isVerified = given.at("verified");
  law.materialExponent = row.at("exponents").at(index);
  return law;
}

ToolMaterial toolMaterialOf(const std::string& word) {
  return word == "carbide" ? ToolMaterial::Carbide : ToolMaterial::HighSpeedSteel;
}

KosilovaRow kosilovaRowIn(const nlohmann::json& json, const nlohmann::json& sources) {
  KosilovaRow row;
  row.id = json.at("id");
  row.work = json.at("work");
  row.tool = toolMaterialOf(json.at("tool"));
  row.operation = json.at("operation");
  row.source = sources.at(json.at("source").get<std::string>());
  row.isByHardness = json.contains("hardness");
  row.reference = json.at(row.isByHardness ? "hardness" : "strength");
  row.cutting = kosilovaLawIn(json, "cutting", 0);
  row.radial = kosilovaLawIn(json, "radial", 1);
  row.feed = kosilovaLawIn(json, "feed", 2);
  return row;
}

KosilovaCorrection::Of quantityOf(const std::string& word) {
  using Of = KosilovaCorrection::Of;
  if (word == "rake") return Of::Rake;
  if (word == "inclination") return Of::Inclination;
  return word == "nose" ? Of::Nose : Of::Approach;
}

KosilovaCorrection kosilovaCorrectionIn(const nlohmann::json& json) {
  KosilovaCorrection correction;
  correction.of = quantityOf(json.at("factor"));
  const std::string tool = json.at("tool");
  if (tool != "any") correction.tool = toolMaterialOf(tool);
  correction.at = json.at("at").get<std::vector<double>>();
  correction.verifiedAt = json.at("verified_cutting_at").get<std::vector<double>>();
  correction.factors = {json.at("cutting").get<std::vector<double>>(), json.at("radial").get<std::vector<double>>(),
                        json.at("feed").get<std::vector<double>>()};
  if (correction.of != KosilovaCorrection::Of::Nose) {
    for (double& angle : correction.at) angle *= kRadiansPerDegree;
    for (double& angle : correction.verifiedAt) angle *= kRadiansPerDegree;
  }
  return correction;
}

bool isSound(const KosilovaCorrection& correction) {
  const auto fits = [&](const std::vector<double>& factors) { return factors.size() == correction.at.size(); };
  return !correction.at.empty() && std::is_sorted(correction.at.begin(), correction.at.end()) &&
         std::all_of(correction.factors.begin(), correction.factors.end(), fits);
}

double interpolatedFactor(const std::vector<double>& at, const std::vector<double>& values, double value) {
  const auto above = static_cast<std::size_t>(std::upper_bound(at.begin(), at.end(), value) - at.begin());
  if (above == 0) return values.front();
  if (above == at.size()) return values.back();
  const double t = (value - at[above - 1]) / (at[above] - at[above - 1]);
  return (1.0 - t) * values[above - 1] + t * values[above];
}

std::optional<double> givenBy(const CuttingEdge& edge, KosilovaCorrection::Of of) {
  switch (of) {
    case KosilovaCorrection::Of::Approach:
      return edge.approach;
    case KosilovaCorrection::Of::Rake:
      return edge.rake;
    case KosilovaCorrection::Of::Inclination:
      return edge.inclination;
    case KosilovaCorrection::Of::Nose:
      break;
  }
  return edge.noseRadius;
}

}  // namespace

Result<KosilovaTables> KosilovaTables::fromJson(std::string_view text) {
  const Result<nlohmann::json> json = parseJson(text, "the table of forces");
  if (!json) return json.error();
  KosilovaTables tables;
  try {
    for (const nlohmann::json& row : json->at("rows")) tables.m_rows.push_back(kosilovaRowIn(row, json->at("sources")));
    for (const nlohmann::json& row : json->at("corrections")) tables.m_corrections.push_back(kosilovaCorrectionIn(row));
  } catch (const nlohmann::json::exception& problem) {
    return Error{ErrorCode::ElementMalformed, {"the table of forces", problem.what()}, {}, {}};
  }
  if (!std::all_of(tables.m_corrections.begin(), tables.m_corrections.end(), isSound))
    return Error{
        ErrorCode::ElementMalformed, {"corrections", "its lists differ in length, or are not ascending"}, {}, {}};
  return tables;
}

const KosilovaTables& KosilovaTables::standard() {
  static const Result<KosilovaTables> kShipped = fromJson(kosilovaResource());
  assert(kShipped);
  return *kShipped;
}

const KosilovaRow* KosilovaTables::find(std::string_view id) const {
  const auto found = std::find_if(m_rows.begin(), m_rows.end(), [&](const KosilovaRow& row) { return row.id == id; });
  return found == m_rows.end() ? nullptr : &*found;
}

EdgeFactors KosilovaTables::factorsOf(const CuttingEdge& edge) const {
  constexpr double kSameEntry = 1e-9;  // radian, mm
  EdgeFactors factors;
  for (const KosilovaCorrection& correction : m_corrections) {
    const std::optional<double> value = givenBy(edge, correction.of);
    if (!value || (correction.tool && *correction.tool != edge.material)) continue;
    factors.cutting *= interpolatedFactor(correction.at, correction.factors[0], *value);
    factors.radial *= interpolatedFactor(correction.at, correction.factors[1], *value);
    factors.feed *= interpolatedFactor(correction.at, correction.factors[2], *value);
    factors.isVerified &= std::any_of(correction.verifiedAt.begin(), correction.verifiedAt.end(),
                                      [&](double entry) { return std::abs(entry - *value) <= kSameEntry; });
  }
  return factors;
}

}  // namespace handwheel
