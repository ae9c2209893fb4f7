// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"
#include "document/volume/VolumeSnapshot.h"

namespace handwheel {

// Writes into a container how the holes of a volume were drilled. A list is in the object manifest["document"], and the
// poses of all are in arrays ("volume/holes/…").
void writeHoles(const DrilledHoles& holes, Container& container);

// Reads it from any input. Where one is lost or makes no sense there is none, and the damage has it: a hole alone would
// not be drilled again as it was.
DrilledHoles readHoles(const Container& container, std::vector<Error>& damage);

// Writes the holes that were tried into the list manifest["document"]["tried"], each as [mark, depth in the forbidden
// region, number of its try].
void writeTried(const TriedHoles& tried, Container& container);
// Reads it from any input. Null: there are none. What makes no sense is left out, and the damage has it.
std::shared_ptr<const TriedHoles> readTried(const Container& container, std::vector<Error>& damage);

}  // namespace handwheel
