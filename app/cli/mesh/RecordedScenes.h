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

// Restores the haptic scenes of a recording. From what it notes of them: the surface of a mesh with its edits, or the
// parts of other documents where they were. What else acted, such as snapping, is not made again, and counted.
class RecordedScenes {
 public:
  // document: of the mesh in the state of its file; it is edited. All outlive it.
  RecordedScenes(const Recording& recording, MeshDocument& document, MeshFileReader readMesh, Progress progress);

  // parts: as the file has them; only those that were felt with the shapes of these can be felt again.
  RecordedScenes(const Recording& recording, DisplayModel parts, Progress progress);

  // The scene of a tick: those of a recording in order. Null: nothing is known of it, or of the contact it began with.
  ForceRenderer* at(const RecordedTick& tick);

  std::size_t sceneCount() const { return m_sceneCount; }
  std::size_t editCount() const { return m_editCount; }
  // Sources of force that were left out; by id, sorted.
  const std::set<std::string>& leftOut() const { return m_leftOut; }
  // Why the rest of the recording cannot be felt again; a sentence. Empty: it can.
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
  std::map<std::string, const TriangleSoup*> m_shapes;                   // of the parts; by digest
  std::map<std::string, ContactSurface> m_surfaces;                      // of those that were felt so far; by digest
  std::vector<std::pair<std::string, ContactSurface::Placed>> m_placed;  // with names
  Progress m_progress;
  std::size_t m_nextEvent = 0;
  // Done to the document, and taken back from it, the last one at the end.
  std::vector<std::string> m_steps, m_undone;
  std::optional<ContactSurface> m_surface;
  MeshHaptics m_felt;  // what m_scene was made of
  std::unique_ptr<SceneForces> m_scene;
  bool m_isKnown = false;  // the state of m_scene
  std::size_t m_sceneCount = 0, m_editCount = 0;
  std::set<std::string> m_leftOut;
  std::string m_problem;
};

}  // namespace handwheel
