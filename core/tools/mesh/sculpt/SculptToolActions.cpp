// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/mesh/MeshDocument.h"
#include "tools/mesh/sculpt/SculptTool.h"

#include <QtGlobal>
#include <algorithm>
#include <utility>

// The actions of SculptTool other than following the pointer: levels, and how steps get into the document.
namespace handwheel {
namespace {

constexpr double kRadiusStep = 1.25;  // from one size to the next by key
constexpr ToolKey kSculptKeys[] = {
    {"smaller", "[", QT_TRANSLATE_NOOP("Tool", "smaller brush")},
    {"larger", "]", QT_TRANSLATE_NOOP("Tool", "larger brush")},
    {"subdivide", "L", QT_TRANSLATE_NOOP("Tool", "subdivide the patch")},
    {"back", "Shift+L", QT_TRANSLATE_NOOP("Tool", "one level back")},
    {"refine", "Ctrl+L", QT_TRANSLATE_NOOP("Tool", "refine to the surroundings")},
    {"coarser", "PgDown", QT_TRANSLATE_NOOP("Tool", "sculpt a coarser level")},
    {"finer", "PgUp", QT_TRANSLATE_NOOP("Tool", "sculpt a finer level")},
    {"noise", "Shift+O", QT_TRANSLATE_NOOP("Tool", "smooth the noise of the patch")},
    {"whole", "A", QT_TRANSLATE_NOOP("Tool", "sculpt the whole surface")},
    {"commit", "Return", QT_TRANSLATE_NOOP("Tool", "done")},
    {"revert", "Esc", QT_TRANSLATE_NOOP("Tool", "done")},
};

}  // namespace

// Makes something of the levels on another thread.
void SculptTool::start(const char* name, const char* text, std::function<SculptResult(PatchLevels, Progress)> make) {
  cancelJob();
  m_problem = nullptr;
  m_job = std::make_shared<const int>();
  m_services.run(
      {name, [this, text, make = std::move(make), levels = m_levels, job = std::weak_ptr(m_job)](Progress progress) {
         SculptResult made = make(levels, progress);
         if (progress.cancelled()) return std::function<void()>([] {});
         return std::function<void()>([this, text, made = std::move(made), job] {
           if (job.expired()) return;
           m_job.reset();
           m_problem = made.problem;
           if (!made.touched.empty()) take(text, made);
           reportUpdated();
         });
       }});
}

void SculptTool::cancelJob() {
  if (!m_job) return;
  m_job.reset();
  m_services.cancel();
}

// Something has been done: it is shown at once, and gets into the document when what was done before is there.
void SculptTool::take(const char* text, SculptResult made) {
  PatchLevels& levels = made.levels;
  const std::size_t level = std::min(m_level, levels.finest());
  const bool isSameDepth = levels.finest() == m_levels.finest();
  MeshChange change;
  change.text = text;
  change.step = std::move(made.step);
  change.apply = [from = m_levels.mesh(), to = levels.mesh()](HalfEdgeMesh& mesh, Progress) {
    if (isSameVersion(mesh, from)) mesh = to;  // else somebody else was faster, and what is there counts
  };
  change.ended = [this, alive = std::weak_ptr(m_alive), ticket = ++m_ticket] {
    if (!alive.expired()) stepEnded(ticket);
  };
  change.crossed = [this, alive = std::weak_ptr(m_alive)](std::size_t pairs) {
    if (!alive.expired()) stepCrossed(pairs);
  };
  setLevels(levels);
  if (isSameDepth) m_level = level;
  m_touched.add(made.touched);
  m_waiting.push_back({m_ticket, std::move(levels)});
  showPreviewMesh();
  m_services.commit(std::move(change));
}

void SculptTool::documentChanged() {
  if (isSameVersion(m_document.mesh(), m_known)) return;  // in something else
  if (!m_waiting.empty() && isSameVersion(m_document.mesh(), m_waiting.front().levels.mesh())) return landed();
  restart();
}

// The first step is in the document.
void SculptTool::landed() {
  m_known = m_document.mesh();
  m_document.keepLevels(m_waiting.front().levels);
  m_waiting.pop_front();
  if (m_waiting.empty()) m_touched = {};
  showPreviewMesh();
}

void SculptTool::stepEnded(std::uint64_t ticket) {
  if (m_waiting.empty() || m_waiting.front().ticket != ticket) return;  // it is in
  if (isSameVersion(m_document.mesh(), m_waiting.front().levels.mesh())) {
    landed();
  } else {
    restart();  // it was given up
  }
  reportUpdated();
}

// A brush may go where it pleases; but whoever holds it must know.
void SculptTool::stepCrossed(std::size_t pairs) {
  if (pairs == 0) return;
  m_crossings += pairs;
  reportUpdated();
}

// From what the document is now.
void SculptTool::restart() {
  cancelJob();
  m_crossings = 0;
  m_stroke.reset();
  m_tip.reset();
  m_hovered.reset();
  m_waiting.clear();
  m_touched = {};
  m_known = m_document.mesh();
  FaceSelection patch = m_levels.patch();
  patch.dropDead(m_known);
  const PatchLevels* remembered = m_isWhole ? nullptr : m_document.levels(patch);
  setLevels(remembered ? *remembered : PatchLevels(m_known, std::move(patch)));
  showPreviewMesh();
}

ToolReply SculptTool::perform(std::string_view action) {
  if (action == "revert") return revert();
  dropStroke();
  if (action == "commit") return ToolReply::Finished;
  if (action == "smaller" || action == "larger") {
    m_settings.scaleBrush(action == "larger" ? kRadiusStep : 1.0 / kRadiusStep);
  } else if (action == "coarser" || action == "finer") {
    m_level = action == "finer" ? std::min(m_level + 1, m_levels.finest()) : m_level - (m_level > 0);
  } else if (action == "subdivide") {
    subdivideLater();
  } else if (action == "refine") {
    refineLater();
  } else if (action == "back") {
    goBackALevel();
  } else if (action == "noise") {
    smoothNoiseLater();
  } else if (action == "whole") {
    m_isWhole = true;
    setLevels(PatchLevels(m_levels.mesh(), {}));
  } else {
    return ToolReply::Ignored;
  }
  return ToolReply::Used;
}

void SculptTool::subdivideLater() {
  start(QT_TRANSLATE_NOOP("Tool", "Subdividing"), QT_TRANSLATE_NOOP("Tool", "Subdivide patch"),
        [numbers = m_document.fileNumbers()](PatchLevels levels, Progress progress) {
          return subdivided(std::move(levels), 1, numbers, progress);
        });
}

void SculptTool::refineLater() {
  start(QT_TRANSLATE_NOOP("Tool", "Refining"), QT_TRANSLATE_NOOP("Tool", "Refine to the surroundings"),
        [numbers = m_document.fileNumbers()](const PatchLevels& levels, Progress progress) {
          return refined(levels, numbers, progress);
        });
}

void SculptTool::smoothNoiseLater() {
  Denoising options;
  options.method = m_settings.noiseMethod;
  options.bilateral.normalSpread = m_settings.noiseAngle;
  options.bilateral.movesBorder = m_settings.movesBorder;
  options.laplace.isBending = m_settings.noiseMethod == NoiseMethod::Bending;
  options.laplace.passes = static_cast<int>(m_settings.noisePasses);
  options.bilateral.numbers = options.laplace.numbers = m_document.fileNumbers();
  start(QT_TRANSLATE_NOOP("Tool", "Smoothing noise"), QT_TRANSLATE_NOOP("Tool", "Smooth noise"),
        [options](PatchLevels levels, Progress progress) { return denoised(std::move(levels), options, progress); });
}

void SculptTool::goBackALevel() {
  cancelJob();
  take(QT_TRANSLATE_NOOP("Tool", "One level back"), coarsened(m_levels));
}

// Step by step out of what is going on.
ToolReply SculptTool::revert() {
  if (m_stroke) {
    dropStroke();
  } else if (m_job) {
    cancelJob();
  } else {
    return ToolReply::Finished;
  }
  return ToolReply::Used;
}

std::span<const ToolKey> SculptTool::keys() {
  return kSculptKeys;
}

std::vector<ToolAction> SculptTool::actions() const {
  const bool hasPatch = !m_levels.patch().empty(), isIdle = !m_job;
  const std::size_t finest = m_levels.finest();
  std::vector<ToolAction> all = {
      {"", QT_TRANSLATE_NOOP("ToolInput", "Drag"), QT_TRANSLATE_NOOP("Tool", "sculpt")},
      {"", QT_TRANSLATE_NOOP("ToolInput", "Shift+drag"), QT_TRANSLATE_NOOP("Tool", "smooth")},
      {"", QT_TRANSLATE_NOOP("ToolInput", "Ctrl+drag"), QT_TRANSLATE_NOOP("Tool", "opposite direction")},
      actionOf(kSculptKeys, "smaller"),
      actionOf(kSculptKeys, "larger"),
      actionOf(kSculptKeys, "subdivide", hasPatch && isIdle),
      actionOf(kSculptKeys, "back", finest > 0 && isIdle),
      actionOf(kSculptKeys, "refine", hasPatch && isIdle),
      actionOf(kSculptKeys, "coarser", m_level > 0),
      actionOf(kSculptKeys, "finer", m_level < finest),
      actionOf(kSculptKeys, "noise", isIdle,
               hasPatch ? nullptr : QT_TRANSLATE_NOOP("Tool", "smooth the noise along the holes")),
      actionOf(kSculptKeys, "whole", hasPatch),
      actionOf(kSculptKeys, "commit"),
      actionOf(kSculptKeys, "revert"),  // always offered, so that no button appears and disappears
  };
  if (m_crossings > 0)
    all.insert(all.begin(),
               {"", "Ctrl+Z", QT_TRANSLATE_NOOP("Tool", "undo: the surface now intersects itself"), true, "undo"});
  return all;
}

std::vector<Property> SculptTool::settings() const {
  std::vector<Property> all = m_settings.properties();
  if (m_crossings > 0) {
    Property crossings;
    crossings.id = "crossings";
    crossings.label = QT_TRANSLATE_NOOP("Property", "New self-intersections");
    crossings.value = static_cast<double>(m_crossings);
    crossings.editable = false;
    crossings.problem = QT_TRANSLATE_NOOP("Property", "The surface now intersects itself here: undo, or smooth it.");
    all.push_back(std::move(crossings));
  }
  if (m_levels.patch().empty()) return all;
  Property faces;
  faces.id = "patch";
  faces.label = QT_TRANSLATE_NOOP("Property", "Triangles of the patch");
  faces.value = static_cast<double>(m_levels.patch().count());
  faces.editable = false;
  if (m_problem) faces.problem = m_problem;
  all.push_back(std::move(faces));
  if (m_levels.finest() == 0) return all;
  Property level;
  level.id = "level";
  level.label = QT_TRANSLATE_NOOP("Property", "Level");
  level.value = static_cast<double>(m_level);
  for (std::size_t i = 0; i <= m_levels.finest(); ++i) level.choices.push_back(std::to_string(i));
  all.push_back(std::move(level));
  Property aspect;
  aspect.id = "aspect";
  aspect.label = QT_TRANSLATE_NOOP("Property", "Aspect ratio at the boundary");
  aspect.value = m_aspect;
  aspect.editable = false;
  if (m_levels.finest() > kEvenLevels)
    aspect.problem = QT_TRANSLATE_NOOP("Property", "Its outer triangles have become long and thin: go back one level.");
  all.push_back(std::move(aspect));
  return all;
}

void SculptTool::setSetting(std::string_view id, const PropertyValue& value) {
  const double* number = std::get_if<double>(&value);
  if (id == "level" && number && *number >= 0.0) {
    dropStroke();
    m_level = static_cast<std::size_t>(std::min(*number, static_cast<double>(m_levels.finest())));
  } else if (m_settings.set(id, value)) {
    dropStroke();
  }
}

}  // namespace handwheel
