// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/StatusPanel.h"

#include "theme/Theme.h"

#include <QHeaderView>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QTreeView>
#include <QVBoxLayout>
#include <algorithm>

namespace handwheel {

namespace {

constexpr int kIntervalMs = 500;
constexpr int kBarHeight = 3;
constexpr double kTight = 0.7;  // from here on little is left of the budget

// Draws the share of the budget as a bar under its text.
class ShareDelegate final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    QStyledItemDelegate::paint(painter, option, index);
    const QVariant share = index.data(ServiceModel::ShareRole);
    if (!share.isValid()) return;
    const ThemeColours& colours = themeColours(currentTheme());
    QRect bar = option.rect.adjusted(4, 0, -4, 0);
    bar.setTop(bar.bottom() - kBarHeight + 1);
    painter->fillRect(bar, colours.hover);
    const double filled = std::clamp(share.toDouble(), 0.0, 1.0);
    bar.setWidth(static_cast<int>(bar.width() * filled));
    painter->fillRect(bar, filled < kTight ? colours.accent : colours.warning);
  }
};

}  // namespace

StatusPanel::StatusPanel(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("statusPanel"));
  auto* view = new QTreeView(this);
  view->setObjectName(QStringLiteral("serviceList"));
  view->setAccessibleName(tr("Services"));
  view->setModel(&m_model);
  view->setItemDelegateForColumn(ServiceModel::Share, new ShareDelegate(view));
  view->setRootIsDecorated(false);
  view->setUniformRowHeights(true);
  view->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  view->header()->setStretchLastSection(true);
  view->header()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(view);
  m_timer.setInterval(kIntervalMs);
  connect(&m_timer, &QTimer::timeout, this, &StatusPanel::refresh);
}

void StatusPanel::setSource(Source source) {
  m_source = std::move(source);
  if (isVisible()) refresh();
}

void StatusPanel::showEvent(QShowEvent* event) {
  refresh();
  m_timer.start();
  QWidget::showEvent(event);
}

void StatusPanel::hideEvent(QHideEvent* event) {
  m_timer.stop();
  QWidget::hideEvent(event);
}

void StatusPanel::refresh() {
  if (m_source) m_model.setServices(m_source());
}

}  // namespace handwheel
