// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/mesh/MeshTouch.h"

#include "haptics/TouchableSurface.h"
#include "window/haptics/HapticSession.h"
#include "window/haptics/TouchScene.h"
#include "window/mesh/OpenMesh.h"

namespace handwheel {

namespace {

// More are not brought up to date on the window thread, where they would take longer than a frame.
constexpr std::size_t kMostAtOnce = 10'000;

}  // namespace

MeshTouch::MeshTouch(HapticSession& session, TouchScene& scene, QThreadPool& pool, QObject* parent)
    : QObject(parent), m_session(session), m_scene(scene), m_making(JobRunner::Policy::Latest, pool) {
  connect(&session, &HapticSession::chosenChanged, this, &MeshTouch::followSession);
}

void MeshTouch::setDocument(OpenMesh* document) {
  if (m_document) m_document->document.disconnect(this);
  m_document = document;
  if (document) connect(&document->document, &MeshDocument::meshChanged, this, &MeshTouch::edited);
  m_isOpen = m_session.isOpen();
  rebuild();
}

void MeshTouch::followSession() {
  if (m_session.isOpen() == m_isOpen) return;
  m_isOpen = m_session.isOpen();
  rebuild();
}

void MeshTouch::rebuild() {
  m_making.cancel();
  m_surface.reset();
  m_scene.setSurface({}, false);
  if (!m_document || !m_document->visible || !m_isOpen) return;
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

// While it is being made, it is made of a mesh that is no longer there.
void MeshTouch::edited(const std::vector<Face>& touched) {
  if (!m_isOpen || !m_document->visible) return;
  m_surface&& touched.size() <= kMostAtOnce ? update(touched) : rebuild();
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
