// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/holes/HoleFiller.h"
#include "tools/mesh/MeshServices.h"
#include "tools/mesh/ScriptLine.h"

#include <QtGlobal>
#include <vector>

namespace handwheel {

// Functions that several fixes of defects use.

inline constexpr const char* kTooLong = QT_TRANSLATE_NOOP("Tool", "it would take too long for a mesh of this size");

// Creates a change that limits its effort. work: the function that makes the change; it returns false if it stopped
// because the effort was too high.
MeshChange countedChange(const char* text, std::function<bool(HalfEdgeMesh&, Progress)> work, const char* reason);
// Returns the effort limit for the work of a countedChange(), in steps of WorkBudget. fixed: as in repairBudget().
std::size_t mostEffort(const HalfEdgeMesh& mesh, std::size_t fixed = tolerance::kObstructedHoleBudget);

// Return the values of an operation with these fill options, or with this number type.
OperationValues fillingValues(const char* verb, const FillOptions& options);
OperationValues roundingValues(const char* verb, NumberType numbers);

// Separates vertices; returns false if the effort was too high. at: as in separateCoincidentVertices().
bool separateNonManifold(HalfEdgeMesh& mesh, NumberType numbers, const std::vector<Vertex>& at, Progress progress);

// Marks a change as a fix, so that it is reported with the numbers of defects before and after it. step: its script
// step.
MeshChange asFix(MeshChange change, std::string step);

}  // namespace handwheel
