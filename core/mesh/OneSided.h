// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/HoleFilling.h"

namespace handwheel {

// What cutting made of parts with one side only.
struct OneSidedCut {
  std::size_t loops = 0;         // cut along
  std::size_t opened = 0;        // edges of cuts that begin and end at a border, or at a cut
  std::vector<Vertex> vertices;  // along the cuts, rising
  bool isTwoSided = false;       // there is no such part left
};

// Cuts parts of the surface, as a file shows it, that have one side only along shortest closed ways on which left
// becomes right (shortestReversingLoop()), until they have two sides: at most as often as a part's Euler characteristic
// is below 2. The cut is opened to a slit: what is on its smaller side moves into its own faces by a tenth of them.
// Ways longer than this (mm) are none. The number of faces stays, and so does the characteristic, but for 1 more with a
// cut from border to border. Of no use once cancelled.
// O(n) for each way and the search for it.
OneSidedCut cutOneSided(HalfEdgeMesh& mesh, double longest, NumberType numbers, Progress progress = {});

// Whether a cut from border to border will do, which makes an opening wider and leaves it open.
enum class BorderCuts { No, Yes };

// The same, and closes the slits (fillLoops(), else closeHardHoles()). Returns along how many ways was cut: 0, and the
// mesh is as it was, where a slit stays open, where more faces would cross than before, or once cancelled. What crosses
// may be cut; nothing else goes.
std::size_t closeOneSided(HalfEdgeMesh& mesh, const FillOptions& options, double longest, BorderCuts borderCuts,
                          Progress progress = {});

}  // namespace handwheel
