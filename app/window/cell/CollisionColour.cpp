// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/cell/CollisionColour.h"

#include "document/cell/CellDisplay.h"
#include "document/scene/BodyDisplay.h"

#include <algorithm>

namespace handwheel {

void markColliding(DisplayModel& model, const CellScene& scene, std::span<const RobotScene::Nearest> pairs) {
  constexpr std::array<float, 3> kWarning{0.86f, 0.12f, 0.10f};  // sRGB
  for (DisplayPart& part : model.parts) {
    const std::uint32_t link = linkOfPart(*scene.robot, part.name);
    const auto body = bodyOfPart(part.name);
    const bool isMeeting = std::ranges::any_of(pairs, [&](const RobotScene::Nearest& pair) {
      const bool isOfPair = link == pair.link || link == pair.otherLink || link == CellScene::linkOfOwner(pair.owner);
      if (link != kNone && isOfPair) return true;
      return body &&
             (pair.owner == *body || scene.bodyOfLink(pair.link) == body || scene.bodyOfLink(pair.otherLink) == body);
    });
    if (isMeeting) part.colour = kWarning;
  }
}

}  // namespace handwheel
