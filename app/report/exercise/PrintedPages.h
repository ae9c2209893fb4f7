// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

class QPagedPaintDevice;
class QPaintDevice;
class QTextDocument;

namespace handwheel {

// A block that stays in one piece on paper. It is a paragraph with its pictures, or a row of a table. Heights are from
// the top of the document before it is divided into pages.
struct PrintedBlock {
  double top = 0.0, bottom = 0.0;
  bool beginsPage = false;
  bool staysWithNext = false;  // a heading
};

// The part of such a document that is on one page.
struct PrintedPage {
  double from = 0.0, to = 0.0;
};

// Returns the pages of blocks that follow each other down the document. A page ends between two blocks; only a block
// that is higher than a page is cut. O(blocks).
std::vector<PrintedPage> pagesOf(const std::vector<PrintedBlock>& blocks, double height);

// Prints a document with margins of 2 cm and page numbers. QTextDocument::print() would cut rows of tables between
// their lines. The document is laid out anew, for the device; larger pictures are scaled down to the area between the
// margins.
void printWholeRows(QTextDocument& document, QPaintDevice& device, const std::function<void()>& newPage);
void printWholeRows(QTextDocument& document, QPagedPaintDevice& device);

}  // namespace handwheel
