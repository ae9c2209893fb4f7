// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/StartPage.h"

#include "panels/Tile.h"
#include "theme/Icons.h"
#include "theme/Theme.h"

#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace handwheel {

namespace {

constexpr int kColumnWidth = 2 * 264 + 16;
constexpr int kRecentShown = 6;

QLayout* heading(QWidget* parent) {
  auto* sign = new QLabel(parent);
  sign->setPixmap(icon(QStringLiteral("handwheel"), themeColours(currentTheme()).accent)
                      .pixmap(QSize(48, 48), parent->devicePixelRatioF()));
  auto* name = new QLabel(QStringLiteral("Handwheel"), parent);
  QFont big = name->font();
  big.setPointSizeF(big.pointSizeF() * 2.4);
  big.setWeight(QFont::DemiBold);
  name->setFont(big);
  auto* line = new QLabel(StartPage::tr("Open a scan, see what is wrong with it, close its holes."), parent);
  line->setProperty("muted", true);
  auto* text = new QVBoxLayout;
  text->setSpacing(0);
  text->addWidget(name);
  text->addWidget(line);
  auto* row = new QHBoxLayout;
  row->setSpacing(16);
  row->addWidget(sign);
  row->addLayout(text);
  row->addStretch();
  return row;
}

QPushButton* recentButton(const QString& path, QWidget* parent) {
  const QFileInfo file(path);
  auto* button = new QPushButton(icon(QStringLiteral("documents")), file.fileName(), parent);
  button->setProperty("flat", true);
  button->setStyleSheet(QStringLiteral("text-align: left"));
  button->setToolTip(QDir::toNativeSeparators(path));
  button->setAccessibleName(StartPage::tr("Open %1").arg(file.fileName()));
  button->setObjectName(QStringLiteral("recent/") + file.fileName());
  return button;
}

}  // namespace

StartPage::StartPage(QWidget* parent) : QWidget(parent), m_recentHeader(new QWidget(this)), m_recent(new QVBoxLayout) {
  setObjectName(QStringLiteral("startPage"));
  setAttribute(Qt::WA_StyledBackground);
  auto* sample = new Tile(QStringLiteral("repair"), tr("Repair a scan — try the sample"),
                          tr("A scanned part with holes. Close the first one with Enter."), this);
  sample->setObjectName(QStringLiteral("sampleTile"));
  m_sample = sample;
  auto* open = new Tile(QStringLiteral("open"), tr("Open a file…"),
                        tr("STL, PLY, OBJ or OFF. Or drop files anywhere on this window."), this);
  open->setObjectName(QStringLiteral("openTile"));
  connect(sample, &Tile::clicked, this, &StartPage::sampleRequested);
  connect(open, &Tile::clicked, this, &StartPage::openRequested);
  auto* tiles = new QHBoxLayout;
  tiles->setSpacing(16);
  tiles->addWidget(sample);
  tiles->addWidget(open);
  tiles->addStretch();

  auto* recentTitle = new QLabel(tr("Recent files"), m_recentHeader);
  recentTitle->setProperty("strong", true);
  auto* clear = new QPushButton(tr("Clear"), m_recentHeader);
  clear->setObjectName(QStringLiteral("clearRecent"));
  clear->setProperty("flat", true);
  clear->setAccessibleName(tr("Clear the list of recent files"));
  connect(clear, &QPushButton::clicked, this, &StartPage::clearRecentRequested);
  auto* recentRow = new QHBoxLayout(m_recentHeader);
  recentRow->setContentsMargins(0, 16, 0, 0);
  recentRow->addWidget(recentTitle);
  recentRow->addStretch();
  recentRow->addWidget(clear);
  m_recent->setSpacing(0);

  auto* content = new QWidget(this);
  content->setFixedWidth(kColumnWidth);
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(24);
  column->addLayout(heading(this));
  column->addLayout(tiles);
  auto* recent = new QVBoxLayout;
  recent->setSpacing(4);
  recent->addWidget(m_recentHeader);
  recent->addLayout(m_recent);
  column->addLayout(recent);
  auto* middle = new QHBoxLayout;
  middle->addStretch();
  middle->addWidget(content);
  middle->addStretch();
  auto* all = new QVBoxLayout(this);
  all->addStretch(2);
  all->addLayout(middle);
  all->addStretch(3);
}

void StartPage::setSampleAvailable(bool available) {
  m_sample->setVisible(available);
}

void StartPage::setRecentFiles(const QStringList& paths) {
  while (QLayoutItem* item = m_recent->takeAt(0)) {
    if (item->widget()) item->widget()->deleteLater();
    delete item;
  }
  for (const QString& path : paths.mid(0, kRecentShown)) {
    QPushButton* button = recentButton(path, this);
    connect(button, &QPushButton::clicked, this, [this, path] { emit recentRequested(path); });
    m_recent->addWidget(button);
  }
  m_recentHeader->setVisible(!paths.isEmpty());
}

}  // namespace handwheel
