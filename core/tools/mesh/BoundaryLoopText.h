// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/holes/HoleFiller.h"
#include "tools/mesh/ScriptLine.h"

#include <set>

namespace handwheel {

class MeshDocument;

// Writes loops as text for a step. A loop is named by its smallest vertex, "v12", which stays valid after edits
// elsewhere. Users may also write the number that "handwheel inspect" shows, which is valid only for the present state.
std::string loopsText(const std::vector<Vertex>& keys);  // "v1,v12"
// Reads the loops of a document and returns their keys. A loop that does not exist becomes a problem of the reader.
std::vector<Vertex> readLoops(ScriptLineReader& reader, const std::string& words, const MeshDocument& document);

// Returns the fill options for a document: its number type unless the values specify one, and the loops that the user
// wants open.
FillOptions fillOptionsFor(const MeshDocument& document, const OperationValues& values);
// Returns the number type in the values, or else the number type of the document's file.
NumberType numbersFor(const MeshDocument& document, const OperationValues& values);

// Return the loops that the user wants open, which are not filled or repaired. keptCorners() returns their corners,
// keptLoops() their ids. Sheet boundaries are not included.
std::set<PointKey> keptCorners(const MeshDocument& document);
std::set<int> keptLoops(const MeshDocument& document);

}  // namespace handwheel
