// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/FaceHierarchy.h"

#include <functional>
#include <memory>
#include <string>

namespace handwheel {

class MeshDocument;

// A change that a tool wants made to a mesh, as a recipe: it can be carried out on another thread, and once more when
// the mesh has changed meanwhile. Faces keep their numbers.
struct MeshChange {
  const char* text;  // of the undo step; English, context "Tool"
  std::function<void(HalfEdgeMesh&, Progress)> apply;
  // Why it may have changed nothing; English, context "Tool". Null where that needs no reason.
  const char* hindrance = nullptr;
  // Hears on the window thread that nothing more will come of it, whether it was committed or not.
  std::function<void()> ended = [] {};
  // Hears on the window thread, before that and once it is committed, how many pairs of faces cross because of it. Null
  // where it can make none: then nobody looks.
  std::function<void(std::size_t)> crossed = nullptr;
  // The change as a line of text, as MeshSteps.h reads it; empty where it has no such form.
  std::string step = {};
};

// Thinking that takes too long for the window. It sees only what it captured by value, and returns what is to be done
// with the result on the window thread.
struct ToolJob {
  const char* name;  // English, context "Tool"
  std::function<std::function<void()>(Progress)> work;
};

// What the tools for meshes are given by who owns the document's jobs. All of it is called on the window thread. The
// result of a job reaches the tool by way of ToolRunner::deliver().
struct MeshServices {
  // "picking": the faces of the present mesh, or of an older version until their hierarchy is built; null until the
  // first one is.
  std::function<std::shared_ptr<const FaceHierarchy>()> faces;
  // Starts a job in the place of the one before. Nothing comes of a job that is cancelled.
  std::function<void(ToolJob)> run;
  std::function<void()> cancel;
  // Makes a change, looks for the defects of the result, and commits it as one step, now or later, but after those
  // that were asked for before. Nothing happens when it changes nothing.
  std::function<void(MeshChange)> commit;
};

inline MeshChange withStep(MeshChange change, std::string step) {
  change.step = std::move(step);
  return change;
}

// Makes a change, looks for the defects of the result, and commits it as one step, at once. False where nothing
// differs, or it was cancelled.
bool commitChange(MeshDocument& document, const MeshChange& change, Progress progress = {});

// The change, where the mesh is still as it was known when the change was asked for; else none.
MeshChange onlyWhere(std::function<bool(const HalfEdgeMesh&)> isAsKnown, MeshChange change);

// All at once, on the calling thread: for programs without a window. The document must outlive them.
MeshServices immediateServices(MeshDocument& document);

}  // namespace handwheel
