// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/CellScene.h"

namespace handwheel {

// Two objects that may touch, by their names in CellPlans::allowed. Links, or bodies by their numbers ("body.3").
using PairNames = std::pair<std::string, std::string>;

// Returns the nearest pair in a scene; nothing if there is none.
std::optional<PairNames> pairNamesOf(const CellScene& scene, const RobotScene::Nearest& nearest);

// Returns a pair as shown to the user: bodies by their names; removed ones by their numbers.
PairNames shownNames(const PairNames& pair, const BodySet& bodies);

// Returns true if the pair may touch, in either order.
bool isAllowed(const CellPlans& plans, const PairNames& pair);
// Sets if the pair may touch.
void setAllowed(CellPlans& plans, const PairNames& pair, bool mayTouch);

// Returns the pair of two bodies by their names; nothing if one of the names is unknown, or also that of a link.
std::optional<PairNames> bodiesCalled(const std::string& one, const std::string& other, const BodySet& bodies,
                                      const RobotModel& robot);

// Returns the pairs that the user alone excluded from the proofs of a scene, as shown to the user, each once: existing
// pairs of which the robot moves one. Excludes links of one robot, which its description or table lets touch, and
// CellScene::alwaysMeeting. allowed: as in CellPlans.
std::vector<PairNames> uncheckedPairs(const CellScene& scene, const std::set<PairNames>& allowed);

}  // namespace handwheel
