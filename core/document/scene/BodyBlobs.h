// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "document/scene/GeometryBlobs.h"
#include "scene/BodySet.h"

namespace handwheel {

// Writes bodies to a container, in the same format for all kinds of documents. Their list is "bodies" in the object
// "document" of the manifest. Its keys are numbers (four digits or more), its values have name, pose (twelve numbers,
// the rows of the rotation with the position, mm), colour, smooth, visible, link, geometry and carrier. The arrays of a
// shape are in blobs below "FOLDER/bodies/NUMBER". "next_body" is the number of the next body. folder: the folder of
// the kind of document, without a slash. own: formats of the shapes that only this kind has.
void writeBodies(const BodySet& bodies, const std::string& folder, Container& container,
                 std::span<const GeometryFormat> own = {});

// Reads bodies from a container, which may have any content. A fault of a body is mended if that loses nothing (a name
// that another body has, a rotation in few digits), or added to damage: ElementMalformed {"bodies.NUMBER", the fault},
// FileTooLarge, the errors of readGeometry(). Errors: Cancelled.
Result<BodySet> readBodies(const Container& container, const std::string& folder, std::vector<Error>& damage,
                           Progress progress, std::span<const GeometryFormat> own = {});

}  // namespace handwheel
