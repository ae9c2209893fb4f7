// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"
#include "volume/clay/ClayLayers.h"

namespace handwheel {

// Writes the layers of a volume into a container. The list is in manifest["document"]["layers"]. Of the changed blocks,
// the container has the volume below all layers ("document/layers/root/0000"), and the states before and after each
// layer ("document/layers/0/base/0000", "document/layers/0/top/0000"). visible: the volume of the document.
void writeLayers(const ClayLayers& layers, const SparseVolume& visible, Container& container);

// Reads the layers; the input is not trusted. Null: there are none. Layers that are missing or malformed, or that do
// not result in the visible volume, as after a change by a program without layers, are left out and added to the
// damage. The volume is unchanged then.
std::shared_ptr<const ClayLayers> readLayers(const Container& container, const SparseVolume& visible,
                                             std::vector<Error>& damage);

}  // namespace handwheel
