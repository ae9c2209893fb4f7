// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentKind.h"
#include "scene/Body.h"

namespace handwheel {

// A body read from a file, with the notes for the user.
struct ImportedBody {
  Body body;          // Without a number; named after the file
  DocumentFile file;  // With damage, losses and notes; the last note gives the size of the body
};

// Reads a file of any kind as a body: a mesh, a workpiece, a robot in its stored configuration. isLinked: the body gets
// a link to the file. Errors: those of opening, of linkTo(); NoTriangles.
Result<ImportedBody> readBody(const DocumentKinds& kinds, const std::filesystem::path& path, bool isLinked,
                              Progress progress = {});

// Reads the file of a linked body again. Its name, pose and look stay. folder: of the document; may be empty. Errors:
// those of readBody(), NotLinked, LinkedFileGone.
Result<ImportedBody> updatedFromLink(const DocumentKinds& kinds, const Body& body, const std::filesystem::path& folder,
                                     Progress progress = {});

}  // namespace handwheel
