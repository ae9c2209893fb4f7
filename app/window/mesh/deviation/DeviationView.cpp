// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/mesh/deviation/DeviationView.h"

#include "document/mesh/MeshKind.h"
#include "panels/LogModel.h"
#include "panels/MessageBar.h"
#include "report/DeviationReport.h"
#include "text/ErrorText.h"
#include "theme/Icons.h"
#include "viewport/Viewport.h"
#include "viewport/surface/MeshLayer.h"
#include "window/ActionToolTip.h"
#include "window/CommandLines.h"
#include "window/JobRunner.h"
#include "window/documents/DiscardedResult.h"
#include "window/documents/DocumentTabs.h"
#include "window/documents/FileDialogs.h"
#include "window/documents/FileFilters.h"
#include "window/documents/FileSaver.h"
#include "window/mesh/MeshReading.h"
#include "window/mesh/MeshTab.h"
#include "window/mesh/UnobstructedView.h"
#include "window/mesh/deviation/MeshDeviation.h"

#include <QCursor>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QToolTip>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kZoomShare = 0.08;      // share of the model's diagonal that the camera shows around a point
constexpr std::size_t kFineBins = 4000;  // from which the histogram of any range is made

Result<std::shared_ptr<MeshDeviation>> compared(const HalfEdgeMesh& mesh, const HalfEdgeMesh& scan, Progress progress) {
  auto found = std::make_shared<MeshDeviation>();
  found->scan = std::make_shared<const SurfaceDistance>(scan, progress.part(0.0, 0.1));
  const SurfaceDistance surface(mesh, progress.part(0.1, 0.2));
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  Result<Deviation> statistics =
      deviation(surface, *found->scan, {.bins = kFineBins, .measuresBound = true}, progress.part(0.2, 1.0));
  if (!statistics) return statistics.error();
  found->statistics = std::move(statistics.value());
  found->atVertex = std::make_shared<const std::vector<double>>(std::move(found->statistics.ofMesh.atVertex));
  found->diagonal = found->scan->hierarchy().bounds().diagonal().norm();
  found->scale.range = QString::number(defaultRange(found->ofMesh()), 'g', 3).toDouble();  // to be read at a glance
  return found;
}

}  // namespace

DeviationView::DeviationView(const WindowContext& parts, MeshLayer& layer, QObject* parent)
    : QObject(parent),
      m_parts(parts),
      m_layer(layer),
      m_action(icon(QStringLiteral("deviation")), tr("De&viation…"), this),
      m_panel(new DeviationPanel(parts.window)) {
  m_action.setObjectName(QStringLiteral("deviation"));
  m_action.setShortcut(QKeySequence(Qt::Key_D));
  setActionToolTip(m_action, tr("Show the deviation of the mesh from the opened file in colours"));
  connect(&m_action, &QAction::triggered, this, [this] {
    if (m_document->deviation) return close();
    if (!m_parts.isPanelVisible()) m_parts.showPanel->trigger();
    compare(m_document, {}, Round::First);
  });
  connect(m_panel, &DeviationPanel::closed, this, &DeviationView::close);
  connect(m_panel, &DeviationPanel::otherFileRequested, this, &DeviationView::askForFile);
  connect(m_panel, &DeviationPanel::reportRequested, this, &DeviationView::askForReport);
  connect(m_panel, &DeviationPanel::positionChosen, this, &DeviationView::flyTo);
  connect(m_panel, &DeviationPanel::rangeChosen, this, [this](double range) {
    m_document->deviation->scale.range = range;
    m_layer.setColourScale(m_document->deviation->scale);
  });
  connect(&m_parts.tabs, &DocumentTabs::closing, this, [this](const DocumentTab* document) { stop(document); });
  connect(&m_parts.viewport, &Viewport::hovered, this, &DeviationView::read);
}

void DeviationView::setDocument(MeshTab* document) {
  if (m_document) m_document->document.disconnect(this);
  m_document = document;
  m_action.setEnabled(document != nullptr);
  if (!document) {
    if (m_panel) m_panel->show(nullptr, LengthUnit::Millimetre);
    return emit shownChanged();
  }
  connect(&document->document, &MeshDocument::meshChanged, this, &DeviationView::refresh);
  connect(&document->document, &Document::fileChanged, this, &DeviationView::refresh);  // its unit
  refresh();
}

bool DeviationView::isShown() const {
  return m_document && (m_document->deviation || isRunning(m_document));
}

void DeviationView::refresh() {
  std::shared_ptr<MeshDeviation>& found = m_document->deviation;
  if (found && found->changes != m_document->changes) found.reset();
  found ? m_layer.setSurfaceValues(found->atVertex, found->scale) : m_layer.setSurfaceValues(nullptr, {});
  if (m_panel)
    m_panel->show(found.get(), m_document->document.displayUnit(),
                  isRunning(m_document) ? tr("Comparing…") : QString());
  emit shownChanged();
}

void DeviationView::compare(MeshTab* document, const QString& path, Round round) {
  stop(document);
  const auto running = m_running.emplace(document, ++m_requests).first;
  Job job;
  job.name = tr("Comparing %1").arg(document->document.name());
  job.document = &document->document;
  job.owner = &running->second;
  job.lane = Job::Lane::Looking;
  job.work = [this, document, path, round, request = m_requests, changes = document->changes,
              mesh = document->document.mesh(), opened = document->asOpened](Progress progress) -> Job::Finish {
    const Result<HalfEdgeMesh> scan =
        path.isEmpty() ? Result<HalfEdgeMesh>(opened) : readMesh(m_parts.kinds, path, progress.part(0.0, 0.2));
    Result<std::shared_ptr<MeshDeviation>> found =
        scan ? compared(mesh, *scan, progress.part(0.2, 1.0)) : Result<std::shared_ptr<MeshDeviation>>(scan.error());
    if (!found) return [this, document, request, error = found.error()] { fail(document, request, error); };
    (*found)->file = path;
    (*found)->changes = changes;
    return [this, document, request, round, made = *found] {
      if (isRunning(document, request)) take(document, made, round);
    };
  };
  job.failed = [this, document, request = m_requests](const Error& error) { fail(document, request, error); };
  m_parts.jobs.start(std::move(job));
  refresh();
}

void DeviationView::take(MeshTab* document, std::shared_ptr<MeshDeviation> found, Round round) {
  const bool isStale = found->changes != document->changes;
  if (isStale && round == Round::First) return compare(document, found->file, Round::Second);
  m_running.erase(document);
  if (!isStale) {
    const QString largest = QLocale().toString(found->ofMesh().farthest().distance, 'g', 4);
    const QString command = !found->file.isEmpty() && document->isAsInFile() && !document->document.isModified()
                                ? compareCommand(document->document.path(), found->file)
                                : QString();
    m_parts.log.add(tr("Compared %1: largest distance %2 mm").arg(document->document.name(), largest), command);
    document->deviation = std::move(found);
  } else {
    emit message(discardedResultMessage(tr("Comparing %1").arg(document->document.name()), document->document));
  }
  if (document == m_document) refresh();
}

void DeviationView::fail(MeshTab* document, std::uint64_t request, const Error& error) {
  if (!isRunning(document, request)) return;
  m_running.erase(document);
  if (document == m_document) refresh();
  if (error.code == ErrorCode::Cancelled) return;
  emit message({Message::Weight::Error,
                tr("The meshes could not be compared"),
                errorSentence(error),
                errorAdvice(error),
                {},
                {},
                {},
                {},
                &document->document});
}

void DeviationView::stop(const DocumentTab* document) {
  const auto running = m_running.extract(document);
  if (!running.empty()) m_parts.jobs.cancelOf(&running.mapped());
}

bool DeviationView::isRunning(const DocumentTab* document, std::uint64_t request) const {
  const auto running = m_running.find(document);
  return running != m_running.end() && (request == 0 || running->second == request);
}

void DeviationView::close() {
  stop(m_document);
  m_document->deviation.reset();
  refresh();
}

void DeviationView::askForFile() {
  auto* dialog = openingDialog(m_parts.window, m_document->document, tr("Compare with"),
                               openFilters(m_parts.kinds).join(QStringLiteral(";;")));
  dialog->setObjectName(QStringLiteral("compareDialog"));
  connect(dialog, &QFileDialog::fileSelected, this, [this, document = m_document](const QString& path) {
    if (m_parts.tabs.contains(document) && document == m_document) compare(document, path, Round::First);
  });
  dialog->open();
}

void DeviationView::askForReport() {
  auto* dialog = new QFileDialog(m_parts.window, tr("Save report"));
  dialog->setObjectName(QStringLiteral("reportDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setNameFilters({tr("Report (*.pdf *.html *.json)")});
  const QFileInfo file(m_document->document.path());
  dialog->setDirectory(file.path());
  dialog->setDefaultSuffix(QStringLiteral("pdf"));
  dialog->selectFile(file.completeBaseName() + QStringLiteral("-deviation.pdf"));
  connect(dialog, &QFileDialog::fileSelected, this, [this, document = m_document](const QString& path) {
    if (m_parts.tabs.contains(document) && document == m_document && document->deviation) saveReport(path);
  });
  dialog->open();
}

// Runs as a job: the pictures are drawn beside the window, which goes on working.
void DeviationView::saveReport(const QString& path) {
  const std::shared_ptr<const MeshDeviation> found = m_document->deviation;
  Comparison comparison;
  comparison.mesh = m_document->document.path().toStdString();
  comparison.scan = found->file.isEmpty() ? tr("as it was opened").toStdString() : found->file.toStdString();
  comparison.deviation = found->statistics;
  Job job;
  job.name = tr("Saving %1").arg(QFileInfo(path).fileName());
  job.document = &m_document->document;
  job.lane = Job::Lane::Saving;
  job.resource = path;
  job.work = [this, path, found, comparison = std::move(comparison),
              mesh = m_document->document.mesh()](Progress progress) mutable -> Job::Finish {
    const Result<QImage> picture = deviationPicture(mesh, found->atVertex, found->scale, progress);
    if (picture) comparison.picture = *picture;
    const Status written = progress.cancelled() ? Status(Error{ErrorCode::Cancelled, {}, {}, {}})
                                                : writeReport(comparison, QFile::encodeName(path).toStdString());
    std::optional<Error> problem;
    if (!picture) problem = picture.error();
    if (!written) problem = written.error();
    return [this, path, problem] { reportSaved(path, problem); };
  };
  job.failed = [this, path](const Error& error) { reportSaved(path, error); };
  m_parts.jobs.start(std::move(job));
}

// A report without pictures is better than none; but one hears of it.
void DeviationView::reportSaved(const QString& path, const std::optional<Error>& problem) {
  if (problem && problem->code == ErrorCode::Cancelled) return emit message(FileSaver::cancelledMessage(path));
  const QString name = QFileInfo(path).fileName();
  if (!problem) return m_parts.log.add(tr("Saved the report %1").arg(name));
  emit message({Message::Weight::Warning,
                QFileInfo::exists(path) ? tr("%1 has no pictures").arg(name) : tr("%1 could not be saved").arg(name),
                errorSentence(*problem),
                errorAdvice(*problem),
                {},
                {}});
}

void DeviationView::flyTo(const DeviationExtremum& extremum) {
  const Vec3 around = Vec3::Constant(0.5 * kZoomShare / std::sqrt(3.0) * m_document->deviation->diagonal);
  const Vec3 outward = (extremum.distance < 0.0 ? -1.0 : 1.0) * (extremum.position - extremum.nearest);
  const Box box(extremum.position - around, extremum.position + around);
  m_parts.viewport.flyTo(box, unobstructedDirection(m_document->document.mesh(), box, outward));
}

void DeviationView::read(const Pick& pick) {
  if (!m_panel || !m_document || !m_document->deviation) return;
  const auto nearest = faceOf(pick) == kNone ? std::nullopt : m_document->deviation->scan->from(pick.point);
  m_panel->setReading(nearest ? std::optional(nearest->distance) : std::nullopt);
  nearest ? QToolTip::showText(QCursor::pos(), m_panel->reading(), &m_parts.viewport) : QToolTip::hideText();
}

}  // namespace handwheel
