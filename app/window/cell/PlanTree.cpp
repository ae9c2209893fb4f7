// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/cell/PlanTree.h"

#include "controls/OwnKeys.h"
#include "document/cell/CellArms.h"
#include "theme/Icons.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QScrollBar>
#include <QTreeWidgetItemIterator>
#include <algorithm>
#include <utility>

namespace handwheel {

namespace {

constexpr int kKindRole = Qt::UserRole, kNameRole = Qt::UserRole + 1, kWaypointRole = Qt::UserRole + 2;

}  // namespace

PlanTree::PlanTree(QWidget* parent) : QTreeWidget(parent) {
  setObjectName(QStringLiteral("planTree"));
  setAccessibleName(tr("Configurations, paths, targets and frames"));
  setColumnCount(2);
  setHeaderHidden(true);
  constexpr int kIndentation = 14;  // pixels: the panel is narrow
  setIndentation(kIndentation);
  header()->setSectionResizeMode(0, QHeaderView::Fixed);
  setSelectionMode(QAbstractItemView::SingleSelection);
  setEditTriggers(QAbstractItemView::EditKeyPressed);
  setContextMenuPolicy(Qt::CustomContextMenu);
  new OwnKeys(*this, {Qt::Key_Return, Qt::Key_Enter, Qt::Key_Delete});
  connect(this, &QTreeWidget::currentItemChanged, this, [this] {
    if (!m_isFilling) emit currentChanged();
  });
  connect(this, &QTreeWidget::itemExpanded, this, [this] {
    if (!m_isFilling) shareColumns();
  });
  connect(this, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* item) { emit activated(entryOf(item)); });
  connect(this, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item, int column) {
    if (m_isFilling || column != 0) return;
    if (!indexWidget(indexFromItem(item))) return emit renameRequested(entryOf(item), item->text(0).trimmed());
    m_renamed = entryOf(item);
    m_newName = item->text(0).trimmed();
  });
}

// Renaming fills the tree anew, which removes the editor: it has to be closed by then.
void PlanTree::closeEditor(QWidget* editor, QAbstractItemDelegate::EndEditHint hint) {
  QTreeWidget::closeEditor(editor, hint);
  const Entry renamed = std::exchange(m_renamed, Entry());
  if (renamed.kind != Entry::Kind::None) emit renameRequested(renamed, m_newName);
}

PlanTree::Entry PlanTree::entryOf(const QTreeWidgetItem* item) const {
  if (!item) return {};
  return {static_cast<Entry::Kind>(item->data(0, kKindRole).toInt()), item->data(0, kNameRole).toString().toStdString(),
          static_cast<std::size_t>(item->data(0, kWaypointRole).toULongLong())};
}

QTreeWidgetItem* PlanTree::add(QTreeWidgetItem* parent, const Entry& entry, const QString& text,
                               const QString& status) {
  auto* item = new QTreeWidgetItem({text, status});
  item->setData(0, kKindRole, static_cast<int>(entry.kind));
  item->setData(0, kNameRole, QString::fromStdString(entry.name));
  item->setData(0, kWaypointRole, static_cast<qulonglong>(entry.waypoint));
  item->setToolTip(0, text);
  item->setToolTip(1, status);
  const bool isNamed = entry.kind != Entry::Kind::Waypoint && entry.kind != Entry::Kind::Robot;
  item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | (isNamed ? Qt::ItemIsEditable : Qt::NoItemFlags));
  parent->addChild(item);
  return item;
}

void PlanTree::addRobots(const CellPlans& plans, const CellRobot& robot) {
  auto* robots = new QTreeWidgetItem(this, {tr("Robots")});
  robots->setFlags(Qt::ItemIsEnabled);
  for (const RobotArm& arm : robot.arms) {
    const bool isPlanned = arm == activeArm(robot, plans);
    add(robots, {Entry::Kind::Robot, arm.name}, QString::fromStdString(arm.name),
        isPlanned ? tr("planned for") : QString());
  }
  robots->setExpanded(true);
}

void PlanTree::setPlans(const CellPlans& plans, const CellRobot* robot,
                        const std::map<std::string, PathStatus>& statuses,
                        const std::map<std::string, TargetReach>& reach,
                        const std::map<std::string, QString>& remarks) {
  m_isFilling = true;
  const Entry before = current();
  const auto* editor = qobject_cast<QLineEdit*>(indexWidget(currentIndex()));
  const QString typed = editor ? editor->text() : QString();
  std::set<std::string> collapsed;
  for (QTreeWidgetItemIterator it(this); *it; ++it) {
    const Entry entry = entryOf(*it);
    if (entry.kind == Entry::Kind::Path && !(*it)->isExpanded()) collapsed.insert(entry.name);
  }
  const int scrolledBy = verticalScrollBar()->value();
  clear();
  const auto waypointText = [](const Waypoint& waypoint, std::size_t number) {
    const QString name = QString::fromStdString(waypoint.name);
    if (!name.isEmpty()) return tr("%1: %2").arg(number + 1).arg(name);
    return waypoint.isCritical ? tr("%1: critical").arg(number + 1) : QString::number(number + 1);
  };
  // The robot, if it is not the one that is planned for.
  const auto ofOther = [&](const std::string& arm) {
    const auto number = robot ? armNumber(*robot, arm) : std::nullopt;
    if (!number || *number == activeArmNumber(*robot, plans)) return QString();
    return tr("of %1").arg(QString::fromStdString(robot->arms[*number].name));
  };
  constexpr std::size_t kMostWaypoints = 2'000;  // Limit on the listed waypoints of a path
  auto* configurations = new QTreeWidgetItem(this, {tr("Configurations")});
  configurations->setFlags(Qt::ItemIsEnabled);
  for (const NamedConfiguration& each : plans.configurations)
    add(configurations, {Entry::Kind::Configuration, each.name}, QString::fromStdString(each.name), ofOther(each.arm));
  auto* paths = new QTreeWidgetItem(this, {tr("Paths")});
  paths->setFlags(Qt::ItemIsEnabled);
  for (const RobotPath& path : plans.paths) {
    const auto known = statuses.find(path.name);
    const PathStatus status = known == statuses.end() ? PathStatus() : known->second;
    const QString owner = ofOther(path.arm);
    QTreeWidgetItem* item = add(paths, {Entry::Kind::Path, path.name}, QString::fromStdString(path.name),
                                owner.isEmpty() ? status.text : tr("%1: %2").arg(owner, status.text));
    item->setToolTip(1, status.details);
    if (!status.icon.isEmpty()) item->setIcon(0, icon(status.icon));
    for (std::size_t i = 0; i < std::min(path.waypoints.size(), kMostWaypoints); ++i) {
      add(item, {Entry::Kind::Waypoint, path.name, i}, waypointText(path.waypoints[i], i),
          path.waypoints[i].motion == ProgramMotion::Kind::Linear ? tr("straight line") : QString());
    }
    item->setExpanded(!collapsed.contains(path.name));
  }
  auto* targets = new QTreeWidgetItem(this, {tr("Targets")});
  targets->setFlags(Qt::ItemIsEnabled);
  for (const NamedTarget& each : plans.targets) {
    const auto known = reach.find(each.name);
    const bool isKnown = known != reach.end();
    QTreeWidgetItem* item = add(targets, {Entry::Kind::Target, each.name}, QString::fromStdString(each.name),
                                isKnown ? known->second.remark : QString());
    if (isKnown) item->setIcon(0, icon(known->second.isFree ? QStringLiteral("ok") : QStringLiteral("warning")));
  }
  if (!plans.frames.empty()) {
    auto* frames = new QTreeWidgetItem(this, {tr("Frames")});
    frames->setFlags(Qt::ItemIsEnabled);
    for (const NamedFrame& each : plans.frames) {
      const auto remark = remarks.find(each.name);
      add(frames, {Entry::Kind::Frame, each.name}, QString::fromStdString(each.name),
          remark == remarks.end() ? QString() : remark->second);
    }
    frames->setExpanded(true);
  }
  if (robot && robot->arms.size() > 1) addRobots(plans, *robot);
  targets->setExpanded(true);
  configurations->setExpanded(true);
  paths->setExpanded(true);
  shareColumns();
  // The rows do not scroll: a click may be about to hit one.
  setAutoScroll(false);
  select(before);
  setAutoScroll(true);
  executeDelayedItemsLayout();
  verticalScrollBar()->setValue(scrolledBy);
  m_isFilling = false;
  // A name that is being typed goes on being typed in the new row.
  if (!editor || current() != before) return;
  editItem(currentItem(), 0);
  if (auto* const again = qobject_cast<QLineEdit*>(indexWidget(currentIndex()))) again->setText(typed);
}

PlanTree::Entry PlanTree::current() const {
  return entryOf(currentItem());
}

void PlanTree::select(const Entry& entry) {
  if (entry.kind == Entry::Kind::None) return;
  for (QTreeWidgetItemIterator it(this); *it; ++it) {
    if (entryOf(*it) == entry) return setCurrentItem(*it);
  }
}

// Long names leave room for what is known of their rows.
void PlanTree::shareColumns() {
  constexpr double kMostOfNames = 0.55;
  const int most = static_cast<int>(kMostOfNames * viewport()->width());
  header()->resizeSection(0, std::min(sizeHintForColumn(0), most));
}

void PlanTree::resizeEvent(QResizeEvent* event) {
  QTreeWidget::resizeEvent(event);
  shareColumns();
}

void PlanTree::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Delete) return emit removalRequested();
  QTreeWidget::keyPressEvent(event);
}

}  // namespace handwheel
