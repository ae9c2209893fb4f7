// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/lathe/LatheRun.h"

namespace handwheel {

// Why a tool was not mounted.
enum class MountRefusal {
  Unknown,     // no such tool, or no such side of the post
  NotAllowed,  // LatheSetup::allowed does not name it
  Turning,     // the spindle turns
  InTheWay     // it would be in the work, the chuck or the tailstock where the slides are
};
const char* sentenceOf(MountRefusal refusal);  // English, context "LathePart"

// Whether the setup lets a tool be mounted; also one that is in its post already.
bool isAllowed(const LatheSetup& setup, std::string_view tool);

// The setup with a tool on one side of its post; a drill goes into the tailstock. Its tip is where it happens to be
// clamped, so it has to be touched off. An empty id empties the side.
LatheSetup mounted(LatheSetup setup, const LatheTools& tools, std::size_t station, const std::string& id);

// Why a tool cannot be mounted on a lathe that stands like this; none: it can.
std::optional<MountRefusal> refusalToMount(const LatheSetup& setup, const LatheTools& tools, std::size_t station,
                                           const std::string& id, const TurnedProfile& part, const LatheState& state);

}  // namespace handwheel
