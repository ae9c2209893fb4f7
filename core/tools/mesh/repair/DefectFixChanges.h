// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/holes/HoleFiller.h"
#include "tools/mesh/MeshServices.h"
#include "tools/mesh/ScriptLine.h"

#include <QtGlobal>
#include <vector>

namespace handwheel {

// Functions that the fixes of defects share.

inline constexpr const char* kTooLong = QT_TRANSLATE_NOOP("Tool", "it would take too long for a mesh of this size");

// Creates a change that limits its effort. work: returns false if it gave up because the effort was too high.
MeshChange countedChange(const char* text, std::function<bool(HalfEdgeMesh&, Progress)> work, const char* reason);
// Returns the effort limit of such a change, in trials.
std::size_t mostEffort(const HalfEdgeMesh& mesh, std::size_t fixed = tolerance::kObstructedHoleBudget);

// Returns the operation with these options of a fill, or number type.
OperationValues fillingValues(const char* verb, const FillOptions& options);
OperationValues roundingValues(const char* verb, NumberType numbers);

// Separates vertices; returns false if it gave up. at: as in separateCoincidentVertices().
bool separateNonManifold(HalfEdgeMesh& mesh, NumberType numbers, const std::vector<Vertex>& at, Progress progress);

// Marks the change as a fix: its effect is reported with the numbers of defects before and after.
MeshChange asFix(MeshChange change, std::string step);

}  // namespace handwheel
