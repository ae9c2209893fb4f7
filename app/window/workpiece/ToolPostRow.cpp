// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/workpiece/ToolPostRow.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolButton>

namespace handwheel {

namespace {

QString nameOf(const LatheTool& tool) {
  return QCoreApplication::translate("LatheTool", titleOf(tool.kind)) + QLatin1Char(' ') +
         QString::fromStdString(tool.designation);
}

}  // namespace

ToolPostRow::ToolPostRow(QWidget* parent)
    : QWidget(parent), m_sides(new QComboBox), m_mount(new QToolButton), m_menu(new QMenu(m_mount)) {
  m_sides->setObjectName(QStringLiteral("latheTool"));
  m_sides->setAccessibleName(tr("Tool in the post"));
  m_sides->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  m_sides->setMinimumContentsLength(14);
  m_mount->setObjectName(QStringLiteral("latheMount"));
  m_mount->setText(tr("&Mount"));
  m_mount->setToolTip(tr("Mounts another tool on this side of the post, or a drill in the tailstock"));
  m_mount->setPopupMode(QToolButton::InstantPopup);
  m_mount->setMenu(m_menu);
  m_menu->setObjectName(QStringLiteral("latheMountMenu"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  row->addWidget(m_sides, 1);
  row->addWidget(m_mount);
  connect(m_sides, &QComboBox::activated, this, &ToolPostRow::sideChosen);
  connect(m_menu, &QMenu::aboutToShow, this, &ToolPostRow::fillMenu);
}

void ToolPostRow::show(const ManualLatheTool& tool) {
  m_setup = tool.setup();
  m_tools = tool.tools();
  std::vector<std::string> ids;
  for (const LatheSlot& slot : m_setup.stations) ids.push_back(slot.tool);
  const QSignalBlocker quiet(m_sides);
  if (ids != m_listed) {
    m_listed = ids;
    m_sides->clear();
    int number = 1;
    for (const std::string& id : ids) {
      const auto found = toolNamed(m_tools, id);
      m_sides->addItem(QStringLiteral("%1: %2").arg(number++).arg(found ? nameOf(*found) : tr("none")));
    }
  }
  m_sides->setCurrentIndex(static_cast<int>(tool.moment()->machine.tool));
}

// Tools that an exercise does not provide are listed, but disabled.
void ToolPostRow::fillMenu() {
  m_menu->clear();
  for (const auto& tool : m_tools) {
    QAction* const entry = m_menu->addAction(
        tool->kind == LatheToolKind::Drill ? tr("%1, in the tailstock").arg(nameOf(*tool)) : nameOf(*tool));
    entry->setObjectName(QStringLiteral("mount/") + QString::fromStdString(tool->id));
    entry->setEnabled(isAllowed(m_setup, tool->id));
    connect(entry, &QAction::triggered, this,
            [this, id = QString::fromStdString(tool->id)] { emit mountRequested(id); });
  }
  m_menu->addSeparator();
  QAction* const none = m_menu->addAction(tr("No tool"));
  none->setObjectName(QStringLiteral("mount/"));
  connect(none, &QAction::triggered, this, [this] { emit mountRequested(QString()); });
}

}  // namespace handwheel
