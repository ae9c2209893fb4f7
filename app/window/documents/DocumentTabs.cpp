// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/documents/DocumentTabs.h"

#include "theme/Icons.h"
#include "window/documents/DocumentTab.h"

#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QTabBar>
#include <QToolButton>
#include <algorithm>

namespace handwheel {

namespace {

// Files that are gone are distinguished by their names: Qt takes all of them for the same.
bool isFileOf(const Document& document, const QFileInfo& wanted) {
  if (document.file().path.empty()) return false;
  const QFileInfo own(document.path());
  return own.exists() && wanted.exists() ? own == wanted : own.absoluteFilePath() == wanted.absoluteFilePath();
}

}  // namespace

DocumentTabs::DocumentTabs(QWidget* parent) : QFrame(parent), m_bar(new QTabBar(this)) {
  setObjectName(QStringLiteral("tabRow"));
  m_bar->setObjectName(QStringLiteral("documentTabBar"));
  m_bar->setAccessibleName(tr("Open documents"));
  m_bar->setDocumentMode(true);
  m_bar->setDrawBase(false);
  m_bar->setExpanding(false);
  m_bar->setMovable(true);
  m_bar->setElideMode(Qt::ElideMiddle);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(m_bar);
  row->addStretch();
  connect(m_bar, &QTabBar::currentChanged, this, [this] { emit currentChanged(current()); });
  connect(m_bar, &QTabBar::tabMoved, this, [this](int from, int to) {
    const auto first = m_documents.begin() + std::min(from, to), last = m_documents.begin() + std::max(from, to) + 1;
    std::rotate(first, from < to ? first + 1 : last - 1, last);
  });
}

DocumentTabs::~DocumentTabs() = default;

DocumentTab* DocumentTabs::current() const {
  const int i = m_bar->currentIndex();
  return i < 0 ? nullptr : m_documents[static_cast<std::size_t>(i)].get();
}

bool DocumentTabs::contains(const DocumentTab* document) const {
  return indexOf(document) >= 0;
}

DocumentTab* DocumentTabs::withPath(const QString& path) const {
  const QFileInfo wanted(path);
  for (const auto& each : m_documents)
    if (isFileOf(each->document, wanted)) return each.get();
  return nullptr;
}

bool DocumentTabs::isOpenBeside(const Document* document, const QString& path) const {
  const QFileInfo wanted(path);
  return std::any_of(m_documents.begin(), m_documents.end(),
                     [&](const auto& each) { return &each->document != document && isFileOf(each->document, wanted); });
}

void DocumentTabs::add(std::unique_ptr<DocumentTab> document) {
  DocumentTab* added = document.get();
  m_documents.push_back(std::move(document));
  int index = -1;
  {
    const QSignalBlocker quiet(m_bar);  // announced below, when the tab is complete
    index = m_bar->addTab({});
    auto* close = new QToolButton(m_bar);
    close->setObjectName(QStringLiteral("closeTab"));
    close->setIcon(icon(QStringLiteral("close")));
    close->setIconSize({12, 12});
    close->setFocusPolicy(Qt::NoFocus);  // the keyboard closes by its own command: Space must not, by accident
    close->setAccessibleName(tr("Close %1").arg(added->document.name()));
    close->setToolTip(m_closeTip);
    connect(close, &QToolButton::clicked, this, [this, added] { emit closeRequested(added); });
    m_bar->setTabButton(index, QTabBar::RightSide, close);
    m_bar->setCurrentIndex(index);
  }
  connect(&added->document, &Document::fileChanged, this, [this, added] { refresh(added); });
  refresh(added);
  emit this->added(added);
  emit currentChanged(added);
}

void DocumentTabs::setCloseTip(const QString& tip) {
  m_closeTip = tip;
  for (auto* close : m_bar->findChildren<QToolButton*>(QStringLiteral("closeTab"))) close->setToolTip(tip);
}

void DocumentTabs::setCurrent(const DocumentTab* document) {
  m_bar->setCurrentIndex(indexOf(document));
}

void DocumentTabs::step(int count) {
  if (m_bar->count() == 0) return;
  m_bar->setCurrentIndex((m_bar->currentIndex() + count + m_bar->count()) % m_bar->count());
}

void DocumentTabs::close(DocumentTab* document) {
  const int index = indexOf(document);
  emit closing(document);
  std::unique_ptr<DocumentTab> last = std::move(m_documents[static_cast<std::size_t>(index)]);
  m_documents.erase(m_documents.begin() + index);
  {
    const QSignalBlocker quiet(m_bar);
    m_bar->removeTab(index);
  }
  emit currentChanged(current());
}

int DocumentTabs::indexOf(const DocumentTab* document) const {
  const auto found = std::find_if(m_documents.begin(), m_documents.end(),
                                  [document](const auto& each) { return each.get() == document; });
  return found == m_documents.end() ? -1 : static_cast<int>(found - m_documents.begin());
}

void DocumentTabs::refresh(const DocumentTab* document) {
  const int index = indexOf(document);
  if (index < 0) return;
  const QString name = document->document.name();
  QString text = name;
  text.replace(QLatin1Char('&'), QLatin1String("&&"));
  m_bar->setTabText(index, document->document.isModified() ? text + QStringLiteral(" •") : text);
  m_bar->setTabToolTip(index, QDir::toNativeSeparators(document->document.path()));
}

}  // namespace handwheel
