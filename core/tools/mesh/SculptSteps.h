// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/NoiseSmoothing.h"
#include "tools/mesh/SculptStroke.h"
#include "tools/mesh/StepText.h"

#include <functional>
#include <optional>

namespace handwheel {

class MeshDocument;

// What becomes of the levels of a patch by a step of sculpting.
struct Sculpted {
  PatchLevels levels;
  FaceSelection touched;          // none: nothing was made
  const char* problem = nullptr;  // why; English, context "Property"
  std::string step = {};
};

// So many levels more; none: until it is as fine as its surroundings.
Sculpted subdivided(PatchLevels levels, std::optional<int> times, NumberType numbers, Progress progress);
// Of the patch, or along the border without one.
Sculpted withoutNoise(PatchLevels levels, const NoiseSmoothing& options);
Sculpted levelBack(PatchLevels levels);
// Of a stroke that has ended.
Sculpted sculpted(const SculptStroke& stroke);

// The levels on which a step works, as a document has them: those that it remembers of this patch and are as many, or
// the patch by itself.
std::optional<PatchLevels> levelsOf(const MeshDocument& document, const FaceSelection& patch, std::size_t finest);

// Reads what comes after "stroke", "subdivide", "smooth-noise" or "level-back". Null: it is no such step.
using SculptWork = std::function<Sculpted(Progress)>;
SculptWork readSculptStep(StepReader& reader, const MeshDocument& document);

}  // namespace handwheel
