// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands/InspectCommand.h"

#include "base/NumberText.h"
#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/PlansText.h"
#include "cli/PropertyText.h"
#include "cli/ReportJson.h"
#include "cli/ReportText.h"
#include "document/Document.h"
#include "document/mesh/ImplausibleUnit.h"
#include "document/mesh/MeshSnapshot.h"
#include "document/workpiece/target/TargetImport.h"
#include "text/NoteText.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

CommandSpec inspectSpec() {
  return {
      "inspect",
      "IN",
      "Lists the contents and the defects of a file.\nIN may also be the name of a built-in robot, as irb120.",
      {
          {"json", 0, "", "Print the figures as JSON"},
          {"target", 0, "FILE", "Target shape of a workpiece, in any format of 'target': lists the deviation from it"},
          {"partial", 0, "", "Read the undamaged part of a damaged file"},
          {"help", 'h', "", "Show this help"},
      }};
}

namespace {

// Formats "diameter: 50 mm", a line for each property; "joint.a: 0 deg (-170 deg to 170 deg)" if it has a range.
std::string readableText(const OpenedFile& opened) {
  std::string text = opened.kind->id() + "\n";
  const std::unique_ptr<Document> document = opened.kind->make(opened);
  for (const Property& property : document->properties()) {
    text += "  " + property.id + ": " + propertyText(property);
    if (property.continuous) text += " (" + limitsText(property) + ")";
    if (!property.problem.empty()) text += " (" + property.problem + ")";
    text += "\n";
  }
  return text;
}

// Describes the surface that the passes have left, a line for each section; only the first of very many.
std::string finishText(const nlohmann::json& described) {
  constexpr std::size_t kMost = 50;
  std::string text;
  const nlohmann::json finish = described.value("finish", nlohmann::json::object());
  for (const char* const side : {"outside", "bore"}) {
    const nlohmann::json stretches = finish.value(side, nlohmann::json::array());
    for (std::size_t i = 0; i < std::min(stretches.size(), kMost); ++i)
      text += std::string("  ") + side + " " + stretches[i]["text"].get<std::string>() + "\n";
    if (stretches.size() > kMost)
      text += std::string("  ") + side + " and " + std::to_string(stretches.size() - kMost) + " more\n";
  }
  return text;
}

// Returns the dimensions that a kind reports, a line for each, its finish, and the distance of the document from its
// target.
std::string dimensionsText(const nlohmann::json& described) {
  std::string text;
  for (const nlohmann::json& dimension : described.value("dimensions", nlohmann::json::array()))
    text += "  " + dimension.value("text", std::string()) + "\n";
  text += finishText(described);
  if (described.contains("dimensions") && described.contains("position")) {
    const double end = described["position"].get<double>();
    text = "  Z below: the end of the bar in the chuck is at Z " + shownText(end) + ", its free end at Z " +
           shownText(end + described["length"].get<double>()) + "\n" + text;
  }
  const nlohmann::json target = described.value("target", nlohmann::json());
  if (!target.is_object()) return text;
  const nlohmann::json& deviation = target["deviation"];
  const auto distance = [&](const char* which) {
    return shownText(std::abs(deviation[which]["distance"].get<double>()));
  };
  return text + "  target " + target["source"].get<std::string>() + ": " + distance("largest_over") +
         " mm too large, " + distance("largest_under") + " mm too small at most\n";
}

// Returns the values that every container has.
nlohmann::ordered_json heading(const OpenedFile& opened) {
  return {{"kind", opened.kind->id()}, {"id", opened.file.id}, {"display_unit", symbolOf(opened.file.displayUnit)}};
}

nlohmann::ordered_json toJson(const OpenedFile& opened, const nlohmann::json& described) {
  nlohmann::ordered_json json = heading(opened);
  json["document"] = described;
  return json;
}

// Returns the numbers of the loops of a document that stay open.
std::vector<int> keptOpen(const MeshSnapshot& document) {
  std::vector<int> ids;
  for (const BoundaryLoop& loop : document.mesh.defects->loops) {
    if (document.keptOpen.contains(keyOf(document.mesh.mesh, loop))) ids.push_back(loop.id);
  }
  return ids;
}

std::string unitText(const Input& input, const MeshReport& report) {
  if (!isUnitImplausible(input.opened.file, report.box)) return {};
  const bool isLarge = report.box.sizes().maxCoeff() > kLargestLikelySize;
  return "\n" + noteText(implausibleUnit(report.box)).toStdString() +
         (isLarge ? " 'handwheel edit' with the step 'place --unit um' converts it from micrometres.\n"
                  : " 'handwheel edit' with the step 'place --unit m' converts it from metres; cm and in are possible, "
                    "too.\n");
}

std::string meshText(const Input& input, const MeshReport& report) {
  const MeshSnapshot* document = input.meshDocument();
  if (!document) return handwheel::readableText(report) + unitText(input, report);
  std::string text = readableText(input.opened) + "\n" + handwheel::readableText(report);
  for (const int id : keptOpen(*document)) text += "Loop " + std::to_string(id) + " is kept open.\n";
  return text;
}

nlohmann::ordered_json meshJson(const Input& input, const MeshReport& report) {
  const MeshSnapshot* document = input.meshDocument();
  nlohmann::ordered_json json = document ? heading(input.opened) : nlohmann::ordered_json();
  json.update(handwheel::toJson(report));
  json["unit_doubtful"] = isUnitImplausible(input.opened.file, report.box);
  if (!document) return json;
  json["kept_open"] = keptOpen(*document);
  return json;
}

struct Inspected {
  Input input;
  MeshReport report;
  nlohmann::json described;  // description of a document that is no mesh; takes seconds for a cell with proofs
};

// Gives the workpiece this target. Errors: Unsupported for other kinds; those of importTarget().
Status giveTarget(OpenedFile& opened, const std::string& path, Progress progress) {
  const auto* const given = dynamic_cast<const WorkpieceSnapshot*>(opened.content.get());
  if (!given) return Error{ErrorCode::Unsupported, {"a target of a document other than a workpiece"}, {}, {}};
  const Result<ImportedTarget> imported = importTarget(path, UnturnedFaces::Refuse, progress);
  if (!imported) return imported.error();
  auto workpiece = std::make_shared<WorkpieceSnapshot>(*given);
  workpiece->target = placedTarget(*imported, given->stock);
  opened.content = std::move(workpiece);
  return Done{};
}

// Opens a file, or a document that comes with the program.
Result<Input> inputOf(const Arguments& arguments, const Registered& registered, Progress progress) {
  const std::string& name = arguments.operands[0];
  for (const ShippedDocument shipped : registered.shipped) {
    if (auto document = shipped(name, registered.kinds)) return Input{*std::move(document), {}};
  }
  return readInput(name, {.partial = arguments.has("partial")}, registered.kinds, progress);
}

Result<Inspected> inspect(const Arguments& arguments, const Registered& registered, Progress progress) {
  Result<Input> input = inputOf(arguments, registered, progress.part(0.0, 0.3));
  if (!input) return input.error();
  Inspected result{std::move(input.value()), {}, {}};
  if (arguments.has("target")) {
    const Status given = giveTarget(result.input.opened, arguments.valueOf("target"), progress.part(0.3, 0.9));
    if (!given) return given.error();
  }
  const OpenedFile& opened = result.input.opened;
  if (result.input.mesh)
    result.report = reportOn(result.input, SelfIntersections::Count, progress.part(0.3, 1.0));
  else
    result.described = opened.kind->describe(*opened.content);
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  return result;
}

}  // namespace

int runInspect(const Arguments& arguments, const Registered& registered) {
  std::optional<Result<Inspected>> result;
  runInterruptible("Inspecting", [&](CommandJob& job) { result = inspect(arguments, registered, job.progress()); });
  if (!*result) return fail(result->error());
  const auto& [input, report, described] = result->value();
  DocumentFile file = input.opened.file;
  if (input.mesh) file.lost.clear();  // nothing is written, so nothing can be lost
  reportLosses(file);
  const bool json = arguments.has("json");
  if (input.mesh) return print(json ? textOf(meshJson(input, report)) : meshText(input, report));
  if (json) return print(textOf(toJson(input.opened, described)));
  return print(readableText(input.opened) + plansText(described, "  ") + dimensionsText(described));
}

}  // namespace handwheel
