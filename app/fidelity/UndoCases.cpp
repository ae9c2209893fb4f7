// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/ThreadClock.h"
#include "fidelity/CaseShapes.h"
#include "fidelity/Cases.h"
#include "fidelity/SeededInput.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshDelta.h"

namespace handwheel {
namespace {

struct EditedMesh {
  HalfEdgeMesh before, after;
};

// A brush moves what lies within a twentieth of the diagonal around a vertex.
EditedMesh brushed(const HalfEdgeMesh& mesh, std::uint64_t seed) {
  Random random(seed);
  EditedMesh edit{mesh, mesh};
  if (mesh.vertexSlots() == 0) return edit;
  Box box;
  for (Vertex v = 0; v < mesh.vertexSlots(); ++v) box.extend(mesh.position(v));
  const double radius = 0.05 * box.diagonal().norm();
  const Vec3 centre = mesh.position(static_cast<Vertex>(random.below(mesh.vertexSlots())));
  for (Vertex v = 0; v < mesh.vertexSlots(); ++v) {
    const Vec3& p = mesh.position(v);
    if ((p - centre).norm() < radius)
      edit.after.setPosition(v, p + 0.01 * (radius - (p - centre).norm()) * Vec3::UnitZ());
  }
  return edit;
}

// A hundred faces go, here and there, as a repair takes degenerate ones.
EditedMesh thinned(const HalfEdgeMesh& mesh, std::uint64_t seed) {
  Random random(seed);
  EditedMesh edit{mesh, mesh};
  for (int i = 0; i < 100 && mesh.faceSlots() > 0; ++i) {
    const auto f = static_cast<Face>(random.below(mesh.faceSlots()));
    if (edit.after.isLive(f)) edit.after.removeFace(f);
  }
  return edit;
}

// Does what happens to a step in the history: it is applied, undone and redone.
FidelitySample keep(const EditedMesh& edit, double runSlots) {
  FidelitySample sample;
  HalfEdgeMesh mesh = edit.after;
  MeshDelta delta;
  sample.cost = cpuMilliseconds([&] {
    delta = MeshDelta::between(edit.after, edit.before, static_cast<std::size_t>(runSlots));
    delta.swap(mesh);
    delta.swap(mesh);
  });
  sample.error = static_cast<double>(delta.bytes()) * 1e-6;
  return sample;
}

FidelityCase caseOn(const std::string& name, SoupSource soup, EditedMesh (*edit)(const HalfEdgeMesh&, std::uint64_t)) {
  const SeededInput<EditedMesh> input([soup, edit](std::uint64_t seed) { return edit(buildMesh(*soup()).mesh, seed); });
  return {name, "counted", [input](double value, std::uint64_t seed, Progress) { return keep(input(seed), value); }};
}

}  // namespace

std::vector<FidelityCase> undoGranularityCases() {
  const auto torus = torusSource(1000, 250, 100.0, 20.0);
  return {caseOn("torus of 500,000 faces, brush stroke", torus, brushed),
          caseOn("torus of 500,000 faces, 100 removed", torus, thinned)};
}

FidelityCase undoGranularityCaseOn(const std::string& name, SoupSource soup) {
  return caseOn(name + ", brush stroke", std::move(soup), brushed);
}

}  // namespace handwheel
