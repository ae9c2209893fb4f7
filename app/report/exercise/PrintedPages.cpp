// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/exercise/PrintedPages.h"

#include <QAbstractTextDocumentLayout>
#include <QPagedPaintDevice>
#include <QPainter>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextTable>
#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kMarginOfPaper = 2.0 / 2.54;  // inches

std::vector<PrintedBlock> blocksOf(const QTextDocument& document) {
  std::vector<PrintedBlock> blocks;
  const QTextTable* table = nullptr;  // table of the last block
  int row = -1;
  for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
    const QRectF rect = document.documentLayout()->blockBoundingRect(block);
    const QTextTable* const its = QTextCursor(block).currentTable();
    const int itsRow = its ? its->cellAt(block.position()).row() : -1;
    if (its && its == table && itsRow == row) {
      blocks.back().top = std::min(blocks.back().top, rect.top());
      blocks.back().bottom = std::max(blocks.back().bottom, rect.bottom());
    } else {
      const QTextBlockFormat format = block.blockFormat();
      const bool beginsPage = format.pageBreakPolicy().testFlag(QTextFormat::PageBreak_AlwaysBefore);
      blocks.push_back({rect.top(), rect.bottom(), beginsPage, format.headingLevel() > 0});
    }
    table = its;
    row = itsRow;
  }
  return blocks;
}

// Makes a picture smaller that is larger than the room on a page. Sizes of formats are in pixels of the screen, `room`
// in those of the device of the layout: how many of these one is, the layout alone knows.
void fitPicture(QTextDocument& document, const QTextFragment& picture, const QSizeF& room) {
  QTextObjectInterface* const handler = document.documentLayout()->handlerForObject(QTextFormat::ImageObject);
  QTextImageFormat format = picture.charFormat().toImageFormat();
  const QSizeF size = handler->intrinsicSize(&document, picture.position(), format);
  if (size.isEmpty()) return;
  const double factor = std::min(room.width() / size.width(), room.height() / size.height());
  if (factor >= 1.0) return;
  constexpr double kProbe = 1000.0;
  QTextImageFormat probe = format;
  probe.setWidth(kProbe);
  const double scale = handler->intrinsicSize(&document, picture.position(), probe).width() / kProbe;
  if (scale <= 0.0) return;
  format.setWidth(std::max(1.0, std::floor(factor * size.width() / scale)));
  format.setHeight(std::max(1.0, std::floor(factor * size.height() / scale)));
  QTextCursor cursor(&document);
  cursor.setPosition(picture.position());
  cursor.setPosition(picture.position() + picture.length(), QTextCursor::KeepAnchor);
  cursor.setCharFormat(format);
}

void fitPictures(QTextDocument& document, const QSizeF& room) {
  std::vector<QTextFragment> pictures;
  for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
    for (auto each = block.begin(); !each.atEnd(); ++each)
      if (each.fragment().charFormat().isImageFormat()) pictures.push_back(each.fragment());
  }
  for (const QTextFragment& picture : pictures) fitPicture(document, picture, room);
}

}  // namespace

std::vector<PrintedPage> pagesOf(const std::vector<PrintedBlock>& blocks, double height) {
  // In the middle between a block and the one before: there is the border between two rows.
  const auto begin = [&](std::size_t i) {
    return i == 0 ? blocks[0].top : 0.5 * (blocks[i - 1].bottom + blocks[i].top);
  };
  std::vector<PrintedPage> pages;
  for (std::size_t first = 0; first < blocks.size();) {
    double from = begin(first);
    std::size_t end = first + 1;
    while (end < blocks.size() && !blocks[end].beginsPage && blocks[end].bottom - from <= height) ++end;
    if (end < blocks.size() && !blocks[end].beginsPage)
      while (end > first + 1 && blocks[end - 1].staysWithNext) --end;
    for (; blocks[end - 1].bottom - from > height; from += height) pages.push_back({from, from + height});
    pages.push_back({from, end < blocks.size() ? begin(end) : blocks.back().bottom});
    first = end;
  }
  return pages;
}

void printWholeRows(QTextDocument& document, QPaintDevice& device, const std::function<void()>& newPage) {
  QPainter painter(&device);
  if (!painter.isActive()) return;
  QAbstractTextDocumentLayout* const layout = document.documentLayout();
  layout->setPaintDevice(&device);
  const double across = kMarginOfPaper * device.logicalDpiX(), down = kMarginOfPaper * device.logicalDpiY();
  document.setDocumentMargin(0.0);
  const QSizeF room(device.width() - 2.0 * across, device.height() - 2.0 * down);
  fitPictures(document, room);
  document.setTextWidth(room.width());
  const QFont numbers(document.defaultFont(), &device);
  QAbstractTextDocumentLayout::PaintContext context;
  context.palette.setColor(QPalette::Text, Qt::black);  // independent of the theme of the window
  int number = 0;
  for (const PrintedPage& page : pagesOf(blocksOf(document), room.height())) {
    if (++number > 1) newPage();
    painter.save();
    painter.translate(across, down - page.from);
    context.clip = QRectF(0.0, page.from, document.textWidth(), page.to - page.from);
    painter.setClipRect(context.clip);
    layout->draw(&painter, context);
    painter.restore();
    painter.setFont(numbers);
    painter.setPen(Qt::black);
    painter.drawText(QRectF(across, device.height() - down, document.textWidth(), down),
                     Qt::AlignRight | Qt::AlignVCenter, QString::number(number));
  }
}

void printWholeRows(QTextDocument& document, QPagedPaintDevice& device) {
  printWholeRows(document, device, [&device] { device.newPage(); });
}

}  // namespace handwheel
