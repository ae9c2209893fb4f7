// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/workpiece/WorkpieceSnapshot.h"

#include <QString>

namespace handwheel {

// A pass called by what its tool does: "Drilling pass 3". number: from 1; tool: null for a round nose on this side.
QString passName(const LatheTool* tool, TurningSide side, const QString& number);

// What the last passes of a part have done, for the history: "Boring pass 2–3: −41 mm³". before: passes that were there
// before; removed: mm³, by the others.
QString passesText(const TurnedPart& part, std::size_t before, double removed);

}  // namespace handwheel
