// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <memory>
#include <vector>

class QTabBar;

namespace handwheel {

class Document;
struct DocumentTab;

// The tab bar, which owns the open documents.
class DocumentTabs : public QFrame {
  Q_OBJECT

 public:
  explicit DocumentTabs(QWidget* parent = nullptr);
  ~DocumentTabs() override;

  DocumentTab* current() const;
  const std::vector<std::unique_ptr<DocumentTab>>& all() const { return m_documents; }
  bool contains(const DocumentTab* document) const;
  DocumentTab* withPath(const QString& path) const;  // null: no document has this path
  // Returns true if the file is open in a document other than the given one. document: may be null.
  bool isOpenBeside(const Document* document, const QString& path) const;

  void add(std::unique_ptr<DocumentTab> document);  // also makes it current
  void setCurrent(const DocumentTab* document);
  void step(int count);                  // makes the tab this many positions to the right current, cyclically
  void close(DocumentTab* document);     // closes the document without asking
  void setCloseTip(const QString& tip);  // tool tip of the close button in each tab

 signals:
  void added(handwheel::DocumentTab* document);
  void currentChanged(handwheel::DocumentTab* document);  // null: no document is open
  void closing(handwheel::DocumentTab* document);         // the last signal for which the pointer is valid
  void closeRequested(handwheel::DocumentTab* document);

 private:
  int indexOf(const DocumentTab* document) const;
  void refresh(const DocumentTab* document);

  QTabBar* m_bar;
  QString m_closeTip;
  std::vector<std::unique_ptr<DocumentTab>> m_documents;  // in the order of the tabs
};

}  // namespace handwheel
