// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"
#include "volume/SparseVolume.h"
#include "volume/clay/ClayMask.h"

namespace handwheel {

// Writes a volume into a container. The voxel size and the origin go into the object manifest["document"], and the
// regions of 64³ voxels into chunks of about a megabyte ("volume/chunks/0000").
void writeVolume(const SparseVolume& volume, Container& container);

// Reads a volume; the input is not trusted. Missing and malformed regions are empty, and are reported as damage. Where
// material would end at such a region, its surface is closed. Errors: ElementMalformed, Cancelled.
Result<SparseVolume> readVolume(const Container& container, std::vector<Error>& damage, Progress progress);

// Writes and reads the mask: manifest["document"]["mask"], and chunks "mask/0000". readMask() returns null if the mask
// protects nothing, or if its grid differs from that of the volume, as after a change by a program without masks.
// Missing and malformed regions are not protected, and are reported as damage.
void writeMask(const ClayMask& mask, Container& container);
std::shared_ptr<const ClayMask> readMask(const Container& container, const SparseVolume& volume,
                                         std::vector<Error>& damage);

}  // namespace handwheel
