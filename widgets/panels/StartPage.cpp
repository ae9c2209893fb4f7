// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/StartPage.h"

#include "panels/Tile.h"
#include "theme/Icons.h"
#include "theme/Theme.h"

#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QStyle>
#include <algorithm>

namespace handwheel {

namespace {

constexpr int kWidestPage = 840;
constexpr int kPageMargin = 24;
constexpr int kTileGap = 16;
constexpr int kNarrowestTile = 152;
constexpr int kMostColumns = 3;
constexpr QSize kPicture(134, 86);
constexpr int kRecentWidth = kPicture.width() + 18;
constexpr int kRecentShown = 10;

// Arranges tiles in rows of so many columns of equal width.
template <class Tiles>
void fill(QGridLayout& grid, const Tiles& tiles, int columns, bool stretched) {
  while (grid.count() > 0) delete grid.takeAt(0);
  for (int column = 0; column < grid.columnCount(); ++column) grid.setColumnStretch(column, 0);
  for (int i = 0; i < static_cast<int>(tiles.size()); ++i) {
    grid.addWidget(tiles[static_cast<typename Tiles::size_type>(i)], i / columns, i % columns);
    if (stretched) grid.setColumnStretch(i % columns, 1);
  }
  if (!stretched) grid.setColumnStretch(columns, 1);
}

}  // namespace

StartPage::StartPage(QWidget* parent)
    : QWidget(parent),
      m_sign(new QLabel(this)),
      m_content(new QWidget(this)),
      m_tiles(new QGridLayout),
      m_recent(new QGridLayout) {
  setObjectName(QStringLiteral("startPage"));
  setAttribute(Qt::WA_StyledBackground);
  m_open = new QPushButton(icon(QStringLiteral("open")), tr("Open a file…"), m_content);
  m_open->setObjectName(QStringLiteral("openTile"));
  m_open->setToolTip(tr("Or drop files anywhere on this window"));
  connect(m_open, &QPushButton::clicked, this, &StartPage::openRequested);
  m_recentHeader = recentHeader();
  m_tiles->setSpacing(kTileGap);
  m_recent->setSpacing(8);
  auto* column = new QVBoxLayout(m_content);
  column->setContentsMargins(kPageMargin, kPageMargin, kPageMargin, kPageMargin);
  column->setSpacing(kTileGap);
  column->addStretch(2);
  column->addLayout(heading());
  column->addSpacing(8);
  column->addLayout(m_tiles);
  column->addWidget(m_open, 0, Qt::AlignLeft);
  column->addWidget(m_recentHeader);
  column->addLayout(m_recent);
  column->addStretch(3);
  makeScrollable();
  setRecentFiles({});
  drawSign();
}

// Needed if the window is small or the letters are large.
void StartPage::makeScrollable() {
  m_content->setMaximumWidth(kWidestPage);
  auto* scroll = new QScrollArea(this);
  scroll->setObjectName(QStringLiteral("startScroll"));
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setAlignment(Qt::AlignHCenter);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFocusPolicy(Qt::NoFocus);  // its tiles have it, and are scrolled to
  scroll->setWidget(m_content);
  scroll->viewport()->setAutoFillBackground(false);
  m_content->setAutoFillBackground(false);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->addWidget(scroll);
}

QLayout* StartPage::heading() {
  auto* name = new QLabel(QStringLiteral("Handwheel"), m_content);
  QFont big = name->font();
  big.setPointSizeF(big.pointSizeF() * 2.4);
  big.setWeight(QFont::DemiBold);
  name->setFont(big);
  auto* line = new QLabel(tr("Repair scans, shape clay, practise at lathe and drill, arrange robot cells."), m_content);
  line->setProperty("muted", true);
  line->setWordWrap(true);
  auto* text = new QVBoxLayout;
  text->setSpacing(0);
  text->addWidget(name);
  text->addWidget(line);
  auto* row = new QHBoxLayout;
  row->setSpacing(kTileGap);
  row->addWidget(m_sign);
  row->addLayout(text, 1);
  return row;
}

QWidget* StartPage::recentHeader() {
  auto* header = new QWidget(m_content);
  auto* title = new QLabel(tr("Recent files"), header);
  title->setProperty("strong", true);
  m_clear = new QPushButton(tr("Clear"), header);
  m_clear->setObjectName(QStringLiteral("clearRecent"));
  m_clear->setProperty("flat", true);
  m_clear->setAccessibleName(tr("Clear the list of recent files"));
  connect(m_clear, &QPushButton::clicked, this, &StartPage::clearRecentRequested);
  auto* row = new QHBoxLayout(header);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(title);
  row->addStretch();
  row->addWidget(m_clear);
  return header;
}

void StartPage::setTiles(const std::vector<StartTile>& tiles) {
  qDeleteAll(std::exchange(m_startTiles, {}));
  for (const StartTile& each : tiles) {
    const QString line = each.isAvailable ? each.line : tr("The sample is not installed.");
    auto* tile = new Tile(each.icon, each.title, line, m_content);
    tile->setObjectName(each.name);
    tile->setEnabled(each.isAvailable);
    connect(tile, &Tile::clicked, this, [this, name = each.name] { emit tileChosen(name); });
    m_startTiles << tile;
  }
  arrange();
  orderKeys();
}

// Sets the tab order to the reading order.
void StartPage::orderKeys() {
  QWidgetList order;
  for (Tile* tile : m_startTiles) order << tile;
  order << m_open << m_clear;
  for (Tile* tile : m_recentTiles) order << tile;
  for (int i = 1; i < order.size(); ++i) setTabOrder(order[i - 1], order[i]);
}

void StartPage::setPictures(Pictures pictures, IconNames icons) {
  m_pictures = std::move(pictures);
  m_icons = std::move(icons);
  setRecentFiles(m_paths);
}

void StartPage::setRecentFiles(const QStringList& paths) {
  m_paths = paths;
  for (Tile* tile : std::exchange(m_recentTiles, {})) {  // one of them may be the sender of the present signal
    tile->hide();
    tile->deleteLater();
  }
  for (const QString& path : paths.mid(0, kRecentShown)) m_recentTiles << recentTile(path);
  m_recentHeader->setVisible(!paths.isEmpty());
  arrange();
  orderKeys();
}

Tile* StartPage::recentTile(const QString& path) {
  const QFileInfo file(path);
  QFont strong = font();
  strong.setBold(true);
  const QString name = QFontMetrics(strong).elidedText(file.fileName(), Qt::ElideMiddle, kPicture.width());
  const QString folder = fontMetrics().elidedText(QDir(file.path()).dirName(), Qt::ElideMiddle, kPicture.width());
  auto* tile = new Tile(m_icons ? m_icons(path) : QStringLiteral("file"), name, folder, m_content);
  tile->setPicture(m_pictures ? m_pictures(path) : QPixmap(), kPicture);
  tile->layout()->setContentsMargins(8, 8, 8, 8);
  tile->layout()->setSpacing(2);
  tile->setFixedWidth(kRecentWidth);
  tile->setToolTip(QDir::toNativeSeparators(path));
  tile->setAccessibleName(tr("Open %1").arg(file.fileName()));
  tile->setAccessibleDescription(QDir::toNativeSeparators(path));
  tile->setObjectName(QStringLiteral("recent/") + file.fileName());
  connect(tile, &Tile::clicked, this, [this, path] { emit recentRequested(path); });
  return tile;
}

// Arranges the tiles in as many columns as fit.
void StartPage::arrange() {
  const int bar = style()->pixelMetric(QStyle::PM_ScrollBarExtent);
  const int room = std::min(width(), kWidestPage) - 2 * kPageMargin - (width() < kWidestPage + bar ? bar : 0);
  fill(*m_tiles, m_startTiles, std::clamp((room + kTileGap) / (kNarrowestTile + kTileGap), 1, kMostColumns), true);
  fill(*m_recent, m_recentTiles, std::max(1, (room + 8) / (kRecentWidth + 8)), false);
}

void StartPage::drawSign() {
  m_sign->setPixmap(icon(QStringLiteral("handwheel"), themeColours(currentTheme()).accent)
                        .pixmap(QSize(48, 48), devicePixelRatioF()));
}

void StartPage::resizeEvent(QResizeEvent* event) {
  arrange();
  QWidget::resizeEvent(event);
}

void StartPage::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) drawSign();
  QWidget::changeEvent(event);
}

}  // namespace handwheel
