// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DisplayModel.h"
#include "document/cell/CellScene.h"

#include <span>

namespace handwheel {

// Gives the links and bodies of colliding pairs a warning colour.
void markColliding(DisplayModel& model, const CellScene& scene, std::span<const RobotScene::Nearest> pairs);

}  // namespace handwheel
