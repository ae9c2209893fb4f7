// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/sculpt/LaplaceSmoothing.h"
#include "mesh/sculpt/NoiseSmoothing.h"
#include "tools/mesh/ScriptLine.h"
#include "tools/mesh/sculpt/SculptSettings.h"
#include "tools/mesh/sculpt/SculptStroke.h"

#include <functional>
#include <optional>

namespace handwheel {

class MeshDocument;

// Result of a sculpting step on the levels of a patch.
struct SculptResult {
  PatchLevels levels;
  FaceSelection touched;          // empty: nothing was changed
  const char* problem = nullptr;  // why; English, context "Property"
  std::string step = {};
};

// Subdivides a patch. times: number of levels to add; none: until it is as fine as its surroundings.
SculptResult subdivided(PatchLevels levels, std::optional<int> times, NumberType numbers, Progress progress);
// How noise is smoothed: by the options of the method that is chosen.
struct Denoising {
  NoiseMethod method = NoiseMethod::Bilateral;
  NoiseSmoothing bilateral;
  LaplaceSmoothing laplace;
};
Denoising denoisingOf(const OperationValues& values, NumberType numbers);

// Smooths noise on the patch, or along the border without one.
SculptResult denoised(PatchLevels levels, Denoising options, Progress progress);
// Removes the finest level of a patch.
SculptResult coarsened(PatchLevels levels);
// The result of a finished stroke.
SculptResult sculpted(const SculptStroke& stroke);

// The subdivision levels of a patch on which a step works. Those that the document stores for this patch, if their
// number fits `finest`, or the patch alone.
std::optional<PatchLevels> levelsOf(const MeshDocument& document, const FaceSelection& patch, std::size_t finest);

// Reads what else a step "stroke", "subdivide", "smooth-noise" or "level-back" has. Null where that is wrong.
using SculptWork = std::function<SculptResult(Progress)>;
SculptWork readSculptLine(ScriptLineReader& reader, const OperationValues& values, const MeshDocument& document);

}  // namespace handwheel
