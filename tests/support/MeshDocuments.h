// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/mesh/MeshDocument.h"
#include "document/mesh/MeshKind.h"

#include <memory>

namespace handwheel::test {

// Returns a document with these triangles, as if opened from a file with this path.
inline std::unique_ptr<MeshDocument> meshDocument(const TriangleSoup& soup, const std::string& path = "/scans/part.stl",
                                                  NumberType numbers = NumberType::Float32) {
  static const MeshKind kind;
  MeshFile file;
  file.soup = soup;
  file.numbers = numbers;
  OpenedFile opened;
  opened.kind = &kind;
  opened.file.path = path;
  opened.file.id = "test";
  opened.content = meshSnapshotOf(file);
  return std::make_unique<MeshDocument>(std::move(opened));
}

}  // namespace handwheel::test
