// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QWidget>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace handwheel {

// What is shown when no document is open: the sample to try, a file to open, and what was open before.
class StartPage : public QWidget {
  Q_OBJECT

 public:
  explicit StartPage(QWidget* parent = nullptr);

  void setSampleAvailable(bool available);
  void setRecentFiles(const QStringList& paths);

 signals:
  void sampleRequested();
  void openRequested();
  void recentRequested(const QString& path);
  void clearRecentRequested();

 private:
  QWidget* m_sample;
  QWidget* m_recentHeader;
  QVBoxLayout* m_recent;
};

}  // namespace handwheel
