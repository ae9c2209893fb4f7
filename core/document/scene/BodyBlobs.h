// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "document/scene/GeometryBlobs.h"
#include "scene/BodySet.h"

namespace handwheel {

// Writes bodies to a container, the same for all kinds of documents. Their list is "bodies" in the object "document" of
// the manifest, by number (four digits or more): name, pose (twelve numbers, the rows of the rotation with the
// position, mm), colour, smooth, visible, link and geometry. The arrays of a shape are in blobs below
// "FOLDER/bodies/NUMBER". "next_body" is the number of the next one. folder: the folder of the kind of document,
// without a slash. own: formats of the shapes that only this kind has.
void writeBodies(const BodySet& bodies, const std::string& folder, Container& container,
                 std::span<const GeometryFormat> own = {});

// Reads bodies; accepts any input. A fault of a body is mended if that loses nothing (a name that another has, a
// rotation in few digits), or added to damage: ElementMalformed {"bodies.NUMBER", the fault}, FileTooLarge, those of
// readGeometry(). Error: Cancelled.
Result<BodySet> readBodies(const Container& container, const std::string& folder, std::vector<Error>& damage,
                           Progress progress, std::span<const GeometryFormat> own = {});

}  // namespace handwheel
