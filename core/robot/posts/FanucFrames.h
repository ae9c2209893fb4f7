// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/arm/SerialArm.h"

#include <string_view>

namespace handwheel {

// The remark before the instructions by which a program sets a user frame.
inline constexpr const char* kSetsFanucFrame = "!Sets UFRAME[";
// The comment in the head of programs that we wrote.
inline constexpr std::string_view kOwnFanucComment = "\"HANDWHEEL\"";
// The beginning of a motion group of a position: "GP2:".
inline constexpr std::string_view kFanucGroup = "GP";

// Returns the arm as this maker's controllers count its joints: the third from the horizontal, which is that of the
// model minus the second. Only the arms that come with the program have limits for that.
SerialArm coupled(const SerialArm& arm);

// Returns the world frame in the base, which this maker puts at the height of the second axis.
Pose fanucWorld(const SerialArm& arm);

}  // namespace handwheel
