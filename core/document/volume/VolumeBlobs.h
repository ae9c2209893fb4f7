// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"
#include "volume/SparseVolume.h"
#include "volume/clay/ClayMask.h"

namespace handwheel {

// Writes a volume into a container. Voxel and origin go into the object manifest["document"], and the regions of 64³
// voxels into chunks of about a megabyte ("volume/chunks/0000").
void writeVolume(const SparseVolume& volume, Container& container);

// Reads it from any input. What is missing or makes no sense is empty, and is added to the damage; where
// material would then end between samples it is closed off. Errors: ElementMalformed, Cancelled.
Result<SparseVolume> readVolume(const Container& container, std::vector<Error>& damage, Progress progress);

// The same of what is protected from dabs: manifest["document"]["mask"], and chunks "mask/0000". Null where it
// protects nothing, or is of another grid than the volume, which a program changed that knows no masks. What is missing
// or makes no sense was not painted, and is added to the damage.
void writeMask(const ClayMask& mask, Container& container);
std::shared_ptr<const ClayMask> readMask(const Container& container, const SparseVolume& volume,
                                         std::vector<Error>& damage);

}  // namespace handwheel
