// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/ResultTable.h"

#include "controls/OwnKeys.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QHeaderView>
#include <QMenu>
#include <QScrollBar>
#include <QShortcut>
#include <algorithm>
#include <utility>

namespace handwheel {

namespace {

// A tab or the end of a line would begin another cell. Files of students come from anywhere.
QString forSpreadsheet(const QModelIndex& cell, bool isNumber) {
  QString text = cell.data().toString().simplified();
  constexpr QStringView kFormula = u"=+-@";
  if (!isNumber && !text.isEmpty() && kFormula.contains(text.front())) text.prepend(QLatin1Char('\''));
  return text;
}

}  // namespace

ResultTable::ResultTable(QWidget* parent)
    : QTreeView(parent), m_model(new ResultModel(this)), m_first(new QTreeView(this)) {
  setObjectName(QStringLiteral("resultTable"));
  setAccessibleName(tr("Results"));
  setModel(m_model);
  setRootIsDecorated(false);
  setUniformRowHeights(true);
  setSelectionMode(ExtendedSelection);
  setSortingEnabled(true);
  header()->setSortIndicatorClearable(true);
  header()->setSortIndicator(-1, Qt::AscendingOrder);
  header()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  auto* key = new QShortcut(QKeySequence::Copy, this, nullptr, nullptr, Qt::WidgetShortcut);
  connect(key, &QShortcut::activated, this, &ResultTable::copy);
  new OwnKeys(*this, {Qt::Key_Return, Qt::Key_Enter});
  for (QTreeView* view : {static_cast<QTreeView*>(this), m_first})
    connect(view, &QTreeView::activated, this,
            [this](const QModelIndex& index) { emit rowActivated(m_model->source(index.row())); });
  keepFirstColumn();
}

// A second view of the same rows, which scrolls up and down with this one and shows nothing else.
void ResultTable::keepFirstColumn() {
  setVerticalScrollMode(ScrollPerPixel);
  m_first->setObjectName(QStringLiteral("firstColumn"));
  m_first->setAccessibleName(tr("First column of the results"));
  m_first->setModel(m_model);
  m_first->setSelectionModel(selectionModel());
  m_first->setFocusPolicy(Qt::NoFocus);  // keys are this one's
  m_first->setContextMenuPolicy(Qt::NoContextMenu);
  m_first->setFrameShape(QFrame::NoFrame);
  m_first->setRootIsDecorated(false);
  m_first->setUniformRowHeights(true);
  m_first->setSelectionMode(ExtendedSelection);
  m_first->setVerticalScrollMode(ScrollPerPixel);
  m_first->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_first->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_first->header()->setStretchLastSection(true);
  m_first->header()->setSectionResizeMode(QHeaderView::Fixed);
  m_first->header()->setDefaultAlignment(header()->defaultAlignment());
  m_first->header()->setSectionsClickable(true);
  m_first->header()->setSortIndicatorShown(true);
  m_first->header()->setSortIndicatorClearable(true);
  m_first->header()->setSortIndicator(-1, Qt::AscendingOrder);
  const auto follow = [](QHeaderView* from, QHeaderView* to) {
    connect(from, &QHeaderView::sortIndicatorChanged, to, [to](int section, Qt::SortOrder order) {
      if (to->sortIndicatorSection() != section || to->sortIndicatorOrder() != order)
        to->setSortIndicator(section, order);
    });
  };
  follow(header(), m_first->header());
  follow(m_first->header(), header());
  connect(verticalScrollBar(), &QScrollBar::valueChanged, m_first->verticalScrollBar(), &QScrollBar::setValue);
  connect(m_first->verticalScrollBar(), &QScrollBar::valueChanged, verticalScrollBar(), &QScrollBar::setValue);
  connect(header(), &QHeaderView::sectionResized, this, [this](int section) {
    if (section == 0) placeFirstColumn();
  });
  connect(header(), &QHeaderView::geometriesChanged, this, &ResultTable::placeFirstColumn);
}

// It takes no more than half of the room.
void ResultTable::placeFirstColumn() {
  const int width = std::min(columnWidth(0), viewport()->width() / 2);
  m_first->setGeometry(frameWidth(), frameWidth(), width, header()->height() + viewport()->height());
  m_first->header()->setFixedHeight(header()->height());
  m_first->setVisible(width > 0);
}

void ResultTable::resizeEvent(QResizeEvent* event) {
  QTreeView::resizeEvent(event);
  placeFirstColumn();
}

void ResultTable::setTable(QStringList headings, std::vector<ResultModel::Row> rows) {
  m_model->setTable(std::move(headings), std::move(rows));
  for (int column = 0; column < m_model->columnCount(); ++column) {
    resizeColumnToContents(column);
    m_first->setColumnHidden(column, column > 0);
  }
  placeFirstColumn();
}

void ResultTable::copy() {
  QGuiApplication::clipboard()->setText(copyText());
}

// Offers the functions of the headings to the keyboard, too. A second choice of a column turns its order.
void ResultTable::contextMenuEvent(QContextMenuEvent* event) {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->setObjectName(QStringLiteral("resultMenu"));
  menu->addAction(tr("Copy"), QKeySequence(QKeySequence::Copy), this, &ResultTable::copy);
  menu->addSeparator();
  for (int column = 0; column < m_model->columnCount(); ++column) {
    const bool isUp =
        header()->sortIndicatorSection() == column && header()->sortIndicatorOrder() == Qt::AscendingOrder;
    const QString heading = m_model->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
    menu->addAction(tr("Sort by “%1”").arg(QString(heading).replace(u'&', QStringLiteral("&&"))), this,
                    [this, column, isUp] { sortByColumn(column, isUp ? Qt::DescendingOrder : Qt::AscendingOrder); });
  }
  menu->popup(event->globalPos());
}

QString ResultTable::copyText() const {
  QList<int> rows;
  for (const QModelIndex& row : selectionModel()->selectedRows()) rows << row.row();
  for (int row = 0; rows.size() < m_model->rowCount() && !selectionModel()->hasSelection(); ++row) rows << row;
  std::sort(rows.begin(), rows.end());
  QStringList line, lines;
  for (int column = 0; column < m_model->columnCount(); ++column) {
    line << m_model->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString().simplified();
  }
  lines << line.join(QLatin1Char('\t'));
  for (int row : rows) {
    line.clear();
    for (int column = 0; column < m_model->columnCount(); ++column) {
      line << forSpreadsheet(m_model->index(row, column), m_model->isNumber(row, column));
    }
    lines << line.join(QLatin1Char('\t'));
  }
  return lines.join(QLatin1Char('\n'));
}

}  // namespace handwheel
