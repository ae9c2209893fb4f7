// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/volume/ClayLayersView.h"

#include "controls/ScrolledPanel.h"
#include "document/volume/VolumeDocument.h"
#include "panels/DockTitle.h"
#include "panels/MessageBar.h"
#include "text/ErrorText.h"
#include "tools/volume/ClayTool.h"
#include "window/ActionToolTip.h"
#include "window/OfferedAction.h"
#include "window/documents/DocumentTab.h"
#include "window/tools/ToolHost.h"

#include <QDockWidget>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QMainWindow>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QTimer>
#include <QVBoxLayout>
#include <cmath>
#include <string_view>
#include <utility>

namespace handwheel {
namespace {

constexpr int kSliderSteps = 100;  // slider steps for a strength of 1
constexpr int kAgainMs = 50;       // while a stroke is waited for

QPushButton* layerButton(const QString& text, const char* name, const QString& tip) {
  auto* const made = new QPushButton(text);
  made->setObjectName(QString::fromLatin1(name));
  made->setToolTip(tip);
  return made;
}

}  // namespace

ClayLayersView::ClayLayersView(const WindowContext& parts, QObject* parent)
    : QObject(parent),
      m_parts(parts),
      m_toggle(tr("La&yers"), this),
      m_computing(JobRunner::Policy::Queue, parts.pool) {
  prepare(m_toggle, "clayLayersToggle", nullptr, tr("Sculpt in layers that can be weakened and turned off"));
  m_toggle.setCheckable(true);
  m_toggle.setEnabled(false);
  connect(&m_toggle, &QAction::triggered, this, &ClayLayersView::show);
}

VolumeDocument& ClayLayersView::volume() const {
  return static_cast<VolumeDocument&>(m_document->document);
}

const std::vector<ClayLayer>& ClayLayersView::layers() const {
  static const std::vector<ClayLayer> none;
  return m_shown ? m_shown->all() : none;
}

int ClayLayersView::chosen() const {
  const int row = m_list->currentRow();
  return row < 0 ? -1 : m_list->count() - 1 - row;
}

void ClayLayersView::makeDock() {
  auto* const window = qobject_cast<QMainWindow*>(m_parts.window);
  if (m_dock || !window) return;
  m_dock = new QDockWidget(tr("Layers"), window);
  m_dock->setObjectName(QStringLiteral("clayLayersDock"));
  m_dock->setAccessibleName(tr("Layers"));
  m_dock->setTitleBarWidget(new DockTitle(m_dock));
  auto* const content = new QWidget;
  m_list = new QListWidget;
  m_list->setObjectName(QStringLiteral("clayLayers"));
  m_list->setAccessibleName(tr("Layers, the topmost first"));
  m_strength = new QSlider(Qt::Horizontal);
  m_strength->setObjectName(QStringLiteral("clayLayerStrength"));
  m_strength->setAccessibleName(tr("Strength of the layer"));
  m_strength->setRange(0, kSliderSteps);
  m_strengthText = new QLabel;
  m_strengthText->setMinimumWidth(m_strengthText->fontMetrics().horizontalAdvance(QStringLiteral("100 %")));
  m_add = layerButton(tr("Add"), "clayLayerAdd", tr("Add a layer on top"));
  m_remove = layerButton(tr("Remove"), "clayLayerRemove", tr("Take the layer and its strokes away"));
  m_merge = layerButton(tr("Merge down"), "clayLayerMerge",
                        tr("Make the layer one with that below it, or with the volume, as it is visible now"));
  m_hint = new QLabel;
  m_hint->setObjectName(QStringLiteral("clayLayerHint"));
  m_hint->setProperty("muted", true);
  m_hint->setWordWrap(true);
  auto* const strength = new QHBoxLayout;
  strength->addWidget(new QLabel(tr("Strength")));
  strength->addWidget(m_strength, 1);
  strength->addWidget(m_strengthText);
  auto* const buttons = new QHBoxLayout;
  for (QPushButton* button : {m_add, m_remove, m_merge}) buttons->addWidget(button);
  buttons->addStretch();
  auto* const column = new QVBoxLayout(content);
  column->setContentsMargins(8, 4, 8, 8);
  // The hint below the list has one line or three, and must not move the buttons.
  column->addLayout(buttons);
  column->addLayout(strength);
  column->addWidget(m_list, 1);
  column->addWidget(m_hint);
  m_dock->setWidget(new ScrolledPanel(content, ScrolledPanel::Directions::Both, m_dock));
  window->addDockWidget(Qt::RightDockWidgetArea, m_dock);
  if (auto* const kind = window->findChild<QDockWidget*>(QStringLiteral("kindDock")))
    window->tabifyDockWidget(kind, m_dock);
  connect(m_dock, &QDockWidget::visibilityChanged, this, [this] {
    if (m_document) m_toggle.setChecked(!m_dock->isHidden());
  });
  connect(m_list, &QListWidget::itemChanged, this, [this](const QListWidgetItem* item) { take(*item); });
  connect(m_list, &QListWidget::currentRowChanged, this, &ClayLayersView::refreshChosen);
  connect(m_strength, &QSlider::valueChanged, this,
          [this] { setStrength(m_strength->isSliderDown() ? DragPhase::Continues : DragPhase::Ends); });
  connect(m_strength, &QSlider::sliderReleased, this, [this] { setStrength(DragPhase::Ends); });
  connect(m_add, &QPushButton::clicked, this, &ClayLayersView::add);
  connect(m_remove, &QPushButton::clicked, this, [this] { start(tr("Remove layer"), withoutLayer); });
  connect(m_merge, &QPushButton::clicked, this, [this] { start(tr("Merge layer"), withLayerMerged); });
}

void ClayLayersView::setDocument(DocumentTab* document, const QString& reason) {
  if (m_document) {
    applyWanted();
    m_document->document.disconnect(this);
  }
  m_document = document;
  offer(m_toggle, document != nullptr, reason);
  m_shown.reset();
  if (document) {
    if (volume().volume()->layers) m_toggle.setChecked(true);
    connect(&document->document, &Document::changed, this, &ClayLayersView::refresh);
    connect(&document->document, &Document::settling, this, &ClayLayersView::applyWanted);
  }
  show();
}

void ClayLayersView::show() {
  const bool isShown = m_document && m_toggle.isChecked();
  if (isShown) makeDock();
  if (!m_dock) return;
  if (isShown) refresh();
  m_dock->setVisible(isShown);
  if (isShown) m_dock->raise();
}

// Items stay as long as there are layers for them: one may be being edited.
void ClayLayersView::refresh() {
  if (!m_document || !m_dock) return;
  const int before = m_list->count();
  m_shown = volume().volume()->layers;
  {
    const QSignalBlocker blocker(m_list);
    const int count = static_cast<int>(layers().size());
    while (m_list->count() > count) delete m_list->takeItem(0);
    while (m_list->count() < count) m_list->insertItem(0, new QListWidgetItem);
    for (int row = 0; row < count; ++row) {
      const ClayLayer& layer = layers()[static_cast<std::size_t>(count - 1 - row)];
      QListWidgetItem& item = *m_list->item(row);
      item.setFlags(Qt::ItemIsSelectable | Qt::ItemIsEnabled | Qt::ItemIsEditable | Qt::ItemIsUserCheckable);
      item.setText(QString::fromStdString(layer.name));
      item.setCheckState(isOn(count - 1 - row) ? Qt::Checked : Qt::Unchecked);
    }
    if (count > 0 && (count > before || m_list->currentRow() < 0)) m_list->setCurrentRow(0);
  }
  refreshChosen();
}

void ClayLayersView::refreshChosen() {
  const int layer = chosen();
  const bool isThere = layer >= 0 && layer < static_cast<int>(layers().size());
  for (QWidget* each : std::initializer_list<QWidget*>{m_strength, m_remove, m_merge})
    each->setEnabled(isThere && !m_step);
  m_add->setEnabled(!m_step && layers().size() < ClayLayers::kMostLayers);
  const double strength = isThere ? strengthOf(layer) : 1.0;
  m_strengthText->setText(tr("%1 %").arg(QLocale().toString(std::round(100.0 * strength), 'f', 0)));
  if (!m_strength->isSliderDown()) {
    const QSignalBlocker blocker(m_strength);
    m_strength->setValue(static_cast<int>(std::lround(kSliderSteps * strength)));
  }
  QString hint = tr("Strokes change the volume itself.");
  if (!layers().empty())
    hint = m_shown->canBeSculpted() ? tr("Strokes go on the top layer.")
                                    : tr("The top layer takes no strokes while it is off or weaker than 100 %.");
  if (!layers().empty()) hint += QLatin1Char(' ') + tr("Drilling and changes of the whole volume apply all layers.");
  m_hint->setText(hint);
}

void ClayLayersView::add() {
  volume().settle();
  const std::size_t count = volume().volume()->layers ? volume().volume()->layers->all().size() : 0;
  if (count >= ClayLayers::kMostLayers) return;
  commit(tr("Add layer"), withNewLayer(*volume().volume(), tr("Layer %1").arg(count + 1).toStdString()));
}

void ClayLayersView::commit(const QString& text, const LayerStep& step) {
  volume().commit(text, step.edit());
}

void ClayLayersView::start(const QString& text, StepOf of) {
  volume().settle();
  if (m_step || chosen() < 0) return;
  m_step = Step{text, of, static_cast<std::size_t>(chosen()), layers().size(), ++m_stepCount};
  computeStep();
  refresh();
}

void ClayLayersView::computeStep() {
  if (!m_step->isPossible(*volume().volume())) return m_step.reset();
  Job job;
  job.name = m_step->text;
  job.work = [this, before = volume().volume(), step = *m_step](Progress) -> Job::Finish {
    const auto made = std::make_shared<const LayerStep>(step.of(*before, step.layer));
    return [this, before, made, number = step.number] { finish(number, before, made); };
  };
  job.failed = [this, number = m_step->number](const Error& error) {
    if (!m_step || m_step->number != number) return;
    m_step.reset();
    if (m_document) warn(error);
    refresh();
  };
  m_computing.start(std::move(job));
}

// Repeats the computation if the volume was changed meanwhile. If the document was settled, the step has been done
// already; an undo of that restores the volume of the computation, and another step may be in progress then.
void ClayLayersView::finish(quint64 number, const std::shared_ptr<const VolumeSnapshot>& before,
                            const std::shared_ptr<const LayerStep>& made) {
  if (!m_step || m_step->number != number || !m_document) return;
  if (isStrokeLive()) {
    QTimer::singleShot(kAgainMs, this, [this, number, before, made] { finish(number, before, made); });
    return;
  }
  if (volume().volume() != before) {
    computeStep();
  } else {
    commit(std::exchange(m_step, std::nullopt)->text, *made);
  }
  refresh();
}

double ClayLayersView::strengthOf(int layer) const {
  return m_wanted && m_wanted->layer == layer ? m_wanted->strength : layers()[static_cast<std::size_t>(layer)].strength;
}

bool ClayLayersView::isOn(int layer) const {
  return m_wanted && m_wanted->layer == layer ? m_wanted->isOn : layers()[static_cast<std::size_t>(layer)].isOn;
}

void ClayLayersView::take(const QListWidgetItem& item) {
  const int number = m_list->count() - 1 - m_list->row(&item);
  const bool isChecked = item.checkState() == Qt::Checked;
  const std::string name = item.text().toStdString();
  if (name != layers()[static_cast<std::size_t>(number)].name) {
    volume().settle();
    set(number, "name", name, DragPhase::Ends);
    refresh();  // restores the shown state after a refused change
  }
  if (isChecked != isOn(number)) want({number, "on", strengthOf(number), isChecked, DragPhase::Ends, 0});
}

void ClayLayersView::setStrength(DragPhase phase) {
  const int layer = chosen();
  if (layer < 0 || layer >= static_cast<int>(layers().size())) return;
  // A strength between two steps of the slider stays until the slider is moved.
  const double now = strengthOf(layer);
  const int step = m_strength->value();
  const bool isSame = step == static_cast<int>(std::lround(kSliderSteps * now));
  const double strength = isSame ? now : static_cast<double>(step) / kSliderSteps;
  want({layer, "strength", strength, isOn(layer), phase, 0});
}

void ClayLayersView::want(Wanted wanted) {
  // Applies the previous request first, unless this one continues the same drag.
  if (m_wanted && (m_wanted->layer != wanted.layer || m_wanted->what != std::string_view(wanted.what))) applyWanted();
  if (!m_wanted) volume().settle();
  wanted.number = ++m_wantedCount;
  m_wanted = wanted;
  compute();
  refresh();
}

void ClayLayersView::compute() {
  if (m_isComputing || !m_wanted || !m_document) return;
  const std::shared_ptr<const VolumeSnapshot> now = volume().volume();
  const auto number = static_cast<std::size_t>(m_wanted->layer);
  const bool isThere = now->layers && number < now->layers->all().size();
  // The end of a drag whose result is already shown.
  if (!isThere ||
      (now->layers->all()[number].strength == m_wanted->strength && now->layers->all()[number].isOn == m_wanted->isOn))
    return applyWanted();
  m_isComputing = true;
  Job job;
  job.name = tr("Computing the layer");
  job.work = [this, now, number, wanted = *m_wanted](Progress) -> Job::Finish {
    const auto share = std::make_shared<const PreparedShare>(prepareShare(now, number, wanted.strength, wanted.isOn));
    return [this, share, wanted] { take(share, wanted); };
  };
  job.failed = [this](const Error& error) {
    m_isComputing = false;
    m_wanted.reset();
    if (m_document) warn(error);
    refresh();
  };
  m_computing.start(std::move(job));
}

bool ClayLayersView::isStrokeLive() const {
  const auto* const tool = dynamic_cast<const ClayTool*>(m_parts.tools.runner().tool());
  return tool && tool->isLive();
}

// A stroke that began meanwhile is kept: it comes first, and the share is computed again. If the volume was changed by
// an undo or another edit, the previously chosen share is dropped.
void ClayLayersView::take(const std::shared_ptr<const PreparedShare>& share, const Wanted& wanted, bool isLate) {
  const bool isMeant = m_document && m_wanted && wanted.number <= m_wanted->number;
  if (isMeant && isStrokeLive()) {
    QTimer::singleShot(kAgainMs, this, [this, share, wanted] { take(share, wanted, true); });
    return;
  }
  m_isComputing = false;
  if (isMeant && volume().volume() == share->of) {
    const std::optional<Wanted> later =
        m_wanted->number == wanted.number ? std::nullopt : std::exchange(m_wanted, wanted);
    volume().prepare(share);
    applyWanted();
    volume().prepare(nullptr);
    m_wanted = later;
  } else if (isMeant && !isLate && m_wanted->number == wanted.number) {
    m_wanted.reset();
  }
  compute();
  refresh();
}

void ClayLayersView::applyWanted() {
  if (m_step) {
    const Step step = *std::exchange(m_step, std::nullopt);
    volume().settle();
    if (step.isPossible(*volume().volume())) commit(step.text, step.of(*volume().volume(), step.layer));
  }
  if (!m_wanted) return;
  const Wanted wanted = *std::exchange(m_wanted, std::nullopt);
  volume().settle();  // a stroke that is ending comes first, also where this is called for the same
  apply(wanted);
}

void ClayLayersView::apply(const Wanted& wanted) {
  const bool isStrength = wanted.what == std::string_view("strength");
  set(wanted.layer, wanted.what, isStrength ? PropertyValue(wanted.strength) : PropertyValue(wanted.isOn),
      wanted.phase);
}

void ClayLayersView::set(int layer, const char* what, const PropertyValue& value, DragPhase phase) {
  const std::string id = "layer." + std::to_string(layer + 1) + "." + what;
  if (const Status done = volume().setProperty(id, value, phase); !done) warn(done.error());
}

void ClayLayersView::warn(const Error& error) {
  Message notice{Message::Weight::Warning, tr("The layer stays as it is"), errorSentence(error), errorAdvice(error)};
  notice.about = &m_document->document;
  emit message(notice);
}

void ClayLayersView::refuse() {
  const auto& layers = volume().volume()->layers;
  if (!layers) return;
  Message notice{
      Message::Weight::Warning, tr("The top layer takes no strokes"),
      tr("“%1” is off, or its strength is below 100 %.").arg(QString::fromStdString(layers->all().back().name)),
      tr("Turn it on at full strength, or add a layer: the panel Layers has both.")};
  notice.about = &m_document->document;
  notice.isOver = [document = &volume()] { return takesStrokes(*document->volume()); };
  emit message(notice);
}

}  // namespace handwheel
