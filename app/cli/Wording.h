// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentFile.h"
#include "mesh/MeshReport.h"
#include "mesh/Repair.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// The method that --fill asks for by this word.
std::optional<FillMethod> fillMethodFor(std::string_view word);

// The words of the report.
std::string wordFor(FillMethod method);
std::string wordFor(LoopOutcome outcome);

// Why a loop was not filled, as a sentence.
std::string reasonSentence(FillFailure failure);

// "colours, normals"
std::string listOf(const std::vector<LostAttribute>& attributes);

// What was skipped or mended on reading, a sentence each; the last one counts those that are not listed.
std::vector<std::string> damageSentences(const DocumentFile& file);

// What a repair did besides filling, as one line; empty when it did nothing.
std::string changesLine(const RepairReport& repair);

// One sentence for each thing that keeps the written file from being closed, manifold and oriented.
std::vector<std::string> leftovers(const RepairReport& repair, const MeshReport& after);

}  // namespace handwheel
