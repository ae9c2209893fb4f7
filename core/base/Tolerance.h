// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace handwheel::tolerance {

// Every tolerance of the program, so that none hides in a formula: what counts as the same, flat, parallel, near. What
// guards one formula against its own rounding stands beside that formula. Lengths are shares of the model's
// bounding-box diagonal unless the name says otherwise.

// A part whose thickness (RMS, to its best plane) is below this share of its extent (RMS) is a flat sheet.
inline constexpr double kFlatSheet = 1e-3;
// A part that holds less than this share of its area to the power 3/2 is thin (a sphere holds 0.094, a half one 0.13).
inline constexpr double kSheetVolume = 0.06;
// A part whose longest loop, squared, is over this many of its areas is an open sheet: eight times a flat disc's
// outline, as the frayed edge of a view from one side has. (A toothed hole in a box has 81; such a view 125.)
inline constexpr double kRaggedOutline = 100.0;
// A part with less than these shares of the largest part's area and faces is debris.
inline constexpr double kDebrisArea = 0.01;
inline constexpr double kDebrisFaces = 0.01;
// A face that hangs on a surplus edge is removed as a flap when no edge of it is longer than this.
inline constexpr double kFlap = 0.01;
// Vertices on open borders nearer than this are one vertex that the file rounded apart; a repair merges them. The
// default of the fidelity setting mesh.near_weld.
inline constexpr double kNearWeld = 1e-5;
// But not across more than this share of the longer border edge at either: that would be detail.
inline constexpr double kNearWeldEdge = 0.25;
// A patch may leave the box of its loop by this share of that box's diagonal,
inline constexpr double kPatchSwelling = 0.5;
// and the model's box by this share of the model's diagonal, or by the height of a cap that continues the surroundings
// times the slack. Surroundings whose normals have a smaller mean cosine to the loop's are too steep for a cap.
inline constexpr double kModelSwelling = 0.01;
inline constexpr double kCapSlack = 1.5;
inline constexpr double kCapCosine = 0.4;
// CGAL's cubic hole triangulation is allowed up to this many edges; beyond, it freezes (90 s at 2554).
inline constexpr int kCubicFillEdges = 300;
// A loop of more edges is cut into pieces of no more before it is triangulated: 2,554 edges then take 60 ms, and what
// is filled in one piece is better shaped. The default of the fidelity setting mesh.piece_edges.
inline constexpr int kPieceEdges = 1000;
// The best of all triangulations by an own criterion, O(n³), is looked for up to this many edges; pieces of longer
// loops have half as many, which keeps 2,554 edges below 0.1 s.
inline constexpr int kOptimalFillEdges = 300;
// CGAL's hole triangulation recurses once per edge at worst: 40,000 overflow a stack of 2 MB, 100,000 one of 8 MB.
inline constexpr int kLibraryFillEdges = 20'000;
// CGAL builds a vertex with n faces in O(n²): 0.2 s for 5,000, 3 s for 20,000.
inline constexpr int kLibraryFanFaces = 5'000;
// How densely a patch is refined: where its edges are longer than 1 / this of those around the hole, they are split.
// √2 splits to about their length. The default of the fidelity setting mesh.patch_density.
inline constexpr double kPatchDensity = 1.4142135623730951;
// A crease whose sides meet at more than this angle (radian; 30°) and that ends at a hole is carried on through it.
inline constexpr double kRidgeAngle = 0.52;
// New vertices of a patch per boundary edge, and in all: where the density of the surroundings asks for more, the patch
// is coarser. 10,000 take 0.15 s to refine and bend, which nothing can interrupt.
inline constexpr int kPatchVerticesPerEdge = 20;
inline constexpr int kPatchVertices = 10'000;
// The thickness of a sheet that is given a back.
inline constexpr double kBackThickness = 1e-3;
// A back is set behind a vertex by at most this share of its shortest edge.
inline constexpr double kBackEdge = 0.25;
// More crossings that hang together than this are not cut apart: it would take minutes.
inline constexpr std::size_t kUncrossPairs = 50'000;
inline constexpr std::size_t kCutsPerFace = 200;
// Coordinates that are exact only with more bits than this, from the largest number to the last digit of the smallest,
// are none of a part: a double has 53, metres with noise of 1e-17 in the zeros some 120. Exact arithmetic takes the
// square.
inline constexpr int kCutBits = 512;
// To fill the holes of n faces takes no more steps (Effort) than this times n log2 n, of a microsecond each, and to
// close by cutting what no patch closes no more again:
inline constexpr double kRepairEffort = 1'000.0;
// of that, trials take no more than this share, nor than some 20 s;
inline constexpr double kHardHoleShare = 0.5;
inline constexpr std::size_t kHardHoleEffort = 20'000'000;
// taking out what is tangled no more than this share, nor than some 10 s; and parting what only touches the rest.
inline constexpr double kTangleShare = 0.25;
inline constexpr std::size_t kTangleEffort = 10'000'000;
inline constexpr double kPartShare = 0.25;
// What is tangled around a hole is taken out and filled anew where that moves the surface by no more than this share of
// the part: more would change what the part is.
inline constexpr double kTangleMove = 0.01;
// A body that is taken out whole lay on the surface so closely.
inline constexpr double kTangleBodyMove = 1e-3;
// A surface that has one side only is given two by cuts no longer than this share of the part. Longer ones change the
// shape: on demand.
inline constexpr double kOneSidedCut = 0.01;
// A polygon of a file is planar when no corner is further from its plane than this share of its size: beyond, which cut
// is right depends on more than the outline, and everybody expects a fan.
inline constexpr double kPlanarPolygon = 1e-3;

// Faces that meet at no more than this angle (radian; 1°) lie in one plane for who looks for edges: files in single
// precision turn them by less, and the sides of a finely drawn cylinder meet at more.
inline constexpr double kFlatEdge = 0.0175;

// What a part can be stood on: points this near to a plane lie in it. A hundred times what single precision rounds, and
// so little that of a smooth ball, whose cap of this height has at most sqrt(3) times this share of the area, nothing
// is a flat face:
inline constexpr double kStandingFlatness = 1e-5;
// a flat face has at least this share of the part's area. Less is a facet of a curved surface rather than a foot.
inline constexpr double kStandingShare = 1e-3;
// Neighbours in one plane have normals with at least this cosine between them (0.08°): single precision turns faces of
// a thousandth of the part by less.
inline constexpr double kFlatCosine = 1.0 - 1e-6;

// How far a proxy stays off the surface that it touches: far above what rounding moves it, far below what a person
// sees.
inline constexpr double kContactSkin = 0x1p-27;
// What is wider than this is no seam that has to be closed before a scan is touched.
inline constexpr double kContactSeam = 0x1p-12;
// Corners across a seam become one when it is narrower than this share of the open edges at them. A strip would be a
// step there: the borders are seldom equally high, and a proxy stops at a step of a micrometre.
inline constexpr double kContactSeamEdge = 0.25;
// How far an edit is looked for that has buried a proxy.
inline constexpr double kContactBuried = 0.01;
// Two planes of contact are one below this sine of their angle, squared;
inline constexpr double kOnePlane = 1e-14;
// a third says nothing new when the volume that the three normals span, squared, is below this.
inline constexpr double kSpannedVolume = 1e-18;

// Height over longest side from which a face counts as a needle, unless it was nearly one before.
inline constexpr double kNeedle = 1e-4;
// A triangle with a smaller sine at a corner may be without area, and is looked at exactly.
inline constexpr double kLeastSine = 1e-12;
// The sine of the angle to an axis below which a cross product with it has no digits left.
inline constexpr double kAlongAxis = 1e-9;
// How far behind a face that does not count the search for a wall's other side goes on.
inline constexpr double kPastFace = 1e-9;

// Knots nearer than this share of their range are one knot written badly.
inline constexpr double kKnotSpan = 1e-12;
// A point is on the axis below this share of the largest radius.
inline constexpr double kOnAxis = 1e-12;
// What volumes and areas of NURBS solids are integrated to, relative: the library's default is 1 % off on rational
// surfaces. A written solid holds the volume that was meant to this share.
inline constexpr double kQuadrature = 1e-9;
inline constexpr double kWrittenVolume = 1e-6;

// A direction of a file is of length one to this, once scaled: else it has none.
inline constexpr double kUnitLength = 1e-9;
// A robot has reached a point at this share of its reach.
inline constexpr double kReached = 1e-9;
// Nearer to a joint's axis a point tells nothing of a turn (mm); a joint stands still below what any pointer resolves
// (rad, mm).
inline constexpr double kLeastLever = 0.01;
inline constexpr double kStillJoint = 1e-7;
// The sine of the angle below which a pointer's ray runs along an axis.
inline constexpr double kParallelLines = 1e-3;

}  // namespace handwheel::tolerance
