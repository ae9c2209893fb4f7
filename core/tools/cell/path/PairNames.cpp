// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/path/PairNames.h"

#include "document/cell/BodyCarriers.h"
#include "document/scene/BodyDisplay.h"
#include "robot/RobotArms.h"

#include <algorithm>

namespace handwheel {

namespace {

// A link, or a body.
struct PairPart {
  std::uint32_t link = kNone;  // itself, or what carries the body; kNone: that stands
  bool isBody = false;
};

// None: it is not there.
std::optional<PairPart> partNamed(const CellScene& scene, const std::string& name) {
  const RobotModel& robot = scene.robot->model;
  if (const std::uint32_t link = linkNamed(robot, name); link != kNone) return PairPart{link, false};
  const auto id = bodyOfPart(name);
  const BodyPointer body = id ? scene.bodies.withId(*id) : nullptr;
  return body ? std::optional(PairPart{carrierOf(*body, robot), true}) : std::nullopt;
}

}  // namespace

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
  return {shownPart(pair.first, bodies), shownPart(pair.second, bodies)};
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

std::optional<PairNames> bodiesCalled(const std::string& one, const std::string& other, const BodySet& bodies,
                                      const RobotModel& robot) {
  const auto called = [&](const std::string& name) {
    return linkNamed(robot, name) == kNone ? bodies.withName(name) : nullptr;
  };
  const BodyPointer first = called(one), second = called(other);
  return first && second ? std::optional(PairNames{partOfBody(first->id), partOfBody(second->id)}) : std::nullopt;
}

std::vector<PairNames> uncheckedPairs(const CellScene& scene, const std::set<PairNames>& allowed) {
  const RobotModel& robot = scene.robot->model;
  const std::vector<std::uint32_t> owners = armsOfLinks(robot, scene.robot->arms);
  const auto isOwn = [&](const PairPart& part) { return part.link != kNone && owners[part.link] == scene.armNumber; };
  const std::set<LinkPair> between = neighbours(robot);
  std::set<PairNames> known;
  std::vector<PairNames> pairs;
  for (const PairNames& each : allowed) {
    const auto first = partNamed(scene, each.first), second = partNamed(scene, each.second);
    if (!first || !second || !(isOwn(*first) || isOwn(*second))) continue;
    if (first->link == second->link) continue;  // a body and what carries it, or both carried by one
    if (!first->isBody && !second->isBody && between.contains(std::minmax(first->link, second->link))) continue;
    if (known.insert(std::minmax(each.first, each.second)).second) pairs.push_back(shownNames(each, scene.bodies));
  }
  for (const auto& [a, b] : scene.alwaysMeeting) {
    const PairNames pair = *pairNamesOf(scene, {0.0, a, b});
    if (known.insert(std::minmax(pair.first, pair.second)).second) pairs.push_back(shownNames(pair, scene.bodies));
  }
  return pairs;
}

}  // namespace handwheel
