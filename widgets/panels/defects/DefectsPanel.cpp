// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/defects/DefectsPanel.h"

#include "panels/ActionButton.h"
#include "panels/defects/DefectCard.h"
#include "panels/defects/DefectDelegate.h"
#include "panels/defects/DefectModel.h"
#include "panels/defects/StateCard.h"
#include "theme/Icons.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QTreeView>

namespace handwheel {

namespace {

constexpr int kFewestRows = 3;  // rows of the list, whatever is below it
constexpr int kRowMargin = 8;   // px

QTreeView* defectList(QWidget* parent, DefectModel* model, DefectDelegate* delegate) {
  auto* list = new QTreeView(parent);
  list->setObjectName(QStringLiteral("defectList"));
  list->setAccessibleName(DefectsPanel::tr("Defects"));
  list->setModel(model);
  list->setItemDelegate(delegate);
  list->setHeaderHidden(true);
  list->setUniformRowHeights(true);
  list->setMinimumHeight(kFewestRows * (list->fontMetrics().height() + kRowMargin));
  // The settings below the list take their room first; the list, which scrolls, has the rest.
  list->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);
  list->setIndentation(16);
  list->setMouseTracking(true);
  list->setExpandsOnDoubleClick(true);
  list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  return list;
}

QToolButton* stepButton(QAction* action, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setObjectName(action->objectName() + QStringLiteral("Button"));
  button->setAccessibleName(action->iconText());
  button->setDefaultAction(action);
  button->setToolButtonStyle(Qt::ToolButtonIconOnly);
  button->setIconSize({18, 18});
  return button;
}

QLabel* emptyText(QWidget* parent) {
  auto* label = new QLabel(DefectsPanel::tr("Open a mesh to see its holes and other defects here."), parent);
  label->setProperty("muted", true);
  label->setWordWrap(true);
  label->setAlignment(Qt::AlignCenter);
  label->setMargin(24);
  return label;
}

}  // namespace

DefectsPanel::DefectsPanel(const DefectsPanelActions& actions, QWidget* parent)
    : QWidget(parent),
      m_model(new DefectModel(this)),
      m_delegate(new DefectDelegate(this)),
      m_state(new StateCard(this)),
      m_list(defectList(this, m_model, m_delegate)),
      m_settings(new HoleSettings(actions.fill, actions.keepOpen, actions.preview, actions.thickenSheet,
                                  actions.cutAndClose, this)),
      m_card(new DefectCard(actions.fix, this)),
      m_content(new QWidget(this)),
      m_empty(emptyText(this)) {
  setObjectName(QStringLiteral("defectsPanel"));
  auto* steps = new QHBoxLayout;
  steps->setSpacing(4);
  steps->addWidget(new ActionButton(actions.fillAll, ActionButton::Rank::Ordinary, this), 1);
  steps->addWidget(stepButton(actions.previous, this));
  steps->addWidget(stepButton(actions.next, this));
  auto* top = new QVBoxLayout;
  top->setContentsMargins(8, 8, 8, 8);
  top->setSpacing(8);
  top->addWidget(m_state);
  top->addLayout(steps);
  auto* column = new QVBoxLayout(m_content);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addLayout(top);
  column->addWidget(m_list, 1);
  column->addWidget(m_settings);
  column->addWidget(m_card);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->addWidget(m_content);
  all->addWidget(m_empty);

  m_expanded.insert(static_cast<int>(DefectKind::Hole));
  m_list->viewport()->installEventFilter(this);
  connect(m_list, &QTreeView::clicked, this, &DefectsPanel::clicked);
  connect(m_list, &QTreeView::entered, this,
          [this](const QModelIndex& index) { emit loopHovered(index.data(DefectModel::LoopRole).toInt()); });
  connect(m_list, &QTreeView::expanded, this, [this](const QModelIndex& index) { m_expanded.insert(index.row()); });
  connect(m_list, &QTreeView::collapsed, this, [this](const QModelIndex& index) { m_expanded.erase(index.row()); });
  connect(m_list->selectionModel(), &QItemSelectionModel::currentChanged, this, &DefectsPanel::currentChanged);
  connect(m_delegate, &DefectDelegate::eyeClicked, this, [this](const QModelIndex& group) {
    const auto kind = static_cast<DefectKind>(group.row());
    m_model->setShown(kind, !m_model->isShown(kind));
  });
  m_spinner.setInterval(80);
  connect(&m_spinner, &QTimer::timeout, this, [this] {
    m_delegate->turnSpinner();
    m_list->update(m_model->groupIndex(DefectKind::SelfIntersection));
  });
  setDefectList(nullptr);
}

void DefectsPanel::setDefectList(DefectList* defectList) {
  if (m_defectList) m_defectList->disconnect(this);
  m_defectList = defectList;
  m_selectedLoop = -1;
  m_model->setDefectList(defectList);
  m_content->setVisible(defectList != nullptr);
  m_empty->setVisible(defectList == nullptr);
  if (defectList) {
    // After the model's own connection: then the list already holds the new rows.
    connect(defectList, &DefectList::changed, this, &DefectsPanel::defectListChanged);
    connect(defectList, &DefectList::reasonsChanged, this, &DefectsPanel::showDefect);
  }
  defectListChanged();
}

void DefectsPanel::defectListChanged() {
  const std::set<int> expanded = m_expanded;
  for (int kind : expanded) m_list->expand(m_model->groupIndex(static_cast<DefectKind>(kind)));
  if (m_defectList) m_state->showState(*m_defectList);
  m_defectList && !m_defectList->selfIntersections() ? m_spinner.start() : m_spinner.stop();
  if (m_defectList && m_selectedLoop >= m_defectList->loopCount()) m_selectedLoop = -1;
  setSelectedLoop(m_selectedLoop);
}

void DefectsPanel::setSelectedLoop(int loop) {
  m_selectedLoop = loop;
  m_following = true;
  const QModelIndex index = m_model->loopIndex(loop);
  if (index.isValid()) {
    m_list->setCurrentIndex(index);
    m_list->scrollTo(index);
  } else if (m_list->currentIndex().data(DefectModel::LoopRole).toInt() >= 0) {
    m_list->setCurrentIndex({});
  }
  m_following = false;
  updateSettings();
}

void DefectsPanel::showFixPreview(const QString& text) {
  m_card->showPreview(text);
  m_settings->showOtherPreview(text);
}

void DefectsPanel::setHighlightedLoop(int loop) {
  m_delegate->setHighlightedLoop(loop);
  m_list->viewport()->update();
}

void DefectsPanel::updateSettings() {
  const bool hole = m_defectList && m_selectedLoop >= 0 && m_selectedLoop < m_defectList->loopCount();
  m_settings->setVisible(hole);
  if (hole)
    m_settings->showLoop(m_defectList->loopName(m_selectedLoop), m_defectList->loopDetail(m_selectedLoop),
                         m_defectList->loopMeasures(m_selectedLoop));
  const QModelIndex defect = m_list->currentIndex();
  m_card->setVisible(!hole && defect.isValid());
  showDefect();
  emit defectChosen(defect);
}

void DefectsPanel::showDefect() {
  const QModelIndex defect = m_list->currentIndex();
  if (!defect.isValid()) return;
  m_card->showDefect(defect.data().toString(),
                     m_model->hint(static_cast<DefectKind>(defect.data(DefectModel::KindRole).toInt())),
                     defect.data(DefectModel::NoteRole).toString());
}

void DefectsPanel::clicked(const QModelIndex& index) {
  if (index.parent().isValid()) emit defectActivated(index);
}

void DefectsPanel::currentChanged(const QModelIndex& index) {
  if (m_following) return;
  const int loop = index.isValid() ? index.data(DefectModel::LoopRole).toInt() : -1;
  m_selectedLoop = loop;
  updateSettings();
  emit loopSelected(loop);
}

bool DefectsPanel::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Leave) emit loopHovered(-1);
  return QWidget::eventFilter(watched, event);
}

}  // namespace handwheel
