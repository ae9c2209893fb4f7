// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh/RepairJson.h"

#include "cli/OperationJson.h"
#include "cli/ReportJson.h"
#include "cli/Wording.h"
#include "text/LossText.h"
#include "tools/mesh/operations/FillOperation.h"
#include "tools/mesh/operations/RepairOperation.h"

#include <algorithm>

namespace handwheel {

namespace {

using Json = nlohmann::ordered_json;

// Those that can be asked for as --fill has them.
std::string methodWord(FillMethod method) {
  switch (method) {
    case FillMethod::Cone:
      return "cone";
    case FillMethod::ThickenedSheet:
      return "backed";
    case FillMethod::Stitched:
      return "stitched";
    case FillMethod::Removed:
      return "removed";
    default:
      return fillOperation().find("fill")->words[static_cast<std::size_t>(method)];
  }
}

Json toJson(const SheetThickness& thickness) {
  if (thickness.largest == 0.0) return nullptr;
  return {{"least", thickness.least},
          {"largest", thickness.largest},
          {"vertices", thickness.vertices},
          {"thin_vertices", thickness.thinVertices}};
}

Json toJson(const std::optional<FarthestRemovedVertex>& removed) {
  if (!removed) return nullptr;
  return {{"distance_mm", removed->distance},
          {"at", {removed->position.x(), removed->position.y(), removed->position.z()}}};
}

Json toJson(const LoopResult& loop) {
  const bool filled = loop.outcome == LoopOutcome::Filled;
  Json json = {
      {"id", loop.id},
      {"sheet_boundary", loop.isSheetBoundary},
      {"edges", loop.edges},
      {"outcome", wordFor(loop.outcome)},
      {"method", filled ? Json(methodWord(loop.method)) : Json(nullptr)},
      {"substitute", filled ? Json(wordFor(loop.substitute)) : Json(nullptr)},
      {"reason", filled ? Json(nullptr) : Json(reasonSentence(loop.reason))},
      {"new_faces", loop.newFaces},
      {"bend_deg", loop.shape.isKnown() ? Json(loop.shape.bend / kRadiansPerDegree) : Json(nullptr)},
      {"bend_around_deg", loop.shape.isKnown() ? Json(loop.shape.bendAround / kRadiansPerDegree) : Json(nullptr)},
      {"ms", loop.milliseconds},
  };
  addFormerKeys(json, {{"sheet_boundary", "rim"}});
  return json;
}

// The members of LoopCounts by their keys in JSON.
constexpr struct {
  const char* key;
  const char* former;  // name in older files; null: the same
  OutcomeCounts LoopCounts::*loops;
  std::size_t OutcomeCounts::*count;
} kCounts[] = {
    {"holes", nullptr, &LoopCounts::holes, &OutcomeCounts::all},
    {"filled", nullptr, &LoopCounts::holes, &OutcomeCounts::closed},
    {"removed", nullptr, &LoopCounts::holes, &OutcomeCounts::removed},
    {"kept_open", nullptr, &LoopCounts::holes, &OutcomeCounts::kept},
    {"not_filled", nullptr, &LoopCounts::holes, &OutcomeCounts::failed},
    {"sheet_boundaries", "sheet_edges", &LoopCounts::sheetBoundaries, &OutcomeCounts::all},
    {"sheet_boundaries_closed", "sheet_edges_closed", &LoopCounts::sheetBoundaries, &OutcomeCounts::closed},
    {"sheet_boundaries_removed", "sheet_edges_removed", &LoopCounts::sheetBoundaries, &OutcomeCounts::removed},
    {"sheet_boundaries_kept_open", "sheet_edges_kept_open", &LoopCounts::sheetBoundaries, &OutcomeCounts::kept},
    {"sheet_boundaries_not_closed", "sheet_edges_not_closed", &LoopCounts::sheetBoundaries, &OutcomeCounts::failed},
};

std::size_t countFrom(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_number_unsigned() ? found->get<std::size_t>() : 0;
}

Json optionsJson(const RepairOptions& options) {
  Json json = toJson(valuesOf(options));
  json.erase("numbers");  // those of the output
  json["keep_open"] = options.keepOpen;
  addFormerKeys(json, {{"open_sheets", "rims"}});
  return json;
}

}  // namespace

Json toJson(const RepairRun& run, const RepairRequest& request, const std::string& unit) {
  Json loops = Json::array();
  for (const LoopResult& loop : run.repair.loops) loops.push_back(toJson(loop));
  Json lost = Json::array();
  for (const QString& name : lostNames(run.file)) lost.push_back(name.toStdString());
  Json json = {
      {"input", request.input.string()},
      {"output", request.output.string()},
      {"options", optionsJson(request.options)},
      {"before", toJson(run.before)},
      {"after", toJson(run.after)},
      {"loops", loops},
      {"loop_counts", toJson(countOutcomes(run.repair))},
      {"removed_degenerate", run.repair.removedDegenerate},
      {"removed_duplicates", run.repair.removedDuplicates},
      {"removed_flaps", run.repair.removedFlaps},
      {"removed_debris", run.repair.removedDebris},
      {"reoriented_faces", run.repair.reversedFaces},
      {"reoriented_bodies", run.repair.reversedBodies},
      {"sheets_thickened", run.repair.sheets.thickened},
      {"sheets_left_open", run.repair.sheets.leftCount()},
      {"sheet_thickness_mm", toJson(run.repair.sheets.thickness)},
      {"merged_vertices", run.repair.mergedVertices},
      {"removed_layers", run.repair.removedLayers},
      {"stitched_cracks", run.repair.stitchedCracks},
      {"smoothed_vertices", run.repair.smoothedVertices},
      {"measured_noise_mm", run.repair.measuredNoise},
      {"cut_crossings", run.repair.cutClusters},
      {"cut_faces", run.repair.cutFaces},
      {"inner_faces", run.repair.innerFaces},
      {"replaced_faces", run.repair.replacedFaces},
      {"farthest_removed_vertex", toJson(run.repair.removed)},
      {"lost_loops", run.repair.lostLoops},
      {"non_orientable_cuts", run.repair.nonOrientableCuts},
      {"separated_vertices", run.repair.separatedVertices},
      {"separation_incomplete", run.repair.isSeparationIncomplete},
      {"intersection_removal_incomplete", run.repair.isIntersectionRemovalIncomplete},
      {"rounding_moved_mm", run.roundingMove},
      {"modified_vertices", run.modified.size()},
      {"unmodified_vertices_identical", run.unmodifiedIdentical},
      {"unit", unit},
      {"lost_attributes", lost},
      {"damage", damageSentences(run.file)},
      {"seconds", run.seconds},
  };
  addFormerKeys(json, {{"reoriented_faces", "turned_faces"},
                       {"reoriented_bodies", "turned_bodies"},
                       {"farthest_removed_vertex", "removed_part"},
                       {"non_orientable_cuts", "one_sided_cuts"},
                       {"separated_vertices", "parted_vertices"},
                       {"separation_incomplete", "parting_cut_short"},
                       {"intersection_removal_incomplete", "cutting_cut_short"},
                       {"modified_vertices", "touched_vertices"},
                       {"unmodified_vertices_identical", "untouched_vertices_identical"}});
  return json;
}

Json toJson(const LoopCounts& loops) {
  Json json;
  for (const auto& [key, former, of, count] : kCounts) {
    json[key] = loops.*of.*count;
    if (former) json[former] = loops.*of.*count;
  }
  json["new_openings"] = loops.newOpenings;
  json["pieces"] = loops.pieces ? Json(*loops.pieces) : Json(nullptr);
  return json;
}

LoopCounts loopCountsFrom(const nlohmann::json& object) {
  LoopCounts loops;
  for (const auto& [key, former, of, count] : kCounts)
    loops.*of.*count = countFrom(object, !former || object.contains(key) ? key : former);
  loops.newOpenings = countFrom(object, "new_openings");
  if (const std::size_t pieces = countFrom(object, "pieces"); pieces > 0) loops.pieces = pieces;
  return loops;
}

std::string outcomeLine(const RepairRun& run, const RepairRequest& request) {
  const std::vector<std::string> left = leftovers(run.repair, request.options, run.before, run.after);
  Json outcome{
      {"input", request.input.string()},
      {"output", request.output.string()},
      {"state", run.after.isSound() ? "closed" : "left-open"},
      {"left", left.size()},
      {"reason", left.empty() ? Json(nullptr) : Json(left.front())},
      {"seconds", run.seconds},
  };
  outcome.update(toJson(countOutcomes(run.repair)));
  return outcome.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace handwheel
