// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/cell/PlanDialog.h"

#include "document/cell/CellArms.h"
#include "tools/cell/path/DefaultClearance.h"

#include <QDialogButtonBox>
#include <QKeyEvent>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

namespace handwheel {

PlanDialog::PlanDialog(const CellRobot& robot, const CellPlans& plans, const FidelityValues& fidelity,
                       const std::optional<OperationValues>& before, LengthUnit unit, QWidget* parent)
    : QDialog(parent),
      m_waypoints{"here"},
      m_values(planOperation()),
      m_clearance(plans.clearance),
      m_hasPlainShapes(hasPlainShapes(robot.model, robot.arms, activeArmNumber(robot, plans))),
      m_list(new PropertyList(this)),
      m_via(new QListWidget(this)),
      m_remark(new QLabel(this)) {
  setObjectName(QStringLiteral("planDialog"));
  setWindowTitle(tr("Plan a path"));
  for (const NamedConfiguration& each : plans.configurations) m_waypoints.push_back(each.name);
  for (const NamedTarget& each : plans.targets) m_waypoints.push_back(each.name);
  setFidelity(m_values, fidelity);
  if (const double offered = defaultClearance(robot, plans); offered > m_clearance)
    m_values.setValid("clearance", offered);
  for (const Parameter& parameter : planOperation().parameters) {
    const std::string& id = parameter.id();
    const bool isOfOnePath = id == "from" || id == "to" || id == "via" || id == "name" || id == "seed";
    if (before && !isOfOnePath && before->isSet(id)) m_values.setValid(id, *before->value(id));
  }
  m_values.setValid("from", m_waypoints.size() > 2 ? m_waypoints[1] : m_waypoints[0]);
  m_values.setValid("to", m_waypoints.back());
  auto* layout = new QVBoxLayout(this);
  m_list->setLengthUnit(unit);
  m_list->setMinimumSize(420, 230);
  layout->addWidget(m_list);
  layout->addWidget(
      new QLabel(tr("Critical configurations and targets on the way, from the top down (drag to reorder):"), this));
  m_via->setObjectName(QStringLiteral("planVia"));
  m_via->setDragDropMode(QAbstractItemView::InternalMove);
  m_via->setMaximumHeight(120);
  for (std::size_t i = 1; i < m_waypoints.size(); ++i) {
    auto* item = new QListWidgetItem(QString::fromStdString(m_waypoints[i]), m_via);
    item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
    item->setCheckState(Qt::Unchecked);
  }
  layout->addWidget(m_via);
  m_remark->setWordWrap(true);
  m_remark->setObjectName(QStringLiteral("planRemark"));
  layout->addWidget(m_remark);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  m_plan = buttons->addButton(tr("&Plan"), QDialogButtonBox::AcceptRole);
  m_plan->setObjectName(QStringLiteral("planNow"));
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &PlanDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(m_via, &QListWidget::itemChanged, this, &PlanDialog::showValues);
  connect(m_list, &PropertyList::edited, this, [this](const std::string& id, const PropertyValue& value, bool) {
    const auto* const number = std::get_if<double>(&value);
    const bool isWaypoint = (id == "from" || id == "to") && number;
    const std::string problem =
        isWaypoint ? m_values.set(id, m_waypoints[std::min(static_cast<std::size_t>(*number), m_waypoints.size() - 1)])
                   : m_values.set(id, value);
    if (!problem.empty()) m_list->refuse(id, value, QString::fromStdString(problem));
    showValues();
  });
  showValues();
}

void PlanDialog::showValues() {
  std::vector<Property> properties;
  for (const Parameter& parameter : planOperation().parameters) {
    const std::string& id = parameter.id();
    if (id == "via" || id == "seed") continue;
    Property property = parameter.property;
    if (id == "from" || id == "to") {
      property.label = id == "from" ? QT_TRANSLATE_NOOP("Property", "From") : QT_TRANSLATE_NOOP("Property", "To");
      property.choices = m_waypoints;
      property.choices[0] = QT_TRANSLATE_NOOP("Property", "Current position of the robot");
      const auto chosen = std::find(m_waypoints.begin(), m_waypoints.end(), m_values.text(id));
      property.value = static_cast<double>(chosen - m_waypoints.begin());
    } else if (id == "name") {
      property.label = QT_TRANSLATE_NOOP("Property", "Name");
      property.value = m_values.isSet(id) ? m_values.text(id) : std::string();
    } else {
      property.value = m_values.value(id).value_or(PropertyValue(m_clearance));
    }
    properties.push_back(std::move(property));
  }
  m_list->setProperties(properties);
  const bool isSame = m_values.text("from") == m_values.text("to");
  int via = 0;
  for (int i = 0; i < m_via->count(); ++i) via += m_via->item(i)->checkState() == Qt::Checked ? 1 : 0;
  m_plan->setEnabled(!isSame || via > 0);
  QString remark = isSame && via == 0 ? tr("The path begins where it ends: choose another end.")
                                      : tr("The path is proven free of collisions everywhere between its places.");
  if (m_hasPlainShapes) {
    remark += QLatin1Char(' ') + tr("The robot has simplified shapes, smaller than its own in places: keep a "
                                    "clearance, or use its maker's shapes by a URDF.");
  }
  m_remark->setText(remark);
}

void PlanDialog::accept() {
  std::string via;
  for (int i = 0; i < m_via->count(); ++i) {
    if (m_via->item(i)->checkState() == Qt::Checked) via += m_via->item(i)->text().toStdString() + ';';
  }
  if (!via.empty()) m_values.setValid("via", via);
  emit chosen(m_values);
  QDialog::accept();
}

// In a field Return takes what was typed, and does not plan at once.
void PlanDialog::keyPressEvent(QKeyEvent* event) {
  const bool isReturn = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (isReturn && focusWidget() && m_list->isAncestorOf(focusWidget())) return event->accept();
  QDialog::keyPressEvent(event);
}

}  // namespace handwheel
