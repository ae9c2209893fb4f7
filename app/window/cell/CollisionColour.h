// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DisplayModel.h"
#include "document/cell/CellScene.h"

namespace handwheel {

// Gives the links and the body that meet a warning colour; nothing where nothing does.
void markColliding(DisplayModel& model, const CellScene& scene, const RobotScene::Nearest& nearest);

}  // namespace handwheel
