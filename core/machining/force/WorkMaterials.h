// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "machining/force/KienzleModel.h"
#include "machining/force/KosilovaModel.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// A material to be turned, with the constants of its cutting forces and their sources.
struct WorkMaterial {
  std::string id;         // stable, for files and the command line: "medium-carbon-steel"
  std::string name;       // English
  char group = 'P';       // of ISO 513: P, M, K, N, S or H
  double strength = 0.0;  // MPa, tensile; 0: the source has none
  double hardness = 0.0;  // HB; 0: the source has none
  KienzleConstants kienzle;
  std::vector<std::pair<double, double>> measured;  // mm, N/mm²: the table that the constants were fitted to
  std::vector<std::string> kosilova;                // ids of rows that fit it
  std::string source;                               // a sentence
  bool isVerified = false;                          // the source was read, and not remembered
};

inline constexpr const char* kUsualMaterial = "medium-carbon-steel";

// The registry of the materials that can be turned.
class WorkMaterials {
 public:
  // Errors: ElementMalformed.
  static Result<WorkMaterials> fromJson(std::string_view text);
  // Those that the program ships: one table for all, read with the first use.
  static const WorkMaterials& standard();

  const std::vector<WorkMaterial>& all() const& { return m_all; }
  void all() const&& = delete;  // of a registry that ends with the expression
  // The material of this id or name, in any case of letters; of other words the usual one, a medium carbon steel.
  const WorkMaterial& called(std::string_view words) const&;
  void called(std::string_view words) const&& = delete;
  const WorkMaterial* find(std::string_view id) const;  // null when unknown

 private:
  std::vector<WorkMaterial> m_all;
};

// The row of the handbook for a material and a tool: the first that fits both. Null where there is none.
const KosilovaRow* kosilovaRowFor(const KosilovaTables& tables, const WorkMaterial& material, ToolMaterial tool);

// The law of the handbook for a material; null where it has no row for it.
std::unique_ptr<KosilovaModel> kosilovaModel(const KosilovaTables& tables, const WorkMaterial& material,
                                             const CuttingEdge& edge, const ThrustSettings& thrust = {});
std::unique_ptr<KienzleModel> kienzleModel(const WorkMaterial& material, const CuttingEdge& edge,
                                           const ThrustSettings& thrust = {});

}  // namespace handwheel
