// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/workpiece/WorkpieceSnapshot.h"

#include <QString>

namespace handwheel {

// Returns the name of a pass according to its tool, such as "Drilling pass 3". number: the number of the pass, from 1;
// tool: null for a round nose on `side`.
QString passName(const LatheTool* tool, TurningSide side, const QString& number);

// Returns a text on the last passes of a part for the history, such as "Boring pass 2–3: −41 mm³". before: the number
// of earlier passes; removed: the volume that the last passes removed, mm³.
QString passesText(const TurnedPart& part, std::size_t before, double removed);

}  // namespace handwheel
