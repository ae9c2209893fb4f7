// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/force/WorkMaterials.h"

#include "base/JsonText.h"
#include "machining/force/ForceResources.h"

#include <algorithm>
#include <cassert>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

WorkMaterial materialIn(const nlohmann::json& json, const nlohmann::json& sources) {
  WorkMaterial material;
  material.id = json.at("id");
  material.name = json.at("name");
  material.group = json.at("group").get<std::string>().at(0);
  material.strength = json.value("strength", 0.0);
  material.hardness = json.value("hardness", 0.0);
  material.source = sources.at(json.at("source").get<std::string>());
  if (json.contains("row")) material.source += ", " + json.at("row").get<std::string>();
  material.isVerified = json.at("verified");
  if (json.contains("kosilova")) material.kosilova = json.at("kosilova").get<std::vector<std::string>>();
  if (json.contains("kc")) {
    for (const nlohmann::json& entry : json.at("kc")) material.measured.emplace_back(entry.at(0), entry.at(1));
    material.kienzle = fittedConstants(material.measured);
  } else {
    material.kienzle = {json.at("kc11"), json.at("mc")};
  }
  return material;
}

}  // namespace

Result<WorkMaterials> WorkMaterials::fromJson(std::string_view text) {
  const Result<nlohmann::json> json = parseJson(text, "the table of materials");
  if (!json) return json.error();
  WorkMaterials materials;
  try {
    for (const nlohmann::json& row : json->at("materials"))
      materials.m_all.push_back(materialIn(row, json->at("sources")));
  } catch (const std::exception& problem) {  // from the library, or an empty group
    return Error{ErrorCode::ElementMalformed, {"the table of materials", problem.what()}, {}, {}};
  }
  return materials;
}

const WorkMaterials& WorkMaterials::standard() {
  static const Result<WorkMaterials> kShipped = fromJson(materialsResource());
  assert(kShipped);
  return *kShipped;
}

const WorkMaterial* WorkMaterials::find(std::string_view id) const {
  const auto found = std::find_if(m_all.begin(), m_all.end(), [&](const WorkMaterial& m) { return m.id == id; });
  return found == m_all.end() ? nullptr : &*found;
}

const WorkMaterial* WorkMaterials::named(std::string_view words) const {
  const auto isSame = [](char a, char b) {
    const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    return small(a) == small(b);
  };
  for (const WorkMaterial& material : m_all) {
    for (const std::string& name : {material.id, material.name}) {
      if (std::equal(name.begin(), name.end(), words.begin(), words.end(), isSame)) return &material;
    }
  }
  return nullptr;
}

const WorkMaterial& WorkMaterials::called(std::string_view words) const& {
  if (const WorkMaterial* const known = named(words)) return *known;
  const WorkMaterial* const usual = find(kUsualMaterial);
  return usual ? *usual : m_all.front();
}

const KosilovaRow* kosilovaRowFor(const KosilovaTables& tables, const WorkMaterial& material, ToolMaterial tool) {
  for (const std::string& id : material.kosilova) {
    const KosilovaRow* row = tables.find(id);
    if (row && row->tool == tool) return row;
  }
  return nullptr;
}

std::unique_ptr<KosilovaModel> kosilovaModel(const KosilovaTables& tables, const WorkMaterial& material,
                                             const CuttingEdge& edge, const ThrustSettings& thrust) {
  const KosilovaRow* row = kosilovaRowFor(tables, material, edge.material);
  if (!row) return nullptr;
  const double property = row->isByHardness ? material.hardness : material.strength;
  return std::make_unique<KosilovaModel>(tables, *row, property, edge, thrust);
}

std::unique_ptr<KienzleModel> kienzleModel(const WorkMaterial& material, const CuttingEdge& edge,
                                           const ThrustSettings& thrust) {
  return std::make_unique<KienzleModel>(material.kienzle, edge, thrust);
}

}  // namespace handwheel
