// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/voxels/MeshDrillTool.h"

#include "document/mesh/MeshDocument.h"
#include "mesh/search/SmoothNormal.h"
#include "mesh/selection/ClippedMesh.h"
#include "mesh/structure/Weld.h"
#include "proximity/SelfIntersection.h"
#include "tools/mesh/MeshPreview.h"
#include "volume/VolumeErrors.h"

#include <QtGlobal>
#include <algorithm>
#include <utility>

namespace handwheel {
namespace {

constexpr double kUsualAcross = 16.0;       // voxels to a diameter: volumes of holes are right within 1 %
constexpr double kUsualAcrossSaw = 4.0;     // to the width of a saw
constexpr double kFewestAcross = 6.0;       // to a diameter,
constexpr double kFewestAcrossSaw = 2.0;    // and to that width
constexpr double kMostAcrossDrill = 200.0;  // to a diameter: more are too slow for the hand

bool isSaw(const DrillBit& head) {
  return head.shape == DrillShape::Saw;
}

double usualVoxelFor(const DrillBit& head) {
  const double voxel = head.diameter / kUsualAcross;
  return isSaw(head) ? std::min(voxel, head.width / kUsualAcrossSaw) : voxel;
}

Limits voxelLimits(const DrillBit& head) {
  const double least = head.diameter / kMostAcrossDrill, largest = head.diameter / kFewestAcross;
  if (!isSaw(head)) return {least, largest};
  const double ofWidth = std::min(largest, head.width / kFewestAcrossSaw);
  return {std::min(least, ofWidth), ofWidth};
}

// Returns the reason against drilling a mesh, by the defects known at once; null: none.
const char* refusalByDefects(const MeshDocument& document) {
  const Defects& defects = document.defects();
  if (document.mesh().liveFaceCount() == 0) return QT_TRANSLATE_NOOP("Tool", "there are no triangles");
  if (!defects.loops.empty())
    return QT_TRANSLATE_NOOP("Tool", "the mesh has holes, so it has no inside: close them first");
  if (!defects.nonManifoldEdges.empty() || !defects.nonManifoldVertices.empty() || !defects.nonOrientableEdges.empty())
    return QT_TRANSLATE_NOOP("Tool", "the mesh is not manifold: repair it first");
  if (!defects.insideOut.empty()) return QT_TRANSLATE_NOOP("Tool", "a body is inside out: turn it over first");
  return nullptr;
}

const char* refusalByVoxels(const Error& error) {
  if (error.code == VolumeErrors::TooFine)
    return QT_TRANSLATE_NOOP("Tool", "the voxels are too small for a part of this size");
  if (error.code == VolumeErrors::NothingInside) return QT_TRANSLATE_NOOP("Tool", "the surface encloses nothing");
  return QT_TRANSLATE_NOOP("Tool", "there are coordinates that are not numbers");
}

const char* const kUncertain =
    QT_TRANSLATE_NOOP("Tool",
                      "bodies overlap here, or a wall is thinner than a voxel: near the drill alone this cannot "
                      "be drilled");

}  // namespace

MeshDrillTool::MeshDrillTool(MeshDocument& document, MeshServices services, const SimulationServices& simulation,
                             OfferVolume offer)
    : HandDrill(DrillSettings(0.0)),
      m_document(document),
      m_services(std::move(services)),
      m_offer(std::move(offer)),
      m_voxel(usualVoxelFor(drillSettings().head())) {
  begin(simulation);
  prepare();
}

// Worker thread.
MeshDrillTool::Prepared MeshDrillTool::prepared(const HalfEdgeMesh& mesh, double voxel, NumberType numbers,
                                                Progress progress) {
  Prepared made;
  const TriangleSoup soup = mesh.compact().soup;
  TriangleSoup stored = soup;
  roundPoints(stored, numbers);
  stored = weld(stored);
  const auto crossing = selfIntersections(stored.points, stored.triangles, progress.part(0.0, 0.4), 1);
  if (crossing && !crossing->empty())
    made.refusal = QT_TRANSLATE_NOOP("Tool", "triangles of the mesh intersect one another: resolve that first");
  if (!crossing || made.refusal) return made;
  Result<HybridPart> part = HybridPart::of(soup, voxel, progress.part(0.4, 0.8));
  if (!part && part.error().code != ErrorCode::Cancelled) made.refusal = refusalByVoxels(part.error());
  if (!part || progress.cancelled()) return made;
  if (!part->isExact()) made.refusal = kUncertain;
  made.part = std::make_shared<const HybridPart>(std::move(*part));
  made.faces = std::make_shared<const FaceHierarchy>(mesh);
  return made;
}

// Once for each change of the mesh or of the voxel.
void MeshDrillTool::prepare() {
  m_prepared = {};
  m_hiddenTiles.clear();
  m_hidden.reset();
  m_job.reset();
  m_services.cancel();
  m_prepared.refusal = refusalByDefects(m_document);
  restart();
  if (m_prepared.refusal) return;
  m_job = std::make_shared<const int>();
  m_services.run({QT_TRANSLATE_NOOP("Tool", "Preparing to drill"),
                  [this, mesh = m_document.mesh(), voxel = m_voxel, numbers = m_document.fileNumbers(),
                   job = std::weak_ptr(m_job)](const Progress& progress) {
                    Prepared made = prepared(mesh, voxel, numbers, progress);
                    return std::function<void()>([this, made = std::move(made), job] {
                      if (job.expired()) return;
                      m_job.reset();
                      m_prepared = made;
                      restart();
                      reportUpdated();
                    });
                  }});
}

std::optional<HandDrill::SurfaceHit> MeshDrillTool::hitAt(const Ray& ray) const {
  const auto hit = m_prepared.faces ? m_prepared.faces->firstHit(ray) : std::nullopt;
  if (!hit) return std::nullopt;
  const Vec3 normal = smoothNormal(m_prepared.faces->mesh(), hit->face, hit->point);
  if (!(normal.norm() > 0.5)) return std::nullopt;
  return SurfaceHit{hit->point, normal};
}

bool MeshDrillTool::isMaterialAlong(const Vec3& from, const Vec3& displacement) const {
  const auto hit = m_prepared.faces ? m_prepared.faces->firstHit({from, displacement}) : std::nullopt;
  return hit && hit->distance < 1.0;
}

// Returns an empty simulation if nothing can be drilled.
std::unique_ptr<DrillSimulation> MeshDrillTool::simulation(const std::optional<DrillFeed>& feed) const {
  if (obstacle()) return std::make_unique<DrillSimulation>(std::make_shared<ClayState>(), setup(), feed, channel());
  return std::make_unique<DrillSimulation>(*m_prepared.part, setup(), feed, channel());
}

const char* MeshDrillTool::obstacle() const {
  if (m_prepared.refusal) return m_prepared.refusal;
  if (m_pending) return QT_TRANSLATE_NOOP("Tool", "the hole is being taken from the triangles");
  return m_prepared.part ? nullptr : QT_TRANSLATE_NOOP("Tool", "the mesh is being prepared for the drill");
}

void MeshDrillTool::refuse() {
  if (m_prepared.refusal) m_offer(m_prepared.refusal);
}

bool MeshDrillTool::isDue() const {
  return isLive() && !state()->isExact;
}

ToolReply MeshDrillTool::resume() {
  restart();
  m_offer(kUncertain);
  return ToolReply::Used;
}

// One that goes on along the hole before is drilled with it, in the mesh that had neither.
DrilledMeshHole MeshDrillTool::holeOf(const DrillSimulation& drilled, std::shared_ptr<const DrillRecord> record) const {
  const HalfEdgeMesh& mesh = m_document.mesh();
  if (m_record && isContinued() && m_origin.part->left().voxel() == m_prepared.part->left().voxel())
    if (auto joined = joinedRecord(*m_record, *record))
      return {mesh, m_origin.mesh, m_origin.part, nullptr, std::move(joined)};
  return {mesh, mesh, m_prepared.part, std::make_shared<const HybridPart>(*drilled.part()), std::move(record)};
}

void MeshDrillTool::take(const DrillSimulation& drilled, std::shared_ptr<const DrillRecord> record) {
  if (!drilled.part() || !drilled.part()->isExact()) {
    forgetHole();
    resume();
    return;
  }
  const auto outcome = std::make_shared<DrilledMeshHoleOutcome>();
  DrilledMeshHole made = holeOf(drilled, std::move(record));
  m_pending = Pending{hole(), made.record, outcome, {made.origin, made.uncut}};
  MeshChange change = drillChange(std::move(made), m_document.fileNumbers(), outcome);
  change.ended = [this, alive = std::weak_ptr(m_alive), outcome] {
    if (!alive.expired()) ended(*outcome);
  };
  restart();
  m_services.commit(std::move(change));
}

// If the hole is in the triangles, documentChanged() has been called before.
void MeshDrillTool::ended(const DrilledMeshHoleOutcome& outcome) {
  if (!m_pending) return;
  m_pending.reset();
  forgetHole();
  restart();
  if (const char* const reason = outcome.reason) m_offer(reason);
  reportUpdated();
}

// A hole that is undone is no longer shown.
void MeshDrillTool::documentChanged() {
  if (m_pending && m_pending->outcome->isMade) {
    m_record = m_pending->record;
    m_origin = m_pending->origin;
    m_pending.reset();
  } else {
    m_record.reset();
    m_origin = {};
    forgetHole();
  }
  prepare();
}

ToolPreview MeshDrillTool::preview() const {
  ToolPreview preview = HandDrill::preview();
  if (m_pending) preview.ofKind = previewOf(m_pending->state);
  return preview;
}

std::shared_ptr<const KindPreview> MeshDrillTool::previewOf(const std::shared_ptr<const DrillState>& state) const {
  auto shown = std::make_shared<MeshPreview>();
  if (state->tiles.empty() || !m_prepared.faces) return shown;
  if (m_hiddenTiles != state->tiles) {
    std::vector<Box> boxes;
    for (const VolumeSurface::Key& tile : state->tiles) boxes.push_back(boxOfTile(*state, tile));
    m_hiddenTiles = state->tiles;
    m_hidden = std::make_shared<const PreviewMesh>(clippedMesh(*m_prepared.faces, boxes));
  }
  shown->previewMesh = m_hidden;
  shown->voxels = state;
  return shown;
}

std::vector<Property> MeshDrillTool::settings() const {
  std::vector<Property> all = HandDrill::settings();
  const auto material =
      std::find_if(all.begin(), all.end(), [](const Property& property) { return property.id == "material"; });
  all.insert(material, numberSetting("voxel", QT_TRANSLATE_NOOP("Property", "Voxel"), m_voxel, Quantity::Length,
                                     voxelLimits(drillSettings().head())));
  return all;
}

void MeshDrillTool::setSetting(std::string_view id, const PropertyValue& value) {
  const double before = m_voxel;
  const bool isOfHead = id == "head" || id == "diameter" || id == "width";
  if ((isOfHead || id == "voxel") && (isLive() || m_pending)) return;  // they are those of the hole
  HandDrill::setSetting(id, value);
  if (isOfHead) m_voxel = usualVoxelFor(drillSettings().head());
  if (id == "voxel") assignNumber(m_voxel, value, voxelLimits(drillSettings().head()));
  if (m_voxel != before) prepare();
}

}  // namespace handwheel
