// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"
#include "base/Progress.h"
#include "mesh/search/FaceHierarchy.h"

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace handwheel {

class MeshDocument;
struct SheetOutcomes;

// What became of a repair by volume.
struct VolumeOutcome {
  std::optional<Error> error;  // why there is none
  bool hasLostWalls = false;   // thinner than a voxel
};

// A change of a mesh as a repeatable function. It can run on another thread, and once more when the mesh has changed
// meanwhile. Faces keep their indices.
struct MeshChange {
  const char* text;  // of the undo step; English, context "Tool"
  std::function<void(HalfEdgeMesh&, Progress)> apply;
  // Why it may have changed nothing; English, context "Tool". Null where that needs no reason.
  const char* reason = nullptr;
  // Called on the window thread when the change is finished, whether it was committed or not.
  std::function<void()> ended = [] {};
  // Called on the window thread, before that and once it is committed, with the number of pairs of faces that cross
  // because of it. Null if it cannot cause any: then they are not searched for.
  std::function<void(std::size_t)> crossed = nullptr;
  // The change as a line of text, as MeshScript.h reads it; empty where it has no such form.
  std::string step = {};
  // Set by apply: why it changed nothing, as `reason`, where only trying shows it. Null where it need not be tried.
  std::shared_ptr<std::atomic<const char*>> found = nullptr;
  // Set by apply: what became of the sheets that were to be thickened, which the log says. Null for other changes.
  std::shared_ptr<SheetOutcomes> sheets = nullptr;
  // Set by apply: the largest distance between the surfaces before and after, mm, where it was measured. Null for other
  // changes.
  std::shared_ptr<std::optional<double>> distance = nullptr;
  // Set by apply of a repair by volume. Null for other changes.
  std::shared_ptr<VolumeOutcome> volume = nullptr;
  // Removes faces that the user has chosen, perhaps more than were meant.
  bool isDeletion = false;
  // Repairs listed defects: it is said how many of each kind there were before and are afterwards.
  bool isFix = false;
};

// Why a change has changed nothing, once it was applied; as MeshChange::reason.
const char* reasonOf(const MeshChange& change);

// A change that finds out why it changes nothing. work: returns that reason, or null for the one given here.
MeshChange explainedChange(const char* text, std::function<const char*(HalfEdgeMesh&, Progress)> work,
                           const char* reason = nullptr);

// A computation that takes too long for the window thread. It uses only what it captured by value, and returns a
// function that processes the result on the window thread.
struct ToolJob {
  const char* name;  // English, context "Tool"
  std::function<std::function<void()>(Progress)> work;
};

// Services for mesh tools, provided by the owner of the document's jobs. All of them are called on the window thread.
// The result of a job reaches the tool by way of ToolRunner::deliver().
struct MeshServices {
  // "picking": the faces of the present mesh, or of an older version until their hierarchy is built; null until the
  // first one is.
  std::function<std::shared_ptr<const FaceHierarchy>()> faces;
  // Starts a job in place of the previous one. A job that is cancelled has no effect.
  std::function<void(ToolJob)> run;
  std::function<void()> cancel;
  // Applies a change, finds the defects of the result, and commits it as one step, now or later, but after those
  // requested before. Nothing happens when it changes nothing.
  std::function<void(MeshChange)> commit;
  // Whether a change of the document waits or runs. Then a long one should not be offered again.
  std::function<bool()> isBusy = [] { return false; };
};

// Returns the change with another step.
inline MeshChange withStep(MeshChange change, std::string step) {
  change.step = std::move(step);
  return change;
}

// Applies a change to a document and commits it as one step, at once. The defects of the result are found, too. False
// if nothing differs, or it was cancelled.
bool commitChange(MeshDocument& document, const MeshChange& change, Progress progress = {});

// Restricts a change to meshes that are still as known when it was requested. For others it does nothing.
MeshChange onlyWhere(std::function<bool(const HalfEdgeMesh&)> isAsKnown, MeshChange change);

// Services that run everything at once, on the calling thread. For programs without a window. The document must outlive
// them.
MeshServices immediateServices(MeshDocument& document);

}  // namespace handwheel
