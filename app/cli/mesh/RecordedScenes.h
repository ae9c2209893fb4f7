// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DisplayModel.h"
#include "document/mesh/MeshDocument.h"
#include "haptics/contact/ContactSurface.h"
#include "haptics/recording/Recording.h"
#include "haptics/scene/MeshHaptics.h"
#include "haptics/scene/SceneForces.h"
#include "tools/mesh/MeshScript.h"

#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>

namespace handwheel {

// Restores the haptic scenes of a recording. The scenes are made from the notes of the recording: the surface of a mesh
// with its edits, or the parts of other documents at their poses. Other sources of force, such as snapping, are not
// restored; their ids are listed in leftOut().
class RecordedScenes {
 public:
  // document: the document of the mesh in the state of its file. The document is edited. recording and document must
  // outlive the object.
  RecordedScenes(const Recording& recording, MeshDocument& document, MeshFileReader readMesh, Progress progress);

  // parts: the parts of the file. Only parts whose shapes were felt in the recording can be felt again.
  RecordedScenes(const Recording& recording, DisplayModel parts, Progress progress);

  // Returns the scene of a tick. The ticks of a recording must be passed in order. Returns null if the scene, or the
  // contact with which it began, is unknown.
  ForceRenderer* at(const RecordedTick& tick);

  std::size_t sceneCount() const { return m_sceneCount; }
  std::size_t editCount() const { return m_editCount; }
  // Returns the ids of the sources of force that were left out, sorted.
  const std::set<std::string>& leftOut() const { return m_leftOut; }
  // Returns the reason why the rest of the recording cannot be felt again, as a sentence, or an empty string.
  const std::string& problem() const { return m_problem; }

 private:
  void begin(const std::string& note, bool isFelt);
  void edit(const nlohmann::json& surface);
  void place(const nlohmann::json& surface);
  bool doStep(const std::string& step);
  void setScene(const nlohmann::json* surface);
  bool isKnown(const RecordedTick& tick);

  const Recording& m_recording;
  MeshDocument* m_document = nullptr;  // null: the parts are felt
  MeshFileReader m_readMesh;
  DisplayModel m_parts;
  std::map<std::string, const TriangleSoup*> m_shapes;  // shapes of the parts, by digest
  std::map<std::string, ContactSurface> m_surfaces;     // surfaces of the shapes felt so far, by digest
  std::vector<std::pair<std::string, ContactSurface::Placed>> m_placed;  // placed parts with their names
  Progress m_progress;
  std::size_t m_nextEvent = 0;
  // Steps applied to the document, and steps undone. The last step is at the end of the list.
  std::vector<std::string> m_steps, m_undone;
  std::optional<ContactSurface> m_surface;
  MeshHaptics m_felt;  // the contents of m_scene
  std::unique_ptr<SceneForces> m_scene;
  bool m_isKnown = false;  // true if the state of m_scene is known
  std::size_t m_sceneCount = 0, m_editCount = 0;
  std::set<std::string> m_leftOut;
  std::string m_problem;
};

}  // namespace handwheel
