// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/defects/DefectList.h"
#include "tools/mesh/MeshServices.h"
#include "tools/mesh/repair/RemainingDefects.h"

namespace handwheel {

// Returns the reasons why loops are still open after a repair. The map is indexed by the keys of the loops in the
// repaired mesh. It contains only loops that were to be closed.
std::map<Vertex, FillFailure> failuresOf(const RepairReport& report);

// Returns the reasons why the defects other than open loops remain after a repair, translated.
DefectReasons reasonsOf(const RemainingDefects& left, const RepairReport& report, const RepairOptions& options);

// Stores in the rows of the list the reason why a change left some of the defects that it was to repair. of: the row of
// these defects. isSame: the change had no effect, so this row still stands for the same defect.
void noteReasons(DefectList& defectList, const MeshChange& change, std::optional<DefectRow> of, bool isSame);

}  // namespace handwheel
