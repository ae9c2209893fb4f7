// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"
#include "volume/clay/ClayLayers.h"

namespace handwheel {

// Writes the layers of a volume into a container. They go into manifest["document"]["layers"], and of the blocks that
// they change the volume below them ("document/layers/root/0000") and each layer before and after it
// ("document/layers/0/base/0000", "document/layers/0/top/0000"). visible: what the volume of the document is.
void writeLayers(const ClayLayers& layers, const SparseVolume& visible, Container& container);

// Reads them from any input; null where there are none. What is missing or makes no sense, and layers of another volume
// than the visible one, as where a program changed it that knows no layers: they are left out, and added to the damage.
// The volume stays what it is then.
std::shared_ptr<const ClayLayers> readLayers(const Container& container, const SparseVolume& visible,
                                             std::vector<Error>& damage);

}  // namespace handwheel
