// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/drilling/DrillMaterials.h"

#include "base/JsonText.h"
#include "volume/drilling/DrillResources.h"

#include <algorithm>
#include <cassert>
#include <nlohmann/json.hpp>

namespace handwheel {

Result<std::vector<DrillMaterial>> drillMaterialsFromJson(std::string_view text) {
  const Result<nlohmann::json> json = parseJson(text, "the table of materials");
  if (!json) return json.error();
  std::vector<DrillMaterial> all;
  try {
    for (const nlohmann::json& row : json->at("materials")) {
      DrillMaterial material{row.at("id"),
                             row.at("name"),
                             row.at("energy"),
                             row.at("tangential"),
                             json->at("sources").at(row.at("source").get<std::string>()),
                             row.at("verified")};
      if (!(material.energy > 0.0) || !(material.tangential > 0.0))
        return Error{ErrorCode::ElementMalformed, {"the table of materials", material.id}, {}, {}};
      all.push_back(std::move(material));
    }
  } catch (const nlohmann::json::exception& problem) {
    return Error{ErrorCode::ElementMalformed, {"the table of materials", problem.what()}, {}, {}};
  }
  return all;
}

const std::vector<DrillMaterial>& drillMaterials() {
  static const Result<std::vector<DrillMaterial>> kShipped = drillMaterialsFromJson(drillMaterialsResource());
  assert(kShipped && !kShipped->empty());
  return *kShipped;
}

const DrillMaterial* drillMaterial(std::string_view id) {
  const std::vector<DrillMaterial>& all = drillMaterials();
  const auto found = std::find_if(all.begin(), all.end(), [&](const DrillMaterial& m) { return m.id == id; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace handwheel
