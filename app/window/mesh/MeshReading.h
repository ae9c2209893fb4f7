// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentKind.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <QString>

namespace handwheel {

// Reads the mesh in a file. Errors: the errors of the readers; NoTriangles if the file contains no mesh. May be called
// on any thread.
Result<HalfEdgeMesh> readMesh(const DocumentKinds& kinds, const QString& path, Progress progress);

}  // namespace handwheel
