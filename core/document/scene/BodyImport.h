// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentKind.h"
#include "scene/Body.h"

namespace handwheel {

// A body read from a file, with what is to be said of it.
struct ImportedBody {
  Body body;          // without a number; named after the file
  DocumentFile file;  // with damage, losses and notes; the last of these says how large the body is
};

// Reads a file of any kind as a body: a mesh, a workpiece, a robot as it stands. isLinked: with a link to it. Errors:
// those of opening, of linkTo(); NoTriangles.
Result<ImportedBody> readBody(const DocumentKinds& kinds, const std::filesystem::path& path, bool isLinked,
                              Progress progress = {});

// Reads the file of a linked body again. Its name, place and look stay. folder: of the document; may be empty. Errors:
// those of readBody(), NotLinked, LinkedFileGone.
Result<ImportedBody> updatedFromLink(const DocumentKinds& kinds, const Body& body, const std::filesystem::path& folder,
                                     Progress progress = {});

}  // namespace handwheel
