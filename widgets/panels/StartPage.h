// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPixmap>
#include <QStringList>
#include <QWidget>
#include <array>
#include <functional>

class QGridLayout;
class QLabel;

namespace handwheel {

class Tile;

// What is shown when no document is open: a sample for each trade, a file to open, and what was open before.
class StartPage : public QWidget {
  Q_OBJECT

 public:
  enum class Sample { Scan, Lathe, Cell };
  Q_ENUM(Sample)
  // The picture of a file; a null one where there is none.
  using Pictures = std::function<QPixmap(const QString& path)>;
  // The name of a drawing for a file that has no picture.
  using IconNames = std::function<QString(const QString& path)>;

  explicit StartPage(QWidget* parent = nullptr);

  // A sample that is not installed is shown, but cannot be opened.
  void setSampleAvailable(Sample sample, bool available);
  void setPictures(Pictures pictures, IconNames icons);
  void setRecentFiles(const QStringList& paths);

 signals:
  void sampleChosen(handwheel::StartPage::Sample sample);
  void openRequested();
  void recentRequested(const QString& path);
  void clearRecentRequested();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void makeSamples();
  void makeScrollable();
  QLayout* heading();
  QWidget* recentHeader();
  void drawSign();
  Tile* recentTile(const QString& path);
  void arrange();

  QLabel* m_sign;
  QWidget* m_content;
  QWidget* m_recentHeader = nullptr;
  QGridLayout* m_samples;
  QGridLayout* m_recent;
  std::array<Tile*, 3> m_sampleTiles{};
  QList<Tile*> m_recentTiles;
  QStringList m_paths;
  Pictures m_pictures;
  IconNames m_icons;
};

}  // namespace handwheel
