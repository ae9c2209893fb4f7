// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/search/FaceHierarchy.h"
#include "mesh/selection/PreviewMesh.h"
#include "tools/carving/HandDrill.h"
#include "tools/mesh/MeshServices.h"
#include "tools/mesh/voxels/MeshDrillChange.h"

namespace handwheel {

class MeshDocument;

// Tool that drills a mesh by hand. Voxels are created near the drill as it moves, and at the end of a gesture a job
// removes the hole from the triangles in one step. The mesh must be closed, manifold and without self-intersections.
// For other meshes, and if the voxels near the drill cannot be determined reliably, the tool shows the reason and
// offers to make a volume.
class MeshDrillTool : public HandDrill {
 public:
  // The function that is called when the user tries to drill a mesh that cannot be drilled. reason: English text,
  // translated in the context "Tool".
  using OfferVolume = std::function<void(const char* reason)>;

  // Only the destructor may be called after the document has been destroyed.
  MeshDrillTool(
      MeshDocument& document, MeshServices services, const SimulationServices& simulation,
      OfferVolume offer = [](const char*) {});

  bool isDue() const override;
  ToolReply resume() override;
  ToolPreview preview() const override;
  std::vector<Property> settings() const override;
  void setSetting(std::string_view id, const PropertyValue& value) override;
  void documentChanged() override;

 private:
  // The result of the job that prepares the mesh for the present voxel size.
  struct Prepared {
    std::shared_ptr<const HybridPart> part;      // null: the mesh cannot be drilled
    std::shared_ptr<const FaceHierarchy> faces;  // null if `part` is null
    const char* refusal =
        nullptr;  // the reason why the mesh cannot be drilled; English text, translated in the context "Tool"
  };
  // The state in which drilling a hole began.
  struct Origin {
    HalfEdgeMesh mesh;
    std::shared_ptr<const HybridPart> part;  // the part before the hole is cut
  };
  // A hole that is being removed from the triangles.
  struct Pending {
    std::shared_ptr<const DrillState> state;
    std::shared_ptr<const DrillRecord> record;
    std::shared_ptr<DrilledMeshHoleOutcome> outcome;
    Origin origin;
  };

  static Prepared prepared(const HalfEdgeMesh& mesh, double voxel, NumberType numbers, Progress progress);
  void prepare();
  DrilledMeshHole holeOf(const DrillSimulation& drilled, std::shared_ptr<const DrillRecord> record) const;
  void ended(const DrilledMeshHoleOutcome& outcome);

  double voxelOfPart() const override { return 0.0; }
  std::optional<SurfaceHit> hitAt(const Ray& ray) const override;
  bool isMaterialAlong(const Vec3& from, const Vec3& displacement) const override;
  double slack() const override { return 2.0 * m_voxel; }
  const DrillRecord* holeBefore() const override { return m_record.get(); }
  std::unique_ptr<DrillSimulation> simulation(const std::optional<DrillFeed>& feed) const override;
  std::shared_ptr<const KindPreview> previewOf(const std::shared_ptr<const DrillState>& state) const override;
  const char* obstacle() const override;
  void refuse() override;
  void take(const DrillSimulation& drilled, std::shared_ptr<const DrillRecord> record) override;

  MeshDocument& m_document;
  MeshServices m_services;
  OfferVolume m_offer;
  double m_voxel;                               // mm
  Prepared m_prepared;                          // prepared data of the present mesh; empty while a job computes it
  std::shared_ptr<const int> m_job;             // identifies the running job; null: no job is running
  std::optional<Pending> m_pending;             // the hole that is being removed; none after the change has ended
  std::shared_ptr<const DrillRecord> m_record;  // record of the hole drilled last, while the hole exists; null: none
  Origin m_origin;                              // origin of the hole drilled last
  std::shared_ptr<const int> m_alive = std::make_shared<const int>();
  // The mesh without the faces that the tiles hide, cached for the tiles of the last request.
  mutable std::vector<VolumeSurface::Key> m_hiddenTiles;
  mutable std::shared_ptr<const PreviewMesh> m_hidden;
};

}  // namespace handwheel
