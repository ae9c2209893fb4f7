// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/lathe/LatheMounting.h"

#include "base/Translatable.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

const char* sentenceOf(MountRefusal refusal) {
  switch (refusal) {
    case MountRefusal::Unknown:
      return translatable("LathePart", "There is no such tool.");
    case MountRefusal::NotAllowed:
      return translatable("LathePart", "The exercise does not provide this tool.");
    case MountRefusal::Turning:
      return translatable("LathePart", "The spindle turns. Stop it before you change tools.");
    case MountRefusal::InTheWay:
      break;
  }
  return translatable("LathePart", "There is no room for it here. Move the slides away from the work first.");
}

bool isAllowed(const LatheSetup& setup, std::string_view tool) {
  return setup.allowed.empty() || std::find(setup.allowed.begin(), setup.allowed.end(), tool) != setup.allowed.end();
}

// Tools are clamped by hand, so no two of them have their tips at the same position.
LatheSetup mounted(LatheSetup setup, const LatheTools& tools, std::size_t station, const std::string& id) {
  const auto found = std::find_if(tools.begin(), tools.end(), [&](const auto& each) { return each->id == id; });
  if (found != tools.end() && (*found)->kind == LatheToolKind::Drill) {
    setup.tailstock.fitting = LatheFitting::Drill;
    setup.tailstock.drill = id;
    return setup;
  }
  if (station >= setup.stations.size()) return setup;
  constexpr double kOutward = 0.37, kAlong = -0.23;  // mm, from one tool of the list to the next
  const auto number = static_cast<double>(found - tools.begin());
  setup.stations[station] = {id, {kOutward * number, kAlong * number}};
  return setup;
}

std::optional<MountRefusal> refusalToMount(const LatheSetup& setup, const LatheTools& tools, std::size_t station,
                                           const std::string& id, const TurnedProfile& part, const LatheState& state) {
  const auto tool = toolNamed(tools, id);
  if ((!id.empty() && !tool) || station >= setup.stations.size()) return MountRefusal::Unknown;
  if (tool && !isAllowed(setup, id)) return MountRefusal::NotAllowed;
  if (state.direction != 0 || state.speed != 0.0) return MountRefusal::Turning;
  const LatheRun changed(mounted(setup, tools, station, id), tools, part, state);
  return changed.isClear() ? std::nullopt : std::optional(MountRefusal::InTheWay);
}

}  // namespace handwheel
