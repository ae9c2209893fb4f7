// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace handwheel::tolerance {

// The tolerances of the program: what counts as equal, flat, parallel or near. A bound that guards a single formula
// against its own rounding is defined beside that formula. Lengths are shares of the model's bounding-box diagonal
// unless the name indicates otherwise.

// A shell is an open sheet if its area vector (the sum of its faces' areas times normals) exceeds this share of its
// area. Flat ones have 1, half a sphere 0.5, a cube without a side 0.2; of 70 scans, sheets 0.5 and more, bodies up to
// 0.43.
inline constexpr double kSheetAreaVector = 0.45;
// A part whose volume is less than this share of its area to the power 3/2 is thin (a sphere has 0.094, a half one
// 0.13).
inline constexpr double kSheetVolume = 0.06;
// A part whose longest boundary loop, squared, exceeds this many times its area is an open sheet: eight times the
// outline of a flat disc, as for the frayed edge of a single-view scan. (A toothed hole in a box has 81; such a scan
// 125.)
inline constexpr double kRaggedOutline = 100.0;
// A part with less than these shares of the largest part's area and faces is debris.
inline constexpr double kDebrisArea = 0.01;
inline constexpr double kDebrisFaces = 0.01;
// A face attached to a non-manifold edge is removed as a flap when no edge of it is longer than this.
inline constexpr double kFlap = 0.01;
// Vertices on open borders nearer than this count as one vertex, separated by the rounding of the file; a repair merges
// them. The default of the fidelity setting mesh.near_weld.
inline constexpr double kNearWeld = 1e-5;
// They are not merged across more than this share of the longer border edge at either: that would be detail.
inline constexpr double kNearWeldEdge = 0.25;
// A patch may leave the box of its loop by this share of that box's diagonal.
inline constexpr double kPatchSwelling = 0.5;
// A patch may leave the model's box by this share of the model's diagonal, or by the height of a cap that continues the
// surroundings times the slack. Surroundings whose normals have a smaller mean cosine to the loop's are too steep for a
// cap.
inline constexpr double kModelSwelling = 0.01;
inline constexpr double kCapSlack = 1.5;
inline constexpr double kCapCosine = 0.4;
// CGAL's cubic hole triangulation is allowed up to this many edges; beyond, it freezes (90 s at 2554).
inline constexpr int kCubicFillEdges = 300;
// A loop of more edges is cut into pieces of at most this many before it is triangulated: 2,554 edges then take 60 ms,
// and a part filled in one piece has better triangles. The default of the fidelity setting mesh.piece_edges.
inline constexpr int kPieceEdges = 1000;
// The optimal triangulation by a criterion of this program, O(n³), is computed for up to this many edges; pieces of
// longer loops have half as many, which keeps 2,554 edges below 0.1 s.
inline constexpr int kOptimalFillEdges = 300;
// From here on a patch is reported as unlike its surroundings: radian beyond their largest bend, and share of the
// hole's size beyond the range of their heights. Over a cap of a sphere neither is reached.
inline constexpr double kNoticeableBend = 0.5;
inline constexpr double kNoticeableRise = 0.35;
// CGAL's hole triangulation recurses once per edge at worst: 40,000 overflow a stack of 2 MB, 100,000 one of 8 MB.
inline constexpr int kLibraryFillEdges = 20'000;
// CGAL builds a vertex with n faces in O(n²): 0.2 s for 5,000, 3 s for 20,000.
inline constexpr int kLibraryFanFaces = 5'000;
// Density to which a patch is refined: edges longer than 1 / this of those around the hole are split. √2 splits to
// about their length. The default of the fidelity setting mesh.patch_density.
inline constexpr double kPatchDensity = 1.4142135623730951;
// A crease whose sides meet at more than this angle (radian; 30°) and that ends at a hole is continued through it.
inline constexpr double kCreaseAngle = 0.52;
// Limits on the new vertices of a patch, per boundary edge and in all. If the density of the surroundings requires
// more, the patch is coarser. 10,000 take 0.15 s to refine and fair, which cannot be interrupted.
inline constexpr int kPatchVerticesPerEdge = 20;
inline constexpr int kPatchVertices = 10'000;
// Winding numbers this close to an integer count as that integer: holes elsewhere in a surface change them by their
// solid angle, and a value half way between two integers is undecided.
inline constexpr double kWindingDoubt = 0.25;
// The thickness of a sheet after thickenSheets().
inline constexpr double kSheetThickness = 1e-3;
// The thickness of a flake that nobody asked to thicken is at most this share of its shortest edge.
inline constexpr double kSheetOffsetEdge = 0.25;
// Clusters of more connected self-intersections than this are not removed: it would take minutes.
inline constexpr std::size_t kMaxSelfIntersectionPairs = 50'000;
inline constexpr std::size_t kCutsPerFace = 200;
// Coordinates that need more bits than this, from the largest number to the last digit of the smallest, are not those
// of a part: a double has 53, metres with noise of 1e-17 in the zeros some 120. The time of exact arithmetic grows with
// the square.
inline constexpr int kCutBits = 512;
// Filling the holes of a mesh of n faces takes at most this times n log2 n steps (Effort), of a microsecond each, or
// the least below, which small folded meshes may need; and closing obstructed holes by cutting at most as many again.
inline constexpr double kRepairBudget = 1'000.0;
inline constexpr std::size_t kLeastRepairBudget = 2'000'000;
// Trials take at most this share of that, and at most some 20 s beside the passes over the mesh.
inline constexpr double kObstructedHoleShare = 0.5;
inline constexpr std::size_t kObstructedHoleBudget = 20'000'000;
// Replacing folded regions takes at most this share of that, and at most some 10 s beside the passes; separating
// coincident vertices takes the rest.
inline constexpr double kFoldedRegionShare = 0.25;
inline constexpr std::size_t kFoldedRegionBudget = 10'000'000;
inline constexpr double kSeparationShare = 0.25;
// Steps per face that passes over the whole mesh may take beside the fixed numbers above. A pass takes about one,
// thickening a sound sheet some five, and a trial may take a quarter of what is left.
inline constexpr std::size_t kPassBudget = 40;
// A folded region around a hole is removed and refilled where that moves the surface by at most this share of the
// diagonal: more would change the shape of the part.
inline constexpr double kFoldedRegionMove = 0.01;
// The same limit for a body that is removed as a whole.
inline constexpr double kFoldedRegionBodyMove = 1e-3;
// Material that a repair removed is reported if it stood out by more than this share of the diagonal.
inline constexpr double kRemovedPart = 0.01;
// A non-orientable surface is made orientable by cuts no longer than this share of the diagonal. Longer cuts change the
// shape, and are made on demand only.
inline constexpr double kOneSidedCut = 0.01;
// A polygon of a file is planar when no corner is further from its plane than this share of its size: beyond, the right
// triangulation depends on more than the outline, and a fan is expected.
inline constexpr double kPlanarPolygon = 1e-3;

// Faces that meet at no more than this angle (radian; 1°) count as coplanar in edge detection: files in single
// precision rotate them by less, and the sides of a finely tessellated cylinder meet at more.
inline constexpr double kFlatEdge = 0.0175;

// Points this near to a plane lie in it when a face is searched on which a part can rest. A hundred times the rounding
// of single precision, and so little that a smooth ball, whose cap of this height has at most sqrt(3) times this share
// of the area, has no flat face.
inline constexpr double kFlatBaseFlatness = 1e-5;
// A flat face has at least this share of the part's area. Less is a facet of a curved surface rather than a base.
inline constexpr double kFlatBaseShare = 1e-3;
// Neighbours in one plane have normals with at least this cosine between them (0.08°): single precision rotates faces
// of a thousandth of the part by less.
inline constexpr double kFlatCosine = 1.0 - 1e-6;

// The distance of a haptic proxy from the surface that it touches: far above the effect of rounding, far below what is
// visible.
inline constexpr double kContactSkin = 0x1p-27;
// The width up to which gaps are closed before a scan is used for haptic contact.
inline constexpr double kContactGap = 0x1p-12;
// Corners across a gap are merged when it is narrower than this share of the open edges at them. A strip would form a
// step there: the borders are rarely equally high, and a proxy stops at a step of a micrometre.
inline constexpr double kContactGapEdge = 0.25;
// The distance within which the surface is searched after an edit that may have buried a haptic proxy.
inline constexpr double kContactBuried = 0.01;
// Two contact planes count as one below this sine of their angle, squared.
inline constexpr double kOnePlane = 1e-14;
// A third contact plane is redundant if the volume that the three normals span, squared, is below this.
inline constexpr double kSpannedVolume = 1e-18;

// Height over longest side from which a face counts as a needle, unless it was nearly one before.
inline constexpr double kNeedle = 1e-4;
// A triangle with a smaller sine at a corner may be degenerate, and is tested exactly.
inline constexpr double kLeastSine = 1e-12;
// The sine of the angle to an axis below which a cross product with it has no significant digits.
inline constexpr double kAlongAxis = 1e-9;
// The step behind an ignored face at which the search for the opposite wall continues.
inline constexpr double kPastFace = 1e-9;

// Knots that differ by less than this share of their range are one, written inexactly: such a curve is refused.
inline constexpr double kKnotSpan = 1e-12;
// A point is on the axis below this share of the largest radius.
inline constexpr double kOnAxis = 1e-12;
// The relative accuracy of integrated volumes and areas of NURBS solids: the library's default is 1 % off on rational
// surfaces, and its estimate of its own error is too small where weights differ much (4e-6 at 1e-9, 5e-7 at 1e-11). The
// volume of a written solid agrees with the intended one to the second of these shares.
inline constexpr double kQuadrature = 1e-11;
inline constexpr double kWrittenVolume = 1e-6;

// A direction read from a file is valid if its length is one to this accuracy, once scaled.
inline constexpr double kUnitLength = 1e-9;
// A robot has reached a point at this share of its reach.
inline constexpr double kReached = 1e-9;
// A point nearer to a joint's axis than this does not determine a rotation (mm); a joint is at rest below what any
// pointer resolves (rad, mm).
inline constexpr double kLeastLever = 0.01;
inline constexpr double kStillJoint = 1e-7;
// The sine of the angle below which a pointer's ray is parallel to an axis.
inline constexpr double kParallelLines = 1e-3;

}  // namespace handwheel::tolerance
