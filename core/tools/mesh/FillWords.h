// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/HoleFilling.h"
#include "tools/mesh/StepText.h"

#include <set>

namespace handwheel {

class MeshDocument;

// How steps name loops: by the smallest vertex, "v12", which outlives edits elsewhere. People may write the number that
// "handwheel inspect" shows, too, which is that of the present state.
std::string loopsText(const std::vector<Vertex>& keys);  // "v1,v12"
// The loops of a document, by their keys. Complains where there is none.
std::vector<Vertex> readLoops(StepReader& reader, const std::string& words, const MeshDocument& document);

std::string_view wordFor(NumberType numbers);  // "single"
// The option --numbers, or else what the document's file holds.
NumberType readNumbers(StepReader& reader, const MeshDocument& document);

// How holes are filled: --fill, --numbers, and what is not the default.
void addFillWords(StepWriter& step, const FillOptions& options);
// loopSize: of the loop that is filled, between whose points bridges may run; 0: none may.
FillOptions readFillWords(StepReader& reader, const MeshDocument& document, std::size_t loopSize = 0);

// What filling and mending leave alone, because the user wants it open: the corners of the loops, and their ids. Rims
// are not among them.
std::set<PointKey> keptCorners(const MeshDocument& document);
std::set<int> keptLoops(const MeshDocument& document);

}  // namespace handwheel
