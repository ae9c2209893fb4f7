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
  std::string id;         // stable id for files and the command line, for example "medium-carbon-steel"
  std::string name;       // English name
  char group = 'P';       // material group of ISO 513: P, M, K, N, S or H
  double strength = 0.0;  // MPa, tensile strength; 0: the source has none
  double hardness = 0.0;  // HB; 0: the source has none
  KienzleConstants kienzle;
  std::vector<std::pair<double, double>> measured;  // mm and N/mm²; the table that the constants were fitted to
  std::vector<std::string> kosilova;                // ids of the Kosilova rows for this material
  std::string source;                               // the source of the constants, as a sentence
  bool isVerified = false;                          // the source was checked, not quoted from memory
};

inline constexpr const char* kUsualMaterial = "medium-carbon-steel";

// The registry of the materials that can be turned.
class WorkMaterials {
 public:
  // Reads materials from JSON. Errors: ElementMalformed.
  static Result<WorkMaterials> fromJson(std::string_view text);
  // Returns the shipped materials. They are read at the first use and shared by all callers.
  static const WorkMaterials& standard();

  const std::vector<WorkMaterial>& all() const& { return m_all; }
  void all() const&& = delete;  // A temporary registry would be destroyed before its list is used.
  // Returns the material with this id or name; upper and lower case are the same. Null if there is none.
  const WorkMaterial* named(std::string_view words) const;
  // The same; for other words it returns the usual material, a medium carbon steel.
  const WorkMaterial& called(std::string_view words) const&;
  void called(std::string_view words) const&& = delete;
  const WorkMaterial* find(std::string_view id) const;  // null if there is no such material

 private:
  std::vector<WorkMaterial> m_all;
};

// Returns the first row of the handbook that fits both the material and the tool, or null if there is none.
const KosilovaRow* kosilovaRowFor(const KosilovaTables& tables, const WorkMaterial& material, ToolMaterial tool);

// Returns the law of the handbook for a material, or null if the handbook has no row for it.
std::unique_ptr<KosilovaModel> kosilovaModel(const KosilovaTables& tables, const WorkMaterial& material,
                                             const CuttingEdge& edge, const ThrustSettings& thrust = {});
std::unique_ptr<KienzleModel> kienzleModel(const WorkMaterial& material, const CuttingEdge& edge,
                                           const ThrustSettings& thrust = {});

}  // namespace handwheel
