// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/ReportJson.h"

#include "mesh/boundary/LoopNumbers.h"
#include "text/RepairText.h"

namespace handwheel {

namespace {

using Json = nlohmann::ordered_json;

template <class T>
Json orNull(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json toJson(const Box& box) {
  if (box.isEmpty()) return nullptr;
  const auto corner = [](const Vec3& p) { return Json::array({p.x(), p.y(), p.z()}); };
  return Json::array({corner(box.min()), corner(box.max())});
}

}  // namespace

Json toJson(const MeshReport& report) {
  Json loops = Json::array();
  LoopNumbers numbers;
  for (const LoopReport& loop : report.loops) {
    loops.push_back({{"id", loop.id},
                     {"number", numbers.take(loop.isSheetBoundary)},
                     {"edges", loop.edges},
                     {"length_mm", loop.lengthMm},
                     {"area_mm2", loop.areaMm2},
                     {"planarity", loop.planarity},
                     {"islands", loop.islands},
                     {"sheet_boundary", loop.isSheetBoundary}});
    addFormerKeys(loops.back(), {{"sheet_boundary", "rim"}});
  }
  return {
      {"triangles", report.triangles},
      {"vertices", report.vertices},
      {"state", stateText(report).toStdString()},
      {"components", report.components},
      {"closed", report.closed},
      {"manifold", report.manifold},
      {"oriented", report.oriented},
      {"inside_out_bodies", report.insideOutBodies},
      {"one_sided_pieces", report.oneSidedPieces},
      {"euler_characteristic", report.eulerCharacteristic},
      {"boundary_loops", report.loops.size()},
      {"loops", loops},
      {"non_manifold_edges", report.nonManifoldEdges},
      {"non_manifold_vertices", report.nonManifoldVertices},
      {"degenerate_faces", report.degenerateFaces},
      {"duplicate_faces", report.duplicateFaces},
      {"reversed_faces", report.reversedFaces},
      {"near_vertices", report.nearVertices},
      {"debris", report.debris},
      {"nested_bodies", report.nestedBodies},
      {"self_intersecting_pairs", orNull(report.selfIntersectingPairs)},
      {"area_mm2", report.areaMm2},
      {"volume_mm3", orNull(report.volumeMm3)},
      {"bounding_box_mm", toJson(report.box)},
  };
}

void addFormerKeys(Json& object, std::initializer_list<std::pair<const char*, const char*>> renamed) {
  for (const auto& [present, former] : renamed) {
    Json value = object.at(present);  // an insertion may move what it refers to
    object[former] = std::move(value);
  }
}

std::string textOf(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace handwheel
