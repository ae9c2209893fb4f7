// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/CellContacts.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr std::size_t kLookedAt = 1000;  // contacts of a pair: dense meshes that cross have very many
constexpr double kSamePosition = 5.0;    // mm: what is nearer is seen as one

bool isMet(const ClosestPoints& touch) {
  return touch.distance <= 0.0 && touch.first.allFinite() && touch.second.allFinite() && touch.normal.allFinite();
}

// Returns the contacts of each pair, the deepest first. A pair of robots is found by both.
std::vector<std::vector<ClosestPoints>> touchesByPair(std::span<const CellCollision> collisions, Progress progress) {
  std::vector<std::vector<ClosestPoints>> found;
  const auto keep = [&](std::vector<ClosestPoints> touches) {
    std::erase_if(touches, [](const ClosestPoints& touch) { return !isMet(touch); });
    if (!touches.empty()) found.push_back(std::move(touches));
  };
  std::set<std::pair<std::uint32_t, std::uint32_t>> seen;  // Owners of obstacles, which are the same for all robots
  for (const CellCollision& each : collisions) {
    const RobotScene& scene = each.scene->scene;
    const auto ownerOf = [&](std::uint32_t link) {
      const auto body = each.scene->bodyOfLink(link);
      return body ? *body : CellScene::kLinkOwners + link;
    };
    if (!each.moved.isEmpty()) keep(scene.touches(each.values, each.moved, each.movedPose, kLookedAt, each.without));
    for (const RobotScene::Nearest& pair : each.pairs) {
      if (progress.cancelled()) return found;
      const std::uint32_t first = ownerOf(pair.link);
      const std::uint32_t second = pair.owner == kNone ? ownerOf(pair.otherLink) : pair.owner;
      if (each.moved.isEmpty() && seen.insert(std::minmax(first, second)).second)
        keep(scene.touches(each.values, pair, kLookedAt, each.displacement));
    }
  }
  return found;
}

}  // namespace

std::vector<CellContact> contactsOf(std::span<const CellCollision> collisions, std::size_t most, Progress progress) {
  const auto byPair = touchesByPair(collisions, progress);
  std::vector<ClosestPoints> deepest, others;
  for (const std::vector<ClosestPoints>& touches : byPair) {
    deepest.push_back(touches.front());
    others.insert(others.end(), touches.begin() + 1, touches.end());
  }
  const auto isDeeper = [](const ClosestPoints& a, const ClosestPoints& b) { return a.distance < b.distance; };
  std::stable_sort(deepest.begin(), deepest.end(), isDeeper);
  std::stable_sort(others.begin(), others.end(), isDeeper);
  deepest.insert(deepest.end(), others.begin(), others.end());
  std::vector<CellContact> contacts;
  for (const ClosestPoints& touch : deepest) {
    if (contacts.size() >= most) break;
    const Vec3 position = 0.5 * (touch.first + touch.second);
    const bool isTaken = std::any_of(contacts.begin(), contacts.end(), [&](const CellContact& contact) {
      return (contact.position - position).norm() < kSamePosition;
    });
    if (!isTaken) contacts.push_back({position, touch.normal, std::abs(touch.distance)});
  }
  return contacts;
}

}  // namespace handwheel
