// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh/RepairArguments.h"

#include "cli/FidelityOption.h"
#include "cli/Input.h"
#include "cli/Messages.h"
#include "cli/OperationOptions.h"
#include "cli/Picture.h"
#include "mesh/measure/MeshFidelity.h"
#include "tools/mesh/operations/RepairOperation.h"

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

}  // namespace

std::string readRepairOptions(const Arguments& arguments, RepairRequest& request) {
  request.read.partial = arguments.has("partial");
  if (arguments.has("fidelity")) {
    // Those that apply() puts into the options.
    const FidelitySetting read[] = {nearWeldSetting(), fillMethodSetting(), fillContinuitySetting(),
                                    patchDensitySetting(), pieceEdgesSetting()};
    FidelityValues values;
    const std::string problem = readFidelity(arguments, "repair", read, values);
    if (!problem.empty()) return problem;
    apply(values, request.options);
  }
  OperationValues values = valuesOf(request.options);
  if (const std::string problem = readOptions(arguments, values); !problem.empty()) return problem;
  request.options = repairOptionsOf(values);
  if (arguments.has("keep-open") && !readIds(arguments.valueOf("keep-open"), request.options.keepOpen)) {
    return "--keep-open takes loop numbers separated by commas.";
  }
  const std::string wanted = unitOf(arguments);
  for (const LengthUnit unit : {LengthUnit::Millimetre, LengthUnit::Centimetre, LengthUnit::Metre, LengthUnit::Inch}) {
    if (wanted != symbolOf(unit)) continue;
    request.unit = unit;
    return {};
  }
  return "--unit takes mm, cm, m or in.";
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
