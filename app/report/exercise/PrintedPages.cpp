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

namespace handwheel {

namespace {

constexpr double kMarginOfPaper = 2.0 / 2.54;  // inches

std::vector<PrintedBlock> blocksOf(const QTextDocument& document) {
  std::vector<PrintedBlock> blocks;
  const QTextTable* table = nullptr;  // of the last block
  int row = -1;
  for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
    const QRectF place = document.documentLayout()->blockBoundingRect(block);
    const QTextTable* const its = QTextCursor(block).currentTable();
    const int itsRow = its ? its->cellAt(block.position()).row() : -1;
    if (its && its == table && itsRow == row) {
      blocks.back().top = std::min(blocks.back().top, place.top());
      blocks.back().bottom = std::max(blocks.back().bottom, place.bottom());
    } else {
      const QTextBlockFormat format = block.blockFormat();
      const bool beginsPage = format.pageBreakPolicy().testFlag(QTextFormat::PageBreak_AlwaysBefore);
      blocks.push_back({place.top(), place.bottom(), beginsPage, format.headingLevel() > 0});
    }
    table = its;
    row = itsRow;
  }
  return blocks;
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

void printWholeRows(QTextDocument& document, QPagedPaintDevice& device) {
  QPainter painter(&device);
  if (!painter.isActive()) return;
  QAbstractTextDocumentLayout* const layout = document.documentLayout();
  layout->setPaintDevice(&device);
  const double across = kMarginOfPaper * device.logicalDpiX(), down = kMarginOfPaper * device.logicalDpiY();
  document.setDocumentMargin(0.0);
  document.setTextWidth(device.width() - 2.0 * across);
  const QFont numbers(document.defaultFont(), &device);
  QAbstractTextDocumentLayout::PaintContext context;
  context.palette.setColor(QPalette::Text, Qt::black);  // whatever the theme of the window is
  int number = 0;
  for (const PrintedPage& page : pagesOf(blocksOf(document), device.height() - 2.0 * down)) {
    if (++number > 1) device.newPage();
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

}  // namespace handwheel
