// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"
#include "base/Progress.h"
#include "document/Note.h"
#include "mesh/search/FaceHierarchy.h"

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace handwheel {

class MeshDocument;
struct SheetOutcomes;

// The outcome of a repair by volume.
struct VolumeOutcome {
  std::optional<Error> error;  // the reason why there is no result; none: there is one
  bool hasLostWalls = false;   // parts of walls that the voxels do not resolve are lost
  std::vector<Note> notes;     // the walls and gaps that the voxels do not resolve
};

// A change of a mesh as a repeatable function. It can run on another thread, and can be repeated if the mesh has
// changed in the meantime. Unless a change states otherwise, faces keep their indices.
struct MeshChange {
  const char* text;  // text of the undo step; English text, translated in the context "Tool"
  std::function<void(HalfEdgeMesh&, Progress)> apply;
  // The reason why the change had no effect; English text, translated in the context "Tool". Null: no reason is needed.
  const char* reason = nullptr;
  // The function that is called on the window thread when the change is finished, even if it was not committed.
  std::function<void()> ended = [] {};
  // The function that is called on the window thread after the change is committed and before `ended`, with the number
  // of pairs of faces that intersect because of the change. Null: the change cannot cause intersections, so they are
  // not searched for.
  std::function<void(std::size_t)> crossed = nullptr;
  // The change as a line of text, as MeshScript.h reads it; empty: it has no textual form.
  std::string step = {};
  // The reason why the change had no effect, as in `reason`, if only the attempt shows it. It is set by apply. Null: no
  // attempt is needed.
  std::shared_ptr<std::atomic<const char*>> found = nullptr;
  // The outcomes of the sheets to be thickened, for the log. They are set by apply. Null: the change thickens no
  // sheets.
  std::shared_ptr<SheetOutcomes> sheets = nullptr;
  // The largest distance between the surfaces before and after the change, mm, if it was measured. It is set by apply.
  // Null: the change measures no distance.
  std::shared_ptr<std::optional<double>> distance = nullptr;
  // The outcome of a repair by volume. It is set by apply. Null: the change is not a repair by volume.
  std::shared_ptr<VolumeOutcome> volume = nullptr;
  // True if the change removes faces that the user has selected, perhaps more than intended.
  bool isDeletion = false;
  // True if the change repairs listed defects. The log then contains the number of each kind before and after the
  // change.
  bool isFix = false;
};

// Returns the reason why an applied change had no effect, as in MeshChange::reason.
const char* reasonOf(const MeshChange& change);

// Creates a change that determines the reason if it has no effect. work: the function that makes the change and returns
// the reason, or null for the parameter "reason".
MeshChange explainedChange(const char* text, std::function<const char*(HalfEdgeMesh&, Progress)> work,
                           const char* reason = nullptr);

// A computation that takes too long for the window thread. It uses only values that it captured by copy, and returns a
// function that processes the result on the window thread.
struct ToolJob {
  const char* name;  // name of the job; English text, translated in the context "Tool"
  std::function<std::function<void()>(Progress)> work;
};

// Services for mesh tools, provided by the owner of the document's jobs. All of them are called on the window thread.
// The result of a job reaches the tool through ToolRunner::deliver().
struct MeshServices {
  // The service "picking". It returns the faces of the present mesh, or of an older version until their hierarchy is
  // built; null: no hierarchy has been built yet.
  std::function<std::shared_ptr<const FaceHierarchy>()> faces;
  // Starts a job, which replaces the previous one. A job that is cancelled has no effect.
  std::function<void(ToolJob)> run;
  std::function<void()> cancel;
  // Applies a change, finds the defects of the result, and commits it as one step, at once or later, but after the
  // changes requested before. A change without effect adds no step.
  std::function<void(MeshChange)> commit;
  // Returns true while a change of the document waits or runs. Meanwhile a long change should not be offered again.
  std::function<bool()> isBusy = [] { return false; };
};

// Returns the change with another script step.
inline MeshChange withStep(MeshChange change, std::string step) {
  change.step = std::move(step);
  return change;
}

// Applies a change to a document and commits it as one step, at once. Also finds the defects of the result. Returns
// false if the mesh is unchanged or the call is cancelled.
bool commitChange(MeshDocument& document, const MeshChange& change, Progress progress = {});

// Restricts a change to meshes for which isAsKnown returns true. It does nothing to other meshes.
MeshChange onlyWhere(std::function<bool(const HalfEdgeMesh&)> isAsKnown, MeshChange change);

// Returns services that run everything at once, on the calling thread. They are for programs without a window. The
// document must outlive them.
MeshServices immediateServices(MeshDocument& document);

}  // namespace handwheel
