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

// Outcome of a repair by volume.
struct VolumeOutcome {
  std::optional<Error> error;  // the reason if there is no result
  bool hasLostWalls = false;   // walls thinner than a voxel are lost
};

// A change of a mesh as a repeatable function. It can run on another thread, and again if the mesh has changed
// meanwhile. Faces keep their indices.
struct MeshChange {
  const char* text;  // text of the undo step; English, context "Tool"
  std::function<void(HalfEdgeMesh&, Progress)> apply;
  // The reason if it has changed nothing; English, context "Tool". Null if that needs no reason.
  const char* reason = nullptr;
  // Called on the window thread when the change is finished, whether it was committed or not.
  std::function<void()> ended = [] {};
  // Called on the window thread, before `ended` and once the change is committed, with the number of pairs of faces
  // that cross because of it. Null if the change cannot cause any: then they are not searched for.
  std::function<void(std::size_t)> crossed = nullptr;
  // The change as a line of text, as MeshScript.h reads it; empty if it has no such form.
  std::string step = {};
  // Set by apply: the reason why it changed nothing, as `reason`, if only the attempt shows it. Null if no attempt is
  // needed.
  std::shared_ptr<std::atomic<const char*>> found = nullptr;
  // Set by apply: the outcomes of the sheets to be thickened, for the log. Null for other changes.
  std::shared_ptr<SheetOutcomes> sheets = nullptr;
  // Set by apply: the largest distance between the surfaces before and after, mm, if it was measured. Null for other
  // changes.
  std::shared_ptr<std::optional<double>> distance = nullptr;
  // Set by apply of a repair by volume. Null for other changes.
  std::shared_ptr<VolumeOutcome> volume = nullptr;
  // The change removes faces that the user has chosen, perhaps more than were meant.
  bool isDeletion = false;
  // The change repairs listed defects: the log says how many of each kind there were before and are afterwards.
  bool isFix = false;
};

// Returns the reason why an applied change has changed nothing; as MeshChange::reason.
const char* reasonOf(const MeshChange& change);

// Creates a change that finds out why it changes nothing. work: returns that reason, or null for the reason given here.
MeshChange explainedChange(const char* text, std::function<const char*(HalfEdgeMesh&, Progress)> work,
                           const char* reason = nullptr);

// A computation that takes too long for the window thread. It uses only values that it captured by copy, and returns a
// function that processes the result on the window thread.
struct ToolJob {
  const char* name;  // English, context "Tool"
  std::function<std::function<void()>(Progress)> work;
};

// Services for mesh tools, provided by the owner of the document's jobs. All of them are called on the window thread.
// The result of a job reaches the tool through ToolRunner::deliver().
struct MeshServices {
  // "picking": the faces of the present mesh, or of an older version until their hierarchy is built; null until the
  // first hierarchy exists.
  std::function<std::shared_ptr<const FaceHierarchy>()> faces;
  // Starts a job, which replaces the previous one. A job that is cancelled has no effect.
  std::function<void(ToolJob)> run;
  std::function<void()> cancel;
  // Applies a change, finds the defects of the result, and commits it as one step, now or later, but after the changes
  // requested before. A change that changes nothing adds no step.
  std::function<void(MeshChange)> commit;
  // Returns true while a change of the document waits or runs. Then a long change should not be offered again.
  std::function<bool()> isBusy = [] { return false; };
};

// Returns the change with another step.
inline MeshChange withStep(MeshChange change, std::string step) {
  change.step = std::move(step);
  return change;
}

// Applies a change to a document and commits it as one step, at once. Also finds the defects of the result. Returns
// false if nothing differs, or if cancelled.
bool commitChange(MeshDocument& document, const MeshChange& change, Progress progress = {});

// Restricts a change to meshes that are still as they were when it was requested. It does nothing to others.
MeshChange onlyWhere(std::function<bool(const HalfEdgeMesh&)> isAsKnown, MeshChange change);

// Returns services that run everything at once, on the calling thread. For programs without a window. The document must
// outlive them.
MeshServices immediateServices(MeshDocument& document);

}  // namespace handwheel
