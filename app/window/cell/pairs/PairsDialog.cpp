// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/cell/pairs/PairsDialog.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

namespace handwheel {

PairsDialog::PairsDialog(const CellPlans& plans, const std::set<PairNames>& found, const BodySet& bodies,
                         QWidget* parent)
    : QDialog(parent), m_list(new QListWidget(this)) {
  setObjectName(QStringLiteral("pairsDialog"));
  setWindowTitle(tr("Pairs that may touch"));
  m_list->setObjectName(QStringLiteral("pairsList"));
  for (const PairNames& each : found) {
    if (!isAllowed(plans, each)) add(each, bodies, false);
  }
  for (const PairNames& each : plans.allowed) add(each, bodies, true);
  auto* const remark =
      new QLabel(m_pairs.empty() ? tr("Nothing meets where the robot is, nor on the selected path.")
                                 : tr("Checked pairs may touch: nothing is proven about them. Neighbouring links "
                                      "may touch anyway."),
                 this);
  remark->setWordWrap(true);
  auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  buttons->button(QDialogButtonBox::Ok)->setObjectName(QStringLiteral("pairsNow"));
  buttons->button(QDialogButtonBox::Ok)->setEnabled(!m_pairs.empty());
  auto* const column = new QVBoxLayout(this);
  column->addWidget(m_list);
  column->addWidget(remark);
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &PairsDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void PairsDialog::add(const PairNames& pair, const BodySet& bodies, bool isAllowed) {
  const auto [first, second] = shownNames(pair, bodies);
  auto* const item =
      new QListWidgetItem(tr("%1 and %2").arg(QString::fromStdString(first), QString::fromStdString(second)), m_list);
  item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
  item->setCheckState(isAllowed ? Qt::Checked : Qt::Unchecked);
  m_pairs.emplace_back(pair, isAllowed);
}

void PairsDialog::accept() {
  std::vector<PairNames> allowed, forbidden;
  for (std::size_t i = 0; i < m_pairs.size(); ++i) {
    const auto& [pair, before] = m_pairs[i];
    const bool now = m_list->item(static_cast<int>(i))->checkState() == Qt::Checked;
    if (now != before) (now ? allowed : forbidden).push_back(pair);
  }
  if (!allowed.empty() || !forbidden.empty()) emit chosen(allowed, forbidden);
  QDialog::accept();
}

}  // namespace handwheel
