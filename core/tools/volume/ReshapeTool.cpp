// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/volume/ReshapeTool.h"

#include "base/NumberText.h"
#include "document/volume/VolumeEdit.h"
#include "document/volume/VolumeMaking.h"
#include "tools/OperationSettings.h"
#include "tools/ToolProperty.h"
#include "tools/volume/ShapingObstacle.h"
#include "volume/surface/VolumeToSurface.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace handwheel {
namespace {

constexpr ToolKey kReshapeKeys[] = {
    {"commit", "Return", QT_TRANSLATE_NOOP("Tool", "apply")},
    {"file", "Shift+F", QT_TRANSLATE_NOOP("Tool", "combine with a file")},
    {"revert", "Esc", QT_TRANSLATE_NOOP("Tool", "done")},
};

constexpr std::array<const char*, ReshapeTool::kChanges> kChangeNames = {
    QT_TRANSLATE_NOOP("Property", "Shell"),      QT_TRANSLATE_NOOP("Property", "Move surface"),
    QT_TRANSLATE_NOOP("Property", "Combine"),    QT_TRANSLATE_NOOP("Property", "Remove debris"),
    QT_TRANSLATE_NOOP("Property", "Close gaps"), QT_TRANSLATE_NOOP("Property", "Smooth all"),
};

Property shownFigure(const char* id, const char* label, double value) {
  Property property{.id = id, .group = {}, .label = label, .value = value};
  property.editable = false;
  return property;
}

struct DebrisMade {
  Result<SparseVolume> volume;
  std::shared_ptr<const VolumeParts> parts;
  std::size_t kept = 0;
  std::shared_ptr<const DisplayPart> gone;
};

DebrisMade debrisOf(const SparseVolume& volume, const OperationValues& values, std::shared_ptr<const VolumeParts> parts,
                    const Progress& progress) {
  if (!parts) {
    if (const auto error = VolumeParts::refusal(volume)) return {*error, nullptr, 0, nullptr};
    parts = std::make_shared<const VolumeParts>(volume, progress.part(0.0, 0.4));
  }
  if (progress.cancelled()) return {Error{ErrorCode::Cancelled, {}, {}, {}}, nullptr, 0, nullptr};
  DebrisMade made{volume, parts, keptParts(*parts, values, volume.voxel()), nullptr};
  if (made.kept == parts->voxels().size()) return made;
  made.volume = parts->only(0, made.kept, progress.part(0.4, 0.7));
  auto gone = std::make_shared<DisplayPart>();
  gone->name = gone->group = "debris";
  gone->soup = std::make_shared<const TriangleSoup>(
      surfaceOf(parts->only(made.kept, parts->voxels().size(), progress.part(0.7, 0.9)), progress.part(0.9, 1.0)));
  gone->colour = {0.85f, 0.2f, 0.15f};
  made.gone = std::move(gone);
  return made;
}

}  // namespace

const Operation& ReshapeTool::operation(Change change) {
  switch (change) {
    case Change::Shell:
      return shellOperation();
    case Change::Offset:
      return offsetOperation();
    case Change::Boolean:
      return booleanOperation();
    case Change::Debris:
      return debrisOperation();
    case Change::Gaps:
      return gapsOperation();
    case Change::Smooth:
      break;
  }
  return smoothOperation();
}

ReshapeTool::ReshapeTool(VolumeDocument& document, ReshapeServices services, Change change)
    : m_document(document), m_services(std::move(services)), m_change(change), m_bodies(m_services.bodies()) {
  for (int i = 0; i < kChanges; ++i) m_values.emplace_back(operation(static_cast<Change>(i)));
  chooseUsual();
  propose();
}

// Depends on the voxels and the size of the part.
void ReshapeTool::chooseUsual() {
  const double voxel = m_document.volume()->volume.voxel();
  const Box box = m_document.volume()->surface.box();
  const double extent = box.isEmpty() ? voxel : box.sizes().maxCoeff();
  const auto set = [&](Change change, const char* id, double value) {
    takeSetting(m_values[static_cast<std::size_t>(change)], id, roundedNumber(value, 2));
  };
  set(Change::Shell, "wall", std::max(4.0 * voxel, 0.03 * extent));
  set(Change::Offset, "distance", std::max(2.0 * voxel, 0.01 * extent));
  set(Change::Debris, "below", std::max(4.0 * voxel, 0.05 * extent));
  set(Change::Gaps, "radius", 3.0 * voxel);
}

void ReshapeTool::drop() {
  ++m_request;  // first: what is cancelled is reported at once
  m_services.cancel();
  m_isWorking = m_isToCommit = false;
  m_made.reset();
}

// Returns the reason why the settings have no result; null: they have.
const char* ReshapeTool::obstacle() const {
  if (const char* const why = shapingObstacle(m_document)) return why;
  if (m_document.volume()->volume.isEmpty()) return QT_TRANSLATE_NOOP("Tool", "there is no material");
  if (m_change == Change::Boolean && m_body >= m_bodies.size())
    return QT_TRANSLATE_NOOP("Tool", "no other body is open; choose a file");
  return nullptr;
}

// Returns the reason why the result is not worth a step; null: it is, or there is none.
const char* ReshapeTool::needless() const {
  const bool isSame = m_change == Change::Debris && m_made && m_made->kept == m_made->parts;
  return isSame ? QT_TRANSLATE_NOOP("Tool", "no part is that small") : nullptr;
}

void ReshapeTool::propose() {
  drop();
  if (obstacle()) return;
  m_isWorking = true;
  const std::uint64_t request = m_request;
  ReshapeServices::Job job{operation(m_change).title, {}};
  const std::weak_ptr<const int> alive = m_alive;
  job.work = [this, alive, request, change = m_change, values = values(), parts = m_parts, before = m_document.volume(),
              scan = m_document.scan(),
              other = m_change == Change::Boolean ? m_bodies[m_body].material : nullptr](Progress progress) {
    const SparseVolume& volume = before->volume;
    const Progress making = progress.part(0.0, 0.7);
    DebrisMade debris{Error{ErrorCode::Cancelled, {}, {}, {}}, parts, 0, nullptr};
    const auto made = [&]() -> Result<SparseVolume> {
      switch (change) {
        case Change::Shell:
          return makeShell(volume, values, making);
        case Change::Offset:
          return makeOffset(volume, values, making);
        case Change::Boolean: {
          const Result<SparseVolume> second = other(volume, making.part(0.0, 0.6));
          return second ? makeBoolean(volume, *second, values, making.part(0.6, 1.0)) : second;
        }
        case Change::Debris:
          debris = debrisOf(volume, values, parts, making);
          return debris.volume;
        case Change::Gaps:
          return closeGaps(volume, values, making);
        case Change::Smooth:
          break;
      }
      return smoothWhole(volume, values, making);
    }();
    const auto answer = [this, alive, request](const Result<Made>& result,
                                               const std::shared_ptr<const VolumeParts>& known) {
      return std::function<void()>([this, alive, request, result, known] {
        if (!alive.expired()) take(request, result, known);
      });
    };
    if (!made) return answer(made.error(), debris.parts);
    const auto snapshot =
        snapshotOf(*made, before->source, progress.part(0.7, 1.0), scan, {}, before->surface.pieceCells());
    if (!snapshot) return answer(snapshot.error(), debris.parts);
    auto state = std::make_shared<ClayState>();
    state->volume = (*snapshot)->volume;
    state->surface = (*snapshot)->surface;
    if (before->mask && before->mask->fits(state->volume)) state->mask = before->mask;
    auto shown = std::make_shared<VolumePreview>();
    shown->state = std::move(state);
    return answer(Made{std::move(shown), debris.gone, debris.kept, debris.parts ? debris.parts->voxels().size() : 0},
                  debris.parts);
  };
  m_services.run(std::move(job), [this, alive, request] {
    if (alive.expired() || request != m_request) return;
    m_isWorking = m_isToCommit = m_isProposing = false;
    reportUpdated();
  });
}

void ReshapeTool::take(std::uint64_t request, const Result<Made>& made, std::shared_ptr<const VolumeParts> parts) {
  if (request != m_request) return;
  m_isWorking = false;
  m_parts = std::move(parts);
  if (!made) {
    m_isToCommit = false;
    if (made.error().code != ErrorCode::Cancelled) m_services.failed(made.error());
  } else {
    m_made = *made;
    if (std::exchange(m_isToCommit, false) && !needless()) commit();
  }
  reportUpdated();
}

void ReshapeTool::commit() {
  const std::shared_ptr<const VolumePreview> made = m_made->shown;
  auto after = std::make_shared<VolumeSnapshot>(*m_document.volume());
  after->volume = made->state->volume;
  after->surface = made->state->surface;
  after->mask = made->state->mask;
  after->layers = nullptr;
  m_isProposing = false;
  const std::size_t blocks = after->volume.blockCount();
  m_document.commit(QCoreApplication::translate("Tool", operation(m_change).title),
                    std::make_unique<VolumeEdit>(std::move(after), blocks));
}

ToolReply ReshapeTool::perform(std::string_view action) {
  if (action == "revert") {
    drop();
    return ToolReply::Finished;
  }
  if (action == "file" && m_change == Change::Boolean) {
    m_services.addFile();
    return ToolReply::Used;
  }
  if (action != "commit" || obstacle() || needless()) return ToolReply::Ignored;
  if (m_made) {
    commit();
  } else {
    if (!m_isWorking) propose();
    m_isToCommit = true;
  }
  reportUpdated();
  return ToolReply::Used;
}

// Undo drops a proposal before it undoes a step of the document.
ToolReply ReshapeTool::undo() {
  if (!m_made && !m_isWorking) return ToolReply::Ignored;
  drop();
  m_isProposing = false;
  reportUpdated();
  return ToolReply::Used;
}

std::span<const ToolKey> ReshapeTool::keys() {
  return kReshapeKeys;
}

std::vector<ToolAction> ReshapeTool::actions() const {
  const char* why = m_isToCommit ? QT_TRANSLATE_NOOP("Tool", "it is being computed") : obstacle();
  if (!why) why = needless();
  ToolAction commit = actionOf(kReshapeKeys, "commit", !why);
  if (why) commit.reason = why;
  std::vector<ToolAction> all{commit};
  if (m_change == Change::Boolean) all.push_back(actionOf(kReshapeKeys, "file"));
  all.push_back(actionOf(kReshapeKeys, "revert"));
  return all;
}

ToolPreview ReshapeTool::preview() const {
  ToolPreview preview;
  if (!m_made) return preview;
  preview.ofKind = m_made->shown;
  if (m_made->gone) preview.parts = {*m_made->gone};
  return preview;
}

std::vector<Property> ReshapeTool::settings() const {
  const SparseVolume& volume = m_document.volume()->volume;
  std::vector<Property> all = {choiceSetting("change", QT_TRANSLATE_NOOP("Property", "Change"),
                                             static_cast<int>(m_change), {kChangeNames.begin(), kChangeNames.end()})};
  if (m_change == Change::Boolean) {
    std::vector<std::string> names;
    for (const OtherBody& body : m_bodies) names.push_back(body.name);
    if (!names.empty())
      all.push_back(choiceSetting("with", QT_TRANSLATE_NOOP("Property", "With"), static_cast<int>(m_body), names));
  }
  for (const Parameter& parameter : operation(m_change).parameters) all.push_back(settingOf(values(), parameter.id()));
  if (m_change == Change::Debris) {
    Property& below = all.back();
    below.continuous = true;
    below.least = 0.0;
    below.largest = m_parts && !m_parts->voxels().empty() ? diameterOf(m_parts->voxels().front(), volume.voxel())
                                                          : std::cbrt(2.0 * volume.material());
    if (m_made) {
      all.push_back(shownFigure("parts", QT_TRANSLATE_NOOP("Property", "Pieces"), static_cast<double>(m_made->parts)));
      all.push_back(shownFigure("gone", QT_TRANSLATE_NOOP("Property", "Parts that go"),
                                static_cast<double>(m_made->parts - m_made->kept)));
    }
  }
  if (m_made) {
    const double after = m_made->shown->state->volume.enclosed();
    all.push_back(shownFigure("after", QT_TRANSLATE_NOOP("Property", "Material then (mm³)"), after));
    all.push_back(
        shownFigure("difference", QT_TRANSLATE_NOOP("Property", "Difference (mm³)"), after - volume.enclosed()));
  }
  return all;
}

// Selects a body by its key, or by its index among the displayed ones, as the list may have changed since. A chosen
// body that is no longer offered stays.
void ReshapeTool::chooseBody(const PropertyValue& value) {
  std::vector<OtherBody> shown = std::exchange(m_bodies, m_services.bodies());
  std::size_t number = std::min(m_body, shown.size());
  const bool isShown = assignChoice(number, value, static_cast<int>(shown.size()));
  std::string key = number < shown.size() ? shown[number].key : std::string();
  if (const auto* const text = std::get_if<std::string>(&value)) key = *text;
  const auto isChosen = [&](const OtherBody& body) { return body.key == key; };
  const auto offered = std::find_if(m_bodies.begin(), m_bodies.end(), isChosen);
  m_body = static_cast<std::size_t>(offered - m_bodies.begin());
  if (offered != m_bodies.end()) return;
  if (const auto gone = std::find_if(shown.begin(), shown.end(), isChosen); gone != shown.end())
    return m_bodies.push_back(std::move(*gone));
  m_body = 0;
  if (!isShown) assignChoice(m_body, value, static_cast<int>(m_bodies.size()));
}

void ReshapeTool::setSetting(std::string_view id, const PropertyValue& value) {
  const OperationValues before = values();
  const Change changeBefore = m_change;
  if (id == "change") {
    assignChoice(m_change, value, kChanges);
    if (m_change != changeBefore) m_isProposing = true;
  } else if (id == "with") {
    chooseBody(value);
  } else {
    takeSetting(values(), id, value);
  }
  if (id != "with" && m_change == changeBefore && values() == before) return;
  m_isProposing = true;
  propose();
}

void ReshapeTool::documentChanged() {
  m_parts.reset();
  drop();
  if (m_isProposing) propose();
}

}  // namespace handwheel
