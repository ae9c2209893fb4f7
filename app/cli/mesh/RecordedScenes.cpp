// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh/RecordedScenes.h"

#include "cli/Messages.h"
#include "haptics/scene/MeshHaptics.h"
#include "tools/mesh/MeshSurface.h"

#include <nlohmann/json.hpp>

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

}  // namespace

RecordedScenes::RecordedScenes(const Recording& recording, MeshDocument& document, MeshFileReader readMesh,
                               Progress progress)
    : m_recording(recording), m_document(document), m_readMesh(std::move(readMesh)), m_progress(progress) {}

ForceRenderer* RecordedScenes::at(const RecordedTick& tick) {
  const auto& events = m_recording.events();
  std::vector<std::string> notes;
  for (; m_nextEvent < events.size() && events[m_nextEvent].tick <= tick.tick; ++m_nextEvent) {
    const std::string& text = events[m_nextEvent].text;
    if (text.starts_with(kSceneEvent)) notes.push_back(text.substr(kSceneEvent.size()));
  }
  // Of several scenes before a tick only the last was felt; the edits of the others were made all the same.
  for (std::size_t i = 0; i < notes.size() && m_problem.empty(); ++i) begin(notes[i], i + 1 == notes.size());
  return m_problem.empty() ? m_scene.get() : nullptr;
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
  if (surface) edit(*surface);
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
      &m_document, &MeshDocument::meshChanged, &m_document,
      [&](const std::vector<Face>& faces) { touched.insert(touched.end(), faces.begin(), faces.end()); });
  const auto steps = surface.find("steps");
  if (steps != surface.end() && steps->is_array()) {
    const auto keep = static_cast<std::size_t>(numberOf(surface, "keep", 1e9));
    for (; m_steps.size() > keep; m_steps.pop_back()) {
      m_document.history()->undo();
      m_undone.push_back(m_steps.back());
    }
    for (const nlohmann::json& step : *steps) {
      if (!doStep(step.is_string() ? step.get<std::string>() : std::string())) break;
    }
  }
  QObject::disconnect(connection);
  if (!m_surface || !isSmallEdit(touched.size())) {
    m_surface = contactSurfaceOf(m_document.mesh());
  } else if (!touched.empty()) {
    updateSurface(*m_surface, m_document.mesh(), touched);
  }
}

// Done again as it was: what was taken back is restored and not computed once more. False: there is a problem.
bool RecordedScenes::doStep(const std::string& step) {
  ++m_editCount;
  if (!m_undone.empty() && m_undone.back() == step) {
    m_document.history()->redo();
    m_undone.pop_back();
    m_steps.push_back(step);
    return true;
  }
  const Result<StepOutcome> done = applyStep(m_document, step, m_progress.unlimited(), m_readMesh);
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
  auto next = std::make_unique<SceneForces>(forceSources(std::move(felt)));
  if (m_scene) next->follow(*m_scene);
  m_scene = std::move(next);
  ++m_sceneCount;
}

}  // namespace handwheel
