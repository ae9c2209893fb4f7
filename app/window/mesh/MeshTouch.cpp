// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/mesh/MeshTouch.h"

#include "haptics/SnapScene.h"
#include "haptics/TouchableSurface.h"
#include "window/FidelityChoice.h"
#include "window/KindUi.h"
#include "window/ToolHost.h"
#include "window/haptics/HapticSession.h"
#include "window/haptics/TouchScene.h"
#include "window/mesh/OpenMesh.h"

namespace handwheel {

namespace {

// More are not brought up to date on the window thread, where they would take longer than a frame.
constexpr std::size_t kMostAtOnce = 10'000;

// The points of the edges around holes, and of the outer ones.
SnapScene boundaryPoints(const HalfEdgeMesh& mesh, const std::vector<BoundaryLoop>& loops, Progress progress) {
  struct Rim {
    std::vector<Vec3> points;
    std::vector<std::uint32_t> vertices;
  };
  std::vector<Rim> kept(loops.size());
  std::vector<SnapRim> rims;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    for (const HalfEdge h : loops[i].halfEdges) {
      kept[i].vertices.push_back(mesh.from(h));
      kept[i].points.push_back(mesh.position(mesh.from(h)));
    }
    rims.push_back({static_cast<std::uint32_t>(i), kept[i].points, kept[i].vertices, loops[i].halfEdges});
  }
  return snapSceneOf(rims, {.vertices = true, .edges = false, .rims = false}, progress);
}

}  // namespace

MeshTouch::MeshTouch(const WindowParts& parts, QObject* parent)
    : QObject(parent),
      m_session(parts.haptics),
      m_scene(parts.touch),
      m_tools(parts.tools),
      m_fidelity(parts.fidelity),
      m_making(JobRunner::Policy::Latest, parts.pool),
      m_gathering(JobRunner::Policy::Latest, parts.pool) {
  connect(&m_session, &HapticSession::chosenChanged, this, &MeshTouch::followSession);
  connect(&m_tools, &ToolHost::updated, this, &MeshTouch::followTool);
  connect(&m_fidelity, &FidelityChoice::changed, this, [this] {
    if (m_isSnapping) gather(false);
  });
}

void MeshTouch::setDocument(OpenMesh* document) {
  if (m_document) m_document->document.disconnect(this);
  m_document = document;
  if (document) connect(&document->document, &MeshDocument::meshChanged, this, &MeshTouch::edited);
  m_isOpen = m_session.isOpen();
  rebuild(false);
}

void MeshTouch::followSession() {
  if (m_session.isOpen() == m_isOpen) return;
  m_isOpen = m_session.isOpen();
  rebuild(false);
}

// After an edit the surface of before is felt until the new one is there: who was outside would else be inside of it.
void MeshTouch::rebuild(bool isEdit) {
  m_making.cancel();
  m_surface.reset();
  if (!isEdit) {
    m_scene.setSurface({}, false);
    m_isSnapping = false;
    m_gathering.cancel();
    m_scene.setSnap({}, 0.0, false);
  }
  if (!isFelt()) return;
  followTool();
  Job job;
  job.name = tr("Preparing to touch");
  job.work = [this, mesh = m_document->document.mesh()](Progress progress) -> Job::Finish {
    HalfEdgeMesh::Compact all = mesh.compact();
    auto surface = std::make_shared<ContactSurface>(
        touchableSurface(std::move(all.soup.points), std::move(all.soup.triangles), all.faceOf, progress));
    return [this, surface] {
      m_surface = *surface;
      m_scene.setSurface(*surface, false);
    };
  };
  m_making.start(std::move(job));
}

bool MeshTouch::isFelt() const {
  return m_document && m_document->visible && m_isOpen;
}

void MeshTouch::followTool() {
  const Tool* const tool = m_tools.runner().tool();
  const bool isWanted = isFelt() && tool && tool->wantsBoundaryPoints();
  if (isWanted == m_isSnapping) return;
  m_isSnapping = isWanted;
  if (isWanted) return gather(false);
  m_gathering.cancel();
  m_scene.setSnap({}, 0.0, false);
}

// Until the new ones are there, the old draw the tip.
void MeshTouch::gather(bool isEdit) {
  Job job;
  job.name = tr("Preparing to snap");
  job.work = [this, isEdit, mesh = m_document->document.mesh(),
              loops = m_document->document.defects().loops](Progress progress) -> Job::Finish {
    auto points = std::make_shared<SnapScene>(boundaryPoints(mesh, loops, progress));
    return [this, isEdit, points] {
      const double distance = points->distance(m_fidelity.values());
      m_scene.setSnap(std::move(points->field), distance, isEdit);
    };
  };
  m_gathering.start(std::move(job));
}

// While it is being made, it is made of a mesh that is no longer there.
void MeshTouch::edited(const std::vector<Face>& touched) {
  if (!isFelt()) return;
  if (m_isSnapping) gather(true);
  if (m_surface && touched.size() <= kMostAtOnce) return update(touched);
  rebuild(true);
}

void MeshTouch::update(const std::vector<Face>& touched) {
  const HalfEdgeMesh& mesh = m_document->document.mesh();
  std::vector<std::uint32_t> removed;
  std::vector<ContactTriangle> added;
  for (const Face f : touched) {
    removed.push_back(touchableNumber(f));
    if (f < mesh.faceSlots() && mesh.isLive(f)) added.push_back({mesh.points(f), touchableNumber(f)});
  }
  m_surface->update(removed, added);
  m_scene.setSurface(*m_surface, true);
}

}  // namespace handwheel
