// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/proof/RestingPairs.h"

#include "document/cell/CellScene.h"

#include <QtGlobal>
#include <algorithm>

namespace handwheel {

namespace {

// The pairs of the robot of this scene, as numbers of links.
std::set<LinkPair> restingPairs(const CellScene& scene) {
  const ArmValues rest = scene.planned(restValues(scene.robot->model));
  std::set<LinkPair> pairs = scene.scene.closePairsMeeting(rest);
  std::set<LinkPair> always = scene.scene.alwaysMeeting();
  std::erase_if(always, [&](const LinkPair& pair) { return pairs.contains(pair); });
  if (always.empty()) return pairs;
  for (const RobotScene::Nearest& each : scene.scene.overlappingLinks(rest)) {
    const LinkPair pair = std::minmax(each.link, each.otherLink);
    if (always.contains(pair)) pairs.insert(pair);
  }
  return pairs;
}

}  // namespace

std::shared_ptr<const RobotCellSnapshot> withRestingPairs(std::shared_ptr<const RobotCellSnapshot> cell,
                                                          std::vector<Note>& notes) {
  constexpr std::size_t kMostNamed = 20;
  auto bare = std::make_shared<RobotCellSnapshot>(*cell);
  bare->bodies = {};
  CollisionMeshes meshes;
  std::vector<std::pair<std::string, std::string>> added;
  for (std::size_t arm = 0; arm < cell->robot->arms.size(); ++arm) {
    const Result<CellScene> scene = sceneOf(*bare, meshes, arm);
    if (!scene) continue;  // it cannot be planned for
    for (const auto& [a, b] : restingPairs(*scene))
      added.emplace_back(cell->robot->model.links[a].name, cell->robot->model.links[b].name);
  }
  if (added.empty()) return cell;
  auto changed = std::make_shared<RobotCellSnapshot>(*cell);
  auto plans = std::make_shared<CellPlans>(*cell->plans);
  std::string names;
  for (std::size_t i = 0; i < added.size(); ++i) {
    plans->allowed.insert(added[i]);
    if (i < kMostNamed) names += (i > 0 ? ", " : "") + added[i].first + " – " + added[i].second;
  }
  if (added.size() > kMostNamed) names += ", …";
  notes.push_back({QT_TRANSLATE_NOOP("Note",
                                     "Links that touch each other at rest are not checked against each other: %1. "
                                     "Forbid those that must not touch in the list of pairs."),
                   {names}});
  changed->plans = std::move(plans);
  return changed;
}

}  // namespace handwheel
