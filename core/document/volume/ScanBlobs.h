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
// manifest["document"]["scan"], samples and bricks into separate blobs ("scan/samples/0000", "scan/segment/0000").
// These are outside the folder of the kind, so that a program that does not know them keeps them.
void writeScan(const ImageVolume& image, const Segment& segment, Container& container);

struct StoredScan {
  ImageVolume image;
  std::optional<Segment> segment;  // none if its range is lost
};

// Reads the image and the segment; the input is not trusted. None: there is no image, or it is unusable, which is added
// to the damage. Lost samples get the least value of the others, lost bricks are defined by the range; both are added
// to the damage, too.
std::optional<StoredScan> readScan(const Container& container, std::vector<Error>& damage, Progress progress);

}  // namespace handwheel
