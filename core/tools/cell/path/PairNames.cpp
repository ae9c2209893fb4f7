// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/path/PairNames.h"

#include "document/scene/BodyDisplay.h"

namespace handwheel {

std::optional<PairNames> pairNamesOf(const CellScene& scene, const RobotScene::Nearest& nearest) {
  if (nearest.link == kNone) return std::nullopt;
  const auto ofLink = [&](std::uint32_t link) {
    const auto body = scene.bodyOfLink(link);
    return body ? partOfBody(*body) : scene.robot->model.links[link].name;
  };
  if (const std::uint32_t link = CellScene::linkOfOwner(nearest.owner); link != kNone)
    return PairNames{ofLink(nearest.link), ofLink(link)};
  if (nearest.owner != kNone) return PairNames{ofLink(nearest.link), partOfBody(nearest.owner)};
  if (nearest.otherLink != kNone) return PairNames{ofLink(nearest.link), ofLink(nearest.otherLink)};
  return std::nullopt;
}

PairNames shownNames(const PairNames& pair, const BodySet& bodies) {
  const auto shown = [&](const std::string& name) {
    const auto id = bodyOfPart(name);
    const BodyPointer body = id ? bodies.withId(*id) : nullptr;
    return body ? body->name : name;
  };
  return {shown(pair.first), shown(pair.second)};
}

bool isAllowed(const CellPlans& plans, const PairNames& pair) {
  return plans.allowed.contains(pair) || plans.allowed.contains({pair.second, pair.first});
}

void setAllowed(CellPlans& plans, const PairNames& pair, bool mayTouch) {
  if (mayTouch == isAllowed(plans, pair)) return;
  if (mayTouch) {
    plans.allowed.insert(pair);
  } else {
    plans.allowed.erase(pair);
    plans.allowed.erase({pair.second, pair.first});
  }
}

}  // namespace handwheel
