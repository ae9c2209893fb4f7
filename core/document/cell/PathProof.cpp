// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/PathProof.h"

#include "base/JsonText.h"
#include "document/Container.h"
#include "robot/program/RobotPath.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

using nlohmann::json;

const std::string kProofs = "cell/proofs.json";
constexpr std::uint64_t kMethod = 2;  // Version of verification and digests; increased whenever the proof changes

// In the order of ProofGap::Kind.
constexpr std::array<std::string_view, 3> kGapKinds = {"corner", "carried", "zone"};

constexpr std::array<const char*, 10> kParts = {"robots", "path",      "joints",  "bodies",         "allowed",
                                                "tool",   "clearance", "targets", "configurations", "rates"};

json toJson(const std::string& path, const PathProof& proof) {
  const PathFindings& found = proof.found;
  json stored = {{"path", path},
                 {"at", proof.at},
                 {"certified", found.isCertified},
                 {"collisions", found.collisions},
                 {"too_near", found.tooNear},
                 {"clearance_mm", found.clearance},
                 {"least_clearance_mm", found.leastClearance},
                 {"seconds", found.seconds},
                 {"touching", found.isTouching},
                 {"missing", json::array()},
                 {"robots_moved", found.robotsMoved},
                 {"part_moved", found.outdated.part},
                 {"base_moved", found.outdated.isBaseOther},
                 {"tool_changed", found.outdated.isToolOther},
                 {"targets_moved", found.outdated.targets},
                 {"configurations_changed", found.outdated.configurations},
                 {"frames_moved", found.outdated.frames},
                 {"not_checked", found.notChecked},
                 {"listed", json::array()},
                 {"basis", json::object()}};
  if (found.measures) {
    stored["length_rad"] = found.measures->length;
    stored["security_mm"] = found.measures->security;
    stored["manipulability"] = found.measures->manipulability;
    if (found.measures->slid > 0.0) stored["length_mm"] = found.measures->slid;
  }
  if (found.stopsAt) stored["stops_at"] = *found.stopsAt;
  for (const PathFindings::Meeting& each : found.listed)
    stored["listed"].push_back({{"place", each.waypoint},
                                {"link", each.link},
                                {"other", each.other},
                                {"distance_mm", each.distance},
                                {"needed_mm", each.needed}});
  for (const MissingShape& each : found.missing) {
    stored["missing"].push_back({{"part", each.part},
                                 {"name", each.name},
                                 {"what", each.what},
                                 {"state", static_cast<int>(each.state)},
                                 {"by", each.by}});
  }
  for (const ProofGap& each : found.gaps) {
    stored["gaps"].push_back({{"kind", kGapKinds[static_cast<std::size_t>(each.kind)]},
                              {"place", each.waypoint},
                              {"text", each.text},
                              {"line", each.line},
                              {"kept_mm", each.kept}});
  }
  for (std::size_t i = 0; i < kParts.size(); ++i) stored["basis"][kParts[i]] = proof.basis[i];
  return stored;
}

std::optional<double> lengthAt(const json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number() || !std::isfinite(found->get<double>())) return std::nullopt;
  return found->get<double>();
}

bool isAt(const json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_boolean() && found->get<bool>();
}

std::set<std::string> namesAt(const json& object, const char* key) {
  std::set<std::string> names;
  const auto found = object.find(key);
  for (const json& each : found != object.end() && found->is_array() ? *found : json::array()) {
    if (each.is_string()) names.insert(each.get<std::string>());
  }
  return names;
}

std::optional<PathProof> proofFrom(const json& stored) {
  const auto clearance = lengthAt(stored, "clearance_mm"), least = lengthAt(stored, "least_clearance_mm"),
             seconds = lengthAt(stored, "seconds");
  const auto basis = stored.find("basis");
  if (!clearance || !least || !seconds || basis == stored.end() || !basis->is_object()) return std::nullopt;
  PathProof proof;
  proof.at = stringAt(stored, "at");
  for (std::size_t i = 0; i < kParts.size(); ++i) proof.basis[i] = stringAt(*basis, kParts[i]);
  PathFindings& found = proof.found;
  found.isCertified = isAt(stored, "certified");
  found.collisions = countAt(stored, "collisions");
  found.tooNear = std::min(countAt(stored, "too_near"), found.collisions);
  if (stored.contains("stops_at")) found.stopsAt = countAt(stored, "stops_at");
  found.clearance = *clearance;
  found.leastClearance = *least;
  found.seconds = *seconds;
  const auto length = lengthAt(stored, "length_rad"), security = lengthAt(stored, "security_mm"),
             manipulability = lengthAt(stored, "manipulability");
  if (length && security && manipulability)
    found.measures = PathMeasures{*length, *security, *manipulability, lengthAt(stored, "length_mm").value_or(0.0)};
  found.isTouching = isAt(stored, "touching");
  const auto missing = stored.find("missing");
  for (const json& each : missing != stored.end() && missing->is_array() ? *missing : json::array()) {
    if (!each.is_object() || found.missing.size() >= CellPlans::kMost) continue;
    const auto state = static_cast<MissingShape::State>(std::min<std::size_t>(countAt(each, "state"), 2));
    found.missing.push_back(
        {stringAt(each, "part"), stringAt(each, "name"), stringAt(each, "what"), state, stringAt(each, "by")});
  }
  found.robotsMoved = namesAt(stored, "robots_moved");
  found.outdated = {stringAt(stored, "part_moved"),
                    isAt(stored, "base_moved"),
                    isAt(stored, "tool_changed"),
                    namesAt(stored, "targets_moved"),
                    namesAt(stored, "configurations_changed"),
                    namesAt(stored, "frames_moved")};
  const auto pairs = stored.find("not_checked");
  for (const json& each : pairs != stored.end() && pairs->is_array() ? *pairs : json::array()) {
    const bool isPair = each.is_array() && each.size() == 2 && each[0].is_string() && each[1].is_string();
    if (isPair && found.notChecked.size() < CellPlans::kMost)
      found.notChecked.emplace_back(each[0].get<std::string>(), each[1].get<std::string>());
  }
  const auto listed = stored.find("listed");
  for (const json& each : listed != stored.end() && listed->is_array() ? *listed : json::array()) {
    if (each.is_object() && found.listed.size() < PathFindings::kMostListed)
      found.listed.push_back({countAt(each, "place"), stringAt(each, "link"), stringAt(each, "other"),
                              std::max(lengthAt(each, "distance_mm").value_or(0.0), 0.0),
                              std::max(lengthAt(each, "needed_mm").value_or(0.0), 0.0)});
  }
  const auto gaps = stored.find("gaps");
  for (const json& each : gaps != stored.end() && gaps->is_array() ? *gaps : json::array()) {
    if (!each.is_object() || found.gaps.size() >= RobotPath::kMostWaypoints) continue;
    const auto* const kind = std::ranges::find(kGapKinds, stringAt(each, "kind"));
    if (kind == kGapKinds.end()) return std::nullopt;
    found.gaps.push_back({static_cast<ProofGap::Kind>(kind - kGapKinds.begin()), countAt(each, "place"),
                          stringAt(each, "text"), countAt(each, "line"),
                          std::max(lengthAt(each, "kept_mm").value_or(0.0), 0.0)});
  }
  // Contradictory findings prove nothing.
  const bool isOpen =
      std::ranges::find(found.missing, MissingShape::State::Open, &MissingShape::state) != found.missing.end();
  if (found.isCertified && (found.collisions > 0 || !found.gaps.empty() || found.stopsAt || isOpen))
    return std::nullopt;
  return proof;
}

}  // namespace

const char* keyOf(BasisChange change) {
  return change == BasisChange::Nothing ? nullptr : kParts[static_cast<std::size_t>(change) - 1];
}

void writeProofs(const PathProofs& proofs, const std::set<std::string>& paths, Container& container) {
  json stored = {{"method", kMethod}, {"paths", json::array()}};
  for (const auto& [path, proof] : proofs) {
    if (paths.contains(path)) stored["paths"].push_back(toJson(path, proof));
  }
  if (!stored["paths"].empty()) container.blobs[kProofs] = stored.dump(-1, ' ', false, json::error_handler_t::replace);
}

PathProofs readProofs(const Container& container) {
  const auto bytes = container.blobs.find(kProofs);
  if (bytes == container.blobs.end()) return {};
  const Result<json> stored = parseJson(bytes->second, "proofs");
  if (!stored || !stored->is_object() || countAt(*stored, "method") != kMethod) return {};
  const auto paths = stored->find("paths");
  PathProofs proofs;
  for (const json& each : paths != stored->end() && paths->is_array() ? *paths : json::array()) {
    if (!each.is_object() || proofs.size() >= CellPlans::kMost) continue;
    if (auto proof = proofFrom(each)) proofs.emplace(stringAt(each, "path"), std::move(*proof));
  }
  return proofs;
}

}  // namespace handwheel
