// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPixmap>
#include <QStringList>
#include <QWidget>
#include <functional>
#include <vector>

class QGridLayout;
class QLabel;
class QPushButton;

namespace handwheel {

class Tile;

// The contents of a tile that creates or opens a document.
struct StartTile {
  QString name;  // object name of the widget
  QString icon;  // name of an icon
  QString title;
  QString line;
  bool isAvailable = true;  // false: the sample is not installed; the tile is shown, but cannot be opened
};

// The page that is shown when no document is open. It has a sample for each field of work, a button to open a file, and
// the recent files.
class StartPage : public QWidget {
  Q_OBJECT

 public:
  // Function that returns the thumbnail of a file, or a null pixmap if there is none.
  using Pictures = std::function<QPixmap(const QString& path)>;
  // Function that returns the icon name for a file without a thumbnail.
  using IconNames = std::function<QString(const QString& path)>;

  explicit StartPage(QWidget* parent = nullptr);

  void setTiles(const std::vector<StartTile>& tiles);
  void setPictures(Pictures pictures, IconNames icons);
  void setRecentFiles(const QStringList& paths);

 signals:
  void tileChosen(const QString& name);
  void openRequested();
  void recentRequested(const QString& path);
  void clearRecentRequested();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void makeScrollable();
  QLayout* heading();
  QWidget* recentHeader();
  void drawSign();
  Tile* recentTile(const QString& path);
  void arrange();
  void orderKeys();

  QLabel* m_sign;
  QWidget* m_content;
  QWidget* m_recentHeader = nullptr;
  QPushButton* m_open = nullptr;
  QPushButton* m_clear = nullptr;
  QGridLayout* m_tiles;
  QGridLayout* m_recent;
  QList<Tile*> m_startTiles;
  QList<Tile*> m_recentTiles;
  QStringList m_paths;
  Pictures m_pictures;
  IconNames m_icons;
};

}  // namespace handwheel
