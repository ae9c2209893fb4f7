// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/CellScene.h"

namespace handwheel {

// Two things that may touch, by their names in CellPlans::allowed. Links, or bodies by their numbers ("body.3").
using PairNames = std::pair<std::string, std::string>;

// What is nearest in a scene; none: nothing is.
std::optional<PairNames> pairNamesOf(const CellScene& scene, const RobotScene::Nearest& nearest);

// A pair as people call it: bodies by their names; those that were removed by their numbers.
PairNames shownNames(const PairNames& pair, const BodySet& bodies);

// Whether the pair may touch, in either order.
bool isAllowed(const CellPlans& plans, const PairNames& pair);
// Lets the pair touch from now on, or no longer.
void setAllowed(CellPlans& plans, const PairNames& pair, bool mayTouch);

// Two bodies by what they are called; none: one of the names is not that of a body alone, but also of a link, or of
// none.
std::optional<PairNames> bodiesCalled(const std::string& one, const std::string& other, const BodySet& bodies,
                                      const RobotModel& robot);

// The pairs that only a person has left out of the proofs of a scene, as people call them, each once: of things that
// are there, of which the robot moves one. Not links of one robot, which its description or table lets touch, and not
// CellScene::alwaysMeeting. allowed: as CellPlans has them.
std::vector<PairNames> uncheckedPairs(const CellScene& scene, const std::set<PairNames>& allowed);

}  // namespace handwheel
