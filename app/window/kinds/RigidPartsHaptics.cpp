// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/kinds/RigidPartsHaptics.h"

#include "haptics/contact/TouchableSurface.h"
#include "window/haptics/HapticSceneBuilder.h"
#include "window/haptics/HapticSession.h"
#include "window/kinds/KindUi.h"

namespace handwheel {

RigidPartsHaptics::RigidPartsHaptics(const WindowContext& window, QObject* parent)
    : QObject(parent),
      m_session(window.haptics),
      m_scene(window.touch),
      m_making(JobRunner::Policy::Latest, window.pool),
      m_isOpen(window.haptics.isOpen()) {
  connect(&m_session, &HapticSession::chosenChanged, this, [this] {
    if (m_session.isOpen() == m_isOpen) return;
    m_isOpen = m_session.isOpen();
    if (m_parts) rebuild();
  });
}

void RigidPartsHaptics::setParts(std::shared_ptr<const DisplayModel> parts) {
  if (!parts && !m_parts) return;
  m_parts = std::move(parts);
  rebuild();
}

// Until the new surface is there, the old one is felt; a tip would else sink in while a joint is dragged.
void RigidPartsHaptics::rebuild() {
  m_making.cancelAll();
  if (!m_parts || !m_isOpen) return m_scene.setSurface({}, false);
  Job job;
  job.name = tr("Preparing to touch");
  job.work = [this, parts = m_parts](Progress progress) -> Job::Finish {
    TriangleSoup soup = placedSoup(*parts);
    auto surface = std::make_shared<ContactSurface>(
        touchableSurface(std::move(soup.points), std::move(soup.triangles), {}, progress));
    return [this, surface] { m_scene.setSurface(*surface, false); };
  };
  m_making.start(std::move(job));
}

}  // namespace handwheel
