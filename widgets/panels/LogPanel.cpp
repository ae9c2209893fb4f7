// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/LogPanel.h"

#include "panels/LogModel.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QShortcut>
#include <QTreeView>
#include <QVBoxLayout>

namespace handwheel {

LogPanel::LogPanel(LogModel* model, QWidget* parent) : QWidget(parent), m_view(new QTreeView(this)) {
  setObjectName(QStringLiteral("logPanel"));
  m_view->setObjectName(QStringLiteral("logView"));
  m_view->setAccessibleName(tr("Log"));
  m_view->setModel(model);
  m_view->setRootIsDecorated(false);
  m_view->setUniformRowHeights(true);
  m_view->setSelectionMode(QAbstractItemView::ExtendedSelection);
  m_view->header()->resizeSection(0, 80);
  m_view->header()->resizeSection(1, 460);
  m_view->header()->setDefaultAlignment(Qt::AlignLeft);
  connect(model, &QAbstractItemModel::rowsInserted, m_view, &QTreeView::scrollToBottom, Qt::QueuedConnection);
  auto* copy = new QShortcut(QKeySequence::Copy, m_view, nullptr, nullptr, Qt::WidgetShortcut);
  connect(copy, &QShortcut::activated, this, &LogPanel::copySelected);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(m_view);
}

void LogPanel::copySelected() const {
  QStringList lines;
  for (const QModelIndex& row : m_view->selectionModel()->selectedRows()) {
    const QAbstractItemModel* model = row.model();
    QStringList cells;
    for (int column = 0; column < model->columnCount(); ++column) {
      cells << model->index(row.row(), column).data().toString();
    }
    lines << cells.join(QLatin1Char('\t')).trimmed();
  }
  QGuiApplication::clipboard()->setText(lines.join(QLatin1Char('\n')));
}

}  // namespace handwheel
