// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/VolumeFidelity.h"

#include "base/Translatable.h"
#include "volume/repair/VolumeRepair.h"

#include <array>
#include <limits>

namespace handwheel {
namespace {

constexpr std::array kErosions{1.0, 2.0, 4.0, 8.0, std::numeric_limits<double>::infinity()};

}  // namespace

FidelitySetting volumeVoxelsSetting() {
  FidelitySetting s;
  s.id = "volume.voxels";
  s.label = translatable("Fidelity", "Voxels along the largest extent of a part");
  s.scale = FidelityScale::Logarithmic;
  s.least = 32.0;
  s.largest = 512.0;
  s.whole = true;
  s.standard = kUsualVoxels;
  s.presets = {32.0, 200.0, 512.0};
  s.error = {translatable("Fidelity", "largest distance of the surface from the part, in extents"), "%"};
  s.cost = {translatable("Fidelity", "CPU time to make the volume and its surface"), "ms"};
  return s;
}

FidelitySetting volumeMethodSetting() {
  FidelitySetting s;
  s.id = "volume.method";
  s.label = translatable("Fidelity", "How voxels are sampled");
  setChoices(s,
             {translatable("Fidelity", "sign"), translatable("Fidelity", "density")});  // in the order of VoxelMethod
  s.presets = {0.0, 0.0, 0.0};
  s.error = {translatable("Fidelity", "largest distance of the surface from the part, in voxels"), "%"};
  s.cost = {translatable("Fidelity", "CPU time to make the volume"), "ms"};
  return s;
}

FidelitySetting volumeReductionSetting() {
  FidelitySetting s;
  s.id = "volume.reduction";
  s.label = translatable("Fidelity", "Voxels that a repair by volume may move the surface by to save triangles");
  s.scale = FidelityScale::Logarithmic;
  s.least = 0.05;
  s.largest = 2.0;
  s.standard = VolumeRepairOptions().within;
  s.presets = {1.0, 1.0, 1.0};
  s.error = {translatable("Fidelity", "largest distance of the surface from the part, in voxels"), "%"};
  s.cost = {translatable("Fidelity", "remaining triangles"), "%"};
  return s;
}

FidelitySetting volumePolygonsSetting() {
  FidelitySetting s;
  s.id = "volume.polygons";
  s.label = translatable("Fidelity", "How a volume becomes triangles");
  setChoices(s, {translatable("Fidelity", "marching"), translatable("Fidelity", "dual")});
  s.presets = {0.0, 0.0, 1.0};
  s.error = {translatable("Fidelity", "RMS distance of edges from the surface, in voxels"), "%"};
  s.cost = {translatable("Fidelity", "CPU time to make the triangles"), "ms"};
  return s;
}

FidelitySetting volumePiecesSetting() {
  FidelitySetting s;
  s.id = "volume.pieces";
  s.label = translatable("Fidelity", "Cells of a volume along a piece of its display");
  setChoices(s, {"16", "32", "64", "128"});
  s.standard = 2.0;
  s.presets = {1.0, 2.0, 3.0};
  s.error = {translatable("Fidelity", "draw calls of a frame"), translatable("Fidelity", "calls")};
  s.cost = {translatable("Fidelity", "CPU time to renew the pieces that a touch of clay changes"), "ms"};
  return s;
}

FidelitySetting drillErosionSetting() {
  FidelitySetting s;
  s.id = "drill.erosion";
  s.label = translatable("Fidelity", "What a voxel loses to a drill in a cycle, in lengths of its way");
  setChoices(s, {"1", "2", "4", "8", translatable("Fidelity", "all")});
  s.standard = kErosions.size() - 1.0;
  s.presets = {4.0, 4.0, 4.0};
  s.error = {translatable("Fidelity", "RMS error of the thrust"), "%"};
  s.cost = {translatable("Fidelity", "CPU time of a cycle"), "us"};
  return s;
}

VoxelMethod voxelMethodOf(const FidelityValues& values) {
  return static_cast<VoxelMethod>(values.of(volumeMethodSetting()));
}

int pieceCellsOf(double value) {
  return 16 << static_cast<int>(value);
}

double erosionOf(double value) {
  return kErosions.at(static_cast<std::size_t>(value));
}

}  // namespace handwheel
