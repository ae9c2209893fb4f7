// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "document/Container.h"
#include "volume/image/ImageVolume.h"
#include "volume/segment/Segment.h"

#include <optional>

namespace handwheel {

// Writes the CT or MR image of a volume, and its segment, into a container. The grid of the image and the range of the
// segment go into the object manifest["document"]["scan"]; the samples of the image and the bricks of the segment go
// into separate blobs ("scan/samples/0000", "scan/segment/0000"). The blobs are outside the folder of the document
// kind, so that programs that do not know them keep them.
void writeScan(const ImageVolume& image, const Segment& segment, Container& container);

struct StoredScan {
  ImageVolume image;
  std::optional<Segment> segment;  // none: the range of the segment is lost
};

// Reads the image and the segment; the input is not trusted. Returns nothing if there is no image, or if the image is
// unusable, which is reported as damage. Lost samples get the least value of the other samples, and lost bricks are
// computed from the range of the segment; both losses are reported as damage, too.
std::optional<StoredScan> readScan(const Container& container, std::vector<Error>& damage, Progress progress);

}  // namespace handwheel
