// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentKind.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <QString>

namespace handwheel {

// Reads the mesh in a file. Errors: those of the readers; NoTriangles if it holds no mesh. Any thread.
Result<HalfEdgeMesh> readMesh(const DocumentKinds& kinds, const QString& path, Progress progress);

}  // namespace handwheel
