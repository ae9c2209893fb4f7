// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/cell/CollisionColour.h"

#include "document/cell/CellDisplay.h"
#include "document/scene/BodyDisplay.h"

namespace handwheel {

void markColliding(DisplayModel& model, const CellScene& scene, const RobotScene::Nearest& nearest) {
  if (nearest.link == kNone) return;
  constexpr std::array<float, 3> kWarning{0.86f, 0.12f, 0.10f};  // sRGB
  for (DisplayPart& part : model.parts) {
    const std::uint32_t link = linkOfPart(*scene.robot, part.name);
    const auto body = bodyOfPart(part.name);
    const bool isMeeting = (link != kNone && (link == nearest.link || link == nearest.otherLink)) ||
                           (body && (nearest.owner == *body || scene.bodyOfLink(nearest.link) == body ||
                                     scene.bodyOfLink(nearest.otherLink) == body));
    if (isMeeting) part.colour = kWarning;
  }
}

}  // namespace handwheel
