// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/lathe/LatheRun.h"

namespace handwheel {

// The reason why a tool was not mounted.
enum class MountRefusal {
  Unknown,     // there is no such tool, or no such side of the post
  NotAllowed,  // LatheSetup::allowed does not name it
  Turning,     // the spindle is turning
  InTheWay     // the tool would be in the work, the chuck or the tailstock
};
const char* sentenceOf(MountRefusal refusal);  // English text, translated in the context "LathePart"

// Returns true if the setup allows this tool to be mounted: LatheSetup::allowed is empty or contains its id.
bool isAllowed(const LatheSetup& setup, std::string_view tool);

// Returns the setup with a tool mounted on one side of its post, or in the tailstock if the tool is a drill. The tip is
// at an arbitrary offset, so the tool has to be touched off. An empty id removes the tool from the side.
LatheSetup mounted(LatheSetup setup, const LatheTools& tools, std::size_t station, const std::string& id);

// Returns the reason why a tool cannot be mounted on a lathe in this state, or nothing if the tool can be mounted.
std::optional<MountRefusal> refusalToMount(const LatheSetup& setup, const LatheTools& tools, std::size_t station,
                                           const std::string& id, const TurnedProfile& part, const LatheState& state);

}  // namespace handwheel
