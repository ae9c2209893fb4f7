// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh/MeshCommands.h"

#include "cli/mesh/CompareCommand.h"
#include "cli/mesh/DecimateCommand.h"
#include "cli/mesh/EditCommand.h"
#include "cli/mesh/FeelCommand.h"
#include "cli/mesh/RepairCommand.h"
#include "cli/mesh/SectionCommand.h"
#include "cli/mesh/SplitMergeCommands.h"

#include <algorithm>

namespace handwheel {

namespace {

bool printsPage(std::span<char* const> words) {
  return std::any_of(words.begin(), words.end(), [](std::string_view word) { return word.ends_with(".pdf"); });
}

}  // namespace

std::vector<Command> meshCommands() {
  return {
      {repairSpec(), runRepair},     {editSpec(), runEdit},   {compareSpec(), runCompare, nullptr, printsPage},
      {decimateSpec(), runDecimate}, {splitSpec(), runSplit}, {mergeSpec(), runMerge},
      {sectionSpec(), runSection},   {feelSpec(), runFeel},
  };
}

}  // namespace handwheel
