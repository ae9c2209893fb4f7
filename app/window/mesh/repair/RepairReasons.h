// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/defects/DefectList.h"
#include "tools/mesh/MeshServices.h"
#include "tools/mesh/repair/RemainingDefects.h"

namespace handwheel {

// Returns the reasons why loops are still open after a repair. The map is indexed by their keys in its result. Contains
// only loops that were to be closed.
std::map<Vertex, FillFailure> failuresOf(const RepairReport& report);

// Returns the reasons why the other defects of its result remain, translated.
DefectReasons reasonsOf(const RemainingDefects& left, const RepairReport& report, const RepairOptions& options);

// Notes the reason why a change left some of the defects that it was to repair: the rows of the list keep it. of: these
// defects. isSame: the change had no effect, so that its row is still the same.
void noteReasons(DefectList& defectList, const MeshChange& change, std::optional<DefectRow> of, bool isSame);

}  // namespace handwheel
