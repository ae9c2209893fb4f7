// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/workpiece/WorkpieceSnapshot.h"

#include <QString>

namespace handwheel {

// Returns the name of a pass by its tool: "Drilling pass 3". number: from 1; tool: null for a round nose on this side.
QString passName(const LatheTool* tool, TurningSide side, const QString& number);

// Returns a text on the last passes of a part for the history: "Boring pass 2–3: −41 mm³". before: number of earlier
// passes; removed: mm³, by the later ones.
QString passesText(const TurnedPart& part, std::size_t before, double removed);

}  // namespace handwheel
