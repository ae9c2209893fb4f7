// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentKind.h"
#include "scene/Body.h"

namespace handwheel {

// A body that was read from a file, with the notes for the user.
struct ImportedBody {
  Body body;          // The body, without a number and named after the file
  DocumentFile file;  // The file, with damage, losses and notes; the last note states the size of the body
};

// Reads a file of any kind as a body: a mesh, a workpiece, or a robot in its stored configuration. isLinked: the body
// gets a link to the file. Errors: the errors of opening and of linkTo(); NoTriangles.
Result<ImportedBody> readBody(const DocumentKinds& kinds, const std::filesystem::path& path, bool isLinked,
                              Progress progress = {});

// Reads the file of a linked body again. The name, pose and look of the body do not change. folder: the folder of the
// document; may be empty. Errors: the errors of readBody(), NotLinked, LinkedFileGone.
Result<ImportedBody> updatedFromLink(const DocumentKinds& kinds, const Body& body, const std::filesystem::path& folder,
                                     Progress progress = {});

}  // namespace handwheel
