// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh/RecordedScenes.h"

#include "cli/Messages.h"
#include "document/ShapeDigest.h"
#include "haptics/contact/TouchableSurface.h"
#include "tools/mesh/MeshContactSurface.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>

namespace handwheel {

namespace {

// The bounds are those of the options of 'handwheel feel'.
double numberOf(const nlohmann::json& object, const char* key, double most) {
  const auto at = object.find(key);
  const double value = at != object.end() && at->is_number() ? at->get<double>() : 0.0;
  return value >= 0.0 ? std::min(value, most) : 0.0;
}

Vec3 directionOf(const nlohmann::json& surface) {
  const auto at = surface.find("from");
  if (at == surface.end() || !at->is_array() || at->size() != 3) return Vec3::Zero();
  Vec3 direction = Vec3::Zero();
  for (int k = 0; k < 3; ++k)
    direction[k] =
        (*at)[static_cast<std::size_t>(k)].is_number() ? (*at)[static_cast<std::size_t>(k)].get<double>() : 0.0;
  return direction.allFinite() ? direction : Vec3(Vec3::Zero());
}

std::string stringOf(const nlohmann::json& object, const char* key) {
  const auto at = object.is_object() ? object.find(key) : object.end();
  return at != object.end() && at->is_string() ? at->get<std::string>() : std::string();
}

// Three rows of four numbers; nothing where they are no rotation and translation.
std::optional<Pose> poseOf(const nlohmann::json& part) {
  constexpr double kRotation = 1e-9;  // precision of the digits of a pose
  const auto at = part.is_object() ? part.find("pose") : part.end();
  if (at == part.end() || !at->is_array() || at->size() != 12) return std::nullopt;
  Pose pose = Pose::Identity();
  for (int i = 0; i < 12; ++i) {
    const nlohmann::json& number = (*at)[static_cast<std::size_t>(i)];
    if (!number.is_number()) return std::nullopt;
    pose.matrix()(i / 4, i % 4) = number.get<double>();
  }
  const bool isRotation = pose.matrix().allFinite() && pose.linear().determinant() > 0.0 &&
                          (pose.linear() * pose.linear().transpose()).isIdentity(kRotation);
  return isRotation ? std::optional(pose) : std::nullopt;
}

}  // namespace

RecordedScenes::RecordedScenes(const Recording& recording, MeshDocument& document, MeshFileReader readMesh,
                               Progress progress)
    : m_recording(recording), m_document(&document), m_readMesh(std::move(readMesh)), m_progress(progress) {}

RecordedScenes::RecordedScenes(const Recording& recording, DisplayModel parts, Progress progress)
    : m_recording(recording), m_parts(std::move(parts)), m_progress(progress) {
  for (const DisplayPart& part : m_parts.parts) m_shapes.emplace(shapeDigest(*part.soup), part.soup.get());
}

ForceRenderer* RecordedScenes::at(const RecordedTick& tick) {
  const auto& events = m_recording.events();
  std::vector<std::string> notes;
  for (; m_nextEvent < events.size() && events[m_nextEvent].tick <= tick.tick; ++m_nextEvent) {
    const std::string& text = events[m_nextEvent].text;
    if (text.starts_with(kSceneEvent)) notes.push_back(text.substr(kSceneEvent.size()));
  }
  // Only the last of several scenes before a tick was felt; but the edits of the others were made.
  for (std::size_t i = 0; i < notes.size() && m_problem.empty(); ++i) begin(notes[i], i + 1 == notes.size());
  return m_problem.empty() && m_scene && isKnown(tick) ? m_scene.get() : nullptr;
}

// A contact that began in a scene without notes is unknown. The state is known once the tip is free.
bool RecordedScenes::isKnown(const RecordedTick& tick) {
  if (m_isKnown || !tick.hasSource) return m_isKnown;
  m_isKnown = tick.tip.isRestart || !tick.felt.isContact;
  if (m_isKnown && !tick.tip.isRestart) {
    MeshHaptics felt = m_felt;
    felt.comesFrom = Vec3::Zero();
    SceneForces before(forceSources(std::move(felt)));
    ForceOut none;
    before.tick(tick.tip, none);
    m_scene->follow(before);
  }
  return m_isKnown;
}

void RecordedScenes::begin(const std::string& note, bool isFelt) {
  const nlohmann::json scene = nlohmann::json::parse(note, nullptr, false);
  if (!scene.is_object()) {
    m_problem = "The description of a scene cannot be read.";
    return;
  }
  const nlohmann::json* surface = nullptr;
  for (const auto& [id, own] : scene.items()) {
    if (id == kSurfaceSource && own.is_object()) {
      surface = &own;
    } else {
      m_leftOut.insert(id);
    }
  }
  if (surface && m_document) edit(*surface);
  if (surface && !m_document) place(*surface);
  if (m_problem.empty() && isFelt) setScene(surface);
}

// Takes back and does what was taken back and done before this scene.
void RecordedScenes::edit(const nlohmann::json& surface) {
  if (surface.contains("unknown")) {
    m_problem = "An edit of the mesh is not described by a step.";
    return;
  }
  std::vector<Face> touched;
  const auto connection = QObject::connect(
      m_document, &MeshDocument::meshChanged, m_document,
      [&](const std::vector<Face>& faces) { touched.insert(touched.end(), faces.begin(), faces.end()); });
  const auto steps = surface.find("steps");
  if (steps != surface.end() && steps->is_array()) {
    const auto keep = static_cast<std::size_t>(numberOf(surface, "keep", 1e9));
    for (; m_steps.size() > keep; m_steps.pop_back()) {
      m_document->history()->undo();
      m_undone.push_back(m_steps.back());
    }
    for (const nlohmann::json& step : *steps) {
      if (!doStep(step.is_string() ? step.get<std::string>() : std::string())) break;
    }
  }
  QObject::disconnect(connection);
  if (!m_surface || !isSmallEdit(touched.size())) {
    m_surface = contactSurfaceOf(m_document->mesh());
  } else if (!touched.empty()) {
    updateSurface(*m_surface, m_document->mesh(), touched);
  }
}

// The notes omit the parts if none has moved since the previous scene.
void RecordedScenes::place(const nlohmann::json& surface) {
  const bool isAnew = surface.contains("parts");
  const auto list = surface.find(isAnew ? "parts" : "moved");
  if (list == surface.end() || !list->is_array()) {
    if (!m_surface) m_problem = "It does not hold where the parts were.";
    return;
  }
  if (isAnew) m_placed.clear();
  ++m_editCount;
  for (const nlohmann::json& part : *list) {
    const std::string name = stringOf(part, "name"), shape = stringOf(part, "shape");
    const std::optional<Pose> pose = poseOf(part);
    if (!pose) {
      m_problem = "The place of '" + name + "' cannot be read.";
      return;
    }
    if (isAnew) {
      const auto known = m_shapes.find(shape);
      if (known == m_shapes.end()) {
        m_problem = "'" + name + "' had another shape then than in the file.";
        return;
      }
      const auto [felt, isNew] = m_surfaces.try_emplace(shape);
      if (isNew) felt->second = touchableSurface(known->second->points, known->second->triangles, {}, m_progress);
      m_placed.push_back({name, {felt->second, *pose}});
      continue;
    }
    const auto moved =
        std::find_if(m_placed.begin(), m_placed.end(), [&](const auto& each) { return each.first == name; });
    if (moved != m_placed.end()) moved->second.pose = *pose;
  }
  std::vector<ContactSurface::Placed> bodies;
  for (const auto& [name, placed] : m_placed) bodies.push_back(placed);
  const auto edit = surface.find("edit");
  const bool isEdit = m_surface && edit != surface.end() && edit->is_boolean() && edit->get<bool>();
  m_surface = ContactSurface(std::span<const ContactSurface::Placed>(bodies), isEdit ? &*m_surface : nullptr);
}

// Done again as it was: what was taken back is restored and not computed once more. False: there is a problem.
bool RecordedScenes::doStep(const std::string& step) {
  ++m_editCount;
  if (!m_undone.empty() && m_undone.back() == step) {
    m_document->history()->redo();
    m_undone.pop_back();
    m_steps.push_back(step);
    return true;
  }
  const Result<ScriptLineOutcome> done = applyScriptLine(*m_document, step, m_progress.unlimited(), m_readMesh);
  if (!done) {
    m_problem = sentenceFor(done.error());
    return false;
  }
  if (done->changed) m_steps.push_back(step);
  m_undone.clear();
  return true;
}

void RecordedScenes::setScene(const nlohmann::json* surface) {
  MeshHaptics felt;
  if (surface) {
    felt.surface =
        TouchedSurface{*m_surface, numberOf(*surface, "stiffness", 1e6), numberOf(*surface, "damping", 1e6), {}};
    felt.surface->contact.friction = numberOf(*surface, "friction", 100.0);
    felt.surface->contact.tolerance = numberOf(*surface, "tolerance", 1.0);
    felt.comesFrom = directionOf(*surface);
  }
  m_felt = felt;
  auto next = std::make_unique<SceneForces>(forceSources(std::move(felt)));
  if (m_scene) next->follow(*m_scene);
  m_scene = std::move(next);
  ++m_sceneCount;
}

}  // namespace handwheel
