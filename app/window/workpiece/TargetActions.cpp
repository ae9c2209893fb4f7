// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/workpiece/TargetActions.h"

#include "controls/property/PropertyDialog.h"
#include "document/workpiece/WorkpieceDocument.h"
#include "document/workpiece/target/DeviationDisplay.h"
#include "document/workpiece/target/SectionPicture.h"
#include "document/workpiece/target/TargetEdit.h"
#include "document/workpiece/target/TargetPosition.h"
#include "document/workpiece/target/TargetReport.h"
#include "panels/LogModel.h"
#include "panels/MessageBar.h"
#include "text/ErrorText.h"
#include "text/NoteText.h"
#include "viewport/Viewport.h"
#include "window/ActionToolTip.h"
#include "window/OfferedAction.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/documents/FileDialogs.h"
#include "window/kinds/TargetPlacementView.h"
#include "window/tools/ToolHost.h"
#include "window/workpiece/TargetOutline.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <algorithm>
#include <cmath>
#include <utility>

namespace handwheel {

namespace {

// Measures a workpiece; on a worker thread.
PartMeasurement measure(const WorkpieceSnapshot& workpiece, Progress progress) {
  PartMeasurement found;
  found.zero = programZero(workpiece);
  if (const Result<TargetProfile> section = sectionOf(workpiece))
    found.features = withCurves(featuresOf(*section, workpiece.chord));
  if (workpiece.target) found.wanted = withCurves(featuresOf(workpiece.target->profile, workpiece.chord));
  if (workpiece.target) found.deviation = deviationOf(workpiece, progress);
  return found;
}

// Grades of roughness double from one to the next (ISO 1302, N4 to N10): 1.6 µm is the middle, usual for turning.
constexpr double kMiddleRoughness = 1.6, kFinishSteps = 3.0;  // µm; doublings to both ends

std::array<float, 3> componentsOf(const QColor& colour) {
  return {static_cast<float>(colour.redF()), static_cast<float>(colour.greenF()), static_cast<float>(colour.blueF())};
}

std::array<float, 3> finishColour(std::optional<double> roughness) {
  constexpr std::array<float, 3> kUnknown{0.45f, 0.45f, 0.47f};
  if (!roughness) return kUnknown;
  constexpr double kSteps = 4.0;  // colour steps per doubling
  const double doublings = std::round(kSteps * std::log2(std::max(*roughness, 1e-3) / kMiddleRoughness)) / kSteps;
  return componentsOf(ColourScale{kFinishSteps}.at(std::clamp(doublings, -kFinishSteps, kFinishSteps)));
}

QString finishLegend() {
  const QLocale locale;
  const double most = std::exp2(kFinishSteps);
  return TargetActions::tr("blue: Ra %1 µm or less, white: %2, red: %3 or more, grey: unknown")
      .arg(locale.toString(kMiddleRoughness / most), locale.toString(kMiddleRoughness),
           locale.toString(kMiddleRoughness * most));
}

}  // namespace

TargetActions::TargetActions(const WindowContext& parts, QObject* parent)
    : QObject(parent),
      m_parts(parts),
      m_import(tr("Import &target…"), this),
      m_turn(tr("Turn the target &end for end"), this),
      m_remove(tr("&Remove target"), this),
      m_outline(tr("&Target in the view"), this),
      m_colours(tr("&Deviation in colours"), this),
      m_roughness(tr("Rou&ghness in colours"), this),
      m_panel(new TargetPanel(actions(), parts.window)),
      m_measuring(JobRunner::Policy::Latest, parts.pool),
      m_layer(std::make_shared<PathLayer>()),
      m_legend(std::make_shared<LegendLayer>()) {
  m_outline.setObjectName(QStringLiteral("targetOutline"));
  m_outline.setCheckable(true);
  m_outline.setChecked(true);
  setActionToolTip(m_outline, tr("Show the outline of the target over the part"));
  parts.viewport.addLayer(m_layer);
  parts.viewport.addLayer(m_legend);
  connect(&parts.tools, &ToolHost::updated, this, &TargetActions::showLegend);
  connect(&m_outline, &QAction::toggled, this, &TargetActions::showOutline);
  connect(&parts.viewport, &Viewport::cameraChanged, this, &TargetActions::showOutline);
  m_import.setObjectName(QStringLiteral("importTarget"));
  m_turn.setObjectName(QStringLiteral("turnWorkpieceTarget"));
  m_remove.setObjectName(QStringLiteral("removeTarget"));
  m_colours.setObjectName(QStringLiteral("targetDeviation"));
  m_colours.setCheckable(true);
  m_roughness.setObjectName(QStringLiteral("finishColours"));
  m_roughness.setCheckable(true);
  setActionToolTip(m_roughness, tr("Show how rough the part is, from feed and nose of its last cuts"));
  setActionToolTip(m_import, tr("Import the target shape of the part from STEP, DXF, SVG or a workpiece"));
  setActionToolTip(m_turn, tr("Make the end at the chuck the free one, whose face is finished"));
  setActionToolTip(m_remove, tr("Do not compare the part with a target"));
  setActionToolTip(m_colours, tr("Show where the part is larger or smaller than the target"));
  connect(&m_import, &QAction::triggered, this, &TargetActions::askForFile);
  connect(&m_turn, &QAction::triggered, this, &TargetActions::turn);
  connect(&m_remove, &QAction::triggered, this,
          [this] { m_document->document.commit(tr("Remove target"), std::make_unique<TargetEdit>(nullptr)); });
  connect(&m_colours, &QAction::toggled, this, [this] { choose(m_colours, m_roughness); });
  connect(&m_roughness, &QAction::toggled, this, [this] { choose(m_roughness, m_colours); });
}

TargetActions::~TargetActions() {
  m_parts.viewport.removeLayer(*m_layer);
  m_parts.viewport.removeLayer(*m_legend);
}

void TargetActions::setVisible(bool isVisible) {
  m_isVisible = isVisible;
  showOutline();
  showLegend();
}

void TargetActions::showOutline() {
  const WorkpieceDocument* const owner = workpiece();
  const bool isShown = owner && m_isVisible && m_outline.isChecked();
  const auto target = !isShown ? nullptr : m_proposed ? m_proposed : owner->workpiece().target;
  const int facing = target ? outlineStep(m_parts.viewport.camera()) : 0;
  const bool isSame = std::exchange(m_outlined, target) == target;
  if (std::exchange(m_facing, facing) == facing && isSame) return;
  m_layer->setLines(target ? targetOutline(target->profile, facing) : nullptr);
}

// Shows the legend in the view, as for a mesh, since the panel may be hidden. A tool that cuts shows the part in its
// own colours.
void TargetActions::showLegend() {
  const Tool* const tool = m_parts.tools.runner().tool();
  const bool isCutting = tool && (tool->id() == "lathe" || tool->id() == "turn");
  const bool isShown =
      workpiece() && workpiece()->workpiece().target && m_isVisible && m_colours.isChecked() && !isCutting;
  m_legend->setScale(isShown ? std::optional(ColourScale{m_range}) : std::nullopt);
}

// One of the two is shown at a time.
void TargetActions::choose(const QAction& shown, QAction& other) {
  if (shown.isChecked()) other.setChecked(false);
  refresh();
  emit shownChanged();
}

const WorkpieceDocument* TargetActions::workpiece() const {
  return m_document ? static_cast<const WorkpieceDocument*>(&m_document->document) : nullptr;
}

void TargetActions::setDocument(DocumentTab* document) {
  if (m_document) m_document->document.disconnect(this);
  m_measuring.cancelAll();
  m_document = document;
  offer(m_import, document != nullptr && !document->document.file().assigned,
        document ? tr("The target is that of the exercise.") : tr("Open a workpiece first."));
  if (document) connect(&document->document, &Document::changed, this, &TargetActions::refresh);
  refresh();
}

void TargetActions::refresh() {
  const WorkpieceDocument* const owner = workpiece();
  const bool hasTarget = owner && owner->workpiece().target;
  const bool isAssigned = m_document && m_document->document.file().assigned;
  const QString none = owner ? tr("There is no target.") : tr("Open a workpiece first.");
  for (QAction* const change : {&m_turn, &m_remove})
    offer(*change, hasTarget && !isAssigned, isAssigned ? tr("The target is that of the exercise.") : none);
  offer(m_outline, hasTarget, none);
  offer(m_colours, hasTarget, none);
  showOutline();
  showLegend();
  if (!owner) return;
  Job job;
  job.name = tr("Measuring");
  job.document = &m_document->document;
  job.work = [this, document = m_document, value = owner->workpiece()](Progress progress) -> Job::Finish {
    PartMeasurement found = measure(value, progress);
    return [this, document, made = std::move(found)] {
      if (document == m_document) measured(made);
    };
  };
  m_measuring.start(std::move(job));
}

void TargetActions::measured(const PartMeasurement& measurement) {
  if (!m_panel) return;
  const auto& target = workpiece()->workpiece().target;
  const LengthUnit unit = m_document->document.displayUnit();
  const bool isAssigned = static_cast<bool>(m_document->document.file().assigned);
  const QString source = target ? QString::fromStdString(target->source) : QString();
  m_panel->show(measurement, isAssigned ? tr("Target of the exercise") : source, unit);
  const bool isShown = m_colours.isChecked() && target;
  if (m_roughness.isChecked())
    m_panel->setLegend(ColourScale{kFinishSteps}, finishLegend());
  else if (isShown)
    m_panel->setLegend(ColourScale{m_range}, m_panel->deviationLegend(m_range, unit));
  else
    m_panel->setLegend({}, {});
}

std::optional<DisplayModel> TargetActions::display(const WorkpieceSnapshot& workpiece) const {
  if (m_roughness.isChecked()) return finishDisplay(workpiece, finishColour);
  if (!m_colours.isChecked() || !workpiece.target) return std::nullopt;
  constexpr double kSteps = 16.0;  // colour steps on either side
  return deviationDisplay(workpiece, [scale = ColourScale{m_range}](double distance) {
    const double step = scale.range / kSteps;
    return componentsOf(scale.at(step * std::round(std::clamp(distance, -scale.range, scale.range) / step)));
  });
}

void TargetActions::askForFile() {
  QStringList patterns;
  for (const std::string& ending : targetEndings()) patterns << QStringLiteral("*") + QString::fromStdString(ending);
  auto* dialog = new QFileDialog(m_parts.window, tr("Import a target"), QString(),
                                 tr("Turned parts (%1)").arg(patterns.join(QLatin1Char(' '))));
  dialog->setObjectName(QStringLiteral("targetDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  beginInFolderOf(*dialog, QStringLiteral("targets"));
  connect(dialog, &QFileDialog::fileSelected, this, [this, document = m_document](const QString& path) {
    if (m_parts.tabs.contains(document)) importFrom(document, path);
  });
  dialog->open();
}

void TargetActions::importFrom(DocumentTab* document, const QString& path) {
  Job job;
  job.name = tr("Reading %1").arg(QFileInfo(path).fileName());
  job.document = &document->document;
  const auto failed = [this, path](const Error& error) {
    if (error.code == ErrorCode::Cancelled) return;
    emit message({Message::Weight::Error, tr("%1 cannot be used as a target").arg(QFileInfo(path).fileName()),
                  errorSentence(error), errorAdvice(error)});
  };
  job.work = [this, document, path, failed](Progress progress) -> Job::Finish {
    const Result<ImportedTarget> imported = importTarget(path.toStdString(), UnturnedFaces::Refuse, progress);
    if (!imported) return [failed, error = imported.error()] { failed(error); };
    return [this, document, path, made = *imported] { askForPosition(document, made, path); };
  };
  job.failed = failed;
  m_parts.jobs.start(std::move(job));
}

// Asks where in the bar it lies, and shows it there meanwhile.
void TargetActions::askForPosition(DocumentTab* document, const ImportedTarget& imported, const QString& path) {
  if (!m_parts.tabs.contains(document)) return;
  const StockCylinder stock = static_cast<const WorkpieceDocument&>(document->document).workpiece().stock;
  // State of this dialog: there may be another one behind it.
  const auto proposed = std::make_shared<std::shared_ptr<const WorkpieceTarget>>(placedTarget(imported, stock));
  const auto intro = [proposed] {
    return tr("The finished face of the part is zero of the drawing and of programs. The bar goes beyond it by what is "
              "left "
              "for facing. It can be changed later in the panel Stock.") +
           QLatin1Char('\n') + noteText(endsNote((*proposed)->profile));
  };
  auto* view = new TargetPlacementView;
  const auto show = [this, document, proposed, stock, view] {
    propose(document, *proposed);
    view->setPicture(targetInBar(stock, (*proposed)->profile));
  };
  const auto change = [proposed, show](TargetProfile profile) {
    *proposed = std::make_shared<const WorkpieceTarget>(WorkpieceTarget{std::move(profile), (*proposed)->source});
    show();
  };
  auto* dialog = new PropertyDialog(
      {tr("Where the target lies"), intro(), tr("&Import")},
      [proposed, stock] { return positionProperties((*proposed)->profile, stock); },
      [proposed, stock, change](const std::string&, const PropertyValue& value) -> Status {
        Result<TargetProfile> placed = withPosition((*proposed)->profile, stock, value);
        if (!placed) return placed.error();
        change(std::move(*placed));
        return Done{};
      },
      m_parts.window);
  dialog->addView(view);
  show();  // once the view is in the dialog, for by itself it would be a window
  connect(view, &TargetPlacementView::turned, dialog, [proposed, change, intro, dialog] {
    change((*proposed)->profile.turnedEndForEnd());
    dialog->setIntro(intro());
    dialog->refresh();
  });
  dialog->setObjectName(QStringLiteral("targetPlaceDialog"));
  dialog->setModal(true);
  dialog->setLengthUnit(document->document.displayUnit());
  connect(dialog, &QDialog::finished, this, [this, document, proposed, imported, path](int result) {
    if (m_proposed == *proposed) m_proposed = nullptr;
    if (result == QDialog::Accepted) take(document, *proposed, imported, path);
    showOutline();
  });
  dialog->open();
}

void TargetActions::turn() {
  const std::shared_ptr<const WorkpieceTarget> target = workpiece() ? workpiece()->workpiece().target : nullptr;
  if (!target) return;
  const WorkpieceTarget turned{target->profile.turnedEndForEnd(), target->source};
  m_document->document.commit(tr("Turn the target end for end"),
                              std::make_unique<TargetEdit>(std::make_shared<const WorkpieceTarget>(turned)));
}

void TargetActions::propose(DocumentTab* document, std::shared_ptr<const WorkpieceTarget> target) {
  m_proposed = std::move(target);
  if (document == m_document) showOutline();
}

void TargetActions::take(DocumentTab* document, const std::shared_ptr<const WorkpieceTarget>& target,
                         const ImportedTarget& imported, const QString& path) {
  if (!target || !m_parts.tabs.contains(document)) return;
  document->document.commit(tr("Import target"), std::make_unique<TargetEdit>(target));
  m_parts.log.add(tr("Target read from %1").arg(QFileInfo(path).fileName()));
  for (const Note& note : imported.notes) m_parts.log.add(noteText(note));
}

}  // namespace handwheel
