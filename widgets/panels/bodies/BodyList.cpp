// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/bodies/BodyList.h"

#include <QDrag>
#include <QHeaderView>
#include <QItemSelection>
#include <QKeyEvent>
#include <QMimeData>
#include <QScopedValueRollback>

namespace handwheel {

namespace {

constexpr int kMarkWidth = 26;
constexpr int kRowsShown = 6;
constexpr int kIndentation = 14;  // pixels: the panel is narrow

// Returns the key of a press without modifiers; 0 for others.
int plainKeyOf(const QEvent& event) {
  const auto& key = static_cast<const QKeyEvent&>(event);
  return (key.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier ? key.key() : 0;
}

bool isOfRow(int key) {
  return key == Qt::Key_Space || key == Qt::Key_Delete;
}

}  // namespace

BodyList::BodyList(QWidget* parent) : QTreeView(parent), m_model(new BodyModel(this)) {
  setObjectName(QStringLiteral("bodyList"));
  setAccessibleName(tr("Bodies"));
  setModel(m_model);
  setHeaderHidden(true);
  setRootIsDecorated(false);
  setItemsExpandable(false);
  setDragDropMode(DragDrop);
  setDragDropOverwriteMode(true);  // onto rows, not between them
  setIndentation(kIndentation);
  setUniformRowHeights(true);
  setAllColumnsShowFocus(true);
  setSelectionMode(ExtendedSelection);
  setEditTriggers(EditKeyPressed | DoubleClicked);
  setContextMenuPolicy(Qt::CustomContextMenu);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setIconSize({16, 16});
  header()->setStretchLastSection(false);
  header()->setMinimumSectionSize(kMarkWidth);
  header()->setSectionResizeMode(BodyModel::Name, QHeaderView::Stretch);
  for (int column : {BodyModel::Link, BodyModel::Eye}) {
    header()->setSectionResizeMode(column, QHeaderView::Fixed);
    header()->resizeSection(column, kMarkWidth);
  }
  setMinimumHeight(kRowsShown * fontMetrics().height());
  connect(selectionModel(), &QItemSelectionModel::selectionChanged, this, &BodyList::follow);
  connect(m_model, &BodyModel::renameRequested, this, &BodyList::renameRequested);
  connect(m_model, &BodyModel::carrierRequested, this, &BodyList::carrierRequested);
}

void BodyList::setBodies(const BodySet& bodies, const QStringList& carriers) {
  {
    const QScopedValueRollback following(m_isFollowing, true);
    m_model->setBodies(bodies, carriers);
    expandAll();
  }
  setSelected(std::set<BodyId>(m_selected));
}

void BodyList::setSelected(const std::set<BodyId>& bodies) {
  m_selected = bodies;
  if (bodies == selectedBodies()) return;
  const QScopedValueRollback following(m_isFollowing, true);
  QItemSelection rows;
  for (BodyId id : bodies) {
    const QModelIndex index = m_model->indexOf(id);
    if (index.isValid()) rows.select(index, index);
  }
  selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
  const QModelIndex only = bodies.size() == 1 ? m_model->indexOf(*bodies.begin()) : QModelIndex();
  if (!only.isValid()) return;
  selectionModel()->setCurrentIndex(only, QItemSelectionModel::NoUpdate);
  scrollTo(only);
}

std::set<BodyId> BodyList::selectedBodies() const {
  std::set<BodyId> bodies;
  for (const QModelIndex& row : selectionModel()->selectedRows(BodyModel::Name)) {
    if (const BodyPointer body = m_model->body(row)) bodies.insert(body->id);
  }
  return bodies;
}

void BodyList::follow() {
  if (m_isFollowing) return;
  m_selected = selectedBodies();
  emit selected(m_selected);
}

// A selected body stands for all that are selected.
void BodyList::toggle(const BodyPointer& body) {
  const std::set<BodyId> one{body->id};
  emit visibilityRequested(m_selected.contains(body->id) ? std::set<BodyId>(m_selected) : one, !body->visible);
}

bool BodyList::clickEye(const QMouseEvent& event) {
  const QModelIndex index = indexAt(event.position().toPoint());
  const BodyPointer body = m_model->body(index);
  if (!body || index.column() != BodyModel::Eye || event.button() != Qt::LeftButton) return false;
  toggle(body);
  return true;
}

// A press on an eye does not select its row.
void BodyList::mousePressEvent(QMouseEvent* event) {
  if (!clickEye(*event)) QTreeView::mousePressEvent(event);
}

void BodyList::mouseDoubleClickEvent(QMouseEvent* event) {
  if (!clickEye(*event)) QTreeView::mouseDoubleClickEvent(event);
}

// A drop changes the document, and the document changes the rows: none is removed here.
void BodyList::startDrag(Qt::DropActions actions) {
  QMimeData* const dragged = m_model->mimeData(selectionModel()->selectedRows(BodyModel::Name));
  if (!dragged) return;
  auto* drag = new QDrag(this);
  drag->setMimeData(dragged);
  drag->exec(actions);
}

// The keys of a row are not commands of the window.
bool BodyList::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && isOfRow(plainKeyOf(*event))) event->accept();
  return QTreeView::event(event);
}

void BodyList::keyPressEvent(QKeyEvent* event) {
  const BodyPointer current = m_model->body(currentIndex());
  if (current && plainKeyOf(*event) == Qt::Key_Space) return toggle(current);
  if (!m_selected.empty() && plainKeyOf(*event) == Qt::Key_Delete) return emit removalRequested();
  QTreeView::keyPressEvent(event);
}

}  // namespace handwheel
