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

// Returns the name of the outcome in reports.
std::string wordFor(LoopOutcome outcome);
// Returns "3 of 4 holes filled, 1 kept open", or that there are none.
std::string outcomesText(const LoopCounts& loops);

// Returns warnings about results that need a look: removed parts, and each patch that is unlike its surroundings; their
// number if there are more than ten.
std::vector<std::string> repairWarnings(const RepairReport& repair);
// Returns the reason why a loop was not filled, as a sentence.
std::string reasonSentence(FillFailure failure);

// Returns one sentence for each damage that was skipped or repaired on reading. The last one counts those that are not
// listed.
std::vector<std::string> damageSentences(const DocumentFile& file);

// Returns one line on what a repair did besides filling; empty if it did nothing.
std::string changesLine(const RepairReport& repair);

// Returns one sentence for each remaining defect. These keep the written file from being sound (MeshState).
std::vector<std::string> leftovers(const RepairReport& repair, const RepairOptions& options, const MeshReport& before,
                                   const MeshReport& after);

}  // namespace handwheel
