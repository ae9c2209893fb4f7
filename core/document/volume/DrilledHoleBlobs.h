// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"
#include "document/volume/VolumeSnapshot.h"

namespace handwheel {

// Writes the records of the holes of a volume into a container. A list is in the object manifest["document"], and all
// poses are in arrays ("volume/holes/…").
void writeHoles(const DrilledHoles& holes, Container& container);

// Reads the records; the input is not trusted. If one is lost or malformed, there are none, and the damage is reported:
// single holes could not be reproduced.
DrilledHoles readHoles(const Container& container, std::vector<Error>& damage);

// Writes the tried holes into the list manifest["document"]["tried"], each as [mark, depth in the forbidden region,
// number of its try].
void writeTried(const TriedHoles& tried, Container& container);
// Reads the tried holes; the input is not trusted. Null: there are none. Malformed entries are left out and reported as
// damage.
std::shared_ptr<const TriedHoles> readTried(const Container& container, std::vector<Error>& damage);

}  // namespace handwheel
