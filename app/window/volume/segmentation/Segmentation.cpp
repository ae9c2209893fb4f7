// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/volume/segmentation/Segmentation.h"

#include "controls/ScrolledPanel.h"
#include "document/volume/SegmentEdit.h"
#include "document/volume/VolumeDocument.h"
#include "document/volume/VolumeEdit.h"
#include "document/volume/VolumeMaking.h"
#include "panels/DockTitle.h"
#include "panels/MessageBar.h"
#include "text/ErrorText.h"
#include "volume/segment/SegmentBrush.h"
#include "volume/segment/SegmentSmoothing.h"
#include "volume/segment/SegmentToVolume.h"
#include "window/ActionToolTip.h"
#include "window/MemoryQuestion.h"
#include "window/documents/DocumentTab.h"
#include "window/volume/segmentation/SlicesPanel.h"

#include <QDockWidget>
#include <QLocale>
#include <QMainWindow>
#include <algorithm>
#include <cmath>
#include <utility>

namespace handwheel {

namespace {

// From the darkest to nearly the brightest values: few samples of metal do not make all others dark.
GreyWindow usualGreys(const ImageHistogram& histogram) {
  const double black = histogram.quantile(0.01), white = histogram.quantile(0.998);
  const double width = std::max(white - black, histogram.width());
  // Rounds to integers if the range spans hundreds.
  const double unit = width > 100.0 ? 1.0 : 1e-3 * width;
  return width > 0.0 ? GreyWindow{unit * std::round((black + 0.5 * width) / unit), unit * std::round(width / unit)}
                     : GreyWindow{black, 1.0};
}

}  // namespace

Segmentation::Segmentation(const WindowContext& parts, QObject* parent)
    : QObject(parent),
      m_parts(parts),
      m_toggle(tr("&Segmentation"), this),
      m_counting(JobRunner::Policy::Latest, parts.pool) {
  prepare(m_toggle, "segmentationToggle", "kind-volume", tr("Choose the material of a scan in its slices"));
  m_toggle.setCheckable(true);
  m_toggle.setChecked(true);
  m_toggle.setEnabled(false);
  connect(&m_toggle, &QAction::triggered, this, &Segmentation::show);
  constexpr int kPauseMs = 150;
  m_pause.setSingleShot(true);
  m_pause.setInterval(kPauseMs);
  connect(&m_pause, &QTimer::timeout, this, &Segmentation::count);
}

VolumeDocument& Segmentation::volume() const {
  return static_cast<VolumeDocument&>(m_document->document);
}

bool Segmentation::isOlder() const {
  return volume().volume()->madeFrom != volume().segment();
}

void Segmentation::makeDocks() {
  auto* const window = qobject_cast<QMainWindow*>(m_parts.window);
  if (m_panelDock || !window) return;
  const auto dock = [&](const QString& title, const char* name) {
    auto* const made = new QDockWidget(title, window);
    made->setObjectName(QString::fromLatin1(name));
    made->setAccessibleName(title);
    made->setTitleBarWidget(new DockTitle(made));
    connect(made, &QDockWidget::visibilityChanged, this, [this] {
      if (m_document) m_toggle.setChecked(!m_panelDock->isHidden() || !m_slicesDock->isHidden());
    });
    return made;
  };
  m_panelDock = dock(tr("Segmentation"), "segmentationDock");
  m_slicesDock = dock(tr("Slices"), "slicesDock");
  m_panel = new SegmentationPanel(m_panelDock);
  m_slices = new SlicesPanel(m_slicesDock);
  m_panelDock->setWidget(new ScrolledPanel(m_panel, ScrolledPanel::Directions::Both, m_panelDock));
  m_slicesDock->setWidget(m_slices);
  window->addDockWidget(Qt::RightDockWidgetArea, m_panelDock);
  if (auto* kind = window->findChild<QDockWidget*>(QStringLiteral("kindDock")))
    window->tabifyDockWidget(kind, m_panelDock);
  window->addDockWidget(Qt::BottomDockWidgetArea, m_slicesDock);
  constexpr int kUsualHeight = 330;  // pixels
  window->resizeDocks({m_slicesDock}, {kUsualHeight}, Qt::Vertical);
  connect(m_panel, &SegmentationPanel::rangeEdited, this, &Segmentation::setRange);
  connect(m_panel, &SegmentationPanel::firstPartsKept, this, &Segmentation::keepFirst);
  connect(m_panel, &SegmentationPanel::smoothingRequested, this, [this] {
    change(tr("Smoothing the segment"), tr("Smooth segment"),
           [](const Scan& scan, const Segment& segment, const SegmentParts&, Progress progress) {
             return Changed{smoothed(scan.image, segment, progress)};
           });
  });
  connect(m_panel, &SegmentationPanel::brushChanged, this, &Segmentation::setBrush);
  connect(m_panel, &SegmentationPanel::greysEdited, this, &Segmentation::setGreys);
  connect(m_panel, &SegmentationPanel::surfaceRequested, this, &Segmentation::askForSurface);
  connectSlices();
}

void Segmentation::connectSlices() {
  m_slices->setMirrored(m_panel->isLeftAtLeft());
  connect(m_panel, &SegmentationPanel::sidesChanged, m_slices, &SlicesPanel::setMirrored);
  connect(m_slices, &SlicesPanel::crosshairMoved, m_panel, &SegmentationPanel::setPosition);
  for (SliceCanvas* canvas : m_slices->canvases()) {
    connect(canvas, &SliceCanvas::greysEdited, this, &Segmentation::setGreys);
    connect(canvas, &SliceCanvas::strokeBegan, this, &Segmentation::begin);
    connect(canvas, &SliceCanvas::strokeMoved, this, &Segmentation::paint);
    connect(canvas, &SliceCanvas::strokeEnded, this, &Segmentation::endStroke);
    connect(canvas, &SliceCanvas::grown, this, &Segmentation::grow);
    connect(canvas, &SliceCanvas::radiusStepped, m_panel, &SegmentationPanel::stepRadius);
  }
}

void Segmentation::setDocument(DocumentTab* document) {
  if (document && !static_cast<VolumeDocument&>(document->document).scan()) document = nullptr;
  if (m_document) {
    endStroke();
    m_document->document.disconnect(this);
  }
  m_pause.stop();
  m_counting.cancelAll();
  m_document = document;
  m_toggle.setEnabled(document != nullptr);
  if (document) {
    makeDocks();
    const std::shared_ptr<const Scan>& scan = volume().scan();
    m_panel->setScan(scan);
    m_slices->setScan(scan);
    m_panel->setPosition(m_slices->crosshair());
    setGreys(usualGreys(scan->histogram));
    setBrush();
    m_figures = {};
    m_shown = volume().segment();
    m_panel->setSegment(m_shown);
    m_panel->setOlder(isOlder());
    m_slices->setSegment(m_shown);
    m_pause.start();
    connect(&document->document, &Document::changed, this, &Segmentation::refresh);
    connect(&document->document, &Document::settling, this, &Segmentation::endStroke);
  } else if (m_panel) {
    m_panel->setScan(nullptr);
    m_slices->setScan(nullptr);
  }
  show();
}

void Segmentation::forget(DocumentTab* document) {
  std::erase_if(m_waiting, [&](const Waiting& waiting) { return waiting.document == &document->document; });
}

void Segmentation::show() {
  if (!m_panelDock) return;
  const bool isShown = isOpen();
  m_panelDock->setVisible(isShown);
  m_slicesDock->setVisible(isShown);
  // Deferred until the window has raised the panel of the kind, and the dock has its tab.
  QTimer::singleShot(0, this, [this] {
    if (isOpen()) m_panelDock->raise();
  });
}

void Segmentation::refresh() {
  const Segment& segment = volume().segment();
  m_panel->setOlder(isOlder());
  if (segment == m_shown) return;
  dropStroke();  // a stroke does not continue after an undo
  m_shown = segment;
  m_panel->setSegment(segment);
  m_slices->setSegment(segment);
  m_counting.cancelAll();
  m_pause.start();
}

void Segmentation::count() {
  Job job;
  job.name = tr("Counting parts");
  job.work = [this, scan = volume().scan(), segment = volume().segment()](Progress progress) -> Job::Finish {
    const SegmentStatistics figures{std::make_shared<const SegmentParts>(scan->image, segment, progress.part(0.0, 0.7)),
                                    facesOf(scan->image, segment, progress.part(0.7, 1.0))};
    if (progress.cancelled()) return {};
    return [this, figures, segment] {
      if (!m_document || !(volume().segment() == segment)) return;
      m_figures = figures;
      m_counted = segment;
      m_panel->setFigures(figures);
    };
  };
  job.failed = [this, segment = volume().segment()](const Error& error) {
    if (error.code == ErrorCode::Cancelled || !m_document || !(volume().segment() == segment)) return;
    m_panel->setUncounted();
    fail(volume(), tr("Counting parts"), errorSentence(error));
  };
  m_counting.start(std::move(job));
}

void Segmentation::commit(Segment segment, const QString& text) {
  if (segment == volume().segment()) return refresh();
  const Segment& before = volume().segment();
  volume().commit(text, std::make_unique<SegmentEdit>(std::move(segment), before));
}

// While a handle is dragged the slices show what would be chosen.
void Segmentation::setRange(const ValueRange& range, bool stillDragging) {
  if (!m_document) return;
  dropStroke();
  if (!stillDragging) return commit(Segment(range), tr("Choose values"));
  m_shown = Segment(range);
  m_slices->setSegment(m_shown);
}

void Segmentation::setBrush() {
  const SegmentationPanel::Brush brush = m_panel->brush();
  m_slices->setAction(brush.action, brush.radius);
}

void Segmentation::setGreys(const GreyWindow& greys) {
  m_panel->setGreys(greys);
  m_slices->setGreys(greys);
}

void Segmentation::begin(int through, const Vec3& index, bool opposite) {
  if (!m_document) return;
  endStroke();
  const SegmentationPanel::Brush brush = m_panel->brush();
  m_stroke = Stroke{volume().segment(), brush.isBall ? std::nullopt : std::optional(through), brush.radius,
                    (brush.action == SliceAction::Erase) != opposite, index};
  paint(index);
}

void Segmentation::paint(const Vec3& index) {
  if (!m_stroke) return;
  const SegmentBrush brush{m_stroke->radius, m_stroke->isErasing, m_stroke->plane};
  applyBrush(m_stroke->segment, volume().scan()->image, brush, m_stroke->last, index);
  m_stroke->last = index;
  m_slices->setSegment(m_stroke->segment);
}

void Segmentation::endStroke() {
  if (const std::optional<Stroke> stroke = std::exchange(m_stroke, std::nullopt))
    commit(stroke->segment, stroke->isErasing ? tr("Erase from segment") : tr("Paint segment"));
  commitWaiting();
}

// The waiting commits may be triggered in the middle of an undo, so they run after it.
void Segmentation::dropStroke() {
  if (!m_stroke) return;
  m_stroke.reset();
  QMetaObject::invokeMethod(this, &Segmentation::commitWaiting, Qt::QueuedConnection);
}

void Segmentation::commitWaiting() {
  if (m_stroke) return;
  for (const Waiting& waiting : std::exchange(m_waiting, {})) waiting.commit();
}

void Segmentation::afterStroke(const Document& document, std::function<void()> commit) {
  if (!m_stroke || &m_document->document != &document) return commit();
  m_waiting.push_back({&document, std::move(commit)});
}

void Segmentation::change(const QString& name, const QString& text, const Change& how) {
  if (!m_document) return;
  endStroke();
  startChange(&volume(), name, text, how);
}

// Another document may be in view by the end.
void Segmentation::startChange(VolumeDocument* document, const QString& name, const QString& text, const Change& how) {
  Job job;
  job.name = name;
  job.document = document;
  const Segment before = document->segment();
  const bool isCurrent = m_document && &m_document->document == document;
  const std::shared_ptr<const SegmentParts> known = isCurrent && m_counted == before ? m_figures.parts : nullptr;
  job.work = [this, document, name, text, how, before, known,
              scan = document->scan()](Progress progress) -> Job::Finish {
    const std::shared_ptr<const SegmentParts> parts =
        known ? known : std::make_shared<const SegmentParts>(scan->image, before, progress.part(0.0, 0.5));
    if (progress.cancelled()) return {};
    const Changed changed = how(*scan, before, *parts, progress.part(0.5, 1.0));
    if (progress.cancelled()) return {};
    const auto finish = [this, document, name, text, how, before, changed] {
      if (!(document->segment() == before)) return startChange(document, name, text, how);
      if (!changed.segment) return fail(*document, text, changed.problem);
      document->commit(text, std::make_unique<SegmentEdit>(*changed.segment, before));
    };
    return [this, document, finish] { afterStroke(*document, finish); };
  };
  job.failed = [this, document, text](const Error& error) {
    if (error.code != ErrorCode::Cancelled) fail(*document, text, errorSentence(error));
  };
  m_parts.jobs.start(std::move(job));
}

void Segmentation::keepFirst(int count) {
  change(tr("Keeping the largest parts"), tr("Keep %n largest part(s)", nullptr, count),
         [count](const Scan&, const Segment&, const SegmentParts& parts, Progress) {
           return Changed{parts.only(0, static_cast<std::size_t>(count))};
         });
}

void Segmentation::grow(const Vec3& index) {
  const VoxelIndex at = index.array().round().matrix().cast<int>();
  change(tr("Growing from the point"), tr("Grow from point"),
         [at](const Scan& scan, const Segment&, const SegmentParts& parts, Progress) {
           if (const auto part = parts.partAt(at)) return Changed{parts.only(*part, *part + 1)};
           const std::array<int, 3>& size = scan.image.grid().size;
           const double value = scan.image.value((static_cast<std::size_t>(at.z()) * static_cast<std::size_t>(size[1]) +
                                                  static_cast<std::size_t>(at.y())) *
                                                     static_cast<std::size_t>(size[0]) +
                                                 static_cast<std::size_t>(at.x()));
           return Changed{{},
                          tr("The point (value %1) is not in the segment. Click a coloured place, or choose a range "
                             "that includes this value.")
                              .arg(QLocale().toString(value, 'g', 6))};
         });
}

void Segmentation::askForSurface() {
  askForMemory(m_parts.window, m_panel->surfaceBytes(), [this] { makeSurface(); });
}

void Segmentation::makeSurface() {
  if (!m_document) return;
  endStroke();
  VolumeDocument* const document = &volume();
  Job job;
  job.name = tr("Making the surface");
  job.document = document;
  const SegmentationPanel::Surface how = m_panel->surface();
  const auto failed = [this, document](const Error& error) {
    if (error.code != ErrorCode::Cancelled) fail(*document, tr("The surface was not made"), errorSentence(error));
  };
  job.work = [this, document, how, failed, scan = document->scan(), segment = document->segment(),
              source = document->volume()->source,
              pieces = document->volume()->surface.pieceCells()](Progress progress) -> Job::Finish {
    const Result<SparseVolume> made =
        volumeOfSmoothed(scan->image, segment, how.voxel, how.isSmoothed, progress.part(0.0, 0.7));
    if (!made) return [failed, error = made.error()] { failed(error); };
    const auto snapshot = snapshotOf(*made, source, progress.part(0.7, 1.0), scan, segment, pieces);
    if (!snapshot) return [failed, error = snapshot.error()] { failed(error); };
    const auto finish = [document, made = *snapshot] {
      document->settle();
      document->commit(tr("Make surface"), std::make_unique<VolumeEdit>(made, made->volume.blockCount()));
    };
    return [this, document, finish] { afterStroke(*document, finish); };
  };
  job.failed = failed;
  m_parts.jobs.start(std::move(job));
}

void Segmentation::fail(const Document& document, const QString& what, const QString& why) {
  Message notice{Message::Weight::Warning, what, why};
  notice.about = &document;
  emit message(notice);
}

}  // namespace handwheel
