// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"
#include "document/volume/VolumeSnapshot.h"

namespace handwheel {

// Writes the records of the holes of a volume into a container. The list of holes is in the object
// manifest["document"], and the poses of all holes are in arrays ("volume/holes/…").
void writeHoles(const DrilledHoles& holes, Container& container);

// Reads the records; the input is not trusted. If a record is lost or malformed, the result is empty and the damage is
// reported, as the other holes could not be reproduced without it.
DrilledHoles readHoles(const Container& container, std::vector<Error>& damage);

// Writes the tried holes into the list manifest["document"]["tried"]. Each entry is [fingerprint of the hole,
// depth in the forbidden region, number of its try].
void writeTried(const TriedHoles& tried, Container& container);
// Reads the tried holes; the input is not trusted. Malformed entries are skipped and reported as damage. Returns null
// if there are no tried holes.
std::shared_ptr<const TriedHoles> readTried(const Container& container, std::vector<Error>& damage);

}  // namespace handwheel
