// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <memory>
#include <vector>

class QTabBar;

namespace handwheel {

struct OpenDocument;

// The tab bar, which owns the open documents.
class DocumentTabs : public QFrame {
  Q_OBJECT

 public:
  explicit DocumentTabs(QWidget* parent = nullptr);
  ~DocumentTabs() override;

  OpenDocument* current() const;
  const std::vector<std::unique_ptr<OpenDocument>>& all() const { return m_documents; }
  bool contains(const OpenDocument* document) const;
  OpenDocument* withPath(const QString& path) const;  // null when it is not open

  void add(std::unique_ptr<OpenDocument> document);  // and makes it current
  void setCurrent(const OpenDocument* document);
  void step(int places);                 // to the right, cyclically
  void close(OpenDocument* document);    // without asking
  void setCloseTip(const QString& tip);  // of the button in each tab

 signals:
  void added(handwheel::OpenDocument* document);
  void currentChanged(handwheel::OpenDocument* document);  // null when none is left
  void closing(handwheel::OpenDocument* document);         // the last signal for which the pointer is valid
  void closeRequested(handwheel::OpenDocument* document);

 private:
  int indexOf(const OpenDocument* document) const;
  void refresh(const OpenDocument* document);

  QTabBar* m_bar;
  QString m_closeTip;
  std::vector<std::unique_ptr<OpenDocument>> m_documents;  // in the order of the tabs
};

}  // namespace handwheel
