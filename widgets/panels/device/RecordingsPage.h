// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>
#include <vector>

class QAction;
class QLabel;
class QSlider;
class QTableWidget;
class QTableWidgetItem;

namespace handwheel {

// The page with the haptic recordings of a document. It shows a running recording, the list of recordings, and the
// position of playback. The page only displays values, and emits signals for the user's requests.
class RecordingsPage : public QWidget {
  Q_OBJECT

 public:
  struct Actions {
    QAction* record;
    QAction* play;
    QAction* leave;
    QAction* exportCsv;
    QAction* rename;
    QAction* remove;
  };
  struct Row {
    QString key;
    QString name;
    double duration = 0.0;  // s
    std::size_t ticks = 0;
    std::uint64_t missing = 0;  // ticks missing within the recording

    bool operator==(const Row&) const = default;
  };

  explicit RecordingsPage(const Actions& actions, QWidget* parent = nullptr);

  // Shows the list of recordings. chosen: the key of the selected row; empty: none.
  void showRecordings(const std::vector<Row>& rows, const QString& chosen);
  void showRecorded(double seconds, std::size_t ticks);  // length of the running recording
  void showNotRecording();
  void showPosition(double seconds, double duration);  // position of playback, s; duration 0: no playback
  void editName(const QString& key);

 signals:
  void chosen(const QString& key);
  void renamed(const QString& key, const QString& name);
  void seekRequested(double seconds);

 private:
  void fill(int at, const Row& row);
  int rowOf(const QString& key) const;  // -1: none
  void take(QTableWidgetItem* item);

  std::vector<Row> m_rows;
  QLabel* m_recorded;
  QTableWidget* m_list;  // name and duration
  QSlider* m_slider;     // milliseconds
  QLabel* m_position;
};

}  // namespace handwheel
