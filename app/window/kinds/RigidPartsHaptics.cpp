// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/kinds/RigidPartsHaptics.h"

#include "document/ShapeDigest.h"
#include "haptics/contact/TouchableSurface.h"
#include "window/haptics/HapticSceneBuilder.h"
#include "window/haptics/HapticSession.h"
#include "window/kinds/KindUi.h"

#include <QJsonArray>
#include <algorithm>
#include <set>
#include <string_view>

namespace handwheel {

namespace {

constexpr double kAhead = 0.1;  // s that it may take until a scene is felt

// Returns the parts of one model that are not in the other, or have another pose there.
std::vector<const DisplayPart*> changedParts(const DisplayModel& model, const DisplayModel& other) {
  std::map<std::string_view, const DisplayPart*> known;
  for (const DisplayPart& part : other.parts) known.emplace(part.name, &part);
  std::vector<const DisplayPart*> changed;
  for (const DisplayPart& part : model.parts) {
    const auto same = known.find(part.name);
    if (same == known.end() || same->second->soup != part.soup || same->second->pose.matrix() != part.pose.matrix())
      changed.push_back(&part);
  }
  return changed;
}

}  // namespace

RigidPartsHaptics::RigidPartsHaptics(const WindowContext& window, QObject* parent)
    : QObject(parent),
      m_session(window.haptics),
      m_scene(window.touch),
      m_making(JobRunner::Policy::Latest, window.pool),
      m_isOpen(window.haptics.isOpen()) {
  connect(&m_session, &HapticSession::chosenChanged, this, [this] {
    if (m_session.isOpen() == m_isOpen) return;
    m_isOpen = m_session.isOpen();
    if (m_parts) feel();
  });
  connect(&m_session, &HapticSession::recordingStarted, this, [this] {
    m_noted.reset();
    m_digests.clear();
  });
}

void RigidPartsHaptics::setParts(std::shared_ptr<const DisplayModel> parts) {
  if (!parts && !m_parts) return;
  m_parts = std::move(parts);
  feel();
}

// Until the surface of a new shape is there, the old ones are felt; a tip would else sink in while a body is added.
void RigidPartsHaptics::feel() {
  m_making.cancelAll();
  if (!m_parts || !m_isOpen) {
    m_surfaces.clear();
    m_placed.reset();
    m_felt = {};
    return m_scene.setSurface({}, false);
  }
  std::vector<Shape> unknown;
  for (const DisplayPart& part : m_parts->parts) {
    if (!m_surfaces.contains(part.soup) && std::find(unknown.begin(), unknown.end(), part.soup) == unknown.end())
      unknown.push_back(part.soup);
  }
  if (unknown.empty()) return place();
  build(std::move(unknown));
}

void RigidPartsHaptics::build(std::vector<Shape> shapes) {
  Job job;
  job.name = tr("Preparing to touch");
  job.work = [this, shapes = std::move(shapes)](Progress progress) -> Job::Finish {
    auto surfaces = std::make_shared<std::map<Shape, ContactSurface>>();
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      const auto share = [&](std::size_t n) { return static_cast<double>(n) / static_cast<double>(shapes.size()); };
      surfaces->emplace(shapes[i], touchableSurface(shapes[i]->points, shapes[i]->triangles, {},
                                                    progress.part(share(i), share(i + 1))));
    }
    return [this, surfaces] {
      m_surfaces.merge(*surfaces);
      place();
    };
  };
  m_making.start(std::move(job));
}

// If nothing has changed at the hand the proxy continues from its position. Otherwise it starts at the viewer again, as
// the tip may be inside a part that was moved, and the force rises by the ramp.
void RigidPartsHaptics::place() {
  const bool isEdit = m_placed && !isAtHand(*m_placed, *m_parts) && !isAtHand(*m_parts, *m_placed);
  std::vector<ContactSurface::Placed> bodies;
  std::set<Shape> used;
  for (const DisplayPart& part : m_parts->parts) {
    bodies.push_back({m_surfaces.at(part.soup), part.pose});
    used.insert(part.soup);
  }
  std::erase_if(m_surfaces, [&](const auto& surface) { return !used.contains(surface.first); });
  m_felt = ContactSurface(std::span<const ContactSurface::Placed>(bodies), isEdit ? &m_felt : nullptr);
  m_placed = m_parts;
  m_isEdit = isEdit;
  m_scene.setSurface(m_felt, isEdit, [this] { return describe(); });
}

// For a recording, which cli/mesh/RecordedScenes.h reads: the "parts" with shape and pose, or, where there are the same
// as before, those that have "moved".
QJsonObject RigidPartsHaptics::describe() {
  QJsonObject note;
  if (!m_placed || m_noted == m_placed) return note;
  const auto& parts = m_placed->parts;
  const bool isSame = m_noted && std::equal(parts.begin(), parts.end(), m_noted->parts.begin(), m_noted->parts.end(),
                                            [](const DisplayPart& a, const DisplayPart& b) {
                                              return a.name == b.name && a.soup == b.soup;
                                            });
  QJsonArray list;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (isSame && parts[i].pose.matrix() == m_noted->parts[i].pose.matrix()) continue;
    QJsonObject part{{"name", QString::fromStdString(parts[i].name)}};
    if (!isSame) {
      const auto [digest, isNew] = m_digests.try_emplace(parts[i].soup);
      if (isNew) digest->second = shapeDigest(*parts[i].soup);
      part["shape"] = QString::fromStdString(digest->second);
    }
    QJsonArray pose;
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 4; ++column) pose.append(parts[i].pose.matrix()(row, column));
    part["pose"] = pose;
    list.append(part);
  }
  note[isSame ? "moved" : "parts"] = list;
  note["edit"] = m_isEdit;
  m_noted = m_placed;
  return note;
}

// Returns true if the tip, its proxy, or a position that the tip may soon reach lies in a part of the first model that
// is missing or elsewhere in the other.
bool RigidPartsHaptics::isAtHand(const DisplayModel& moved, const DisplayModel& others) const {
  const ServoSample* const last = m_session.latest();
  if (!last) return false;
  const Vec3 reach = Vec3::Constant(kAhead * last->tip.velocity.norm());
  Box hand(last->tip.position - reach, last->tip.position + reach);
  if (last->felt.isContact) hand.extend(last->felt.proxy);
  const std::vector<const DisplayPart*> changed = changedParts(moved, others);
  return std::any_of(changed.begin(), changed.end(), [&](const DisplayPart* part) {
    const auto surface = m_surfaces.find(part->soup);
    return surface == m_surfaces.end() || surface->second.bounds().transformed(part->pose).intersects(hand);
  });
}

}  // namespace handwheel
