// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/holes/HoleFilling.h"
#include "tools/mesh/StepText.h"

#include <set>

namespace handwheel {

class MeshDocument;

// Writes loops as text for a step. A loop is named by its smallest vertex, "v12", which stays valid after edits
// elsewhere. Users may also write the number that "handwheel inspect" shows, which is that of the present state.
std::string loopsText(const std::vector<Vertex>& keys);  // "v1,v12"
// Reads the loops of a document; returns their keys. A loop that does not exist is a problem of the reader.
std::vector<Vertex> readLoops(StepReader& reader, const std::string& words, const MeshDocument& document);

// The word for a number type in a step.
std::string_view wordFor(NumberType numbers);  // "single"
// Reads the option --numbers; default: the number type of the document's file.
NumberType readNumbers(StepReader& reader, const MeshDocument& document);

// Writes fill options to a step: --fill, --numbers, and what is not the default.
void addFillOptions(StepWriter& step, const FillOptions& options);
// Reads fill options from a step. loopSize: of the loop that is filled, between whose points bridges may run; 0: no
// bridges.
FillOptions readFillOptions(StepReader& reader, const MeshDocument& document, std::size_t loopSize = 0);

// The loops that are not filled or repaired, because the user wants them open. Returned as the corners of the loops, or
// as their ids. Rims are not among them.
std::set<PointKey> keptCorners(const MeshDocument& document);
std::set<int> keptLoops(const MeshDocument& document);

}  // namespace handwheel
