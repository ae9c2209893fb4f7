// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/ThreadClock.h"
#include "base/Translatable.h"
#include "fidelity/CaseShapes.h"
#include "fidelity/Cases.h"
#include "fidelity/SeededInput.h"
#include "mesh/structure/MeshBuilder.h"
#include "viewport/surface/SurfaceGeometry.h"

#include <set>

namespace handwheel {
namespace {

constexpr int kEdits = 8;  // an edit near the end of a block rebuilds two: averages tell more than one

struct EditedFaces {
  HalfEdgeMesh mesh;
  std::vector<Face> faces;  // each the position of an edit
};

EditedFaces edited(const TriangleSoup& soup, std::uint64_t seed) {
  EditedFaces edit{buildMesh(soup).mesh, {}};
  Random random(seed);
  for (int i = 0; i < kEdits; ++i) {
    const auto f = static_cast<Face>(random.below(edit.mesh.faceSlots()));
    if (edit.mesh.isProper(f)) edit.faces.push_back(f);
  }
  return edit;
}

// The blocks with a face that shares a vertex with this one: its normals change with it.
std::set<std::size_t> touchedBlocks(const HalfEdgeMesh& mesh, Face face, Face blockFaces) {
  std::set<std::size_t> blocks;
  for (HalfEdge h = 3 * face; h < 3 * face + 3; ++h) {
    for (HalfEdge g : mesh.fan(h)) blocks.insert(HalfEdgeMesh::face(g) / blockFaces);
  }
  return blocks;
}

FidelitySample rebuild(const EditedFaces& edit, double value) {
  const auto blockFaces = static_cast<Face>(value);
  FidelitySample sample;
  sample.error = static_cast<double>(blockCount(edit.mesh, blockFaces));
  for (Face f : edit.faces) {
    const std::set<std::size_t> blocks = touchedBlocks(edit.mesh, f, blockFaces);
    sample.cost += cpuMilliseconds([&] {
      for (std::size_t b : blocks) blockGeometry(edit.mesh, b, Vec3::Zero(), blockFaces);
    });
  }
  if (!edit.faces.empty()) sample.cost /= static_cast<double>(edit.faces.size());
  return sample;
}

}  // namespace

FidelitySetting blockFacesSetting() {
  FidelitySetting s;
  s.id = "view.block_faces";
  s.label = translatable("Fidelity", "Triangles in a block of the display");
  s.scale = FidelityScale::Logarithmic;
  s.least = 4096.0;
  s.largest = 262144.0;
  s.whole = true;
  s.standard = kBlockFaces;
  s.presets = {5800.0, 46000.0, 262144.0};
  s.error = {translatable("Fidelity", "draw calls of a frame"), translatable("Fidelity", "calls")};
  s.cost = {translatable("Fidelity", "CPU time to rebuild the blocks that an edit of one triangle affects"), "ms"};
  s.budget = FidelityBudget::Frame;
  return s;
}

FidelityCase blockFacesCaseOn(const std::string& name, SoupSource soup) {
  const SeededInput<EditedFaces> input([soup](std::uint64_t seed) { return edited(*soup(), seed); });
  return {name, "counted", [input](double value, std::uint64_t seed, Progress) { return rebuild(input(seed), value); }};
}

std::vector<FidelityCase> blockFacesCases() {
  return {blockFacesCaseOn("torus of 1,000,000 faces", torusSource(2000, 250, 100.0, 20.0))};
}

}  // namespace handwheel
