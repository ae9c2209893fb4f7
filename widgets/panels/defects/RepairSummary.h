// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "theme/DefectKind.h"

#include <QStringList>

namespace handwheel {

class DefectList;

// The summary of a repair or fix, for card, log and messages. The list of defects shows the same counts.

// Returns a phrase like "26 holes", for use in a list. May be called for all kinds that a repair can change or leave.
QString defectPhrase(DefectKind kind, std::size_t count);

// Returns a phrase for each change since the counts in RepairFindings::before: "26 of 28 holes filled", "new: 2 pieces
// of debris", then the other changes. The result is empty if these counts are unknown.
QStringList defectSummary(const DefectList& defectList);

}  // namespace handwheel
