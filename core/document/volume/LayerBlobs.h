// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"
#include "volume/clay/ClayLayers.h"

namespace handwheel {

// Writes the layers of a volume into a container. The list is in manifest["document"]["layers"]. The blobs contain only
// changed blocks: those of the volume below all layers ("document/layers/root/0000"), and those before and after each
// layer ("document/layers/0/base/0000", "document/layers/0/top/0000"). visible: the volume of the document.
void writeLayers(const ClayLayers& layers, const SparseVolume& visible, Container& container);

// Reads the layers; the input is not trusted. Layers are dropped and reported as damage if they are missing or
// malformed, or do not result in the visible volume, as after a change by a program without layers. The volume remains
// unchanged. Returns null if there are no layers.
std::shared_ptr<const ClayLayers> readLayers(const Container& container, const SparseVolume& visible,
                                             std::vector<Error>& damage);

}  // namespace handwheel
