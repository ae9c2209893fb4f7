// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/measure/MeshFidelity.h"

#include "base/Translatable.h"
#include "mesh/structure/MeshDelta.h"

#include <algorithm>
#include <iterator>

namespace handwheel {
namespace {

constexpr FillMethod kMethods[] = {FillMethod::Ear,  FillMethod::Minimal,  FillMethod::Refined, FillMethod::Fair,
                                   FillMethod::Area, FillMethod::Dihedral, FillMethod::Crease,  FillMethod::Flat};

}  // namespace

FidelitySetting nearWeldSetting() {
  FidelitySetting s;
  s.id = "mesh.near_weld";
  s.label = translatable("Fidelity", "Distance below which boundary vertices are merged");
  s.unit = translatable("Fidelity", "share of the diagonal");
  s.scale = FidelityScale::Logarithmic;
  s.least = 1e-8;
  s.largest = 1e-2;
  s.standard = RepairOptions().nearWeld;
  s.presets = {1e-5, 1e-5, 1e-5};
  s.error = {translatable("Fidelity", "boundary vertices left unmerged or merged wrongly"), "%"};
  s.cost = {translatable("Fidelity", "CPU time to merge the boundary vertices"), "ms"};
  s.budget = FidelityBudget::Wait;
  return s;
}

FidelitySetting fillMethodSetting() {
  FidelitySetting s;
  s.id = "mesh.fill_method";
  s.label = translatable("Fidelity", "Method that fills holes");
  setChoices(s,
             {translatable("Fidelity", "ear"), translatable("Fidelity", "minimal"), translatable("Fidelity", "refined"),
              translatable("Fidelity", "fair"), translatable("Fidelity", "area"), translatable("Fidelity", "dihedral"),
              translatable("Fidelity", "ridge"), translatable("Fidelity", "flat")});  // in the order of kMethods
  s.standard = 3.0;
  s.presets = {3.0, 3.0, 3.0};
  s.error = {translatable("Fidelity", "RMS distance of the patch from the surface"),
             translatable("Fidelity", "% of the hole")};
  s.cost = {translatable("Fidelity", "CPU time of a fill"), "ms"};
  s.budget = FidelityBudget::Fill;
  return s;
}

FidelitySetting fillContinuitySetting() {
  FidelitySetting s;
  s.id = "mesh.fill_continuity";
  s.label = translatable("Fidelity", "Continuity of fair patches with their surroundings");
  setChoices(s, {translatable("Fidelity", "position"), translatable("Fidelity", "tangent"),
                 translatable("Fidelity", "curvature")});  // in the order of Continuity
  s.standard = static_cast<double>(FillOptions().continuity);
  s.presets = {1.0, 1.0, 2.0};
  s.error = {translatable("Fidelity", "RMS distance of the patch from the surface"),
             translatable("Fidelity", "% of the hole")};
  s.cost = {translatable("Fidelity", "CPU time of a fill"), "ms"};
  s.budget = FidelityBudget::Fill;
  return s;
}

FidelitySetting patchDensitySetting() {
  FidelitySetting s;
  s.id = "mesh.patch_density";
  s.label = translatable("Fidelity", "Density of patches, relative to their surroundings");
  s.scale = FidelityScale::Logarithmic;
  s.least = 0.35;
  s.largest = 2.0;  // beyond, larger patches are at the limit of their vertices
  s.standard = FillOptions().density;
  s.presets = {0.54, 0.84, s.standard};
  s.error = {translatable("Fidelity", "RMS distance of the patch from the surface"),
             translatable("Fidelity", "% of the hole")};
  s.cost = {translatable("Fidelity", "CPU time of a fill"), "ms"};
  s.budget = FidelityBudget::Fill;
  return s;
}

FidelitySetting pieceEdgesSetting() {
  FidelitySetting s;
  s.id = "mesh.piece_edges";
  s.label = translatable("Fidelity", "Edges of a hole that is filled in one piece");
  s.scale = FidelityScale::Logarithmic;
  s.least = 20.0;
  s.largest = 4000.0;
  s.whole = true;
  s.standard = static_cast<double>(FillOptions().pieceEdges);
  s.presets = {s.standard, s.standard, s.standard};
  s.error = {translatable("Fidelity", "RMS distance of the patch from the surface"),
             translatable("Fidelity", "% of the hole")};
  s.cost = {translatable("Fidelity", "CPU time of a fill"), "ms"};
  s.budget = FidelityBudget::Fill;
  return s;
}

FidelitySetting decimationErrorSetting() {
  FidelitySetting s;
  s.id = "mesh.decimation_error";
  s.label = translatable("Fidelity", "Largest distance from the original when triangles are reduced");
  s.unit = translatable("Fidelity", "share of the diagonal");
  s.scale = FidelityScale::Logarithmic;
  s.least = 1e-4;
  s.largest = 1e-2;
  s.standard = 1e-3;  // hardly seen
  s.presets = {0.01, 0.0022, 1e-4};
  s.error = {translatable("Fidelity", "largest distance from the mesh, in diagonals"), "%"};
  s.cost = {translatable("Fidelity", "remaining triangles"), "%"};
  return s;
}

FidelitySetting undoGranularitySetting() {
  FidelitySetting s;
  s.id = "document.undo_granularity";
  s.label = translatable("Fidelity", "Vertices or triangles in a block of an undo step");
  s.scale = FidelityScale::Logarithmic;
  s.least = 1.0;
  s.largest = 4096.0;
  s.whole = true;
  s.standard = static_cast<double>(MeshDelta::kRunSlots);
  s.presets = {4.0, 2.0, 1.0};
  s.error = {translatable("Fidelity", "memory of an undo step"), "MB"};
  s.cost = {translatable("Fidelity", "CPU time to take, undo and redo a step"), "ms"};
  s.budget = FidelityBudget::Frame;
  return s;
}

FillMethod fillMethodOf(const FidelityValues& values) {
  return kMethods[static_cast<std::size_t>(values.of(fillMethodSetting()))];
}

void setMethod(FidelityValues& values, FillMethod method) {
  const auto at = std::find(std::begin(kMethods), std::end(kMethods), method) - std::begin(kMethods);
  (void)values.set(fillMethodSetting(), static_cast<double>(at));
}

Continuity fillContinuityOf(const FidelityValues& values) {
  return static_cast<Continuity>(values.of(fillContinuitySetting()));
}

void apply(const FidelityValues& values, FillOptions& options) {
  options.method = fillMethodOf(values);
  options.continuity = fillContinuityOf(values);
  options.density = values.of(patchDensitySetting());
  options.pieceEdges = static_cast<std::size_t>(values.of(pieceEdgesSetting()));
}

void apply(const FidelityValues& values, RepairOptions& options) {
  apply(values, options.fill);
  options.nearWeld = values.of(nearWeldSetting());
}

}  // namespace handwheel
