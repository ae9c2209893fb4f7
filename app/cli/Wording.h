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

// Returns the name of an outcome in reports.
std::string wordFor(LoopOutcome outcome);
std::string wordFor(Substitute substitute);
// Returns the numbers of holes by outcome: "3 of 4 holes filled, 1 kept open". Without holes the text begins with "No
// holes".
std::string outcomesText(const LoopCounts& loops);

// Returns warnings about results that should be inspected: removed parts, and each patch that is unlike its
// surroundings. After ten warnings the other patches are only counted.
std::vector<std::string> repairWarnings(const RepairReport& repair);
// Returns the reason why a loop was not filled, as a sentence.
std::string reasonSentence(FillFailure failure);

// Returns one sentence for each damaged part that was skipped or repaired on reading. The last sentence counts the
// parts that are not listed.
std::vector<std::string> damageSentences(const DocumentFile& file);

// Returns one line on the changes of a repair other than filling. The line is empty if there are none.
std::string changesLine(const RepairReport& repair);

// Returns one sentence for each defect that remains after a repair and keeps the written file from being sound
// (MeshState).
std::vector<std::string> leftovers(const RepairReport& repair, const RepairOptions& options, const MeshReport& before,
                                   const MeshReport& after);

}  // namespace handwheel
