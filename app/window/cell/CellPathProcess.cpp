// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Fields of paths, and those along curves on parts: planned, and planned anew when their process is changed.
#include "document/cell/RobotCellDocument.h"
#include "document/cell/WaypointProperties.h"
#include "tools/cell/ProcessPathSettings.h"
#include "window/JobRunner.h"
#include "window/cell/CellPaths.h"
#include "window/cell/PathStatus.h"
#include "window/documents/DocumentTab.h"

namespace handwheel {

namespace {

const std::string kField = "process.";  // Prefix of the ids of the fields

Property measureToRead(const char* id, const char* label, const QString& text) {
  Property property{
      .id = id, .group = QT_TRANSLATE_NOOP("Property", "Path"), .label = label, .value = text.toStdString()};
  property.editable = false;
  return property;
}

// Returns the measures by which planners compare paths.
std::vector<Property> measuresOf(const PathFindings& found, LengthUnit unit) {
  constexpr double kSumRounding = 1e-6;  // mm: the mean of many that are as far as is measured is so, too
  const QLocale locale;
  std::vector<Property> all{measureToRead("path.time", QT_TRANSLATE_NOOP("Property", "Cycle time"),
                                          locale.toString(found.seconds, 'f', 2) + QStringLiteral(" s"))};
  if (!found.measures) return all;
  const auto& [length, security, manipulability, slid] = *found.measures;
  const QString ofSlides = slid > 0.0 ? QStringLiteral(", %1 mm").arg(locale.toString(slid, 'f', 1)) : QString();
  all.push_back(measureToRead("path.length", QT_TRANSLATE_NOOP("Property", "Length"),
                              locale.toString(length, 'f', 3) + QStringLiteral(" rad") + ofSlides));
  all.push_back(measureToRead("path.security", QT_TRANSLATE_NOOP("Property", "Security index"),
                              clearanceText(security + kSumRounding, unit, locale)));
  all.push_back(measureToRead("path.manipulability", QT_TRANSLATE_NOOP("Property", "Manipulability"),
                              locale.toString(manipulability, 'g', 3)));
  return all;
}

}  // namespace

void CellPaths::planProcess(const OperationValues& values, std::shared_ptr<const PartSurface> surface) {
  PlanRequest request{plans().freePathName(tr("Process").toStdString()), tr("Plan %1"),
                      [this, values] { planProcess(values, nullptr); }};  // the part may be another one then
  request.part = values.text("part");
  startPlanning(processPlanning(values, std::move(surface), std::nullopt), std::move(request));
}

CellPaths::Planning CellPaths::processPlanning(const OperationValues& values,
                                               std::shared_ptr<const PartSurface> surface,
                                               const std::optional<Pose>& chosenAt) {
  return [values, surface = std::move(surface), chosenAt](const CellScene& scene, const RobotCellSnapshot& content,
                                                          Progress progress) -> Result<PlannedPath> {
    const Result<BodyPointer> part = partCalled(values, scene);
    if (!part) return part.error();
    const auto own = surface ? surface : std::make_shared<const PartSurface>(*(*part)->geometry->surface());
    return processPath(scene, content, values, own, **part, progress, chosenAt);
  };
}

std::vector<Property> CellPaths::resultProperties() const {
  const PlanTree::Entry entry = m_tree->current();
  const RobotPath* const of = entry.kind == PlanTree::Entry::Kind::Path ? plans().path(entry.name) : nullptr;
  if (!of) return {};
  Property result{
      .id = "path.result",
      .group = QT_TRANSLATE_NOOP("Property", "Path"),
      .label = QT_TRANSLATE_NOOP("Property", "Verification"),
      .value = pathStatusOf(m_checks.stateOf(*of), *of, cell().displayUnit(), QLocale()).summary.toStdString()};
  result.editable = false;
  std::vector<Property> all{std::move(result)};
  if (!of->process) all.push_back(clearanceProperty(*of, plans()));  // else it is a field of the process
  const PathChecks::State state = m_checks.stateOf(*of);
  const bool isMeasured = state.last && state.last->found && state.change == BasisChange::Nothing;
  for (Property& each : isMeasured ? measuresOf(*state.last->found, cell().displayUnit()) : std::vector<Property>())
    all.push_back(std::move(each));
  return all;
}

const CellPaths::WantedProcess* CellPaths::wanted(const std::string& path) const {
  const auto found = m_wanted.find(m_document);
  return found != m_wanted.end() && found->second.path == path ? &found->second : nullptr;
}

// While the path is planned anew the fields show what was entered.
std::vector<Property> CellPaths::processProperties() const {
  const RobotPath* const present = path();
  if (m_tree->current().kind != PlanTree::Entry::Kind::Path || !present || !present->process) return {};
  const WantedProcess* const now = wanted(present->name);
  std::vector<Property> all =
      settingsOfStoredPath(now ? now->values : valuesOf(*present->process), processEnds(cell().robot(), plans()));
  for (Property& each : all) each.id = kField + each.id;
  return all;
}

bool CellPaths::takeProcessEdit(const std::string& id, const PropertyValue& value, bool stillDragging) {
  const RobotPath* const present = path();
  if (!id.starts_with(kField) || !present || !present->process) return false;
  if (stillDragging) return true;
  const std::string name = present->name;
  const WantedProcess* const now = wanted(name);
  OperationValues values = now ? now->values : valuesOf(*present->process);
  takeProcessSetting(values, processEnds(cell().robot(), plans()), std::string_view(id).substr(kField.size()), value);
  remakeProcess(name, values);
  return true;
}

// In one step that can be undone; what was entered before and is not planned yet comes with it.
void CellPaths::remakeProcess(const std::string& name, const OperationValues& values) {
  const RobotPath* const present = plans().path(name);
  if (!present || !present->process) return;
  DocumentTab* const tab = m_document;
  if (const auto last = m_wanted.find(tab); last != m_wanted.end()) m_parts.jobs.cancelOf(&last->second);
  const std::uint64_t number = ++m_remakes;
  const WantedProcess& kept = m_wanted.insert_or_assign(tab, WantedProcess{name, values, number}).first->second;
  emit rowChanged();
  PlanRequest request{name, tr("Change the process of %1"), [this, name, values] { remakeProcess(name, values); }};
  request.owner = &kept;
  request.ended = [this, tab, number] {
    const auto found = m_wanted.find(tab);
    if (found == m_wanted.end() || found->second.number != number) return;
    m_wanted.erase(found);
    if (tab == m_document) emit rowChanged();
  };
  startPlanning(processPlanning(values, nullptr, present->process->part), std::move(request));
}

}  // namespace handwheel
