// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentFile.h"
#include "mesh/defects/MeshReport.h"
#include "mesh/repair/OutcomeCounts.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// The name of the outcome in reports.
std::string wordFor(LoopOutcome outcome);
// "3 of 4 holes filled, 1 kept open", or that there are none.
std::string outcomesText(const LoopCounts& loops);

// What a person should look at: what was removed, and each patch that is unlike its surroundings; of more than ten
// lines the number.
std::vector<std::string> repairWarnings(const RepairReport& repair);
// Why a loop was not filled, as a sentence.
std::string reasonSentence(FillFailure failure);

// One sentence for each damage that was skipped or repaired on reading. The last one counts those that are not listed.
std::vector<std::string> damageSentences(const DocumentFile& file);

// One line on what a repair did besides filling; empty when it did nothing.
std::string changesLine(const RepairReport& repair);

// One sentence for each remaining defect. These keep the written file from being sound (MeshState).
std::vector<std::string> leftovers(const RepairReport& repair, const RepairOptions& options, const MeshReport& before,
                                   const MeshReport& after);

}  // namespace handwheel
