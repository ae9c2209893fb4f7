// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh/RepairArguments.h"

#include "cli/FidelityOption.h"
#include "cli/Input.h"
#include "cli/Messages.h"
#include "cli/Picture.h"
#include "cli/Wording.h"
#include "mesh/measure/MeshFidelity.h"

#include <optional>

namespace handwheel {

namespace {

bool readIds(std::string_view list, std::set<int>& ids) {
  while (true) {
    const std::size_t comma = list.find(',');
    int id = 0;
    if (!readNumber(list.substr(0, comma), id)) return false;
    ids.insert(id);
    if (comma == std::string_view::npos) return true;
    list.remove_prefix(comma + 1);
  }
}

// OUT may be IN, but what is written beside must not replace either, nor another document, nor one another.
std::string problemBeside(const RepairRequest& request, const Arguments& arguments, const DocumentKinds& kinds) {
  const std::string report = arguments.valueOf("report"), picture = arguments.valueOf("screenshot");
  for (const std::string& beside : {report, picture}) {
    if (beside.empty()) continue;
    if (isSameFile(beside, request.input) || isSameFile(beside, request.output)) {
      return "IN and OUT cannot be the report or the screenshot too: " + beside + ".";
    }
  }
  const bool both = !report.empty() && !picture.empty();
  if (both && isSameFile(report, picture)) return "The report and the screenshot need a file each.";
  if (isDocumentName(report, kinds)) return "--report takes a name such as part.json, not that of a document.";
  if (!picture.empty() && !isPictureName(picture)) return "--screenshot takes a name that ends in .png.";
  std::error_code error;
  for (const std::string& beside : {report, picture}) {
    const std::filesystem::path folder = std::filesystem::path(beside).parent_path();
    if (!folder.empty() && !std::filesystem::is_directory(folder, error)) {
      return "There is no folder " + folder.string() + " for " + beside + ".";
    }
  }
  return {};
}

std::optional<RimHandling> rimHandlingFor(const std::string& word) {
  if (word == "keep") return RimHandling::Keep;
  if (word == "back") return RimHandling::Back;
  if (word == "fill") return RimHandling::Fill;
  return std::nullopt;
}

}  // namespace

std::string readRepairOptions(const Arguments& arguments, RepairRequest& request) {
  request.read.partial = arguments.has("partial");
  if (arguments.has("rims")) {
    const auto rims = rimHandlingFor(arguments.valueOf("rims"));
    if (!rims) return "--rims takes keep, back or fill.";
    request.options.rims = *rims;
  }
  request.options.removeDebris = arguments.has("remove-debris");
  request.options.replaceFoldedRegions = !arguments.has("keep-folded-regions");
  request.options.cutCrossings = arguments.has("cut-crossings");
  if (arguments.has("fidelity")) {
    // Those that apply() puts into the options.
    const FidelitySetting read[] = {nearWeldSetting(), fillMethodSetting(), fillContinuitySetting(),
                                    patchDensitySetting(), pieceEdgesSetting()};
    FidelityValues values;
    const std::string problem = readFidelity(arguments, "repair", read, values);
    if (!problem.empty()) return problem;
    apply(values, request.options);
  }
  if (arguments.has("fill")) {
    const auto method = fillMethodFor(arguments.valueOf("fill"));
    if (!method) return "--fill takes fair, ridge, refined, ear, minimal, area or dihedral.";
    request.options.fill.method = *method;
  }
  if (arguments.has("continuity")) {
    const auto continuity = valueOf(fillContinuitySetting(), arguments.valueOf("continuity"));
    if (!continuity) return "--continuity takes position, tangent or curvature.";
    request.options.fill.continuity = static_cast<Continuity>(*continuity);
  }
  if (arguments.has("keep-open") && !readIds(arguments.valueOf("keep-open"), request.options.keepOpen)) {
    return "--keep-open takes loop numbers separated by commas.";
  }
  if (arguments.has("max-hole") &&
      (!readNumber(arguments.valueOf("max-hole"), request.options.maxEdges) || request.options.maxEdges == 0)) {
    return "--max-hole takes a number of edges above zero.";
  }
  const std::string unit = unitOf(arguments);
  if (unit != "mm" && unit != "cm" && unit != "m" && unit != "in") return "--unit takes mm, cm, m or in.";
  return {};
}

std::string readRequest(const Arguments& arguments, const DocumentKinds& kinds, RepairRequest& request) {
  if (!arguments.has("output")) return "The option -o OUT is missing.";
  request.input = arguments.operands[0];
  request.output = arguments.valueOf("output");
  request.inspectInput = arguments.has("report");
  const std::string problem = readRepairOptions(arguments, request);
  return problem.empty() ? problemBeside(request, arguments, kinds) : problem;
}

std::string unitOf(const Arguments& arguments) {
  return arguments.has("unit") ? arguments.valueOf("unit") : "mm";
}

}  // namespace handwheel
