// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/DocumentsPanel.h"

#include "document/Document.h"
#include "document/DocumentKind.h"
#include "theme/Icons.h"

#include <QDir>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QSignalBlocker>
#include <QStyledItemDelegate>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace handwheel {

namespace {

enum RowColumn { Name, Eye, RowColumns };
constexpr int kDocumentRole = Qt::UserRole;
constexpr int kVisibleRole = Qt::UserRole + 1;
constexpr QSize kEye(16, 16);
constexpr QSize kRowPicture(48, 30);  // logical pixels, with the sides of a thumbnail

// The eye is smaller than the pictures, whose size applies to the whole tree.
class EyeDelegate final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
    QStyledItemDelegate::initStyleOption(option, index);
    option->decorationSize = kEye;
  }
};

QTreeWidget* documentTree(QWidget* parent) {
  auto* tree = new QTreeWidget(parent);
  tree->setObjectName(QStringLiteral("documentTree"));
  tree->setAccessibleName(DocumentsPanel::tr("Open documents"));
  tree->setColumnCount(RowColumns);
  tree->setHeaderHidden(true);
  tree->setIconSize(kRowPicture);
  tree->setItemDelegateForColumn(Eye, new EyeDelegate(tree));
  tree->setRootIsDecorated(false);
  tree->header()->setStretchLastSection(false);
  tree->header()->setMinimumSectionSize(28);
  tree->header()->setSectionResizeMode(Name, QHeaderView::Stretch);
  tree->header()->setSectionResizeMode(Eye, QHeaderView::Fixed);
  tree->header()->resizeSection(Eye, 28);
  return tree;
}

Document* documentOf(const QTreeWidgetItem* item) {
  return item->data(Name, kDocumentRole).value<Document*>();
}

}  // namespace

DocumentsPanel::DocumentsPanel(QWidget* parent)
    : QWidget(parent), m_tree(documentTree(this)), m_visibility(tr("Hide or show the d&ocument"), this) {
  setObjectName(QStringLiteral("documentsPanel"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(m_tree);
  m_visibility.setObjectName(QStringLiteral("toggleDocument"));
  m_visibility.setIcon(icon(QStringLiteral("eye")));
  m_visibility.setShortcut(QKeySequence(Qt::CTRL | Qt::Key_H));
  m_visibility.setEnabled(false);
  connect(&m_visibility, &QAction::triggered, this, [this] { toggle(m_tree->currentItem()); });
  m_tree->installEventFilter(this);
  m_tree->viewport()->installEventFilter(this);
  connect(m_tree, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
    if (item) emit chosen(documentOf(item));
  });
  connect(m_tree, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem* item) { emit activated(documentOf(item)); });
}

// The keys of a row are not commands of the window, and a press on an eye does not choose its row.
bool DocumentsPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == m_tree && (event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress)) {
    const auto* pressed = static_cast<QKeyEvent*>(event);
    const bool taken = pressed->modifiers() == Qt::NoModifier || pressed->modifiers() == Qt::KeypadModifier;
    const int key = taken ? pressed->key() : 0;
    if (event->type() == QEvent::KeyPress) return takesKey(key);
    if (key == Qt::Key_Space || key == Qt::Key_Return || key == Qt::Key_Enter) event->accept();
    return event->isAccepted();
  }
  if (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonDblClick) {
    const auto* pressed = static_cast<QMouseEvent*>(event);
    QTreeWidgetItem* item = watched == m_tree->viewport() ? itemWithEyeAt(pressed->pos()) : nullptr;
    if (item && pressed->button() == Qt::LeftButton) {
      toggle(item);
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

bool DocumentsPanel::takesKey(int key) {
  QTreeWidgetItem* item = m_tree->currentItem();
  if (!item) return false;
  if (key == Qt::Key_Space) {
    toggle(item);
    return true;
  }
  if (key != Qt::Key_Return && key != Qt::Key_Enter) return false;
  emit activated(documentOf(item));
  return true;
}

QTreeWidgetItem* DocumentsPanel::itemWithEyeAt(const QPoint& position) const {
  return m_tree->columnAt(position.x()) == Eye ? m_tree->itemAt(position) : nullptr;
}

void DocumentsPanel::toggle(QTreeWidgetItem* item) {
  const bool visible = !item->data(Eye, kVisibleRole).toBool();
  item->setData(Eye, kVisibleRole, visible);
  refresh(documentOf(item));
  emit visibilityChanged(documentOf(item), visible);
}

void DocumentsPanel::addDocument(Document* document) {
  const QSignalBlocker quiet(m_tree);  // the first one becomes the present row by itself
  auto* item = new QTreeWidgetItem(m_tree);
  item->setData(Name, kDocumentRole, QVariant::fromValue(document));
  item->setData(Eye, kVisibleRole, true);
  item->setIcon(Name, icon(QStringLiteral("kind-") + QString::fromStdString(document->kind().id())));
  connect(document, &Document::fileChanged, this, [this, document] { refresh(document); });
  refresh(document);
}

void DocumentsPanel::removeDocument(Document* document) {
  const QSignalBlocker quiet(m_tree);  // the rows do not decide which document comes next
  document->disconnect(this);
  delete itemOf(document);
}

void DocumentsPanel::setCurrent(Document* document) {
  const QSignalBlocker quiet(m_tree);
  m_tree->setCurrentItem(document ? itemOf(document) : nullptr);
  m_visibility.setEnabled(document != nullptr);
}

void DocumentsPanel::setPicture(const Document* document, const QPixmap& picture) {
  QTreeWidgetItem* item = itemOf(document);
  if (item && !picture.isNull()) item->setIcon(Name, QIcon(picture));
}

QTreeWidgetItem* DocumentsPanel::itemOf(const Document* document) const {
  for (int i = 0; i < m_tree->topLevelItemCount(); ++i) {
    if (documentOf(m_tree->topLevelItem(i)) == document) return m_tree->topLevelItem(i);
  }
  return nullptr;
}

void DocumentsPanel::refresh(const Document* document) {
  QTreeWidgetItem* item = itemOf(document);
  if (!item) return;
  const bool visible = item->data(Eye, kVisibleRole).toBool();
  item->setText(Name, document->isModified() ? document->name() + QStringLiteral(" •") : document->name());
  item->setToolTip(Name, QDir::toNativeSeparators(document->path()));
  item->setIcon(Eye, icon(visible ? QStringLiteral("eye") : QStringLiteral("eye-off")));
  const QString name = document->isModified() ? tr("%1, not saved").arg(document->name()) : document->name();
  item->setData(Name, Qt::AccessibleTextRole, visible ? name : tr("%1, hidden").arg(name));
  item->setData(Eye, Qt::AccessibleTextRole, visible ? tr("Shown") : tr("Hidden"));
  item->setToolTip(Eye, visible ? tr("Hide the surface") : tr("Show the surface"));
}

}  // namespace handwheel
