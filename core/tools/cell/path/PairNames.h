// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/CellScene.h"

namespace handwheel {

// Two objects that may touch, as in CellPlans::allowed. Links are given by their names, bodies by their numbers
// ("body.3").
using PairNames = std::pair<std::string, std::string>;

// Returns the nearest pair in a scene; nothing if there is none.
std::optional<PairNames> pairNamesOf(const CellScene& scene, const RobotScene::Nearest& nearest);

// Returns a pair with the names for the user. Removed bodies are given by their numbers.
PairNames shownNames(const PairNames& pair, const BodySet& bodies);

// Returns true if the pair may touch. The order does not matter.
bool isAllowed(const CellPlans& plans, const PairNames& pair);
// Sets whether the pair may touch.
void setAllowed(CellPlans& plans, const PairNames& pair, bool mayTouch);

// Returns the pair of two bodies with these names; nothing if a name is unknown, or is also that of a link.
std::optional<PairNames> bodiesCalled(const std::string& one, const std::string& other, const BodySet& bodies,
                                      const RobotModel& robot);

// Returns the pairs that are left out of the proofs of a scene, each once, with the names for the user: those that may
// touch, and those in CellScene::alwaysMeeting. The objects of a pair must exist, and the planned robot must move one
// of them. Neighbours, which always touch, are not in the result. allowed: as in CellPlans.
std::vector<PairNames> uncheckedPairs(const CellScene& scene, const std::set<PairNames>& allowed);

}  // namespace handwheel
