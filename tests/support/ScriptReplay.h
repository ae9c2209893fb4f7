// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "MeshDocuments.h"
#include "document/Container.h"
#include "mesh/structure/MeshValidator.h"
#include "tools/mesh/MeshScript.h"

#include <optional>

namespace handwheel::test {

// Returns the bytes of the container of a document.
inline std::string bytesOf(const MeshDocument& document) {
  Container container;
  document.kind().save(*document.snapshot(), container);
  return writeContainer(container, Compression::Fast).value();
}

// Applies the steps of a document to a second document with the same triangles. Returns a description of the first
// difference between the documents. The result is empty if they are equal, byte for byte, at first and after each step.
inline std::string replayed(const TriangleSoup& soup, MeshDocument& edited) {
  const auto steps = scriptLinesSince(edited);
  if (!steps) return "an edit has no step";
  QUndoStack& history = *edited.history();
  const int end = history.index();
  // If the document reverses faces on opening and that is undone, the first step is to undo it.
  const int start = edited.facesAsInFile().empty() ? edited.openingSteps() : -1;
  const auto document = meshDocument(soup, edited.file().path);
  std::string problem;
  for (std::size_t i = 0; i < steps->size() && problem.empty(); ++i) {
    const auto done = applyScriptLine(*document, (*steps)[i]);
    history.setIndex(start + static_cast<int>(i) + 1);
    if (!done) {
      problem = done.error().arguments.at(0);
    } else if (!done->changed) {
      problem = "changed nothing";
    } else {
      problem = validate(document->mesh());
    }
    if (problem.empty() && bytesOf(*document) != bytesOf(edited)) problem = "the bytes differ";
    if (!problem.empty()) problem = (*steps)[i] + ": " + problem;
  }
  history.setIndex(end);
  if (problem.empty() && scriptLinesSince(*document) != steps) problem = "the steps of the replay are others";
  return problem;
}

}  // namespace handwheel::test
