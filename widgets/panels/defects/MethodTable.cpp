// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/defects/MethodTable.h"

#include "base/Units.h"
#include "text/RepairText.h"

#include <QHeaderView>
#include <QLocale>
#include <algorithm>

namespace handwheel {

namespace {

constexpr int kFewestMethods = 3;

enum MethodColumn { kMethod, kTriangles, kArea, kLargestBend, kColumns };

QString degrees(double radian) {
  return QLocale().toString(radian / kRadiansPerDegree, 'f', 0) + QChar(0x00b0);
}

void fill(QTreeWidgetItem& row, const MethodTrial& trial) {
  row.setText(kMethod, fillMethodName(trial.method));
  row.setToolTip(kMethod, MethodTable::tr("%1 It took %2 ms.")
                              .arg(fillMethodHint(trial.method), QLocale().toString(trial.milliseconds, 'f', 1)));
  row.setData(kMethod, Qt::UserRole, static_cast<int>(trial.method));
  for (int column = kTriangles; column < kColumns; ++column) {
    row.setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    row.setText(column, QStringLiteral("–"));
  }
  if (trial.failure != FillFailure::None) {
    row.setToolTip(kTriangles, fillFailureReason(trial.failure));
    row.setForeground(kMethod, row.treeWidget()->palette().color(QPalette::Disabled, QPalette::Text));
    return;
  }
  row.setText(kTriangles, QLocale().toString(static_cast<qulonglong>(trial.statistics.triangles)));
  const double area = trial.statistics.area;
  row.setText(kArea, area < 100.0 ? QLocale().toString(area, 'g', 3) : QLocale().toString(area, 'f', 0));
  row.setText(kLargestBend, degrees(trial.statistics.largestBend));
  row.setToolTip(kLargestBend,
                 MethodTable::tr("Root mean square over all edges: %1").arg(degrees(trial.statistics.meanBend)));
}

}  // namespace

MethodTable::MethodTable(QWidget* parent) : QTreeWidget(parent) {
  setObjectName(QStringLiteral("methodTable"));
  setAccessibleName(tr("Methods side by side"));
  setRootIsDecorated(false);
  setIndentation(0);
  setUniformRowHeights(true);
  setColumnCount(kColumns);
  setHeaderLabels({tr("Method"), tr("Count"), tr("mm²"), tr("Bend")});
  headerItem()->setToolTip(kTriangles, tr("Triangles of the patch"));
  headerItem()->setToolTip(kArea, tr("Area of the patch"));
  headerItem()->setToolTip(kLargestBend, tr("The sharpest edge, that of the hole included"));
  // All columns are visible, however narrow the panel: the names of the methods shrink.
  header()->setMinimumSectionSize(24);
  header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  header()->setSectionResizeMode(kMethod, QHeaderView::Stretch);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  header()->setStretchLastSection(false);
  setMaximumHeight(QTreeWidget::sizeHint().height());
  connect(this, &QTreeWidget::itemClicked, this, [this](const QTreeWidgetItem* row) {
    emit methodChosen(static_cast<FillMethod>(row->data(kMethod, Qt::UserRole).toInt()));
  });
}

void MethodTable::showTrials(const std::vector<MethodTrial>& trials) {
  clear();
  for (const MethodTrial& trial : trials) fill(*new QTreeWidgetItem(this), trial);
  if (trials.empty()) return;
  // All methods if there is room; else some, and it scrolls, so that the list above keeps its rows.
  const auto heightOf = [this](int rows) {
    return header()->sizeHint().height() + rows * sizeHintForRow(0) + 2 * frameWidth();
  };
  const auto all = static_cast<int>(trials.size());
  setMinimumHeight(heightOf(std::min(all, kFewestMethods)));
  setMaximumHeight(heightOf(all));
}

QSize MethodTable::sizeHint() const {
  return {QTreeWidget::sizeHint().width(), maximumHeight()};
}

void MethodTable::showChosen(FillMethod method) {
  for (int i = 0; i < topLevelItemCount(); ++i) {
    QTreeWidgetItem* row = topLevelItem(i);
    if (row->data(kMethod, Qt::UserRole).toInt() == static_cast<int>(method)) setCurrentItem(row);
  }
}

}  // namespace handwheel
