// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "theme/DefectKind.h"

#include <QStringList>

namespace handwheel {

class DefectList;

// The one summary of what a repair or fix did, for card, log and messages. The list of defects shows the same counts.

// "26 holes", in the grammar of a list; all kinds that may be wrong or left open.
QString defectPhrase(DefectKind kind, std::size_t count);

// What has changed since the counts in RepairFindings::before, a phrase each: "26 of 28 holes filled", "new: 2 pieces
// of debris", then what else was done. Empty where nothing is known to compare with.
QStringList defectSummary(const DefectList& defectList);

}  // namespace handwheel
