// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/cell/proximity/ProximityDock.h"

#include "controls/QuantityText.h"
#include "controls/ScrolledPanel.h"
#include "controls/SqueezedPage.h"
#include "controls/property/PropertyList.h"
#include "document/Document.h"
#include "document/cell/RobotCellDocument.h"
#include "panels/DockTitle.h"
#include "tools/ToolProperty.h"
#include "window/ActionToolTip.h"
#include "window/JobRunner.h"
#include "window/cell/CellCollisions.h"
#include "window/documents/DocumentTab.h"

#include <QComboBox>
#include <QDockWidget>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QMainWindow>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <cmath>

namespace handwheel {

namespace {

constexpr Limits kTolerances{0.01, 1e4};  // mm
constexpr int kColumns = 4;

QString numberOf(double value) {
  return QLocale().toString(value, 'f', 1);
}

}  // namespace

ProximityDock::ProximityDock(const WindowContext& parts, CellCollisions& collisions, QObject* parent)
    : QObject(parent), m_parts(parts), m_collisions(collisions), m_toggle(tr("Distance &queries…"), this) {
  prepare(m_toggle, "proximityDockToggle", "ruler",
          tr("Measures what the distances of the robot from its obstacles cost, in three scenarios"));
  m_toggle.setCheckable(true);
  connect(&m_toggle, &QAction::triggered, this, &ProximityDock::open);
  connect(&collisions, &CellCollisions::prepared, this, [this] {
    if (m_state == State::Waiting) start();
  });
}

void ProximityDock::makeDock() {
  auto* const window = qobject_cast<QMainWindow*>(m_parts.window);
  if (m_dock || !window) return;
  m_dock = new QDockWidget(tr("Distance queries"), window);
  m_dock->setObjectName(QStringLiteral("proximityDock"));
  m_dock->setAccessibleName(m_dock->windowTitle());
  m_dock->setTitleBarWidget(new DockTitle(m_dock));
  auto* const page = new SqueezedPage(m_dock);
  m_scenario = new QComboBox(page);
  m_scenario->setObjectName(QStringLiteral("proximityScenario"));
  m_scenario->setAccessibleName(tr("Scenario"));
  m_scenario->addItems({tr("Where it stands"), tr("1: apart by more than the tolerance"),
                        tr("2: nearer than the tolerance"), tr("3: colliding")});
  m_tolerance = new PropertyList(page);
  m_tolerance->setObjectName(QStringLiteral("proximitySettings"));
  m_tolerance->setFixedHeight(4 * page->fontMetrics().lineSpacing());  // one field
  m_measure = new QPushButton(tr("&Measure the distance queries"), page);
  m_measure->setObjectName(QStringLiteral("proximityMeasure"));
  m_cancel = new QPushButton(tr("Cancel"), page);
  m_cancel->setObjectName(QStringLiteral("proximityCancel"));
  m_text = new QLabel(page);
  m_text->setObjectName(QStringLiteral("proximityText"));
  m_text->setTextFormat(Qt::PlainText);
  m_text->setWordWrap(true);
  m_table = new QTableWidget(static_cast<int>(ProximityCosts::kQueries), kColumns, page);
  m_table->setObjectName(QStringLiteral("proximityTable"));
  m_table->setAccessibleName(tr("Costs of the distance queries"));
  m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  m_table->setHorizontalHeaderLabels({tr("CPU time (µs)"), tr("At most (µs)"), tr("Volumes"), tr("Pairs")});
  m_table->setVerticalHeaderLabels(
      {tr("C1 closest points"), tr("C2 nearer than tolerance"), tr("C3 colliding"), tr("C4 all contacts")});
  m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  m_table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  m_table->setMinimumHeight(8 * page->fontMetrics().lineSpacing());
  m_table->setToolTip(
      tr("CPU time of a step: the median, and the largest. Pairs of bounding volumes, and of triangles "
         "or solids, that were compared in a step: the mean"));
  for (int row = 0; row < m_table->rowCount(); ++row) {
    for (int column = 0; column < kColumns; ++column) {
      auto* const item = new QTableWidgetItem;
      item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      m_table->setItem(row, column, item);
    }
  }
  auto* const buttons = new QHBoxLayout;
  buttons->addWidget(m_measure, 1);
  buttons->addWidget(m_cancel);
  auto* const column = new QVBoxLayout;
  column->addWidget(m_scenario);
  column->addWidget(m_tolerance);
  column->addLayout(buttons);
  column->addStretch(1);
  auto* const results = new QVBoxLayout;
  results->addWidget(m_text);
  results->addWidget(m_table, 1);
  auto* const row = new QHBoxLayout(page);
  row->addLayout(column, 1);
  row->addLayout(results, 2);
  m_dock->setWidget(new ScrolledPanel(page, ScrolledPanel::Directions::Both, m_dock));
  window->addDockWidget(Qt::BottomDockWidgetArea, m_dock);
  constexpr int kLines = 16;  // its title, the result and all rows of the table
  window->resizeDocks({m_dock}, {kLines * page->fontMetrics().lineSpacing()}, Qt::Vertical);
  showCosts(nullptr);
  connect(m_measure, &QPushButton::clicked, this, &ProximityDock::measure);
  connect(m_cancel, &QPushButton::clicked, this, &ProximityDock::cancel);
  connect(m_tolerance, &PropertyList::edited, this, [this](const std::string&, const PropertyValue& value, bool) {
    assignNumber(m_request.tolerance, value, kTolerances);
    showTolerance();
  });
  connect(m_dock, &QDockWidget::visibilityChanged, this, [this] { m_toggle.setChecked(!m_dock->isHidden()); });
}

void ProximityDock::setDocument(DocumentTab* document) {
  if (m_document) m_document->document.disconnect(this);
  m_document = document;
  m_parts.jobs.cancelOf(this);
  m_measured.clear();
  if (document) {
    connect(&document->document, &Document::changed, this, [this] {
      m_isOutdated = true;
      setState(m_state);
    });
  }
  if (!document && m_dock) m_dock->hide();
  if (!m_dock) return;
  showCosts(nullptr);
  showTolerance();
  setState(State::Idle);
}

void ProximityDock::open(bool isOpen) {
  if (isOpen) makeDock();
  const bool shown = isOpen && m_document && m_dock;
  if (m_dock) m_dock->setVisible(shown);
  m_toggle.setChecked(shown);
  if (!shown) return;
  m_dock->raise();
  showTolerance();
  setState(m_state);
}

void ProximityDock::showTolerance() {
  m_tolerance->setLengthUnit(m_document ? m_document->document.displayUnit() : LengthUnit::Millimetre);
  m_tolerance->setProperties({numberSetting("tolerance", QT_TRANSLATE_NOOP("Property", "Near below"),
                                            m_request.tolerance, Quantity::Length, kTolerances)});
}

void ProximityDock::setState(State state) {
  m_state = state;
  if (!m_dock) return;
  m_measure->setEnabled(m_document && state == State::Idle);
  m_cancel->setEnabled(state != State::Idle);
  if (state == State::Waiting)
    m_text->setText(tr("The cell is being prepared."));
  else if (state == State::Running)
    m_text->setText(tr("The queries are being measured."));
  else if (m_measured.isEmpty())
    m_text->setText(tr("Nothing is measured yet."));
  else
    m_text->setText(m_isOutdated ? tr("%1 The cell was changed since.").arg(m_measured) : m_measured);
}

void ProximityDock::measure() {
  if (!m_document || m_state != State::Idle) return;
  if (m_collisions.scene()) return start();
  setState(State::Waiting);
  m_collisions.prepareIfIdle();
}

// On the scene as it is now, which no later change of the cell touches.
void ProximityDock::start() {
  const auto scene = m_collisions.scene();
  if (!scene) {
    m_measured = tr("The cell could not be prepared.");
    return setState(State::Idle);
  }
  const int chosen = m_scenario->currentIndex();
  const auto wanted =
      chosen > 0 ? std::optional(static_cast<ProximityScenario>(chosen)) : std::optional<ProximityScenario>();
  const ArmValues present = scene->planned(static_cast<const RobotCellDocument&>(m_document->document).joints());
  Job job;
  job.name = tr("Measuring the distance queries");
  job.document = &m_document->document;
  job.owner = this;
  job.lane = Job::Lane::Looking;
  job.failed = [this](const Error&) { setState(State::Idle); };
  job.work = [this, scene, present, wanted, request = m_request](Progress progress) -> Job::Finish {
    const MeasuredScenario measured = measuredScenario(scene->scene, present, wanted, request, progress);
    return [this, measured] { take(measured); };
  };
  m_isOutdated = false;
  setState(State::Running);
  m_parts.jobs.start(std::move(job));
}

void ProximityDock::cancel() {
  m_parts.jobs.cancelOf(this);
  setState(State::Idle);
}

void ProximityDock::take(const MeasuredScenario& measured) {
  if (m_state != State::Running) return;
  m_measured = textOf(measured);
  showCosts(measured.costs ? &*measured.costs : nullptr);
  setState(State::Idle);
}

void ProximityDock::showCosts(const ProximityCosts* costs) {
  for (std::size_t i = 0; i < ProximityCosts::kQueries; ++i) {
    const ProximityCost cost = costs ? costs->queries[i] : ProximityCost();
    const double values[kColumns] = {cost.median, cost.slowest, cost.volumes, cost.pairs};
    for (int column = 0; column < kColumns; ++column)
      m_table->item(static_cast<int>(i), column)->setText(costs ? numberOf(values[column]) : QStringLiteral("—"));
  }
}

QString ProximityDock::textOf(const MeasuredScenario& measured) const {
  if (!measured.costs) {
    return measured.wanted ? tr("The robot does not get into scenario %1.").arg(static_cast<int>(*measured.wanted))
                           : QString();
  }
  const ProximityCosts& costs = *measured.costs;
  const LengthUnit unit = m_document->document.displayUnit();
  const auto length = [&](double value) { return quantityText(value, Quantity::Length, unit, QLocale()); };
  switch (costs.scenario) {
    case ProximityScenario::Apart:
      if (!std::isfinite(costs.distance)) return tr("Scenario 1, apart: there is no obstacle.");
      return tr("Scenario 1, apart: %1 from the nearest obstacle.").arg(length(costs.distance));
    case ProximityScenario::Near:
      return tr("Scenario 2, near: %1 from the nearest obstacle.").arg(length(costs.distance));
    case ProximityScenario::Colliding:
      break;
  }
  return tr("Scenario 3, colliding: %Ln pair(s) of triangles or solids meet.", nullptr,
            static_cast<int>(costs.contacts));
}

}  // namespace handwheel
