// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "document/Container.h"
#include "volume/image/ImageVolume.h"
#include "volume/segment/Segment.h"

#include <optional>

namespace handwheel {

// Writes the CT or MR image of a volume, and its segment, into a container. Grid and range go into the object
// manifest["document"]["scan"], samples and bricks into blobs of their own ("scan/samples/0000", "scan/segment/0000").
// They are not in the folder of the kind, so that a program that knows neither keeps both.
void writeScan(const ImageVolume& image, const Segment& segment, Container& container);

struct StoredScan {
  ImageVolume image;
  std::optional<Segment> segment;  // none where its range is lost
};

// Reads them from any input; none: there is no image, or none that can be used, which is added to the damage. Samples
// that are lost have the least value of the others, bricks that are lost are by the range; both are damage, too.
std::optional<StoredScan> readScan(const Container& container, std::vector<Error>& damage, Progress progress);

}  // namespace handwheel
