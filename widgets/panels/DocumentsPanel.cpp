// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/DocumentsPanel.h"

#include "document/Document.h"
#include "document/DocumentKind.h"
#include "theme/Icons.h"

#include <QDir>
#include <QHeaderView>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace handwheel {

namespace {

enum Column { Name, Eye, Columns };
constexpr int kDocumentRole = Qt::UserRole;
constexpr int kVisibleRole = Qt::UserRole + 1;

QTreeWidget* documentTree(QWidget* parent) {
  auto* tree = new QTreeWidget(parent);
  tree->setObjectName(QStringLiteral("documentTree"));
  tree->setAccessibleName(DocumentsPanel::tr("Open documents"));
  tree->setColumnCount(Columns);
  tree->setHeaderHidden(true);
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

DocumentsPanel::DocumentsPanel(QWidget* parent) : QWidget(parent), m_tree(documentTree(this)) {
  setObjectName(QStringLiteral("documentsPanel"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(m_tree);
  connect(m_tree, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem* item, int clickedColumn) {
    Document* document = documentOf(item);
    if (clickedColumn != Eye) return emit activated(document);
    const bool visible = !item->data(Eye, kVisibleRole).toBool();
    item->setData(Eye, kVisibleRole, visible);
    refresh(document);
    emit visibilityChanged(document, visible);
  });
}

void DocumentsPanel::addDocument(Document* document) {
  auto* item = new QTreeWidgetItem(m_tree);
  item->setData(Name, kDocumentRole, QVariant::fromValue(document));
  item->setData(Eye, kVisibleRole, true);
  item->setIcon(Name, icon(QStringLiteral("kind-") + QString::fromStdString(document->kind().id())));
  connect(document, &Document::fileChanged, this, [this, document] { refresh(document); });
  refresh(document);
}

void DocumentsPanel::removeDocument(Document* document) {
  document->disconnect(this);
  delete itemOf(document);
}

void DocumentsPanel::setCurrent(Document* document) {
  m_tree->setCurrentItem(document ? itemOf(document) : nullptr);
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
  item->setToolTip(Eye, visible ? tr("Hide the surface") : tr("Show the surface"));
}

}  // namespace handwheel
